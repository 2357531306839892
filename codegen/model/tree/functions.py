"""Functions of bodies in SymPy expressions: places, velocities, energies.

SymPy differentiates but does not expand them: they stand for nodes of a graph, written by `codegen.bodies`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any, ClassVar

import sympy
from sympy.core.function import ArgumentIndexError

from .dual import value
from .quantity import KINDS, Quantity


class BodyFunction(sympy.Function):  # type: ignore[misc]
    """A quantity of bodies, or a derivative of one, applied to arguments. Each has a class of its own."""

    quantity: ClassVar[Quantity]
    orders: ClassVar[tuple[int, ...]]

    def fdiff(self, argindex: int = 1) -> sympy.Expr:
        """Return the derivative with respect to an argument."""
        if not 1 <= argindex <= len(self.args):
            raise ArgumentIndexError(self, argindex)
        orders = tuple(order + (place == argindex - 1) for place, order in enumerate(self.orders))
        return function_of(self.quantity, orders)(*self.args)

    def _eval_is_extended_real(self) -> bool:
        return True

    def _eval_evalf(self, prec: int) -> sympy.Expr | None:
        point = [argument.evalf(prec) for argument in self.args]
        return sympy.Float(value(self.quantity, self.orders, point)) if all(one.is_number for one in point) else None

    @property
    def label(self) -> str:
        """The quantity's name, with the derivatives."""
        by = "".join(f"_{k}" * order for k, order in enumerate(self.orders))
        return self.quantity.label + (f".d{by}" if by else "")

    def _sympystr(self, printer: Any) -> str:
        return f"{self.label}({', '.join(map(printer.doprint, self.args))})"

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        name = self.label.replace("_", r"\_")
        power = f"^{{{exp}}}" if exp else ""
        return rf"\operatorname{{{name}}}{power}\left({', '.join(map(printer.doprint, self.args))}\right)"

    def as_undefined(self) -> sympy.Expr:
        """Return this call as one of an undefined SymPy function."""
        return sympy.Function(self.label.replace(".", "_").replace("[", "_").replace("]", "").replace(", ", "_"))(
            *self.args
        )

    def __reduce_ex__(self, protocol: Any) -> tuple[Callable[..., sympy.Expr], tuple[Any, ...]]:
        return _called, (self.quantity, self.orders, self.args)

    def degree_in_rates(self) -> int:
        """Return an upper bound of its degree in the rates of coordinates, of which it is a polynomial."""
        return KINDS[self.quantity.kind]


@cache
def function_of(quantity: Quantity, orders: tuple[int, ...]) -> type[BodyFunction]:
    """Return a quantity, or its derivative of these orders, one for each argument, as a SymPy function."""
    by = "".join(f"_{k}" * order for k, order in enumerate(orders))
    name = re.sub(
        r"\W", "_", f"{quantity.label}_{quantity.digest}_d{by}" if by else f"{quantity.label}_{quantity.digest}"
    )
    numeric = staticmethod(lambda *point: value(quantity, orders, point))
    return type(name, (BodyFunction,), {"quantity": quantity, "orders": orders, "nargs": len(orders), "_imp_": numeric})


def call(quantity: Quantity) -> sympy.Expr:
    """Return a quantity as a function of its variables."""
    variables = quantity.variables
    if not variables:
        raise ValueError(f"{quantity.label} depends on nothing")
    return function_of(quantity, (0,) * len(variables))(*variables)


def _called(quantity: Quantity, orders: tuple[int, ...], arguments: tuple[sympy.Expr, ...]) -> sympy.Expr:
    return function_of(quantity, orders)(*arguments)
