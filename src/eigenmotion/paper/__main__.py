"""`python -m eigenmotion.paper DIR [FIGURE ...]`."""

import sys
from pathlib import Path

from . import write_figures

if len(sys.argv) < 2 or not all(word in {"2", "3", "4", "5", "6", "7", "8"} for word in sys.argv[2:]):
    sys.exit("usage: python -m eigenmotion.paper DIR [FIGURE ...]   draws Figures 2 to 8, or those named, into DIR")
print(write_figures(Path(sys.argv[1]), {int(word) for word in sys.argv[2:]}))
