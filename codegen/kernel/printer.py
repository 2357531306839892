"""Printer of operations as C expressions, with as few parentheses as possible."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from ..graph.coefficients import Number, magnitude
from ..graph.table_calls import orders_of, table_of
from ..schedule.operations import Operation, operands_of
from ..schedule.schedule import Schedule
from .identifiers import c_identifier

ONE = Operation("number", (1,))
DEEPEST = 40
"""Largest nesting depth of operations in one statement."""
SUM, PRODUCT, ATOM = 0, 1, 2
"""Precedence of the outermost operation of a text."""
CALLS: Mapping[str, str] = {
    "sin": "em_sin", "cos": "em_cos", "abs": "fabs", "min": "em_least", "max": "em_greatest", "sign": "em_sign",
    "step": "em_heaviside", "select": "em_select", "<": "em_less", "<=": "em_not_above", "==": "em_equal",
    "and": "em_and", "or": "em_or", "not": "em_not",
}  # fmt: skip
IN_VECTORS = frozenset(CALLS) | {"exp", "log"}
"""Functions with a vector version; all others call the C library lane by lane (em_lane_functions.h)."""
MIRRORED: Mapping[str, str] = {">": "<", ">=": "<="}


class Printer:
    """Prints the values of a schedule; a value with a name is printed as that name.

    Parameters
    ----------
    names
        Value -> identifier; grows as values get names.
    on_lanes
        Whether values may be vectors, so that a single number must be converted to one (em_real.h).
    """

    def __init__(self, plan: Schedule, names: Mapping[int, str], on_lanes: bool) -> None:
        self.plan, self.names, self.on_lanes = plan, names, on_lanes
        self._depth: dict[int, int] = {}

    def is_deep(self, value: int) -> bool:
        """Whether the text of a value is nested too deeply; must have been called for its operands before."""
        parts = (part for part in operands_of(self.plan.operations[value]) if part not in self.names)
        self._depth[value] = 1 + max((self._depth.get(part, 0) for part in parts), default=0)
        return self._depth[value] > DEEPEST

    def whole(self, value: int) -> str:
        """Return the text of a whole expression: the right-hand side of an assignment, or an argument."""
        text = self.bare(value)
        return f"em_real({text})" if self.on_lanes and self.plan.operations[value].kind == "number" else text

    def bare(self, value: int) -> str:
        """Return the text of a value without parentheses around it."""
        if value in self.names:
            return self.names[value]
        operation = self.plan.operations[value]
        text, _ = self._write(operation)
        return text.strip("()") if operation.kind == "number" else text

    def _bound(self, value: int, tightness: int) -> str:
        """Return the text of a value, in parentheses if its precedence is lower than `tightness`."""
        if value in self.names:
            return self.names[value]
        text, binding = self._write(self.plan.operations[value])
        return text if binding >= tightness else f"({text})"

    def _write(self, operation: Operation) -> tuple[str, int]:
        kind, operands = operation
        if kind == "number":
            return c_number(operands[0]), ATOM if operands[0] >= 0 else SUM
        if kind == "add":
            return self._sum(operands)
        if kind == "mul":
            return self._product(operands), PRODUCT
        if kind == "inverse":
            return f"1.0/{self._bound(operands[0], ATOM)}", PRODUCT
        if kind == "sqrt":
            return f"sqrt({self.whole(operands[0])})", ATOM
        return self._call(operands[0], operands[1:]), ATOM

    def _sum(self, terms: Sequence[tuple[int, Number]]) -> tuple[str, int]:
        ordered = sorted(terms, key=lambda term: term[1] < 0)
        first, *rest = (self._term(*term) for term in ordered)
        sign, text = first
        result = ("-" if sign < 0 else "") + text
        for sign, text in rest:
            result += f" {'-' if sign < 0 else '+'} {text}"
        return result, SUM

    def _term(self, value: int, factor: Number) -> tuple[int, str]:
        sign = -1 if factor < 0 else 1
        if self.plan.operations[value] == ONE:
            return sign, c_number(magnitude(factor))
        text = self._bound(value, PRODUCT)
        return sign, text if abs(factor) == 1 else f"{c_number(magnitude(factor))}*{text}"

    def _product(self, values: Sequence[int]) -> str:
        above = [value for value in values if not self._is_inverse(value)]
        below = [self.plan.operations[value].operands[0] for value in values if self._is_inverse(value)]
        text = "*".join(self._bound(value, ATOM if place else PRODUCT) for place, value in enumerate(above)) or "1.0"
        if not below:
            return text
        under = "*".join(self._bound(value, ATOM) for value in below)
        return f"{text}/{under}" if len(below) == 1 else f"{text}/({under})"

    def _is_inverse(self, value: int) -> bool:
        return value not in self.names and self.plan.operations[value].kind == "inverse"

    def _call(self, name: str, operands: Sequence[int]) -> str:
        if name in MIRRORED:
            return self._call(MIRRORED[name], operands[::-1])
        if name == "!=":
            return f"em_not({self._call('==', operands)})"
        if orders := orders_of(name):
            return self._table_call(table_of(name), orders, *map(self.whole, operands))
        return f"{CALLS.get(name, name)}({', '.join(self.whole(operand) for operand in operands)})"

    @staticmethod
    def _table_call(table: str, orders: tuple[int, ...], number: str, *arguments: str) -> str:
        return f"{table_function(table)}({', '.join([number, *map(str, orders), *arguments])})"


def table_function(table: str) -> str:
    """Return the name of a table's function in C."""
    return f"em_table_{c_identifier(table)}"


def c_number(value: Number) -> str:
    """Return a number as a C constant, exactly where that is possible."""
    if isinstance(value, Fraction) and value.denominator > 1 and Fraction(float(value)) != value:
        return f"({value.numerator}.0/{value.denominator}.0)"
    if value != value:
        return "NAN"
    return repr(float(value))
