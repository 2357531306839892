"""Mechanisms that lean, stand and stick: what equilibria and linearisations of contacts are tried on."""

from functools import cache

from sympy import Expr, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Friction, Model, System, t

from ..support.generation import system_for

m, l, J, b, h, k = symbols("m l J b h k", positive=True)
g, mu, al, wall, F = symbols("g mu al wall F", real=True)
x, y, p, q = dynamicsymbols("x y p q")


@cache
def leaning() -> System:
    """A pendulum, and another below it; the upper one leans on a wall."""
    first, second = (sin(p), -cos(p)), (sin(p) + l * sin(q), -cos(p) - l * cos(q))
    T = sum(place.diff(t) ** 2 for place in (*first, *second)) / 2
    return system_for(
        Model(name="leaning", coordinates=[p, q], kinetic_energy=T, potential_energy=g * (first[1] + second[1]),
              parameters={g: 9.81, l: 0.6, wall: 0.1}, initial={p: 0.1},
              contacts={"wall": Contact(p - wall, rest=0.01)}),
        "lagrange",
    )  # fmt: skip


@cache
def pendulum() -> System:
    return system_for(
        Model(name="alone", coordinates=[p], kinetic_energy=p.diff() ** 2 / 2, potential_energy=-g * cos(p),
              parameters={g: 9.81, wall: 0.1}, initial={p: 0.1}, contacts={"wall": Contact(p - wall, rest=0.01)}),
        "lagrange",
    )  # fmt: skip


@cache
def block(contact: bool) -> System:
    """On an incline; its normal force by a contact, or by hand."""
    kinetic = m * (x.diff() ** 2 + y.diff() ** 2) / 2 if contact else m * x.diff() ** 2 / 2
    rub = {"floor": Contact(y), "rub": Friction(x.diff(), limit=mu, normal="floor")}
    alone = {"rub": Friction(x.diff(), limit=mu * m * g * cos(al))}
    return system_for(
        Model(name=f"block_{contact:d}", coordinates=[x, y] if contact else [x], kinetic_energy=kinetic,
              potential_energy=m * g * ((y * cos(al) if contact else 0) - x * sin(al)), initial={x: 0.7},
              parameters={m: 2.0, g: 9.81, al: 0.3, mu: 0.5}, contacts=rub if contact else alone),
        "lagrange",
    )  # fmt: skip


def box(feet: str) -> Model:
    """A box whose two feet are contacts, or constraints; in it a mass on a spring, at its height."""

    def foot(side: int) -> tuple[Expr, Expr]:
        return x + side * b * cos(p) + h * sin(p), y + side * b * sin(p) - h * cos(p)

    left, right = foot(-1), foot(1)
    T = m * (x.diff() ** 2 + y.diff() ** 2) / 2 + J * p.diff() ** 2 / 2 + (x.diff() + q.diff()) ** 2 / 2
    contacts = {"left": Contact(left[1], rest=0.01), "right": Contact(right[1], rest=0.01),
                "rub": Friction(left[0].diff(t), limit=mu, normal="left")}  # fmt: skip
    held = {"contacts": contacts} if feet == "contacts" else {
        "holonomic_constraints": [left[1], right[1]], "nonholonomic_constraints": [left[0].diff(t)]}  # fmt: skip
    numbers = {m: 1.0, g: 9.81, b: 0.3, h: 0.5, J: 0.2, k: 7.0}
    return Model(name=f"box_on_{feet}", coordinates=[x, y, p, q], kinetic_energy=T, initial={y: 0.5},
                 potential_energy=m * g * y + k * q**2 / 2,
                 parameters=numbers | ({mu: 0.6} if feet == "contacts" else {}), **held)  # fmt: skip


@cache
def ladder() -> System:
    return system_for(
        Model(name="ladder", coordinates=[x, y, p], potential_energy=m * g * y,
              initial={p: 1.2, x: cos(1.2), y: sin(1.2)},
              kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2 + J * p.diff() ** 2 / 2,
              contacts={"floor": Contact(y - l * sin(p), rest=0.01), "wall": Contact(x - l * cos(p), rest=0.01),
                        "rub": Friction((x + l * cos(p)).diff(t), limit=mu, normal="floor")},
              parameters={m: 1.0, g: 9.81, l: 1.0, J: 1 / 3, mu: 0.4}),
        "lagrange",
    )  # fmt: skip


@cache
def beam() -> System:
    return system_for(
        Model(name="beam", coordinates=[y, p], kinetic_energy=m * y.diff() ** 2 / 2 + J * p.diff() ** 2 / 2,
              potential_energy=m * g * y, forces={p: F}, parameters={m: 1.0, g: 9.81, l: 1.0, J: 0.3, F: 0.0},
              contacts={"left": Contact(y - l * sin(p)), "mid": Contact(y), "right": Contact(y + l * sin(p))}),
        "lagrange",
    )  # fmt: skip


@cache
def dragged() -> System:
    """A mass on a spring, with dry friction."""
    return system_for(
        Model(name="dragged", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=k * x**2 / 2,
              parameters={k: 10.0, F: 2.0}, contacts={"rub": Friction(x.diff(), limit=F)}),
        "lagrange",
    )  # fmt: skip
