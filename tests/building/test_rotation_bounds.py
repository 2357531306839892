"""Bounds of rotations along chains of bodies, against the same products in 40 digits."""

import mpmath as mp
import numpy as np
import pytest
from eigenmotion.codegen.model.tree.forward_kinematics import Arithmetic, ForwardKinematics

import eigenmotion as em
from eigenmotion.building.verification.arithmetic.hyperdual import FUNCTIONS, HyperDual
from eigenmotion.building.verification.arithmetic.rotation_bounds import settled
from eigenmotion.building.verification.arithmetic.rounding_bounds import Rounded, rounded


def chain(n):
    """Arms whose joints turn about skew axes."""
    tree, body = em.Tree(), None
    for k in range(n):
        body = tree.body(f"b{k}", body, joint="revolute", axis=(1, 0.3 * k % 2, 0.7 - k % 3), at=(1, 0, 0), mass=1.0)
    return tree, tree._links[-1]


def in_hyperduals(tree, body, q, v):
    """The rotation at q + v d, with rates of which no bound is needed."""
    numbers = {
        symbol: HyperDual(rounded(np.array([[x]])), rounded(np.array([[rate]])))
        for symbol, x, rate in zip(tree.coordinates, q, v, strict=True)
    }
    of = lambda one: HyperDual(rounded(float(one)))  # noqa: E731
    arithmetic = Arithmetic(of, of, FUNCTIONS["sin"], FUNCTIONS["cos"],
                            lambda number: number.power(Rounded(-1.0, 0.0)), settled)  # fmt: skip
    return ForwardKinematics(arithmetic, numbers).placed(body)[0]


def in_digits(tree, body, q):
    number = lambda one: mp.mpf(float(one))  # noqa: E731
    arithmetic = Arithmetic(number, number, mp.sin, mp.cos, lambda one: 1 / one)
    return ForwardKinematics(arithmetic, dict(zip(tree.coordinates, q, strict=True))).placed(body)[0]


@pytest.mark.parametrize("n", [13, 60])
def test_errors_of_long_chains_are_within_bounds_that_do_not_explode(n):
    chance, (tree, body) = np.random.default_rng(n), chain(n)
    q, v = chance.uniform(-3, 3, n), chance.uniform(-2, 2, n)
    R = in_hyperduals(tree, body, q, v)
    with mp.workdps(40):
        at = lambda s: in_digits(tree, body, [mp.mpf(x) + s * mp.mpf(rate) for x, rate in zip(q, v, strict=True)])  # noqa: E731
        there, step = at(mp.mpf(0)), mp.mpf(10) ** -15
        ahead, back = at(step), at(-step)
        for i in range(3):
            for j in range(3):
                value, rate = R[i][j].value.a, R[i][j].value.b
                slope = (ahead[i][j].value - back[i][j].value) / (2 * step)
                assert abs(there[i][j].value - float(value.value[0, 0])) <= float(np.min(value.bound))
                assert abs(slope - float(rate.value[0, 0])) <= float(np.min(rate.bound))
                assert float(np.max(value.bound)) < 1e-13 * n
                assert float(np.max(rate.bound)) < 1e-13 * n * np.abs(v).sum()
