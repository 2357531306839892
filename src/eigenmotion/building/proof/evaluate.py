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
            value = self(branch).where(self._holds(condition), value)
        return value

    def _holds(self, condition: sympy.Basic) -> Part:
        if isinstance(condition, BooleanTrue | BooleanFalse):
            return np.asarray(bool(condition))
        if isinstance(condition, Not):
            return ~self._holds(*condition.args)
        if isinstance(condition, And | Or):
            return reduce(np.logical_and if isinstance(condition, And) else np.logical_or,
                          map(self._holds, condition.args))  # fmt: skip
        if isinstance(condition, ITE):
            return np.where(*map(self._holds, condition.args))
        return RELATIONS[type(condition).__name__](*(self(side).a for side in condition.args))
