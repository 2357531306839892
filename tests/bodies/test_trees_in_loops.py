"""Trees whose recursions C computes in loops, against straight-line code and the proof by forward kinematics."""

import numpy as np
import pytest
from eigenmotion.codegen.equations.derive import derive
from eigenmotion.codegen.equations.tree import link_table
from eigenmotion.codegen.program import lower

import eigenmotion as em
from eigenmotion.building.verification import verdict
from tests.support.random_trees import RandomTree


def random_model(seed, driven=False):
    """A random tree with a mass at the end of each branch, a rotor, a damper and an output."""
    made = RandomTree(seed, most=9, driven=driven)
    tree, last = made.tree, made.bodies[-1]
    for body in made.bodies:
        tree.body(f"load of {body.name}", body, joint="fixed", at=(0.2, 0.1, 0), mass=0.7, inertia=(0.1, 0.2, 0.15))
    tree.body("base", joint="fixed", at=(0.3, 0, 1), mass=2.0, center=(0, 0, 0.5))
    q, tip = tree.coordinates[0], last.position((1, 2, 3))
    return em.Model(name=f"loops{seed}", coordinates=tree.coordinates, parameters=made.parameters,
                    kinetic_energy=tree.kinetic_energy + 0.3 * q.diff() ** 2,
                    potential_energy=tree.potential_energy + 2 * tip.dot(tip),
                    forces={one: -0.1 * one.diff() for one in tree.coordinates},
                    outputs={"x": tip[0], "v": last.velocity((1, 2, 3))[1]})  # fmt: skip


def held_arm(n):
    """An arm whose end is held at its place by two rows."""
    tree, body = em.Tree(), None
    for k in range(n):
        body = tree.body(f"link_{k}", body, joint="revolute", axis="y", at=(0.5, 0, 0) if k else (0, 0, 0),
                         mass=1.0, center=(0.25, 0, 0), inertia=(0.001, 0.02, 0.02))  # fmt: skip
    x, _, z = body.position((0.5, 0, 0))
    start = {q: 0.3 * (-1) ** k for k, q in enumerate(tree.coordinates)}
    return em.Model(name=f"held{n}", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, initial=start,
                    nonholonomic_constraints=[x.diff(em.t), z.diff(em.t)])  # fmt: skip


@pytest.fixture
def loops(monkeypatch, tmp_path):
    """Make trees of any size loop, their accelerations too if asked; builds are in a cache of their own."""

    def chosen(solves):
        monkeypatch.setattr(link_table, "LARGE", 1)
        monkeypatch.setattr(link_table, "LARGEST", 0 if solves else 64)
        monkeypatch.setattr(link_table, "LONGEST", 0)
        monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / str(solves)))

    return chosen


def states(n, count=5):
    chance = np.random.default_rng(n)
    return zip(chance.uniform(-0.6, 0.6, (count, n)), chance.uniform(-1, 1, (count, n)), strict=True)


def assert_the_same(first, second):
    """Both have the same terms, to rounding of the condition of M."""
    for x, v in states(first.n):
        M, N = first.mass_matrix(x), second.mass_matrix(x)
        size = np.sqrt(np.outer(np.diag(N), np.diag(N)))
        assert np.abs((M - N) / size).max() < 1e-13
        (a, *_), (b, *_) = first.acceleration(x, v), second.acceleration(x, v)
        unit = np.sqrt(np.diag(N))
        condition = np.linalg.cond(N / size)
        assert np.abs((a - b) * unit).max() < 1e-14 * condition * max(1.0, np.abs(b * unit).max())
        assert first.energy(x, v) == pytest.approx(second.energy(x, v), rel=1e-13, abs=1e-12)


@pytest.mark.parametrize("solves", [False, True])
@pytest.mark.parametrize("seed", [3, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in (8, *range(12, 40)))])
def test_random_trees_have_the_terms_of_straight_line_code(loops, seed, solves):
    straight = em.build(random_model(seed), formulation="lagrange")
    loops(solves)
    assert_the_same(em.build(random_model(seed), formulation="articulated_body"), straight)


@pytest.mark.parametrize("seed", [2, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(3, 20))])
def test_bodies_that_other_joints_drive_loop_too(loops, seed):
    straight = em.build(random_model(seed, driven=True), formulation="lagrange")
    loops(True)
    assert_the_same(em.build(random_model(seed, driven=True), formulation="articulated_body"), straight)


def test_the_length_of_straight_line_code_decides():
    """Accelerations are loops where n (1 + rows) exceeds 300, but for 64 coordinates and fewer."""
    for n, rows, loop in ((64, 50, False), (65, 2, False), (120, 2, True), (300, 0, False), (301, 0, True)):
        assert link_table.accelerations_loop(n, rows) == loop
    assert not derive(held_arm(65), may_loop=True).trees.table.solves


@pytest.mark.parametrize("solves", [False, True])
def test_rows_hold_trees_in_loops(loops, solves):
    straight = em.build(held_arm(5), formulation="lagrange").simulate((0, 1), rtol=1e-10)
    loops(solves)
    run = em.build(held_arm(5), formulation="articulated_body").simulate((0, 1), rtol=1e-10)
    assert run.success
    assert np.abs(run.x[:, -1] - straight.x[:, -1]).max() < 1e-7
    assert np.abs(run.multipliers[:, 0] - straight.multipliers[:, 0]).max() < 1e-9 * np.abs(run.multipliers).max()


