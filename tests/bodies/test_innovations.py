"""The triangular root of M of trees by articulated bodies: against the root of M by forward kinematics, in 40 digits,
against Newton-Euler equations of random machines with loops, and against other formulations."""

import mpmath as mp
import numpy as np
import pytest
import sympy
from eigenmotion.codegen import compiler
from eigenmotion.codegen.bodies.innovations import Innovations
from eigenmotion.codegen.bodies.scalar import Scalar
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.equations.tree import link_table
from eigenmotion.codegen.program import kernels
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from tests.oracles.newton_euler import DIGITS
from tests.support.generation import loaded
from tests.support.kinematics import root_matrix
from tests.support.random_machines import Machine

from .machine_checks import Counts, faults
from .test_recursions import Case, close
from .test_trees_in_loops import held_arm, random_model

SEEDS = [0, 2, 6, 7, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(8, 80))]
ARMATURE = (0.5, 0, 2, 0.25, 1, 3)


@pytest.fixture
def always(monkeypatch, tmp_path):
    """Take the root from articulated bodies also where M takes fewer operations; builds are in a cache of their own."""
    monkeypatch.setattr(kernels, "dense_weight", lambda *_: 10**9)
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path))


def is_recursive(model):
    made = compiler.program(model, Choices("cholesky"), whole=False)
    return made.kernels.velocity_of_eta is not None


# -- the recursion ---------------------------------------------------------------------------------------------------


def root(M):
    """R, lower triangular, of M = R^T R: Cholesky's L^T of M in reversed order."""
    n = M.rows
    L = mp.cholesky(mp.matrix([[M[n - 1 - i, n - 1 - j] for j in range(n)] for i in range(n)]))
    return mp.matrix([[L[n - 1 - j, n - 1 - i] for j in range(n)] for i in range(n)])


def masses(case, q):
    """M (n, n) at q, from the kinetic energy by forward kinematics, with the armature."""
    n = case.n
    unit = [[mp.mpf(i == k) for i in range(n)] for k in range(n)]

    def T(v):
        return case.energy("kinetic_energy", q, v)

    alone = [T(one) for one in unit]
    M = [[T([a + b for a, b in zip(unit[i], unit[j], strict=True)]) - alone[i] - alone[j] for j in range(n)]
         for i in range(n)]  # fmt: skip
    return mp.matrix(M) + mp.diag([mp.mpf(one) for one in ARMATURE[:n]])


@pytest.mark.parametrize("seed", SEEDS)
def test_the_recursion_has_the_root_of_M(seed):
    case = Case(seed)
    M, (_, bias) = masses(case, case.state["q"]), case.lagrange()
    if mp.svd_r(M, compute_uv=False)[case.n - 1] < 1e-8:
        pytest.skip("a massless body at the end of a branch: M is singular")
    R, v, u = root(M), mp.matrix(case.state["v"]), mp.matrix(case.state["u"])
    case.state["e"] = list(R * v)
    armature = [Scalar(case.graph, case.graph.number(one)) for one in ARMATURE[: case.n]]
    made = Innovations(case.dynamics, armature, [case.dynamics.zero] * case.n, case.symbols("e"))
    close(case.values(made.v), v)
    close(case.values(made.eta_of(case.symbols("v"))), R * v)
    close(case.values(made.of_forces(case.symbols("u"))), mp.lu_solve(R.T, u))
    a = mp.lu_solve(M, u - bias)
    close(case.values(made.accelerations(case.symbols("u"), case.gravity)), a, 1e-12)
    h = mp.mpf(10) ** -12
    ahead, behind = (
        root(masses(case, [x + s * h * w for x, w in zip(case.state["q"], case.state["v"], strict=True)]))
        for s in (1, -1)
    )
    rates = (ahead - behind) * v / (2 * h) + R * a
    close(case.values(made.eta_rates(case.symbols("u"), case.gravity)), rates, 1e-12)


# -- what is compiled ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", [1, 4, 7, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(8, 40))])
def test_random_machines_with_loops_move_as_newton_and_euler_say(seed, always):
    counts = Counts()
    with mp.workdps(DIGITS):
        machine = Machine(seed)
        system = loaded(compiler.generate(machine.model, Choices("cholesky")), "-O0")
        for v in np.random.default_rng(seed).normal(size=(2, len(machine.q))):
            M, *rest = machine.equations(v)
            known = np.array(M.tolist(), dtype=float)
            R = root_matrix(system, 0.0, machine.x)
            size = np.sqrt(np.outer(np.diag(known), np.diag(known)))
            assert np.abs((R.T @ R - known) / size).max() < 1e-13
            y = system.state(machine.x, v)
            assert abs(y[system.layout["eta"]] @ y[system.layout["eta"]] - v @ known @ v) < 1e-12 * (v @ known @ v)
            back = system.rhs(0.0, y)[: system.n]
            assert np.abs(back - v).max() < 1e-14 * np.linalg.cond(known / size) * np.abs(v).max()
            counts.wrong.extend(faults(system, machine.x, v, (M, *rest), counts))
    assert counts.states > 0
    assert not counts.wrong


def chain(n):
    tree, body = em.Tree(), None
    for k in range(n):
        body = tree.body(f"link_{k}", body, joint="revolute", axis="zy"[k % 2], at=(0.6, 0, 0), mass=1.0,
                         center=(0.3, 0.1, 0), inertia=(0.01, 0.03, 0.04))  # fmt: skip
    return em.Model(name=f"chain_{n}", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, forces={q: -0.1 * q.diff() for q in tree.coordinates},
                    initial=dict.fromkeys(tree.coordinates, 0.2))  # fmt: skip


