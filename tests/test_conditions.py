"""Conditions whose times rounding leaves open."""

import numpy as np
import pytest
from sympy import Piecewise, exp, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, StopReason, t

from .generation import system_for

X, Y = dynamicsymbols("x y")
RATE = symbols("rate")
SPANS = [(0.0, 2.0), (-1.0, 2.0), (1.0, 2.0), (2.0, 0.0)]


@pytest.fixture(scope="module")
def fading() -> em.System:
    """What fades for ever is less than 1 from 0 s on: at a rate of 1e-20 / s no number tells when."""
    laws = {X: Piecewise((1, exp(-RATE * t) <= 1), (2, True)), Y: sin(3 * t)}
    return system_for(Model(name="fading", coordinates=[X, Y], kinetic_energy=(X.diff() ** 2 + Y.diff() ** 2) / 2,
                            forces=laws, parameters={RATE: 1.0}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau5", "LSODA"])
@pytest.mark.parametrize("rate", [1.0, -1.0, 0.0, 1e-3, 1e-9, 1e-12, -1e-14, 1e-20])
def test_a_break_that_may_be_anywhere_does_not_hold_the_clock(fading, method, rate):
    """All that the time drives was asked in the middle of the slack: success, by the force of one moment."""
    for span in SPANS:
        run = fading.simulate(span, parameters={"rate": rate}, method=method, rtol=1e-8)
        known = abs(rate) >= 1e-9 or rate == 0.0
        assert run.success or (run.stop is StopReason.STEP_SIZE_UNDERFLOW and not known)
        if run.success:
            assert run.v[1, -1] == pytest.approx((np.cos(3 * span[0]) - np.cos(3 * span[1])) / 3, abs=1e-6)
