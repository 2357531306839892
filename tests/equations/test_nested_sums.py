"""Energies of many angles, whose sums are nested: random planar mechanisms of links against Lagrange's equations."""

from functools import cache

import mpmath
import numpy as np
import pytest
import sympy
from eigenmotion.codegen.equations.derive import derive
from eigenmotion.codegen.equations.forms import saves_by_nesting
from eigenmotion.codegen.equations.specialise import specialise
from eigenmotion.codegen.equations.tree.tree_terms import terms_of
from eigenmotion.codegen.model.statement.states import as_mechanism
from eigenmotion.codegen.schedule.schedule import schedule
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, t
from eigenmotion.runtime.variations import motion_derivatives

from ..oracles import Lagrange
from ..support.generation import model_of, relative, system_for
from .test_partial_derivatives import DIGITS, differences, far

m, l, I, g, d = symbols("m l I g d", positive=True)
VALUES = {m: 0.8, l: 0.3, I: 0.01, g: 9.81, d: 0.1}
SEEDS = (1, 2, 3)
ANGLES = 7


def linkage(n: int, seed: int | None = None) -> Model:
    """Return a chain of n pendulums by relative angles; with a seed, a random mechanism.

    Then links branch, mass centres are anywhere on them, some slide along their parents, the pivot shakes in odd
    mechanisms and a rod holds the last link in even ones.
    """
    random = np.random.default_rng(seed)
    q, shaken = dynamicsymbols(f"q_1:{n + 1}"), seed is not None and seed % 2
    ends = [(sympy.S.Zero, sin(2 * t) / 10 if shaken else sympy.S.Zero, sympy.S.Zero)]
    T = V = sympy.S.Zero
    for k, angle in enumerate(q):
        branches, slides = (False, False) if seed is None else random.random(2) < (0.2, 0.2)
        x, y, turn = ends[max(0, k - 1) if branches else k]
        turn, length = (turn, l + angle) if slides else (turn + angle, l)
        along, part = (sin(turn), -cos(turn)), 1 if seed is None else sympy.Rational(int(random.integers(2, 9)), 8)
        xc, yc = (start + part * length * one for start, one in zip((x, y), along, strict=True))
        T += m * (xc.diff(t) ** 2 + yc.diff(t) ** 2) / 2 + I * turn.diff(t) ** 2 / 2
        V += m * g * yc + (10 * angle**2 if slides else 0)
        ends.append((x + length * along[0], y + length * along[1], turn))
    rod = [ends[-1][0] ** 2 + (ends[-1][1] + 1) ** 2 - 1] if seed is not None and not shaken else []
    return Model(
        name=f"linkage_{n}_{seed}", coordinates=q, kinetic_energy=T, potential_energy=V, parameters=VALUES,
        forces={one: -d * one.diff(t) for one in q}, holonomic_constraints=rod,
        outputs={"tip": ends[-1][0], "rise": ends[-1][1].diff(t)},
    )  # fmt: skip


@cache
def mechanism(seed: int) -> Model:
    return linkage(ANGLES, seed)


def state(model: Model, seed: int) -> tuple[np.ndarray, np.ndarray, float]:
    random = np.random.default_rng(seed)
    return random.uniform(-1, 1, model.n), random.normal(size=model.n), random.uniform(0, 2)


# --- the equations ----------------------------------------------------------------------------------------------------


@cache
def lagrange(seed: int) -> Lagrange:
    return Lagrange(mechanism(seed))


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
@pytest.mark.parametrize("seed", SEEDS)
def test_random_linkages(seed, formulation):
    model = mechanism(seed)
    assert saves_by_nesting(as_mechanism(model))
    system = system_for(model, formulation)
    for k in range(3):
        x, v, time = state(model, 10 * seed + k)
        a, multipliers = lagrange(seed)(x, v, time)
        found = system.acceleration(x, v, t=time)
        assert relative(np.concatenate(found), np.concatenate([a, multipliers]), 1.0) < 1e-10


def test_derivatives_of_a_random_linkage():
    model, (x, v, time) = mechanism(SEEDS[0]), state(mechanism(SEEDS[0]), 5)
    with mpmath.workdps(DIGITS):
        oracle = Lagrange(model, "arbitrary")
    names, arguments = list(map(str, VALUES)), [*x, *v, *VALUES.values(), time]

    def moved(z):
        given = dict(zip(names, z[2 * model.n : -1], strict=True))
        return np.concatenate(oracle(z[: model.n], z[model.n : 2 * model.n], z[-1], given))

    system = system_for(model, "lagrange")
    _, _, da, dm = motion_derivatives(system.compiled, time, x, v, system.prepare(None), [], False)
    assert far(np.vstack([da, dm]), differences(moved, arguments), np.maximum(np.abs(arguments), 1.0)) < 1e-11


def test_twenty_relative_angles():
    """M by Jacobians of the places, with numbers; M's rate by a difference of these along the motion."""
    model = linkage(20)
    system, (x, v, _) = system_for(model, "lagrange"), state(model, 8)
    value = {symbol.name: number for symbol, number in VALUES.items()}

    def jacobians(angles):
        turned, ones = np.cumsum(angles), np.tril(np.ones((20, 20)))
        return [value["l"] * ones @ (np.diag(one) @ ones) for one in (np.cos(turned), np.sin(turned))]

    (Jx, Jy), h = jacobians(x), 1e-6
    rates = [(b - a) / (2 * h) for a, b in zip(jacobians(x - h * v), jacobians(x + h * v), strict=True)]
    ones = np.tril(np.ones((20, 20)))
    M = value["m"] * (Jx.T @ Jx + Jy.T @ Jy) + value["I"] * ones.T @ ones
    force = (
        -value["d"] * v
        - value["m"] * (Jx.T @ rates[0] @ v + Jy.T @ rates[1] @ v)
        - (value["m"] * value["g"] * Jy.sum(axis=0))
    )
    assert relative(system.mass_matrix(x).ravel(), M.ravel()) < 1e-13
    a, _ = system.acceleration(x, v)
    assert relative(M @ a, force, np.abs(force).max()) < 1e-8


# --- their operations -------------------------------------------------------------------------------------------------


def operations(model: Model, nested: bool) -> tuple[int, int]:
    """Count the operations of M and of its bias."""
    terms = terms_of(specialise(derive(as_mechanism(model), nested=nested)))
    M = [entry for i, row in enumerate(terms.M) for entry in row[: i + 1]]
    return tuple(schedule(terms.graph, list(map(terms.expanded, one))).cost.weight for one in (M, terms.bias))


def test_operations_grow_like_those_of_recursions():
    """Those of M with n^2, those of its bias with n."""
    few, many = (operations(linkage(n), nested=True) for n in (8, 16))
    assert many[0] < 4.2 * few[0]
    assert many[1] < 2.1 * few[1]


def test_nested_sums_take_fewer_operations_than_those_written_out():
    model = linkage(12)
    assert saves_by_nesting(as_mechanism(model))
    assert sum(operations(model, nested=True)) < 0.55 * sum(operations(model, nested=False))


def test_trees_and_small_models_are_not_rewritten():
    for name in ("robot_arm", "double_pendulum", "pendulum"):
        assert not saves_by_nesting(as_mechanism(model_of(name)))
