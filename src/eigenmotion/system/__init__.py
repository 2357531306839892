"""The class System: a compiled model with its functions, runs and analyses."""

from .system import System as System
