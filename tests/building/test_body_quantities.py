"""Homogeneous transforms of long chains: against forward kinematics in single numbers, 40 digits, and wrong numbers."""

import mpmath as mp
import numpy as np
import pytest
from eigenmotion.codegen.model.tree.forward_kinematics import Arithmetic, ForwardKinematics

import eigenmotion as em
from eigenmotion.building.verification import prove
from eigenmotion.building.verification.arithmetic import body_values
from eigenmotion.building.verification.arithmetic.evaluate import Evaluation
from eigenmotion.building.verification.arithmetic.hyperdual import HyperDual
from eigenmotion.building.verification.arithmetic.rounding_bounds import Rounded, rounded
from tests.support.random_trees import RandomTree

POINTS = 3


def quantities(made):
    """Energies, and everything of the last body."""
    body = made.bodies[-1]
    ways = (*body.position((1, 2, 3)), *body.velocity((1, 2, 3)), *body.rotation, *body.angular_velocity)
    return [one for one in (made.tree.kinetic_energy, made.tree.potential_energy, *ways) if not one.is_number]


def along(x, v, a, each):
    return HyperDual(x, v), HyperDual(v, a, each)


def across(x, v, a, each):
    return HyperDual(x, v, each), HyperDual(v)


def twice(x, v, a, each):
    return HyperDual(x, v, v, a), HyperDual(v)


def at_rest(x, v, a, each):
    return HyperDual(x), HyperDual(Rounded(0.0, 0.0), None, each)


def numbers(made, seeded):
    """Values of all variables: the proof's hyper-dual numbers, at random points."""
    chance, n = np.random.default_rng(len(made.tree.coordinates)), len(made.tree.coordinates)
    values = {symbol: HyperDual(rounded(np.full((POINTS, 1), value))) for symbol, value in made.parameters.items()}
    for q, unit in zip(made.tree.coordinates, np.eye(n), strict=True):
        x, v, a = (rounded(column) for column in chance.uniform(-1, 1, (3, POINTS, 1)))
        values[q], values[q.diff()] = seeded(x, v, a, Rounded(unit[None], np.zeros((1, n))))
    return values


@pytest.mark.parametrize("seeded", [along, across, twice, at_rest])
@pytest.mark.parametrize("seed", [*range(6), *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(6, 60))])
def test_transforms_are_forward_kinematics_in_single_numbers(seed, seeded, monkeypatch):
    made, found = RandomTree(seed, most=9), []
    for least in (10**6, 1):
        monkeypatch.setattr(body_values, "FROM", least)
        value = Evaluation(numbers(made, seeded))
        found.append([value(one) for one in quantities(made)])
    for single, whole in zip(*found, strict=True):
        for part in "abcf":
            one, other = (getattr(number, part) or Rounded(0.0, 0.0) for number in (single, whole))
            assert np.all(np.abs(one.value - other.value) <= one.bound + other.bound)
            assert np.max(other.bound) < 1e-9 * (1 + np.max(np.abs(one.value)))


def skew_arm(n, link=None, **wrong):
    """An arm whose joints turn about skew axes; one of its links maybe with other numbers."""
    tree, body = em.Tree(), None
    for k in range(n):
        given = {"at": (0.5, 0.1, 0) if k else (0, 0, 0), "mass": 1.0, "center": (0.25, 0.02, -0.03),
                 "inertia": (0.01, 0.02, 0.025)} | (wrong if k == link else {})  # fmt: skip
        body = tree.body(f"b{k}", body, joint="revolute", axis=(0.48, 0.6 * (-1) ** k, 0.64), **given)
    start = {q: 0.3 * (-1) ** k for k, q in enumerate(tree.coordinates)}
    return tree, em.Model(name=f"skew{n}", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                          potential_energy=tree.potential_energy, initial=start)  # fmt: skip


def energies_in_digits(tree, x, v):
    """The kinetic and the potential energy, by the same definitions in more digits."""
    number = lambda one: mp.mpf(float(one))  # noqa: E731
    arithmetic = Arithmetic(number, number, mp.sin, mp.cos, lambda one: 1 / one)
    values = dict(zip(tree.coordinates, x, strict=True)) | {
        q.diff(): rate for q, rate in zip(tree.coordinates, v, strict=True)
    }
    forward = ForwardKinematics(arithmetic, values)
    return [forward.quantity(one.func.quantity) for one in (tree.kinetic_energy, tree.potential_energy)]


@pytest.mark.parametrize("n", [13, 60])
def test_errors_of_energies_are_within_bounds_that_do_not_explode(n):
    chance, (tree, _) = np.random.default_rng(n), skew_arm(n)
    x, v, a = chance.uniform(-2, 2, (3, n))
    values = {}
    for q, place, rate, turned in zip(tree.coordinates, x, v, a, strict=True):
        numbers = [rounded(np.array([[one]])) for one in (place, rate, turned)]
        values[q], values[q.diff()] = HyperDual(*numbers[:2]), HyperDual(*numbers[1:])
    evaluated = [Evaluation(values)(one) for one in (tree.kinetic_energy, tree.potential_energy)]
    with mp.workdps(40):
        step = mp.mpf(10) ** -15

        def at(s):
            return energies_in_digits(
                tree, [mp.mpf(one) + s * mp.mpf(rate) for one, rate in zip(x, v, strict=True)],
                [mp.mpf(one) + s * mp.mpf(rate) for one, rate in zip(v, a, strict=True)])  # fmt: skip

        for number, there, ahead, back in zip(evaluated, at(mp.mpf(0)), at(step), at(-step), strict=True):
            for part, exact in ((number.a, there), (number.b, (ahead - back) / (2 * step))):
                assert abs(exact - float(part.value[0, 0])) <= float(part.bound[0, 0])
                assert float(part.bound[0, 0]) < 1e-13 * n * max(abs(there), abs(exact)) * np.abs(v).sum()


@pytest.fixture(scope="module")
def arm():
    return em.build(skew_arm(70)[1], formulation="articulated_body")


WRONG = {"at": (0.5, 0.101, 0), "mass": 1.001, "center": (0.25, 0.021, -0.03)}


@pytest.mark.parametrize("link", [0, 34, 69])
@pytest.mark.parametrize("what", [*WRONG, "inertia"])
def test_one_wrong_number_of_a_long_arm_is_found(arm, what, link):
    """Of the first link, an inertia is a small part of what the arm has, whose rounding hides a thousandth."""
    wrong = WRONG | {"inertia": (0.01, 0.02, 0.025 * (1.2 if link == 0 else 1.01))}
    if (what, link) == ("at", 0):
        wrong = {"at": (0, 0, 0.001)}
    with pytest.raises(em.ProofError, match="energy"):
        prove(skew_arm(70, link, **{what: wrong[what]})[1], arm, ())


def test_the_arm_itself_is_proved(arm):
    prove(skew_arm(70)[1], arm, ())
