"""The oracle of contacts and frictions against what is solved by hand; nothing of the package takes part."""

import numpy as np
import pytest

from ..oracles.contact_check import off
from ..oracles.contact_cones import solutions
from ..oracles.contact_impacts import Strike, struck
from ..oracles.contact_problem import NONE, Problem, Rub
from ..oracles.feet import State, point, problem, turned
from .contact_cases import Case, Shape, drawn

G = 9.81


def rub(row, mu, normal=0, slip=0.0, bias=0.0, grip=None, force=0.0):
    """A friction of coefficient mu on a contact, or of a force on none."""
    grip = mu if grip is None else grip
    return Rub(
        np.atleast_2d(np.array(row, float)),
        np.atleast_1d(bias),
        (force, grip),
        (force, mu),
        normal,
        np.atleast_1d(slip),
    )


def accelerations(one: Problem) -> list[np.ndarray]:
    """All of them; that each satisfies the law is looked at once more without modes."""
    found = solutions(one)
    assert found.clear
    assert all(off(one, each.a) < 1e-9 for each in found.found)
    return [each.a for each in found.found]


def rod(leans: float, mu: float, slides: float, turns: float = 0.0) -> Problem:
    """Painleve's: a slender rod of mass 1 and half length 1, its tip on the floor, leaning by an angle from upright."""
    r = -np.array([np.sin(leans), np.cos(leans)])
    N, T = np.array([[0, 1, r[0]]]), [1, 0, -r[1]]
    return Problem(
        np.diag([1, 1, 1 / 3]),
        np.array([0, -G, 0]),
        N,
        -(turns**2) * r[1:],
        (rub(T, mu, slip=slides, bias=-(turns**2) * r[0]),),
    )


@pytest.mark.parametrize(("way", "turns", "count"), [(1, 0, 1), (1, 3, 1), (-1, 0, 0), (-1, 6, 2)])
def test_painleves_rod(way, turns, count):
    """p (1 + 3 s (s +- mu c)) = g - w^2 c: beyond mu = (1 + 3 s^2) / (3 s c) it jams or leaps."""
    s, c, mu = np.sin(0.6), np.cos(0.6), 2.0
    factor = 1 + 3 * s * (s + way * mu * c)
    found = accelerations(rod(0.6, mu, way, turns))
    assert len(found) == count
    pressed = [a for a in found if abs(a[1] + turns**2 * c - a[2] * s) < 1e-9]
    assert [a[1] + G for a in pressed] == pytest.approx([(G - turns**2 * c) / factor] * len(pressed))


def test_painleves_rod_at_rest_has_three():
    """Pushed at rest so that its tip would lift: it lifts, sticks, or begins to slide."""
    one = rod(0.8, 2.5, 0.0)
    push = np.array([-7.0, -10.0, -6.0])
    found = accelerations(Problem(one.M, push, one.N, one.c, one.rubs))
    gaps, slips = ([(rows @ a)[0] for a in found] for rows in (one.N, one.rubs[0].rows))
    assert sorted(gap > 1e-9 for gap in gaps) == [False, False, True]
    assert sorted(abs(slip) < 1e-9 for slip in slips) == [False, False, True]
    assert any(a == pytest.approx([-7, -10, -18]) for a in found)


def box(push, mu, half=0.5, height=1.0, torque=0.0, slips=0.0, **more) -> Problem:
    """A box of mass 1 on two feet, at rest or sliding."""
    N, T = np.array([[0, 1, -half], [0, 1, half]]), [1, 0, height]
    return Problem(
        np.diag([1, 1, 0.4]),
        np.array([push, -G, torque]),
        N,
        np.zeros(2),
        tuple(rub(T, mu, k, slips, **more) for k in (0, 1)),
    )


@pytest.mark.parametrize(("push", "a"), [(3.0, 0.0), (-3.9, 0.0), (4.0, 4 - 0.4 * G), (-6.0, -6 + 0.4 * G)])
def test_a_box_sticks_or_skids_on_both_feet(push, a):
    (found,) = accelerations(box(push, 0.4))
    assert found == pytest.approx([a, 0, 0], abs=1e-9)


def test_a_box_tips_about_its_foot():
    """(J + b^2 + h^2) p'' = -(F h - g b) where F h > g b and friction holds it."""
    (found,) = accelerations(box(6.0, 2.0))
    turn = -(6.0 - G / 2) / (0.4 + 0.25 + 1.0)
    assert found == pytest.approx([-turn, -turn / 2, turn])


def test_limits_at_rest_beside_those_for_sliding():
    """Pushed by between both it may stay or go; above the one for rest it goes, below the one for sliding it stays."""
    counts = [len(accelerations(box(push, 0.3, grip=0.4))) for push in (2.0, 3.5, 4.0)]
    assert counts == [1, 2, 1]