@pytest.mark.parametrize("solves", [False, True])
def test_trees_in_loops_run_in_lanes(loops, solves):
    loops(solves)
    system = em.build(random_model(3), formulation="articulated_body")
    starts = {system.coordinates[0]: np.linspace(0.1, 0.2, 6)}
    many = em.simulate_ensemble(system, (0, 0.3), x0=starts, rtol=1e-9, method="dop853")
    for value, end in zip(starts[system.coordinates[0]], many.x[..., -1], strict=True):
        one = system.simulate((0, 0.3), x0={system.coordinates[0]: value}, rtol=1e-9, method="dop853")
        assert np.abs(one.x[:, -1] - end).max() < 1e-8


def turned(axis, angle):
    """The rotation by an angle about an axis of the frame."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[[i, j], [i, j]], R[j, i] = np.cos(angle), np.sin(angle)
    R[i, j] = -R[j, i]
    return R


def past_gimbal_lock(miss):
    """x, v of a ball in two massless rings, which turns about y with 1 rad/s and is close to gimbal lock at 0.5 s."""
    R = turned(1, -0.5) @ turned(0, miss)
    x = np.array([np.arctan2(R[0, 2], -R[1, 2]), np.arccos(R[2, 2]), np.arctan2(R[2, 0], R[2, 1])])
    axes = np.column_stack([(0, 0, 1), (np.cos(x[0]), np.sin(x[0]), 0), R[:, 2]])
    return x, np.linalg.solve(axes, (0, 1, 0))


@pytest.mark.parametrize("solves", [False, True])
@pytest.mark.parametrize(("miss", "rtol", "right"), [(1e-6, 1e-6, True), (1e-6, 1e-8, False), (1e-3, 1e-8, True)])
def test_pivots_of_bodies_tell_gimbal_lock(loops, solves, miss, rtol, right):
    """In one run and in lanes: where the inertia of a ring is lost in rounding, the run ends and names it."""
    loops(solves)
    tree = em.Tree(gravity=(0, 0, 0))
    ring = tree.body("outer", joint="revolute", axis="z", mass=0.0)
    ring = tree.body("inner", ring, joint="revolute", axis="x", mass=0.0)
    tree.body("ball", ring, joint="revolute", axis="z", mass=1.0, inertia=(0.4, 0.4, 0.4))
    model = em.Model(name="ball_in_rings", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     initial=dict(zip(tree.coordinates, (0.1, 0.7, 0.2), strict=True)))  # fmt: skip
    system, (x0, v0) = em.build(model, formulation="articulated_body"), past_gimbal_lock(miss)
    given = {"v0": v0, "rtol": rtol, "method": "dop853"}
    one = system.simulate((0, 1), x0=x0, **given)
    many = em.simulate_ensemble(system, (0, 1), x0=np.tile(x0, (9, 1)), **given)
    assert [one.success, *many.success] == [right] * 10
    for found in (one, *many):
        if right:
            a, b, c = found.x[:, -1]
            off = turned(2, a) @ turned(0, b) @ turned(2, c) - turned(1, 0.5) @ turned(0, miss)
            assert np.abs(off).max() < 1000 * rtol
        else:
            assert found.stop is em.StopReason.SINGULAR_MASS_MATRIX


def test_derivatives_of_a_tree_in_loops_are_those_of_straight_line_code(loops):
    straight = em.build(random_model(3), formulation="lagrange")
    x, v = np.full((2, straight.n), 0.1)
    loops(False)
    linear = em.build(random_model(3), formulation="articulated_body").linearize(x, v)
    assert np.abs(linear.A - straight.linearize(x, v).A).max() < 1e-10 * np.abs(linear.A).max()


LIGHT = {
    "empty": {"joint": "revolute", "axis": "x"},
    "on its axis": {"joint": "revolute", "axis": (1, 2, 3), "mass": 1.0, "center": (0.1, 0.2, 0.3)},
    "a point": {"joint": "spherical", "mass": 1.0, "center": (0.1, 0.2, 0.3)},
}


@pytest.mark.parametrize("kind", LIGHT)
@pytest.mark.parametrize("solves", [False, True])
def test_a_coordinate_without_mass_is_refused(loops, solves, kind):
    loops(solves)
    tree = em.Tree()
    arm = tree.body("arm", joint="revolute", axis="y", mass=1.0, center=(0.3, 0, 0))
    tree.body("hand", arm, at=(0.6, 0, 0), **LIGHT[kind])
    model = em.Model(name="light", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy)
    with pytest.raises(em.ModelError, match=r"'hand.*' moves no mass"):
        em.build(model, formulation="articulated_body")


def test_the_proof_refuses_a_wrong_table(loops, monkeypatch):
    """An entry of the table that is off by a millionth is an error, although M v is compared, and not each entry."""
    loops(True)
    monkeypatch.setattr(verdict, "FEW", 1)
    right = lower.numbers_of
    monkeypatch.setattr(lower, "numbers_of", lambda *given: [one * (1 + 1e-6 * (k == 14)) for k, one in enumerate(
        right(*given))])  # fmt: skip
    with pytest.raises(em.ProofError, match="kinetic_energy"):
        em.build(held_arm(3), formulation="articulated_body")