def test_operations_grow_with_the_number_of_joints():
    costs = []
    for n in (8, 16, 32):
        made = compiler.program(chain(n), Choices("cholesky"), whole=False).kernels
        assert made.velocity_of_eta is not None
        costs.append(np.array(made.published.cost.counts()))
    more = (costs[1] - costs[0]) / 8, (costs[2] - costs[1]) / 16
    assert np.abs(more[1] - more[0]).max() < 0.02 * more[0].max()


def test_the_recursion_is_taken_where_it_has_fewer_operations():
    assert not is_recursive(chain(3))
    assert is_recursive(chain(12))


def rotors():
    """A rotor and a coordinate beside the tree whose inertias vary, a ball joint, and a first-order state."""
    tree = em.Tree()
    arm = tree.body("arm", joint="revolute", axis="y", mass=1.0, center=(0.2, 0, 0), inertia=(0.01, 0.02, 0.02))
    hand = {"mass": 0.5, "center": (0, 0, -0.1), "inertia": (0.01, 0.01, 0.005)}
    tree.body("hand", arm, joint="spherical", at=(0.4, 0, 0), **hand)
    cart, current = dynamicsymbols("cart current")
    q, *s = tree.coordinates
    spring = 15 * (cart - arm.position((0.4, 0, 0))[0]) ** 2
    more = (2 + sympy.cos(q)) * q.diff() ** 2 / 20 + (1 + cart**2) * cart.diff() ** 2
    return em.Model(
        name="rotors", coordinates=[cart, *tree.coordinates], kinetic_energy=tree.kinetic_energy + more,
        potential_energy=tree.potential_energy + spring, forces={q: 0.3 * current - 0.1 * q.diff()},
        states={current: 2 - current - q.diff()}, initial={q: 0.5, s[0]: 0.2, cart.diff(): 1.0},
    )  # fmt: skip


@pytest.mark.parametrize("make", [lambda: chain(4), lambda: held_arm(5), lambda: random_model(3), rotors],
                         ids=["chain", "rows", "branches", "rotors"])  # fmt: skip
def test_the_motion_is_that_of_accelerations(make, always):
    assert is_recursive(make())
    system = em.build(make(), formulation="cholesky")
    run, other = (one.simulate((0, 1), rtol=1e-11, atol=1e-12)
                  for one in (system, em.build(make(), formulation="articulated_body")))  # fmt: skip
    assert run.success
    assert np.abs(run.x[:, -1] - other.x[:, -1]).max() < 1e-8
    for x, v, eta in list(zip(run.x.T, run.v.T, run.eta.T, strict=True))[::20]:
        n = len(x)
        assert eta[:n] @ eta[:n] == pytest.approx(v @ system.mass_matrix(x) @ v, rel=1e-12, abs=1e-14)


def test_masses_in_loops_over_bodies_have_the_same_root(always, monkeypatch, tmp_path):
    straight = em.build(random_model(3), formulation="cholesky")
    monkeypatch.setattr(link_table, "LARGE", 1)
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / "loops"))
    looped = em.build(random_model(3), formulation="cholesky")
    x, v = np.full(straight.n, 0.3), np.linspace(-1, 1, straight.n)
    y = straight.state(x, v)
    assert np.abs(looped.state(x, v) - y).max() < 1e-12 * np.abs(y).max()
    dy = straight.rhs(0.0, y)
    assert np.abs(looped.rhs(0.0, y) - dy).max() < 1e-12 * np.abs(dy).max()


def test_rubbing_contacts_push_along_other_rows(always):
    """A sled with an arm slides on the ground, and stops: friction acts along other rows than those of constraints."""

    def sled():
        tree = em.Tree()
        lift = tree.body("lift", joint="prismatic", axis="z", mass=0.1)
        base = tree.body("base", lift, joint="prismatic", axis="x", mass=2.0)
        tree.body("arm", base, joint="revolute", axis="y", mass=1.0, center=(0.3, 0, 0), inertia=(0.01, 0.03, 0.03))
        z, x, q = tree.coordinates
        return em.Model(name="sled", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                        potential_energy=tree.potential_energy, contacts={"ground": em.Contact(z),
                                  "rub": em.Friction(x.diff(), limit=0.3, normal="ground")},
                        initial={x.diff(): 2.0, q: 0.4})  # fmt: skip

    runs = [em.build(sled(), formulation=one).simulate((0, 1.5), rtol=1e-10, atol=1e-12)
            for one in ("cholesky", "articulated_body")]  # fmt: skip
    assert all(run.success for run in runs)
    assert np.abs(runs[0].x[:, -1] - runs[1].x[:, -1]).max() < 1e-7


def test_lanes_go_the_same_way(always):
    system = em.build(random_model(3), formulation="cholesky")
    starts = {system.coordinates[0]: np.linspace(0.1, 0.2, 6)}
    many = em.simulate_ensemble(system, (0, 0.3), x0=starts, rtol=1e-9, method="dop853")
    for value, end in zip(starts[system.coordinates[0]], many.x[..., -1], strict=True):
        one = system.simulate((0, 0.3), x0={system.coordinates[0]: value}, rtol=1e-9, method="dop853")
        assert np.abs(one.x[:, -1] - end).max() < 1e-8