@pytest.mark.parametrize(("force", "a"), [(1.1, 0.0), (-1.2, 0.0), (2.0, 0.4), (-2.0, -0.4)])
def test_two_brakes_on_one_mass_are_one(force, a):
    brakes = (rub([1], 0.0, NONE, force=0.7), rub([1], 0.0, NONE, force=0.5))
    (found,) = accelerations(Problem(np.array([[2.0]]), np.array([force]), np.zeros((0, 1)), np.zeros(0), brakes))
    assert found == pytest.approx([a], abs=1e-12)


@pytest.mark.parametrize(("press", "a"), [(20.0, 0.0), (10.0, -G + 8.0)])
def test_a_block_between_jaws(press, a):
    """x of the left jaw, block and right jaw, y of the block: held by 2 mu P, or slips down."""
    N = np.array([[-1.0, 1, 0, 0], [0, -1, 1, 0]])
    rubs = tuple(rub([0, 0, 0, 1], 0.4, k) for k in (0, 1))
    (found,) = accelerations(Problem(np.eye(4), np.array([press, 0, -press, -G]), N, np.zeros(2), rubs))
    assert found == pytest.approx([0, 0, 0, a], abs=1e-9)


def test_a_mass_with_friction_at_its_stop():
    """The same row twice: pushed into the stop, back, and hardly back."""
    for push, a in ((10.0, 0.0), (-10.0, -7.0), (-2.0, 0.0)):
        one = Problem(np.eye(1), np.array([push]), np.array([[-1.0]]), np.zeros(1), (rub([1], 0.0, NONE, force=3.0),))
        (found,) = accelerations(one)
        assert found == pytest.approx([a], abs=1e-12)


def test_a_cone_slides_where_it_is_pushed_and_two_lines_make_a_box():
    push, weight = np.array([3.0, 4.0]), G
    N, h = np.array([[0.0, 0, 1]]), np.array([*push, -weight])
    (cone,) = accelerations(
        Problem(np.eye(3), h, N, np.zeros(1), (rub(np.eye(3)[:2], 0.4, slip=np.zeros(2), bias=np.zeros(2)),))
    )
    assert cone == pytest.approx([*(push * (1 - 0.4 * weight / 5)), 0])
    lines = tuple(rub(np.eye(3)[k], 0.4) for k in range(2))
    (two,) = accelerations(Problem(np.eye(3), h, N, np.zeros(1), lines))
    assert two == pytest.approx([0, 4 - 0.4 * weight, 0], abs=1e-12)


def test_a_ball_under_a_cone_rolls_or_slips():
    """Pushed at its centre by F: rolls with 5/7 F as long as 2/7 F <= mu g."""
    T = np.array([[1.0, 0, 0, 0, -0.3, 0], [0, 1, 0, 0.3, 0, 0]])  # slip at the lowest point of a ball of radius 0.3
    M, N = np.diag([1.0, 1, 1, *[0.4 * 0.09] * 3]), np.array([[0.0, 0, 1, 0, 0, 0]])
    way = np.array([0.6, 0.8])
    for force in (5.0, 20.0):
        h = np.array([*(force * way), -G, 0, 0, 0])
        (a,) = accelerations(Problem(M, h, N, np.zeros(1), (rub(T, 0.3, slip=np.zeros(2), bias=np.zeros(2)),)))
        assert a[:2] == pytest.approx(way * max(5 / 7 * force, force - 0.3 * G))


def rocking(half: float, height: float, e: float, mu: float, law: str) -> tuple[Strike, np.ndarray]:
    """Housner's block, homogeneous, turning about its left corner as its right one comes down."""
    rows = np.array([[0, 1, -half], [0, 1, half]])
    rubs = tuple(rub([1, 0, height], mu, k) for k in (0, 1))
    M = np.diag([1, 1, (half**2 + height**2) / 3])
    return Strike(M, rows, np.zeros(2), rubs, np.full(2, e), np.zeros(2), law), np.array([height, -half, -1.0])


@pytest.mark.parametrize("law", ["newton", "poisson"])
@pytest.mark.parametrize("half", [0.2, 0.4, 0.7])
def test_housners_block_keeps_what_angular_momentum_leaves_it(half, law):
    strike, v = rocking(half, 1.0, 0.0, 10.0, law)
    after = struck(strike, v)
    assert after.clear
    assert [one[2] / v[2] for one in after.found] == pytest.approx([1 - 1.5 * half**2 / (half**2 + 1)])


