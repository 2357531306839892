"""Derivatives of trees in loops: against differences of Newton-Euler equations in 40 digits, and straight-line code."""

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.equations.tree import link_table
from mpmath import mp

import eigenmotion as em
from eigenmotion.runtime.variations import equation_partials, motion_derivatives
from tests.oracles.newton_euler import DIGITS
from tests.support.generation import loaded
from tests.support.random_machines import Machine
from tests.support.random_trees import RandomTree

STEP = 2.0**-10
"""Of central differences of sixth order, by x: their error is about 1e-20 of the seventh derivative."""
WEIGHTS = (45 / 60, -9 / 60, 1 / 60)
LIMIT = 1e-12


def arm(n, **more):
    """A spatial arm with dampers, whose joints turn about y and x in turn; further arguments are those of Model."""
    tree, body = em.Tree(), None
    for k in range(n):
        body = tree.body(f"link_{k}", body, joint="revolute", axis="yx"[k % 2], at=(0.5, 0, 0) if k else (0, 0, 0),
                         mass=1.0, center=(0.25, 0, 0), inertia=(0.001, 0.02, 0.02))  # fmt: skip
    of_tip = {name: build(body.position((0.5, 0, 0))) for name, build in more.items()}
    return em.Model(name=f"arm{n}", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, forces={q: -0.3 * q.diff() for q in tree.coordinates},
                    initial=dict.fromkeys(tree.coordinates, 0.1), **of_tip)  # fmt: skip


@pytest.fixture
def loops(monkeypatch, tmp_path):
    """Return a function that makes trees of any size loop, or none of these; builds are in a cache of their own."""

    def chosen(wanted):
        monkeypatch.setattr(link_table, "LARGE", 1 if wanted else 1000)
        monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / str(wanted)))

    return chosen


def both(loops, model):
    """The model with derivatives in straight-line code, and with those of its tree in loops."""
    systems = []
    for wanted in (False, True):
        loops(wanted)
        text = "".join(one.text for one in compiler.generate(model, Choices("articulated_body")).files)
        assert ("em_add_tree_partials" in text) == wanted
        systems.append(em.build(model, formulation="articulated_body"))
        systems[-1].mass_matrix_gradient(np.zeros(systems[-1].n))  # now, since derivatives are generated on demand
    return systems


def residual_slopes(system, x, v, equations):
    """-(M da + A^T dlambda) and -A da by x, v: the slopes of the residuals of (11) and (39) at fixed a, lambda."""
    c = system.compiled
    a, multipliers, da, dm = motion_derivatives(c, 0.0, x, v, system.prepare(), c.input_defaults, False)
    M, _, A, _ = equations
    M, A = np.array(M.tolist(), dtype=float), np.array(A, dtype=float).reshape(len(A), len(x))
    width = 2 * len(x)
    return a, multipliers, -np.vstack([M @ da[:, :width] + A.T @ dm[:, :width], A @ da[:, :width]])


def residuals(machine, x, v, a, multipliers):
    """M a + A^T lambda - F and A a + b by Newton and Euler, in 40 digits."""
    machine.x = x
    M, F, A, b = machine.equations(v)
    balance = M * mp.matrix(a) - F
    for row, factor in zip(A, multipliers, strict=True):
        balance += mp.matrix([one * factor for one in row])
    return [*balance, *(mp.fdot(row, a) + b[k] for k, row in enumerate(A))]


def differences(function, at, step, weights):
    """Columns of d function / d at, by central differences."""
    columns = []
    for k in range(len(at)):
        column = 0
        for number, weight in enumerate(weights, 1):
            e = number * step * (np.arange(len(at)) == k)
            pairs = zip(function(at + e), function(at - e), strict=True)
            column = column + np.array([weight * (ahead - behind) / step for ahead, behind in pairs])
        columns.append(column.astype(float))
    return np.array(columns).T


@pytest.mark.parametrize("seed", [53, 27, *(pytest.param(seed, marks=pytest.mark.nightly)
                                            for seed in (0, 6, 12, 18, 22, 26, 33, 42, 48, 58))])  # fmt: skip
