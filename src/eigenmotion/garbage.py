"""Pause of the cyclic garbage collector while many long-lived objects are created: expressions, graphs, modules.

The collector would traverse all of them again and again, which takes a tenth of the time of importing SymPy, and more
during a generation.
"""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def uncollected() -> Iterator[None]:
    """Disable the collector in a `with` block, and restore its state afterwards."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
