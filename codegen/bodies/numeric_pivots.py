"""Articulated bodies in floating point, for tests whether joints move mass: their pivots, and what they carry."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from types import SimpleNamespace
from typing import Any

from ..graph.store import Node
from .links import Links
from .recursion import Dynamics
from .scalar import Scalar


class _Floats:
    """The operations of a graph that `Scalar` asks for, with floats in place of nodes."""

    zero, one = 0.0, 1.0

    def sum(self, terms: Iterable[tuple[float, Any]]) -> float:
        return math.fsum(value * float(factor) for value, factor in terms)

    def mul(self, a: float, b: float) -> float:
        return a * b

    def scale(self, a: float, factor: Any) -> float:
        return a * float(factor)

    def power(self, a: float, exponent: Any) -> float:
        return float(a ** float(exponent))


_FLOATS: Any = _Floats()
_ZERO = Scalar(_FLOATS, _FLOATS.zero)
_STILL = [_ZERO] * 3, [_ZERO] * 3


def pivots(
    links: Links, value: Callable[[Node], float], armature: Sequence[float]
) -> Iterator[tuple[int, float, float]]:
    """Yield (coordinate, inertia that it feels with joints further out and the rest of its own free, bound of M_kk).

    armature : (n,) inertia of each coordinate besides that of the bodies

    Raises
    ------
    ZeroDivisionError
        A pivot is zero.
    """
    moving = [_valued(replace(one, rate=_STILL), value) for one in links.moving]
    numeric: Any = SimpleNamespace(graph=_FLOATS, zero=_ZERO, still=_STILL, q=links.q, moving=moving)
    floats: Any = tuple(armature)  # in place of nodes
    dynamics = Dynamics(numeric)
    carried = [size.node + abs(one) for size, one in zip(dynamics.carried, armature, strict=True)]
    if dynamics.shared:
        found = dynamics.pivots([Scalar(_FLOATS, one) for one in floats])
        yield from zip(range(len(found)), (pivot.node for pivot in found), carried, strict=True)
        return
    for body, joint in zip(moving, dynamics.articulated(floats), strict=True):
        for place, k in enumerate(body.numbers):
            yield k, 1.0 / joint.inverse[place][place].node, carried[k]


def _valued(part: Any, value: Callable[[Node], float]) -> Any:
    """Return a part of a tree with floats in place of nodes."""
    if isinstance(part, Scalar):
        number: Any = value(part.node)
        return Scalar(_FLOATS, number)
    if isinstance(part, list | tuple):
        return type(part)(_valued(one, value) for one in part)
    if is_dataclass(part) and not isinstance(part, type):
        return replace(part, **{field.name: _valued(getattr(part, field.name), value) for field in fields(part)})
    return part
