"""Functions of bodies in SymPy expressions: places, velocities, energies.

SymPy differentiates but does not expand them: they stand for nodes of a graph, written by `codegen.bodies`.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

import sympy
from sympy.core.function import ArgumentIndexError

from .body import Link

Variables = tuple[sympy.Expr, ...]

KINDS = {
    "position": 0, "velocity": 1, "rotation": 0, "angular_velocity": 1, "kinetic_energy": 2, "potential_energy": 0
}  # fmt: skip
"""What a function may be, and its degree in the rates of coordinates."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity of bodies.

    kind : a key of KINDS
    bodies : those on which it depends, parents before children
    vector : (3,) the point of the last body, in its frame [m], or gravity [m / s^2]; () for neither
    place : which entry of a vector or matrix
    """

    kind: str
    bodies: tuple[Link, ...]
    vector: tuple[sympy.Expr, ...] = ()
    place: tuple[int, ...] = ()

    @property
    def label(self) -> str:
        """A name for people, such as "hand.velocity[2]"."""
        where = f"[{', '.join(map(str, self.place))}]" if self.place else ""
        return f"{self.bodies[-1].name}.{self.kind}{where}"

    @property
    def digest(self) -> str:
        """SHA-256 of all that it depends on."""
        numbers = {body: number for number, body in enumerate(self.bodies)}
        lines = [f"{numbers.get(body.parent)} {body.text}" if body.parent else body.text for body in self.bodies]
        text = "\n".join([self.kind, *lines, *map(sympy.srepr, self.vector), str(self.place)])
        return hashlib.sha256(text.encode()).hexdigest()

    @property
    def variables(self) -> Variables:
        """Coordinates, rates where it depends on them, and parameters."""
        return variables_of(self.bodies, self.vector, rates=KINDS[self.kind] > 0)


def variables_of(bodies: Sequence[Link], vector: Sequence[sympy.Expr], *, rates: bool = True) -> Variables:
    """Return the coordinates of bodies, their rates where asked for, and the parameters in bodies and vector."""
    coordinates = [q for body in bodies for q in body.coordinates]
    numbers = [*vector]
    for body in bodies:
        numbers += [*body.geometry, body.mass, *body.center, *body.inertia]
    parameters = sorted(set().union(*(one.free_symbols for one in numbers)), key=lambda symbol: symbol.name)
    return (*coordinates, *(q.diff() for q in coordinates if rates), *parameters)


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
    name = f"{quantity.label} {quantity.digest} {orders if any(orders) else ''}"
    return type(name, (BodyFunction,), {"quantity": quantity, "orders": orders, "nargs": len(orders)})


def call(quantity: Quantity) -> sympy.Expr:
    """Return a quantity as a function of its variables."""
    variables = quantity.variables
    if not variables:
        raise ValueError(f"{quantity.label} depends on nothing")
    return function_of(quantity, (0,) * len(variables))(*variables)


def _called(quantity: Quantity, orders: tuple[int, ...], arguments: tuple[sympy.Expr, ...]) -> sympy.Expr:
    return function_of(quantity, orders)(*arguments)
