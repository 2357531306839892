"""A user's expression in hyper-dual numbers, straight from SymPy's tree: nothing of `codegen`'s graph, nor of C."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

import numpy as np
import sympy
from sympy.functions.elementary.piecewise import Piecewise
from sympy.logic.boolalg import ITE, And, BooleanFalse, BooleanTrue, Not, Or

from .hyperdual import FUNCTIONS, RELATIONS, HyperDual, Part, power

_NO_VALUE = HyperDual(np.nan, np.nan, np.nan, np.nan)


class Evaluation:
    """Values of expressions at many places at once; each subexpression is computed once.

    Parameters
    ----------
    values
        What each symbol, function of time and derivative is.
    rounding
        Every sum is multiplied by it: 1, or 1 off in a late digit, which shows what cancels (Vignes 1993).

    Attributes
    ----------
    unknown : names of functions met that have no counterpart here; not a number where they stand
    """

    def __init__(self, values: Mapping[sympy.Basic, HyperDual], rounding: Part) -> None:
        self._known = dict(values)
        self._rounding = rounding
        self.unknown: set[str] = set()

    def __call__(self, expression: sympy.Basic) -> HyperDual:
        """Return the value of an expression."""
        value = self._known.get(expression)
        if value is None:
            value = self._known[expression] = self._evaluate(expression)
        return value

    def define(self, symbol: sympy.Basic, value: HyperDual) -> None:
        """Let a symbol have a value from here on."""
        self._known[symbol] = value

    def _evaluate(self, expression: sympy.Basic) -> HyperDual:
        if isinstance(expression, sympy.Number | sympy.NumberSymbol):
            return HyperDual(np.float64(expression))
        if isinstance(expression, sympy.Add):
            return reduce(HyperDual.__add__, map(self, expression.args)).scaled(self._rounding)
        if isinstance(expression, sympy.Mul):
            return reduce(HyperDual.__mul__, map(self, expression.args))
        if isinstance(expression, sympy.Pow):
            return power(*map(self, expression.args))
        if isinstance(expression, Piecewise):
            return self._piecewise(expression)
        return self._function(type(expression).__name__, expression.args)

    def _function(self, name: str, arguments: tuple[sympy.Basic, ...]) -> HyperDual:
        if name not in FUNCTIONS:
            self.unknown.add(name)
            return _NO_VALUE
        if name in ("Min", "Max"):
            return reduce(FUNCTIONS[name], map(self, arguments))
        return FUNCTIONS[name](*map(self, arguments[:1] if name == "Heaviside" else arguments))

    def _piecewise(self, expression: Piecewise) -> HyperDual:
        value = _NO_VALUE
        for branch, condition in reversed([pair.args for pair in expression.args]):
            holds = self._holds(condition)
            value = self(branch).where(holds == 1, value).where(holds == holds, _NO_VALUE)
        return value

    def _holds(self, condition: sympy.Basic) -> Part:
        """Return 1, 0, or what is not a number, where a condition is on what is none."""
        if isinstance(condition, BooleanTrue | BooleanFalse):
            return np.asarray(float(bool(condition)))
        if isinstance(condition, Not):
            return 1 - self._holds(*condition.args)
        if isinstance(condition, And):
            return reduce(_both, map(self._holds, condition.args))
        if isinstance(condition, Or):
            return reduce(_either, map(self._holds, condition.args))
        if isinstance(condition, ITE):
            asked, yes, no = map(self._holds, condition.args)
            return _either(_both(asked, yes), _both(1 - asked, no))
        one, other = (self(side).a for side in condition.args)
        holds = RELATIONS[type(condition).__name__](one, other)
        return np.where(np.isnan(one) | np.isnan(other), np.nan, holds)


def _both(one: Part, other: Part) -> Part:
    return np.where((one == 0) | (other == 0), 0.0, one * other)


def _either(one: Part, other: Part) -> Part:
    return 1 - _both(1 - one, 1 - other)
