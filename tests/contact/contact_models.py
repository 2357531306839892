"""The bodies of `contact_cases` as models of the package, every number a parameter; runs in numbers of order one."""

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from sympy import Expr, Matrix, Symbol, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, System, t

from ..oracles.feet import angular
from ..support.generation import system_for
from .contact_cases import Case, Shape

LETTERS = "xyz"


@cache
def model_for(shape: Shape) -> Model:
    """Return the model of a shape."""
    where = dynamicsymbols("x y") if shape.planar else dynamicsymbols("x y z")
    angles = dynamicsymbols("c") if shape.planar else dynamicsymbols("a b c")
    turns = [angles] if shape.planar else list(angles)
    R, omega, axes = attitude(turns)
    J = symbols("J1:4", positive=True)
    m, rest = Symbol("m", positive=True), Symbol("rest", nonnegative=True)
    inertia = [J[2]] if shape.planar else list(J)
    centre = Matrix([*where, *[0] * (3 - len(where))])
    parameters: dict[Expr, float] = {m: 1.0, rest: 1e-6} | dict.fromkeys(inertia, 1.0)
    force = [Symbol(f"F{letter}") for letter in LETTERS[: len(where)]]
    torque = [Symbol(f"T{letter}") for letter in (LETTERS if len(turns) == 3 else "z")]
    parameters |= dict.fromkeys([*force, *torque], 0.0)
    generalised = list(torque) if shape.planar else list(axes.T * Matrix(torque))
    contacts = entries(shape, centre, R, parameters, rest)
    coordinates = [*where, *turns]
    T = m * sum(x.diff() ** 2 for x in where) / 2 + sum(j * w**2 for j, w in zip(inertia, omega, strict=True)) / 2
    return Model(
        name=shape.name, coordinates=coordinates, kinetic_energy=T,
        forces=dict(zip(coordinates, [*force, *generalised], strict=True)), contacts=contacts, parameters=parameters,
        outputs={f"a{x.func.__name__}": x.diff(t, 2) for x in coordinates},
    )  # fmt: skip


def attitude(turns: list[Expr]) -> tuple[Matrix, list[Expr], Matrix]:
    """Return R, angular velocity in the body's axes, and the axes of the angles in fixed ones."""
    if len(turns) == 1:
        (c,) = turns
        return Matrix([[cos(c), -sin(c), 0], [sin(c), cos(c), 0], [0, 0, 1]]), [c.diff()], Matrix([0, 0, 1])
    a, b, c = turns
    Rx = Matrix([[1, 0, 0], [0, cos(a), -sin(a)], [0, sin(a), cos(a)]])
    Ry = Matrix([[cos(b), 0, sin(b)], [0, 1, 0], [-sin(b), 0, cos(b)]])
    Rz = Matrix([[cos(c), -sin(c), 0], [sin(c), cos(c), 0], [0, 0, 1]])
    p, q, r = (angle.diff() for angle in turns)
    own = [p * cos(b) * cos(c) + q * sin(c), -p * cos(b) * sin(c) + q * cos(c), p * sin(b) + r]
    return Rx * Ry * Rz, own, Matrix.hstack(Matrix([1, 0, 0]), Rx[:, 1], (Rx * Ry)[:, 2])


def entries(shape: Shape, centre: Matrix, R: Matrix, parameters: dict[Expr, float], rest: Expr) -> dict[str, Any]:
    """Return contacts and frictions; what they are made of goes into the parameters."""
    kept, found = LETTERS[:2] if shape.planar else LETTERS, {}

    def number(name: str, value: float = 0.0, **assumed: bool) -> Expr:
        symbol = Symbol(name, **assumed)
        parameters[symbol] = value
        return symbol

    def vector(name: str, value: float = 0.0) -> Matrix:
        return Matrix([number(f"{name}{letter}", value) if letter in kept else 0 for letter in LETTERS])

    for k in range(shape.contacts + shape.brakes):
        at = centre + R * vector(f"u{k}", 0.1 * k)
        if k < shape.contacts:
            level = number(f"d{k}") + number(f"r{k}") * t + number(f"s{k}") * t**2 / 2
            gap = vector(f"n{k}", 0.6).dot(at) - level
            law = {} if shape.law == "newton" else {"law": shape.law}
            found[f"foot{k}"] = Contact(gap, number(f"e{k}", nonnegative=True), rest, **law)
        if k < shape.rubs or k >= shape.contacts:
            slips = [
                vector(f"t{k}{way}", 0.7 - 0.3 * way).dot(at).diff(t) - number(f"b{k}{way}") - number(f"p{k}{way}") * t
                for way in range(shape.ways)
            ]
            limit = number(f"mu{k}", 0.5, nonnegative=True)
            more = {"limit_at_rest": number(f"nu{k}", 0.6, nonnegative=True)} if shape.unequal else {}
            normal = f"foot{k}" if k < shape.contacts else None
            found[f"rub{k}"] = Friction(tuple(slips) if shape.cone else slips[0], limit, normal, **more)
    return found


