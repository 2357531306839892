"""Masses of parts as arguments of `Tree.body`: numbers, or parameters in which forces are linear."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy

from .description import FREEDOMS, Mass, Part
from .names import identifiers

_PLACES = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
_LETTERS = ("m", "mx", "my", "mz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")


class Masses:
    """The masses of parts; with `symbolic`, those of parts that move are ten parameters each.

    Attributes
    ----------
    parameters : symbol -> its value in the file
    """

    def __init__(self, parts: Sequence[Part], symbolic: bool) -> None:
        moving = _moving(parts) if symbolic else []
        names = identifiers(f"{letter}_{part.name}" for part in moving for letter in _LETTERS)
        self.parameters: dict[sympy.Symbol, float] = {}
        self._symbols: dict[str, list[sympy.Symbol]] = {}
        for part in moving:
            symbols = self._symbols[part.name] = [sympy.Symbol(names[f"{one}_{part.name}"]) for one in _LETTERS]
            self.parameters |= dict(zip(symbols, _ten(part.mass), strict=True)) if part.mass else {}

    def of(self, part: Part) -> dict[str, Any]:
        """Return the arguments of `Tree.body`."""
        if part.mass is None:
            return {}
        if part.name in self._symbols:
            m, *rest = self._symbols[part.name]
            return {"mass": m, "moment": rest[:3], "inertia": rest[3:]}
        inertia = [float(part.mass.inertia[place]) for place in _PLACES]
        return {"mass": part.mass.mass, "center": part.mass.center.tolist(), "inertia": inertia}


def _moving(parts: Sequence[Part]) -> list[Part]:
    """Return the parts with a mass that a joint moves."""
    moved: set[str] = set()
    for part in parts:
        if FREEDOMS[part.joint.kind] or part.parent in moved:
            moved.add(part.name)
    return [part for part in parts if part.name in moved and part.mass is not None]


def _ten(given: Mass) -> list[float]:
    """Return mass, first moments, and inertia about the origin of the part's frame."""
    c = given.center
    J = given.inertia + given.mass * (c @ c * np.eye(3) - np.outer(c, c))
    return [given.mass, *(given.mass * c).tolist(), *(float(J[place]) for place in _PLACES)]
