"""Evaluation of SymPy expressions in hyper-dual numbers, independent of the graph of `codegen` and of C."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce

import numpy as np
import sympy
from sympy.functions.elementary.piecewise import Piecewise
from sympy.logic.boolalg import ITE, And, Boolean, BooleanFalse, BooleanTrue, Not, Or

from ....codegen.model.table import TableCall
from ....codegen.model.tree.functions import BodyFunction
from .body_values import BodyValues
from .hyperdual import FUNCTIONS, RELATIONS, HyperDual, doubt, power
from .rounding_bounds import Part, Rounded, constant
from .table_values import of_table

_OF_MANY: Mapping[str, Callable[[HyperDual, HyperDual], HyperDual]] = {
    "Add": HyperDual.__add__, "Mul": HyperDual.__mul__, "Min": FUNCTIONS["Min"], "Max": FUNCTIONS["Max"],
}  # fmt: skip
_NO_VALUE = HyperDual(*4 * (Rounded(np.nan, np.nan),))


@dataclass(frozen=True, slots=True, eq=False)
class _Truth:
    """Truth of a condition: 1, 0, or NaN if its operands are NaN.

    unsure : whether rounding decides
    """

    holds: Part
    unsure: Part

    @property
    def never(self) -> Part:
        """Whether the condition is false whatever the rounding."""
        return (self.holds == 0) & ~self.unsure

    def __invert__(self) -> _Truth:
        return _Truth(1 - self.holds, self.unsure)

    def __and__(self, other: _Truth) -> _Truth:
        holds = np.where((self.holds == 0) | (other.holds == 0), 0.0, self.holds * other.holds)
        return _Truth(holds, (self.unsure | other.unsure) & ~self.never & ~other.never)

    def __or__(self, other: _Truth) -> _Truth:
        return ~(~self & ~other)


class Evaluation:
    """Values of expressions at many points at once; each subexpression is computed once.

    Parameters
    ----------
    values
        The value of each symbol, function of time and derivative.

    Attributes
    ----------
    unknown : names of functions that are not supported here; expressions with them are NaN
    """

    def __init__(self, values: Mapping[sympy.Basic, HyperDual]) -> None:
        self._known = dict(values)
        self._truths: dict[sympy.Basic, _Truth] = {}
        self._bodies = BodyValues(Evaluation)
        self.unknown: set[str] = set()

    def __call__(self, expression: sympy.Basic) -> HyperDual:
        """Return the value of an expression, without recursion, so that it may be nested deeply."""
        waiting = [expression]
        while waiting:
            part = waiting.pop()
            if part in self._known or part in self._truths:
                continue
            missing = [inner for inner in _arguments(part) if inner not in self._known and inner not in self._truths]
            if missing:
                waiting += [part, *missing]
            elif isinstance(part, Boolean):
                self._truths[part] = self._truth(part)
            else:
                self._known[part] = self._evaluate(part)
        value: HyperDual = self._known[expression]
        return value

    def define(self, symbol: sympy.Basic, value: HyperDual) -> None:
        """Set the value of a symbol."""
        self._known[symbol] = value

    def _evaluate(self, expression: sympy.Basic) -> HyperDual:
        if isinstance(expression, sympy.Number | sympy.NumberSymbol):
            return HyperDual(constant(expression))
        if isinstance(expression, Piecewise):
            return self._piecewise(expression)
        if isinstance(expression, sympy.Pow):
            return power(*(self._known[part] for part in expression.args))
        name, values = type(expression).__name__, [self._known[part] for part in _arguments(expression)]
        if isinstance(expression, TableCall):
            return of_table(expression, *values)
        if isinstance(expression, BodyFunction):
            return self._bodies(expression, values)
        if name in _OF_MANY:
            whole: HyperDual = reduce(_OF_MANY[name], values)
            return whole
        if name not in FUNCTIONS:
            self.unknown.add(name)
            return _NO_VALUE
        return FUNCTIONS[name](*values)

    def _piecewise(self, expression: Piecewise) -> HyperDual:
        value = _NO_VALUE
        for branch, condition in reversed([pair.args for pair in expression.args]):
            truth, other = self._truths[condition], self._known[branch]
            value = other.where(truth.holds == 1, truth.unsure, value)
            value = value.where(truth.holds == truth.holds, False, _NO_VALUE)
        return value

    def _truth(self, condition: Boolean) -> _Truth:
        if isinstance(condition, BooleanTrue | BooleanFalse):
            return _Truth(np.asarray(float(bool(condition))), np.asarray(False))
        if isinstance(condition, Not | And | Or | ITE):
            return _joined(condition, [self._truths[part] for part in condition.args])
        one, other = (self._known[side] for side in condition.args)
        holds = RELATIONS[type(condition).__name__](one.a.value, other.a.value)
        known = ~np.isnan(one.a.value + other.a.value)
        return _Truth(np.where(known, holds, np.nan), np.asarray(known & doubt(one, other)))


def _arguments(expression: sympy.Basic) -> Sequence[sympy.Basic]:
    """Return the subexpressions whose values an expression needs."""
    if isinstance(expression, Piecewise):
        return [part for pair in expression.args for part in pair.args]
    parts: Sequence[sympy.Basic] = expression.args
    if isinstance(expression, sympy.Add | sympy.Mul | sympy.Pow | Boolean | TableCall | BodyFunction):
        return parts
    name = type(expression).__name__
    return parts[: 1 if name == "Heaviside" else None] if name in FUNCTIONS else ()


def _joined(condition: Boolean, truths: list[_Truth]) -> _Truth:
    if isinstance(condition, Not):
        return ~truths[0]
    if isinstance(condition, ITE):
        return (truths[0] & truths[1]) | (~truths[0] & truths[2])
    return reduce(_Truth.__and__ if isinstance(condition, And) else _Truth.__or__, truths)
