"""Compile units that are built at first, and those that are built on demand.

A library without some units has NULL where their functions would be (em_units.h). A part is a library, too: the same
objects and those of its units, from whose `em_model` the first one takes what it lacks (`PointModel.need`).
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
"""Their units; by what names runtime/point.pyx asks for them."""
WORDS: Mapping[str, str] = MappingProxyType({
    "derivatives": "derivatives",
    "members": "what runs side by side need",
    "duals": "the Jacobian of the right-hand side",
})  # fmt: skip
ALL_AT_FIRST = not sys.platform.startswith("linux")
"""Whether nothing may be missing as a library is linked: where objects are not ELF's."""
_AT_FIRST = ("model", "rhs", "lanes", "aside")
_DERIVED = {"#define EM_ACTS", '#include "dynamics/em_close_eigenvalues.h"'}
"""In a NAME.c that wants derivatives at once: what events do stands among them, and dM/dx tells where axes turn."""
_DIFFERENTIATES = '#include "dynamics/em_rate_jacobian.h"'


def at_first(text: str) -> tuple[str, ...]:
    """Return the units of a NAME.c that its first run may need."""
    if ALL_AT_FIRST:
        return (*whole(), "duals") if _DIFFERENTIATES in text else whole()
    first = {*_AT_FIRST, "derivatives"} if _DERIVED.intersection(text.splitlines()) else _AT_FIRST
    return tuple(unit for unit in UNITS if unit in first)


def whole() -> tuple[str, ...]:
    """Return the units of a module that stands alone: all but that for `System.jacobian`, which wants a compiler."""
    return tuple(unit for unit in UNITS if unit not in (*IN_PLACE_OF.values(), "duals"))


def methods_of(units: tuple[str, ...]) -> tuple[str, ...]:
    """Return the methods that these units are new to, explicit ones first."""
    explicit = {"model", "lanes", "members"}.intersection(units)
    first = [name for name, method in METHODS.items() if explicit and not method.implicit]
    return (*first, *(name for name, method in METHODS.items() if "derivatives" in units and method.implicit))