@cache
def shaped(shape: Shape, formulation: str = "lagrange") -> System:
    return system_for(model_for(shape), formulation)


@dataclass(frozen=True)
class Scaled:
    """A case in the units it is run in: parameters, x0, v0 by coordinate, tolerances, and the unit of its time."""

    parameters: dict[str, float]
    x0: dict[str, float]
    v0: dict[str, float]
    atol: dict[str, float]
    time: float


def scaled(case: Case) -> Scaled:
    length, mass, time = case.units
    speed, push, angles = length / time, mass * length / time**2, "c" if case.shape.planar else "abc"
    body, kept = case.body, LETTERS[:2] if case.shape.planar else LETTERS
    values = {"m": body.m * mass, "rest": body.rest * speed}
    values |= {f"J{k + 1}": body.J[k] * mass * length**2 for k in ([2] if case.shape.planar else [0, 1, 2])}
    values |= {f"F{letter}": body.force[k] * push for k, letter in enumerate(kept)}
    turned = [2] if case.shape.planar else [0, 1, 2]
    values |= {f"T{LETTERS[k]}": body.torque[k] * push * length for k in turned}
    for k, foot in enumerate(body.feet):
        g = foot.ground
        values |= {f"u{k}{letter}": foot.at[i] * length for i, letter in enumerate(kept)}
        if foot.presses:
            values |= {f"n{k}{letter}": g.normal[i] for i, letter in enumerate(kept)} | {f"e{k}": foot.e}
            values |= {f"d{k}": g.level * length, f"r{k}": g.rate * speed, f"s{k}": g.lift * speed / time}
        for way, along in enumerate(g.along):
            values |= {f"t{k}{way}{letter}": along[i] for i, letter in enumerate(kept)}
            values |= {f"b{k}{way}": g.belt[way] * speed, f"p{k}{way}": g.pull[way] * speed / time}
        if len(g.along):
            values[f"mu{k}"] = foot.drag * (1.0 if foot.presses else push)
            if case.shape.unequal:
                values[f"nu{k}"] = foot.grip * (1.0 if foot.presses else push)
    x0 = {letter: case.x[i] * length for i, letter in enumerate(kept)} | {
        a: case.angles["abc".index(a)] for a in angles
    }
    v0 = {letter: case.u[i] * speed for i, letter in enumerate(kept)} | {
        a: case.rates["abc".index(a)] / time for a in angles
    }
    atol = dict.fromkeys(kept, 1e-11 * length) | dict.fromkeys(angles, 1e-11)
    return Scaled({k: float(v) for k, v in values.items()}, x0, v0, atol, time)


@dataclass(frozen=True)
class Row:
    """What a run says at one time, of order one: x (3,), angles (3,), u (6,), accelerations (6,)."""

    t: float
    x: np.ndarray
    angles: np.ndarray
    u: np.ndarray
    a: np.ndarray


def row(case: Case, t: float, x: np.ndarray, v: np.ndarray, a: np.ndarray) -> Row:
    """Return a row of a run of the scaled case: coordinates, rates and second derivatives (n,)."""
    length, _, time = case.units
    n = 2 if case.shape.planar else 3
    position, speed, push = (np.append(part[:n] / unit, [0.0] * (3 - n))
                             for part, unit in ((x, length), (v, length / time), (a, length / time**2)))  # fmt: skip
    angles, rates, seconds = (np.append([0.0] * (n == 2) * 2, part[n:] * unit)
                              for part, unit in ((x, 1.0), (v, time), (a, time**2)))  # fmt: skip
    omega, alpha = angular(angles, rates, seconds)
    return Row(t / time, position, angles, np.append(speed, omega), np.append(push, alpha))


def rows_of(case: Case, run: Any) -> list[Row]:
    """Return all rows of a run."""
    seconds = np.array([run.outputs[f"a{name}"] for name in scaled(case).x0])
    return [row(case, *one) for one in zip(run.t, run.x.T, run.v.T, seconds.T, strict=True)]


def simulated(case: Case, span: float, formulation: str = "lagrange", **options: Any) -> em.Solution:
    """Run a case for a span in its own unit of time."""
    one = scaled(case)
    return shaped(case.shape, formulation).simulate(
        (0.0, span * one.time),
        x0=one.x0,
        v0=one.v0,
        parameters=one.parameters,
        **{"rtol": 1e-9, "atol": one.atol, "max_steps": 5_000} | options,
    )
