"""Lookup tables: functions defined by numbers, which any expression of a model may call."""

from __future__ import annotations

import hashlib
import keyword
import struct
from collections.abc import Callable, Iterable
from functools import cache
from typing import Any, ClassVar

import sympy
from sympy.core.function import ArgumentIndexError

from .interpolants import pieces_of
from .normalise import ModelError, shown
from .pieces import OUTSIDE, Pieces

_ARGUMENTS = {1: "one argument", 2: "two arguments"}


class Table:
    """A lookup table: a function of one or two arguments, defined by numbers and differentiated exactly.

    Parameters
    ----------
    interpolant
        A piecewise polynomial of SciPy (CubicSpline, PchipInterpolator, Akima1DInterpolator, PPoly) or a spline
        (make_interp_spline, RectBivariateSpline); `(points, values)`, linear between points; or `(x, y, values)`,
        bilinear, with values of the shape (len(x), len(y)).
    outside
        The values beyond its range: "refuse" ends a run there and names the table; "hold" keeps the value at the end;
        "extend" continues the last piece; "periodic" repeats the range.
    name
        The name under which a run can replace its numbers: `parameters={"load": other}`. None: "table".

    Raises
    ------
    ModelError
        Points do not increase, numbers are not finite, or the numbers of values and points differ; says which.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> theta = dynamicsymbols("theta")
    >>> load = em.Table(([0.0, 1.0, 2.0], [0.0, 3.0, 3.0]), outside="hold", name="load")
    >>> load(theta)
    load(theta(t))
    """

    __slots__ = ("_digest", "name", "pieces")

    name: str
    pieces: Pieces

    def __init__(self, interpolant: Any, *, outside: str = "refuse", name: str | None = None) -> None:
        self.name = "table" if name is None else name
        if not isinstance(self.name, str) or not self.name.isidentifier() or keyword.iskeyword(self.name):
            raise ModelError(
                f"Table {shown(name)}: its name is that of a function. Use letters, digits and underscores."
            )
        if outside not in OUTSIDE:
            raise ModelError(f"Table {self.name!r}: outside is {shown(outside)}. Give one of {', '.join(OUTSIDE)}.")
        pieces = interpolant.pieces if isinstance(interpolant, Table) else None
        self.pieces = (
            pieces_of(interpolant, outside, f"Table {self.name!r}")
            if pieces is None
            else Pieces(pieces.axes, pieces.coefficients, outside)
        )
        self._digest = ""

    def __call__(self, *arguments: Any) -> sympy.Expr:
        """Return the table's value at these arguments, as an expression."""
        if len(arguments) != self.arguments:
            raise ModelError(
                f"Table {self.name!r} is a function of {_ARGUMENTS[self.arguments]}, and was called with "
                f"{len(arguments)}."
            )
        call: sympy.Expr = self.function((0,) * self.arguments)(*arguments)
        return call

    def __repr__(self) -> str:
        counts = " x ".join(str(axis.count) for axis in self.pieces.axes)
        return (
            f"<Table {self.name!r} of {_ARGUMENTS[self.arguments]}: {counts} pieces, outside={self.pieces.outside!r}>"
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and (self.name, self.digest) == (other.name, other.digest)

    def __hash__(self) -> int:
        return hash((self.name, self.digest))

    def __reduce__(self) -> tuple[Callable[..., Table], tuple[Pieces, str]]:
        return _restored, (self.pieces, self.name)

    @property
    def arguments(self) -> int:
        """Number of arguments."""
        return len(self.pieces.axes)

    @property
    def handle(self) -> TableHandle:
        """The parameter through which a run can replace its numbers."""
        return TableHandle(self.name)

    @property
    def digest(self) -> str:
        """SHA-256 of its numbers."""
        if not self._digest:
            numbers = self.pieces.numbers()
            self._digest = hashlib.sha256(struct.pack(f"<{len(numbers)}d", *numbers)).hexdigest()
        return self._digest

    def function(self, orders: tuple[int, ...]) -> type[TableCall]:
        """Return the derivative of these orders, one for each argument, as a SymPy function."""
        return _function(self, orders)


class TableHandle(sympy.Symbol):  # type: ignore[misc]
    """The parameter of a table: 0 selects the numbers of the model, other values the numbers passed to a run."""

    __slots__ = ()


class TableCall(sympy.Function):  # type: ignore[misc]
    """A table, or a derivative of one, applied to arguments. Each has a class of its own, as SymPy functions do."""

    table: ClassVar[Table]
    orders: ClassVar[tuple[int, ...]]

    def fdiff(self, argindex: int = 1) -> sympy.Expr:
        """Return the derivative with respect to an argument."""
        if not 1 <= argindex <= len(self.args):
            raise ArgumentIndexError(self, argindex)
        orders = tuple(order + (place == argindex - 1) for place, order in enumerate(self.orders))
        return self.table.function(orders)(*self.args)

    def _eval_is_extended_real(self) -> bool:
        return True

    def _eval_evalf(self, prec: int) -> sympy.Expr | None:
        point = [argument.evalf(prec) for argument in self.args]
        if not all(one.is_Float or one.is_Integer for one in point):
            return None
        return sympy.Float(self.table.pieces.value(self.orders, [float(one) for one in point]), precision=prec)

    def _sympystr(self, printer: Any) -> str:
        return f"{self.label}({', '.join(map(printer.doprint, self.args))})"

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        name = self.label.replace("_", r"\_")
        power = f"^{{{exp}}}" if exp else ""
        return rf"\operatorname{{{name}}}{power}\left({', '.join(map(printer.doprint, self.args))}\right)"

    def as_undefined(self) -> sympy.Expr:
        """Return this call as one of an undefined SymPy function of the same name."""
        function = sympy.Function(self.table.name)
        if not any(self.orders):
            return function(*self.args)
        places = sympy.symbols(f"at_:{len(self.args)}")
        derivative = sympy.Derivative(function(*places), *zip(places, self.orders, strict=True))
        return sympy.Subs(derivative, places, self.args)

    @property
    def label(self) -> str:
        """The name with a ' for each derivative, such as load''; with two arguments, the orders as in map^(1, 0)."""
        orders = self.orders
        marks = "'" * orders[0] if len(orders) == 1 else f"^{orders}" if any(orders) else ""
        return f"{self.table.name}{marks}"

    def __reduce_ex__(self, protocol: Any) -> tuple[Callable[..., sympy.Expr], tuple[Any, ...]]:
        return _called, (self.table, self.orders, self.args)


@cache
def _function(table: Table, orders: tuple[int, ...]) -> type[TableCall]:
    numeric = staticmethod(lambda *point: table.pieces.value(orders, [float(one) for one in point]))
    name = table.name if not any(orders) else f"{table.name}_{''.join(map(str, orders))}"
    parts = {"table": table, "orders": orders, "nargs": len(orders), "_imp_": numeric}
    return type(name, (TableCall,), parts)


def _called(table: Table, orders: tuple[int, ...], arguments: tuple[sympy.Expr, ...]) -> sympy.Expr:
    return table.function(orders)(*arguments)


def _restored(pieces: Pieces, name: str) -> Table:
    made = Table.__new__(Table)
    made.pieces, made.name, made._digest = pieces, name, ""
    return made


def tables_in(expressions: Iterable[sympy.Basic]) -> tuple[Table, ...]:
    """Return the tables that expressions call, sorted by name; shared subexpressions are visited once.

    Raises
    ------
    ModelError
        Two tables with different numbers have one name; says which.
    """
    tables: dict[str, Table] = {}
    seen, waiting = set[int](), list(expressions)
    while waiting:
        part = waiting.pop()
        if id(part) in seen:
            continue
        seen.add(id(part))
        waiting.extend(part.args)
        if isinstance(part, TableCall) and tables.setdefault(part.table.name, part.table) != part.table:
            raise ModelError(
                f"two tables with different numbers are named {part.table.name!r}. Give each a name of its own: "
                "Table(..., name=...)."
            )
    return tuple(tables[name] for name in sorted(tables))
