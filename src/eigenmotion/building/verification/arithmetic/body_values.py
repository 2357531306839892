"""Values of functions of bodies in hyper-dual numbers, by forward kinematics."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np
import sympy

from ....codegen.model.tree.forward_kinematics import Arithmetic, ForwardKinematics
from ....codegen.model.tree.functions import BodyFunction
from .hyperdual import FUNCTIONS, HyperDual
from .rounding_bounds import EPS, Rounded

Values = Sequence[HyperDual]
_ZERO, _ONE = Rounded(0.0, 0.0), Rounded(1.0, 0.0)
_UNKNOWN = Rounded(np.nan, np.nan)


def of_bodies(
    call: BodyFunction, arguments: Values, evaluate: Callable[[dict[sympy.Basic, HyperDual], sympy.Expr], HyperDual]
) -> HyperDual:
    """Return the value of a call.

    Parameters
    ----------
    evaluate
        Evaluates an expression with these values of symbols.
    """

    def value(at: Values) -> HyperDual:
        known = dict(zip(call.quantity.variables, at, strict=True))
        arithmetic = Arithmetic(
            partial(evaluate, known), lambda entry: _unit(evaluate(known, entry)), FUNCTIONS["sin"], FUNCTIONS["cos"],
            lambda number: number.power(Rounded(-1.0, 0.0)),
        )  # fmt: skip
        return ForwardKinematics(arithmetic, known).quantity(call.quantity) or HyperDual(_ZERO)

    by = [place for place, order in enumerate(call.orders) for _ in range(order)]
    if not by:
        return value(arguments)
    return _first(value, arguments, by[0]) if len(by) == 1 else _second(value, arguments, by)


def _unit(entry: HyperDual) -> HyperDual:
    """Return an entry of a rotation with the rounding of its largest entries."""
    return HyperDual(entry.a.off(EPS), entry.b, entry.c, entry.f)


def _first(value: Callable[[Values], HyperDual], at: Values, place: int) -> HyperDual:
    """Return the derivative by an argument with its first derivatives; its mixed second ones are unknown."""

    def seeded(other: str) -> HyperDual:
        """Return the value with a seed for the argument in c, and the derivatives `other` of all in b."""
        return value([
            HyperDual(one.a, getattr(one, other), _ONE if k == place else None) for k, one in enumerate(at)
        ])  # fmt: skip

    along, across = (any(getattr(one, part) is not None for one in at) for part in "bc")
    return HyperDual(
        seeded("b").c or _ZERO,
        seeded("b").f if along else None,
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