def test_machines_against_newton_and_euler(monkeypatch, seed):
    """All joints, driven ones, springs, dampers and closed loops."""
    monkeypatch.setattr(link_table, "LARGE", 1)
    with mp.workdps(DIGITS):
        machine = Machine(seed, parametric=False)
        system = loaded(compiler.generate(machine.model, Choices("articulated_body")), "-O0")
        x = np.round(machine.x * 2**10) / 2**10  # so that steps are exact
        v = np.round(np.random.default_rng(seed).normal(size=len(x)) * 2**10) / 2**10
        machine.x = x
        a, multipliers, found = residual_slopes(system, x, v, machine.equations(v))
        by_x = differences(lambda at: residuals(machine, at, v, a, multipliers), x, STEP, WEIGHTS)
        by_v = differences(lambda at: residuals(machine, x, at, a, multipliers), v, 1.0, (0.5,))  # quadratic in v
    right = np.hstack([by_x, by_v])
    size = np.maximum(np.abs(right).max(axis=1, keepdims=True), 1e-3 * np.abs(right).max())
    assert (np.abs(found - right) / size).max() < LIMIT
    D = equation_partials(system.compiled, 0.0, x, v, a, multipliers, system.prepare(), [])
    assert (np.abs(D[:, : 2 * len(x)] - right) / size).max() < LIMIT


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("seed", [3, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in (4, *range(8, 30)))])
def test_random_trees_have_the_derivatives_of_straight_line_code(loops, seed, driven):
    made = RandomTree(seed, most=9, driven=driven, parametric=False)
    for body in made.bodies:
        made.tree.body(f"load of {body.name}", body, joint="fixed", at=(0.2, 0.1, 0), mass=0.7,
                       inertia=(0.1, 0.2, 0.15))  # fmt: skip
    q, tip = made.tree.coordinates[0], made.bodies[-1].position((1, 2, 3))
    model = em.Model(name=f"partials{seed}", coordinates=made.tree.coordinates,
                     kinetic_energy=made.tree.kinetic_energy + 0.3 * q.diff() ** 2,
                     potential_energy=made.tree.potential_energy + 2 * tip.dot(tip),
                     forces={one: -0.1 * one.diff() for one in made.tree.coordinates})  # fmt: skip
    straight, looped = both(loops, model)
    chance = np.random.default_rng(seed)
    for _ in range(3):
        x, v = chance.uniform(-0.6, 0.6, straight.n), chance.uniform(-1, 1, straight.n)
        M, dM = straight.mass_matrix(x), straight.mass_matrix_gradient(x)
        assert np.abs(looped.mass_matrix_gradient(x) - dM).max() < LIMIT * max(np.abs(dM).max(), np.abs(M).max())
        J, found = (M @ one.jacobian(0.0, [*x, *v])[one.n :] for one in (straight, looped))
        assert np.abs(found - J).max() < LIMIT * np.abs(J).max()


def test_trees_with_parameters_keep_straight_line_code(loops):
    """The loops know no derivatives by parameters."""
    loops(True)
    made = RandomTree(3, most=5)
    assert made.parameters
    model = em.Model(name="parametric", coordinates=made.tree.coordinates, parameters=made.parameters,
                     kinetic_energy=made.tree.kinetic_energy, potential_energy=made.tree.potential_energy)  # fmt: skip
    text = "".join(one.text for one in compiler.generate(model, Choices("articulated_body")).files)
    assert "em_add_tree_energies" in text
    assert "em_add_tree_partials" not in text


@pytest.mark.parametrize("method", ["dop853", "radau9"])
def test_sensitivities_through_an_impact(loops, method):
    """The tip of an arm strikes the floor."""
    model = arm(3, events=lambda tip: {"floor": em.Event(tip[2] + 0.6, direction=-1, impact=(tip[2], 0.5))})
    runs = [system.simulate((0, 0.6), method=method, sensitivities=["link_0", "link_2"], rtol=1e-10, atol=1e-12)
            for system in both(loops, model)]  # fmt: skip
    assert len(runs[0].t_events[0]) == len(runs[1].t_events[0]) > 0
    for name in ("link_0", "link_2"):
        one, other = (run.sensitivity[name] for run in runs)
        assert np.abs(one.dx[:, -1] - other.dx[:, -1]).max() < 1e-7 * np.abs(one.dx).max()
        assert one.dt_events[0] == pytest.approx(other.dt_events[0], rel=1e-8)


def test_the_end_of_a_long_arm_by_its_start():
    """Against a difference of two runs; radau9 solves with the derivatives, too."""
    system, names = em.build(arm(20)), ["link_0", "link_19"]
    options = {"method": "radau9", "rtol": 1e-11, "atol": 1e-12}
    run = system.simulate((0, 0.1), sensitivities=names, **options)
    explicit = system.simulate((0, 0.1), method="dop853", rtol=1e-11, atol=1e-12)
    assert np.abs(run.x[:, -1] - explicit.x[:, -1]).max() < 1e-9
    for name in names:
        ends = [system.simulate((0, 0.1), x0={name: 0.1 + step}, **options).x[:, -1] for step in (1e-4, -1e-4)]
        right = (ends[0] - ends[1]) / 2e-4
        assert np.abs(run.sensitivity[name].dx[:, -1] - right).max() < 1e-6 * np.abs(right).max()
