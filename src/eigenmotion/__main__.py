"""`python -m eigenmotion`."""

import sys

from eigenmotion.cli import main

sys.exit(main())
