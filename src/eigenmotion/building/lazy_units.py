"""Compile units of a first build, and parts that are compiled on demand.

A library without some units has NULL in place of their functions (em_units.h). A part is a library too: it has the
objects of the first library and those of its own units. The first model copies the functions that it lacks from the
`em_model` of the part (`PointModel.need`).
"""

import sys
from collections.abc import Mapping
from types import MappingProxyType

from ..arguments.methods import METHODS
from .toolchain import IN_PLACE_OF, UNITS

PARTS: Mapping[str, tuple[str, ...]] = MappingProxyType({
    "derivatives": ("derivatives",),
    "members": ("members",),
    "duals": ("duals",),
})  # fmt: skip
"""Name of each part, as in runtime/point.pyx -> its units."""
WORDS: Mapping[str, str] = MappingProxyType({
    "derivatives": "derivatives",
    "members": "what runs side by side need",
    "duals": "the Jacobian of the right-hand side",
})  # fmt: skip
ALL_AT_FIRST = not sys.platform.startswith("linux")
"""Whether all units must be linked at first, since undefined symbols are allowed only in ELF objects."""
_AT_FIRST = ("model", "rhs", "lanes", "aside")
_DERIVED = '#include "dynamics/em_close_eigenvalues.h"'
"""Line of a NAME.c that needs derivatives at once: dM/dx near close eigenvalues."""
_DIFFERENTIATES = '#include "dynamics/em_rate_jacobian.h"'


def at_first(text: str) -> tuple[str, ...]:
    """Return the units of a NAME.c that a first run may need."""
    if ALL_AT_FIRST:
        return (*whole(), "duals") if _DIFFERENTIATES in text else whole()
    first = {*_AT_FIRST, "derivatives"} if _DERIVED in text.splitlines() else _AT_FIRST
    return tuple(unit for unit in UNITS if unit in first)


def whole() -> tuple[str, ...]:
    """Return the units of a complete module: all but that for `System.jacobian`, which is compiled on demand."""
    return tuple(unit for unit in UNITS if unit not in (*IN_PLACE_OF.values(), "duals"))


def methods_of(units: tuple[str, ...]) -> tuple[str, ...]:
    """Return the methods that these units add, explicit ones first."""
    explicit = {"model", "lanes", "members"}.intersection(units)
    first = [name for name, method in METHODS.items() if explicit and not method.implicit]
    return (*first, *(name for name, method in METHODS.items() if "derivatives" in units and method.implicit))
