"""One compiled model in Python's terms."""

from .system import System as System
