"""Values of functions of bodies in hyper-dual numbers, by forward kinematics."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
import sympy

from ....codegen.model.tree.body import rate_of
from ....codegen.model.tree.forward_kinematics import Arithmetic, ForwardKinematics
from ....codegen.model.tree.functions import BodyFunction
from ....codegen.model.tree.quantity import KINDS, Quantity
from .body_quantities import BodyQuantities
from .hyperdual import FUNCTIONS, HyperDual
from .rotation_bounds import FROM, settled
from .rounding_bounds import EPS, Rounded
from .transforms import directions_of, width_of

Values = Sequence[HyperDual]
_ZERO, _ONE = Rounded(0.0, 0.0), Rounded(1.0, 0.0)
_UNKNOWN = Rounded(np.nan, np.nan)
_KEPT = 32  # kinematics with seeds: those of a point that sixteen joints move


class _Kinematics:
    """Forward kinematics at values of variables, which may come to be known one after the other."""

    def __init__(self, evaluation: Callable[[dict[sympy.Basic, HyperDual]], Any]) -> None:
        self._known: dict[sympy.Basic, HyperDual] = {}
        self._evaluate = evaluation(self._known)
        arithmetic = Arithmetic(
            self._evaluate, lambda entry: _unit(self._evaluate(entry)), FUNCTIONS["sin"], FUNCTIONS["cos"],
            lambda number: number.power(Rounded(-1.0, 0.0)), settled,
        )  # fmt: skip
        self._forward = ForwardKinematics(arithmetic, self._known)
        self._long: dict[int, BodyQuantities] = {}

    def knows(self, known: Mapping[sympy.Basic, HyperDual], rates: bool) -> bool:
        """Whether no variable has another value here; without `rates`, whether all are known, with the rates."""
        if any(self._known.get(variable, value) is not value for variable, value in known.items()):
            return False
        return rates or all(one in self._known and (not one.args or rate_of(one) in self._known) for one in known)

    def __call__(self, quantity: Quantity, known: Mapping[sympy.Basic, HyperDual]) -> HyperDual:
        """Return the value of a quantity at these values of its variables."""
        for variable, value in known.items():
            if variable not in self._known:
                self._known[variable] = value
                self._evaluate.define(variable, value)
        width = max(width_of(part) for value in known.values() for part in (value.c, value.f))
        if len(quantity.bodies) < FROM or not _is_plain(known, width):
            return self._forward.quantity(quantity) or HyperDual(_ZERO)
        if width not in self._long:
            self._long[width] = BodyQuantities(self._evaluate, self._known, width)
        return self._long[width](quantity)


def _is_plain(known: Mapping[sympy.Basic, HyperDual], width: int) -> bool:
    """Whether parameters are constant, coordinates and rates have one value at a point, and one direction each."""
    return all(
        width_of(value.a) == width_of(value.b) == 1 and len(directions_of(value)) < 2
        and all(width_of(part) == width for part in (value.c, value.f) if part is not None)
        if variable.args else not value.varies
        for variable, value in known.items()
    )  # fmt: skip


class BodyValues:
    """Values of functions of bodies; calls at the same values of variables share their kinematics.

    Parameters
    ----------
    evaluation
        Makes an `Evaluation` of expressions with these values of symbols.
    """

    def __init__(self, evaluation: Callable[[dict[sympy.Basic, HyperDual]], Any]) -> None:
        self._evaluation = evaluation
        self._shared: dict[bool, _Kinematics] = {}
        self._seeded: dict[tuple[object, ...], tuple[Values, Values, _Kinematics]] = {}

    def __call__(self, call: BodyFunction, arguments: Values) -> HyperDual:
        """Return the value of a call."""
        by = [place for place, order in enumerate(call.orders) for _ in range(order)]
        if not by:
            return self._value(call.quantity, arguments)
        if len(by) == 1:
            return _first(partial(self._value_seeded, call.quantity, arguments, by[0]), arguments)
        return _second(partial(self._value_alone, call.quantity), arguments, by)

    def _value(self, quantity: Quantity, at: Values) -> HyperDual:
        known = dict(zip(quantity.variables, at, strict=True))
        rates = KINDS[quantity.kind] > 0  # where these are not known, the places of bodies have no rates
        for whether in (True, rates):
            shared = self._shared.get(whether)
            if shared is not None and shared.knows(known, rates is whether):
                return shared(quantity, known)
        self._shared[rates] = _Kinematics(self._evaluation)
        return self._shared[rates](quantity, known)

    def _value_seeded(self, quantity: Quantity, at: Values, place: int, other: str) -> HyperDual:
        """Return the value with a seed for an argument in c, and the derivatives `other` of all in b.

        Quantities at the same values, such as the coordinates of one point, share their kinematics.
        """
        key = (quantity.variables, *map(id, at), place, other)
        if key not in self._seeded:
            seeds = [HyperDual(one.a, getattr(one, other), _ONE if k == place else None) for k, one in enumerate(at)]
            self._seeded[key] = at, seeds, _Kinematics(self._evaluation)
            if len(self._seeded) > _KEPT:
                del self._seeded[next(iter(self._seeded))]
        _, seeded, kinematics = self._seeded[key]
        return kinematics(quantity, dict(zip(quantity.variables, seeded, strict=True)))

    def _value_alone(self, quantity: Quantity, at: Values) -> HyperDual:
        return _Kinematics(self._evaluation)(quantity, dict(zip(quantity.variables, at, strict=True)))


def _unit(entry: HyperDual) -> HyperDual:
    """Return an entry of a rotation with the rounding of its largest entries."""
    return HyperDual(entry.a.off(EPS), entry.b, entry.c, entry.f)


def _first(seeded: Callable[[str], HyperDual], at: Values) -> HyperDual:
    """Return the derivative by an argument with its first derivatives; its mixed second ones are unknown.

    `seeded` : part -> the value with a seed for the argument in c, and the derivatives of that part of all in b
    """
    along, across = (any(getattr(one, part) is not None for one in at) for part in "bc")
    first = seeded("b")
    return HyperDual(
        first.c or _ZERO,
        first.f if along else None,
        seeded("c").f if across else None,
        _UNKNOWN if along and across else None,
    )


def _second(value: Callable[[Values], HyperDual], at: Values, by: Sequence[int]) -> HyperDual:
    """Return a second derivative; derivatives of it, and those of higher order, are unknown."""
    if len(by) > 2:
        return HyperDual(_UNKNOWN, _UNKNOWN, _UNKNOWN, _UNKNOWN)
    first, second = by
    seeds = [HyperDual(one.a, _ONE if k == first else None, _ONE if k == second else None) for k, one in enumerate(at)]
    whole = HyperDual(value(seeds).f or _ZERO)
    along, across = (any(getattr(one, part) is not None for one in at) for part in "bc")
    return HyperDual(whole.a, *(_UNKNOWN if moves else None for moves in (along, across, along and across)))
