"""Tests, in folders as the product's rooms; `support` is shared, `oracles` shares nothing with the package."""

import os

# Before NumPy is loaded, in every process: matrices here are small, and threads that wait for each other over them took
# more time than all else, the more so where several processes of tests share the processors
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
