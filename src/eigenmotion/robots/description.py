"""A robot as a file describes it, whatever its format: parts, their joints and masses, closed loops."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
FREEDOMS = {"fixed": 0, "revolute": 1, "prismatic": 1, "planar": 3, "spherical": 3, "free": 6}
"""Kinds of joints, and their numbers of coordinates"""


_MOST = 4
"""Names that a list has"""


def listed(names: Sequence[str]) -> str:
    """Return names on one line, the first ones of many."""
    more = len(names) - _MOST
    return ", ".join(names[:_MOST]) + (f" and {more} more" if more > 0 else "")


@dataclass(frozen=True, slots=True)
class Driven:
    """A joint at ratio times the displacement of another joint, plus an offset."""

    joint: str
    ratio: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint of a file. Its displacement is q - zero, with its coordinate q [rad or m].

    Attributes
    ----------
    kind : a key of FREEDOMS
    axis : (3,) of a revolute or prismatic joint, in the joint's frame
    driven : the joint that drives it, or None
    damping : [N s / m or N m s / rad]; armature [kg or kg m^2]
    stiffness, rest : of a spring [N / m or N m / rad], and the position where it is at rest
    friction : Coulomb's, which models leave out [N or N m]
    lower, upper, effort, velocity : limits, which models leave out
    start : initial values of the coordinates
    """

    name: str
    kind: str
    axis: tuple[float, ...] = (0.0, 0.0, 1.0)
    zero: float = 0.0
    driven: Driven | None = None
    damping: float = 0.0
    armature: float = 0.0
    stiffness: float = 0.0
    rest: float = 0.0
    friction: float = 0.0
    lower: float = -math.inf
    upper: float = math.inf
    effort: float = math.inf
    velocity: float = math.inf
    start: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Mass:
    """Mass [kg], mass centre (3,) in the part's frame [m], inertia (3, 3) about it in the part's axes [kg m^2]."""

    mass: float
    center: Array
    inertia: Array

    def flaw(self) -> str:
        """Return what no body can have, or "" if there is nothing of that kind."""
        low, middle, high = np.linalg.eigvalsh((self.inertia + self.inertia.T) / 2)
        if self.mass < 0:
            return f"its mass {self.mass:g} kg is negative"
        if low < -1e-12 * high:
            return f"its inertia has the negative principal moment {low:.3g} kg m^2"
        if high > (low + middle) * (1 + 1e-6):
            return f"its principal moments {low:.3g}, {middle:.3g}, {high:.3g} kg m^2 violate the triangle inequality"
        if high > 0 and self.mass == 0:
            return "it has an inertia and no mass"
        return ""


@dataclass(frozen=True, slots=True)
class Part:
    """A part: the frame of its joint on the parent, moved by the joint. `parent` is None for the ground.

    at : (3,) [m]; rotation : (3, 3), the axes of the joint's frame as columns, in the parent's axes
    solids : of each visible solid, corners (k, 3) in the part's frame [m]
    """

    name: str
    parent: str | None
    joint: Joint
    at: Array
    rotation: Array
    mass: Mass | None = None
    solids: tuple[Array, ...] = ()


@dataclass(frozen=True, slots=True)
class Closure:
    """A point (3,) of a part that coincides with one of another part; None for the ground."""

    name: str
    first: str | None
    first_point: Sequence[float]
    second: str | None
    second_point: Sequence[float]


@dataclass(frozen=True, slots=True)
class Description:
    """All that is used of a file. Parts are in an order with parents first.

    polynomials : name -> (driven joint, driving joint, coefficients), displacements by polynomials of degree 2 or more
    notes : what is not used, for people
    """

    name: str
    parts: tuple[Part, ...]
    gravity: tuple[float, ...]
    closures: tuple[Closure, ...] = ()
    polynomials: Mapping[str, tuple[str, str, tuple[float, ...]]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
