"""Conditions whose times rounding leaves open, and those on what is not a number."""

import numpy as np
import pytest
from sympy import Mod, Ne, Piecewise, exp, log, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, StopReason, t
from eigenmotion.building.verification import prove

from ..support.generation import system_for

X, Y = dynamicsymbols("x y")
RATE = symbols("rate")
SPANS = [(0.0, 2.0), (-1.0, 2.0), (1.0, 2.0), (2.0, 0.0)]


@pytest.fixture(scope="module")
def fading() -> em.System:
    """What fades for ever is less than 1 from 0 s on: at a rate of 1e-20 / s no number tells when."""
    laws = {X: Piecewise((1, exp(-RATE * t) <= 1), (2, True)), Y: sin(3 * t)}
    return system_for(Model(name="fading", coordinates=[X, Y], kinetic_energy=(X.diff() ** 2 + Y.diff() ** 2) / 2,
                            forces=laws, parameters={RATE: 1.0}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau5"])
@pytest.mark.parametrize("rate", [1.0, -1.0, 0.0, 1e-3, 1e-9, 1e-12, -1e-14, 1e-20])
def test_a_break_that_may_be_anywhere_does_not_hold_the_clock(fading, method, rate):
    """All that the time drives was asked in the middle of the slack: success, by the force of one moment."""
    for span in SPANS:
        run = fading.simulate(span, parameters={"rate": rate}, method=method, rtol=1e-8)
        known = abs(rate) >= 1e-9 or rate == 0.0
        assert run.success or (run.stop is StopReason.STEP_SIZE_UNDERFLOW and not known)
        if run.success:
            assert run.v[1, -1] == pytest.approx((np.cos(3 * span[0]) - np.cos(3 * span[1])) / 3, abs=1e-6)


LAWS = {  # at x <= 0, where log(x) is no number, and Mod(t, 0) is none: the force, or None
    "less": (Piecewise((1, log(X) < 1), (2, True)), None),
    "not less": (Piecewise((1, log(X) >= 1), (2, True)), None),
    "unequal": (Piecewise((1, Ne(log(X), 1)), (2, True)), None),
    "periodic": (Piecewise((1, Mod(t, RATE) < 0.5), (2, True)), None),
    "and": (Piecewise((1, (X > 0) & (log(X) < 1)), (2, True)), 2.0),
    "or": (Piecewise((1, (X <= 0) | (log(X) < 1)), (2, True)), 1.0),
    "undecided": (Piecewise((1, (X <= 0) & (log(X) < 1)), (2, True)), None),
    "later": (Piecewise((3, X <= 0), (1, log(X) < 1), (2, True)), 3.0),
}


@pytest.mark.parametrize("name", LAWS)
def test_a_condition_on_what_is_no_number_is_none(name):
    """It did not hold, so that the last piece was taken. What another condition decides is none of its matter."""
    force, expected = LAWS[name]
    model = Model(name="law", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2, forces={X: force}, initial={X: -1.0},
                  parameters={RATE: 0.0})  # fmt: skip
    system = system_for(model, "lagrange")
    prove(model, system)
    for method in ("dop853", "ra15"):
        run = system.simulate((0.0, 0.1), method=method)
        runs = em.simulate_ensemble(system, (0.0, 0.1), x0={"x": np.full(5, -1.0)}, method=method)
        if expected is None:
            assert run.stop is StopReason.NON_FINITE_STATE
            assert not runs.success.any()
        else:
            assert run.v[0, -1] == pytest.approx(0.1 * expected)
            assert np.allclose(runs.v[:, 0, -1], 0.1 * expected)
