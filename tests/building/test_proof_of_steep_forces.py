"""Builds of random mechanisms with steep friction and stiff springs, most of which start at rest: all are proved."""

import numpy as np
import pytest
from sympy import atan, cos, pi, sin, sqrt, symbols, tanh
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import t

from ..support.generation import FORMULATIONS

BY_DAY, AT_NIGHT = range(2), range(2, 25)


def random_model(rng: np.random.Generator) -> em.Model:
    """Return a cart and a pendulum; friction on one or both, a spring between them or none, driven or not."""
    x, theta = dynamicsymbols("x theta")
    e, mu, c = symbols("e mu c", positive=True)
    v, w = x.diff(), theta.diff()
    laws = [lambda v: tanh(v / e), lambda v: 2 / pi * atan(v / e), lambda v: v / sqrt(v**2 + e**2), lambda v: v / e]
    law, drive = laws[rng.integers(4)], [0, 2 * sin(0.7 * t), 1, t, t**2][rng.integers(5)]
    forces = {x: drive - mu * law(v)} | ({theta: -mu * law(w)} if rng.integers(2) else {})
    initial = {theta: [0, 0.3, 3.1][rng.integers(3)], v: [0, 0, 0, 1.0][rng.integers(4)]}
    return em.Model(
        name="steep", coordinates=[x, theta], kinetic_energy=v**2 / 2 + (v**2 + 2 * v * w * cos(theta) + w**2) / 4,
        potential_energy=-5 * cos(theta) + int(rng.integers(2)) * c * (x - theta) ** 2 / 2, forces=forces,
        parameters={e: 10 ** rng.uniform(-8, -1), mu: 10 ** rng.uniform(-2, 2), c: 10 ** rng.uniform(-1, 6)},
        initial=initial,
    )  # fmt: skip


@pytest.mark.parametrize("block", [*BY_DAY, *(pytest.param(block, marks=pytest.mark.nightly) for block in AT_NIGHT)])
def test_random_mechanisms_with_steep_forces_are_proved(block):
    """One in five was refused: two steps from rest move less than the tolerance of the run that is compared."""
    rng = np.random.default_rng(block)
    for _ in range(4):
        em.build(random_model(rng), formulation=str(rng.choice(FORMULATIONS)))
