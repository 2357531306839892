"""Several dips of an event's g between the same two nodes of a step: each is looked into."""

from functools import cache

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System

from ..support.generation import system_for

X = dynamicsymbols("x")
WAYS = pytest.mark.parametrize("way", [1, -1])
CENTRES = symbols("a b c")
HALVES = symbols("p q")
PAIRS = [(X - centre) ** 2 - half**2 for centre, half in zip(CENTRES[:2], HALVES, strict=True)]


@cache
def dipping() -> System:
    """x = t in steps of any length; g dips below zero around a and b, and passes c; one event begins at zero."""
    events = {"pairs": PAIRS[0] * PAIRS[1], "three": PAIRS[0] * (X - CENTRES[2]), "begins": X}
    return system_for(Model(name="dipping", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2, events=events,
                            parameters=dict.fromkeys([*CENTRES, *HALVES], 1.0), initial={X.diff(): 1.0}))  # fmt: skip


def roots_found(way: int, method: str, **values: float) -> list[np.ndarray]:
    start, end = (0.0, 1.0)[::way]
    found = dipping().simulate((start, end), x0=[start], v0=[1.0], method=method, first_step=1.0, parameters=values)
    assert found.success
    return [np.sort(times) for times in found.t_events]


NEIGHBOURS = [(0.36, 0.44, 1e-2), (0.41, 0.48, 1e-3), (0.17, 0.26, 1e-5), (0.06, 0.11, 1e-4), (0.012, 0.028, 1e-4)]
"""Where two pairs of passages lie, and half of what is between two of a pair."""


@WAYS
@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_two_pairs_of_passages_between_the_same_nodes_are_all_found(method, way):
    """A step's nodes are 0, 0.04, 0.15, 0.31, 0.5 and so on; each case lies between two of them."""
    for a, b, half in NEIGHBOURS:
        pairs, three, _ = roots_found(way, method, a=a, b=b, c=b, p=half, q=half)
        np.testing.assert_allclose(pairs, [a - half, a + half, b - half, b + half], rtol=0, atol=1e-12)
        np.testing.assert_allclose(three, [a - half, a + half, b], rtol=0, atol=1e-12)


@WAYS
def test_dips_anywhere_in_a_step_are_found(way):
    """As far apart as two parts of an eighth between two nodes."""
    random = np.random.default_rng(11)
    for _ in range(200):
        a, b = np.sort(random.uniform(0.03, 0.97, 2))
        half = 10 ** random.uniform(-6, -2)
        if b - a < max(0.06, 4 * half):
            continue
        exact = [a - half, a + half, b - half, b + half]
        np.testing.assert_allclose(roots_found(way, "dop853", a=a, b=b, c=0.5, p=half, q=half)[0], exact, atol=1e-11)