@pytest.mark.parametrize("law", ["newton", "poisson"])
def test_a_superball(law):
    """Rolls away if friction suffices, else slides with mu (1 + e) |w| less."""
    for mu, e in ((5.0, 0.8), (0.1, 0.8)):
        M, v = np.diag([1.0, 1.0, 0.4 * 0.09]), np.array([3.0, -2.0, 1.0])
        one = Strike(M, np.array([[0, 1.0, 0]]), np.zeros(1), (rub([1, 0, 0.3], mu),), np.array([e]), np.zeros(1), law)
        (after,) = struck(one, v).found
        taken = min(mu * (1 + e) * 2.0, 3.3 / 3.5)  # slip of 3.3 m/s, 1 / m_eff = 1 + 5 / 2
        assert after == pytest.approx([3 - taken, 1.6, 1 - taken * 0.3 / M[2, 2]])


def test_a_flat_box_lands_on_two_feet():
    """Both strike at once: it comes up flat by the restitution; of unequal ones each has its own."""
    M, N = np.diag([1, 1, 0.4]), np.array([[0, 1, -0.5], [0, 1, 0.5]])
    landing = lambda e, b: Strike(M, N, np.array(b), (), np.array(e), np.zeros(2))  # noqa: E731
    (after,) = struck(landing([0.5, 0.5], [0.0, 0.0]), np.array([1.0, -2.0, 0.0])).found
    assert after == pytest.approx([1, 1, 0])
    (after,) = struck(landing([0.5, 0.0], [0.0, 0.0]), np.array([1.0, -2.0, 0.0])).found
    assert N @ after == pytest.approx([1, 0])
    (after,) = struck(landing([1.0, 1.0], [-0.3, -0.3]), np.array([1.0, -2.0, 0.0])).found  # a floor that rises
    assert after == pytest.approx([1, 2.6, 0])


def test_what_rebounds_slowly_stays():
    one = Strike(np.eye(1), np.array([[1.0]]), np.zeros(1), (), np.array([0.5]), np.array([0.6]))
    assert struck(one, np.array([-1.0])).found[0] == pytest.approx([0.0], abs=1e-12)
    assert struck(one, np.array([-2.0])).found[0] == pytest.approx([1.0])


def test_energy_never_rises():
    """Kane's double pendulum's kind: Newton's law and friction would give energy; restitutions are lowered."""
    random, lowered = np.random.default_rng(1), 0
    for _ in range(60):
        A = random.normal(size=(3, 3))
        M, v = A @ A.T + 0.3 * np.eye(3), random.normal(size=3)
        N = random.normal(size=(1, 3)) * -1.0
        N *= -np.sign(N @ v)[0]
        one = Strike(M, N, np.zeros(1), (rub(random.normal(size=3), 1.5),), np.ones(1), np.zeros(1))
        for after in struck(one, v).found:
            assert after @ M @ after <= v @ M @ v * (1 + 1e-9)
            lowered += (N @ after)[0] < -(N @ v)[0] * (1 - 1e-6)
    assert 0 < lowered < 60


@pytest.mark.parametrize("seed", range(20))
def test_without_friction_there_is_one_motion(seed):
    random = np.random.default_rng(seed)
    n = random.integers(2, 6)
    contacts = random.integers(1, n + 1)
    A = random.normal(size=(n, n))
    one = Problem(
        A @ A.T + np.eye(n), random.normal(size=n), random.normal(size=(contacts, n)), random.normal(size=contacts)
    )
    (a,) = accelerations(one)
    assert off(one, a + 0.01 * random.normal(size=n)) > 1e-4


def path(case: Case, time: float) -> State:
    """The body moved on evenly: along its velocity and about its axis of turning."""
    w = case.u[3:] * time
    angle = np.linalg.norm(w)
    k = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]]) / max(angle, 1e-300)
    return State(
        case.x + case.u[:3] * time,
        (np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k) @ turned(case.angles),
        case.u,
        time,
    )


@pytest.mark.parametrize("shape", [Shape(2, 2), Shape(3, 3, 1, False, True)])
@pytest.mark.parametrize("seed", range(4))
def test_rows_and_biases_are_the_derivatives_of_gaps(shape, seed):
    case, h = drawn(shape, seed), 1e-4
    before, now, then = ([point(foot, path(case, time)) for foot in case.body.feet] for time in (-h, 0.0, h))
    for a, b, c in zip(before, now, then, strict=True):
        assert b.rate == pytest.approx((c.gap - a.gap) / (2 * h), abs=1e-6)
        assert b.bias == pytest.approx((c.gap - 2 * b.gap + a.gap) / h**2, abs=1e-5)
        assert b.offset == pytest.approx((c.slip - a.slip) / (2 * h), abs=1e-6)


@pytest.mark.parametrize("shape", [Shape(2, 2), Shape(3, 2, 0, False), Shape(3, 2, 0, False, True)])
def test_what_is_found_by_modes_is_what_the_law_allows(shape):
    found = 0
    for seed in range(0, 12, 3):
        case = drawn(shape, seed)
        one = problem(case.body, case.state, list(range(shape.contacts)), {})
        answer = solutions(one)
        found += answer.count
        assert all(off(one, each.a) < 1e-6 for each in answer.found)
    assert found
