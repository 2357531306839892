"""One random mechanism with first-order states: as one whose states are inputs, and the rates by themselves."""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import sympy
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, t

from ..oracles import Lagrange
from ..support.generation import FORMULATIONS, loaded, relative
from ..support.random_mechanisms import Maker, State
from .mechanism_checks import LIMIT, STATES, Counts, Right

Expr = sympy.Expr


def made(seed: int) -> tuple[Model, Model]:
    """Return a mechanism with one to three states, and the same with inputs in their place."""
    maker, drawn = Maker(seed), random.Random(seed)
    plain = maker.model()
    z = dynamicsymbols(f"z_1:{drawn.choice((2, 3, 4))}", real=True) if maker.real else list(
        dynamicsymbols(f"z_1:{drawn.choice((2, 3, 4))}")
    )  # fmt: skip
    forces = dict(zip(plain.coordinates, plain.forces, strict=True))
    for one in z:
        forces[drawn.choice(maker.q)] += maker.factor() * drawn.choice(
            (one, sympy.sin(one), one * drawn.choice(maker.v))
        )
    extra = maker.factor() * drawn.choice((0, z[0], z[0] ** 2))
    rates = {one: _rate(maker, drawn, z) for one in z}
    model = replace(plain, forces=forces, potential_energy=plain.potential_energy + extra, states=rates)
    pulls = {q: force - extra.diff(q) for q, force in forces.items()}
    return model, replace(plain, forces=pulls, inputs=[*plain.inputs, *((one, 0.0) for one in z)])


def _rate(maker: Maker, drawn: random.Random, z: list[Expr]) -> Expr:
    one, v = drawn.choice(z), drawn.choice(maker.v)
    terms = [maker.factor(), v * maker.factor(), v**2 * one, -maker.k * one, sympy.tanh(one + v), maker.size(v) * one,
             maker.coordinate() * drawn.choice(z), sympy.cos(maker.a * t)]  # fmt: skip
    return sympy.Add(*drawn.sample(terms, drawn.randint(1, 4)))


def check(seed: int, counts: Counts, formulations: Iterable[str] = FORMULATIONS, *flags: str) -> None:
    """Judge the mechanism of one seed."""
    maker = Maker(seed)
    model, plain = made(seed)
    right, motion, rates = Right(plain), Lagrange(plain), _Rates(model)
    places = [(maker.state(), np.random.default_rng([seed, k]).normal(size=len(model.states))) for k in range(STATES)]
    counts.mechanisms += 1
    for formulation in formulations:
        try:
            system = loaded(compiler.generate(model, Choices(formulation)), *flags, runs=False)
            counts.systems += 1
            for at, z in places:  # NumPy passes through roots that a Piecewise does not choose
                with np.errstate(all="ignore"):
                    counts.wrong.extend(f"states {seed}, {formulation}: {fault}"
                                    for fault in _faults(system, right, motion, rates, at, z, counts))  # fmt: skip
        except Exception as error:
            counts.wrong.append(f"states {seed}, {formulation}: {type(error).__name__}: {str(error)[-600:]}")


class _Rates:
    """The rates of a model's states in NumPy."""

    def __init__(self, model: Model) -> None:
        self.names = [str(p) for p, _ in model.parameters]
        functions = (*model.rates, *model.coordinates, *(z for z, _ in model.states), *(u for u, _ in model.inputs))
        symbols = [sympy.Dummy() for _ in functions]
        plain = dict(zip(functions, symbols, strict=True))
        rates = [rate.xreplace(plain) for _, rate in model.states]
        self.function = sympy.lambdify([symbols, [p for p, _ in model.parameters], t], rates)

    def __call__(self, at: State, z: np.ndarray) -> np.ndarray:
        values = [*at.v, *at.x, *z, *at.inputs.values()]
        return np.array(self.function(values, [at.parameters[name] for name in self.names], at.time), dtype=float)


def _faults(system: System, right: Right, motion: Lagrange, rates: _Rates, at: State, z: np.ndarray, counts: Counts):
    counts.states += 1
    terms = right.terms(at)
    inputs = at.inputs | dict(zip(system.states, z.tolist(), strict=True))
    condition = right.condition(terms["M"], terms["A"])
    x = np.concatenate([at.x, z])
    if condition < 1e6:
        a, multipliers = motion(at.x, at.v, at.time, at.parameters, inputs)
        found = system.acceleration(x, at.v, at.time, at.parameters, at.inputs)
        for name, one, wanted in zip(("acceleration", "multipliers"), found, (a, multipliers), strict=True):
            counts.numbers += one.size
            if not relative(one, wanted) <= LIMIT * condition:
                yield f"{name} {one} for {wanted}"
        y = system.state(x, at.v, at.time, at.parameters)
        try:
            dy = system.rhs(at.time, y, at.parameters, at.inputs)
        except ValueError:  # eigenvalues that coincide have no published rates
            return
        wanted = rates(at, z)
        counts.numbers += len(z)
        if not relative(dy[system.layout["z"]], wanted, 1.0) <= LIMIT:
            yield f"rates {dy[system.layout['z']]} for {wanted}"
