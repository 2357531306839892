"""Garbage in circles is not looked for while what is made is kept: expressions, graphs, modules.

Python would go through all of them again and again: that is a tenth of importing SymPy, and more of a generation.
"""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def uncollected() -> Iterator[None]:
    """Look for none meanwhile; whoever has switched that off for good finds it so."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
