"""Names of what is not finite: a mass or constraint without a value is not called singular, or off by nan."""

from functools import cache

import numpy as np
import pytest
from sympy import log, sqrt, symbols

from eigenmotion import ModelError, System, t
from eigenmotion.runtime import EvaluationError, StopReason

from ..support.failing_runs import FORMULATIONS, X, Y, plane
from ..support.generation import system_for

pytestmark = pytest.mark.filterwarnings("ignore:.*:RuntimeWarning")

Q = symbols("q")
ENERGY = (X.diff() ** 2 + Y.diff() ** 2 + X.diff() * Y.diff()) / 2
MODELS = {
    "mass": plane("mass_undefined", kinetic_energy=ENERGY + log(Q) * Y.diff() ** 2, parameters={Q: 2.0}),
    "later": plane("mass_later", kinetic_energy=ENERGY + sqrt(1 - t) * Y.diff() ** 2),
    "row": plane("row_undefined", nonholonomic_constraints=[Y.diff() - log(Q) * X.diff()], parameters={Q: 2.0}),
}  # fmt: skip
BAD = {"parameters": {"q": -1.0}}


@cache
def made(name: str, formulation: str) -> System:
    return system_for(MODELS[name], formulation)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("mass", "mass matrix is not finite at coordinate 'y'"),
        ("row", r"Constraint row 0 \(counted from 0\) is not finite"),
    ],
)
def test_functions_of_a_state_name_what_is_not_finite(name, words, formulation):
    """They called the mass matrix singular, with a pivot of 0."""
    system = made(name, formulation)
    start = system.state()
    for call in (lambda: system.rhs(0.0, start, **BAD), lambda: system.acceleration([0.0, 0.0], [0.0, 0.0], **BAD)):
        with pytest.raises(EvaluationError, match=words) as caught:
            call()
        assert caught.value.stop is StopReason.NON_FINITE_STATE


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("mass", "mass matrix is not finite at coordinate 'y'"),
        ("row", "A v .* b of constraint row 0 is not finite at x0, v0. Look in it"),
    ],
)
def test_starts_name_what_is_not_finite(name, words, formulation):
    """A row was said to be off "by nan", and the loop to be closed from a guess."""
    system = made(name, formulation)
    for call in (lambda: system.simulate((0, 1), **BAD), lambda: system.stepper(**BAD)):
        with pytest.raises((ModelError, EvaluationError), match=words):
            call()


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("method", ["dop853", "radau9", "ra15", "auto"])
def test_masses_that_have_no_value_later_are_not_singular(method, formulation):
    """M is positive definite up to t = 1, and has no value then."""
    found = made("later", formulation).simulate((0, 2), method=method, v0=[1.0, 1.0])
    assert found.stop in (StopReason.NON_FINITE_STATE, StopReason.STEP_SIZE_UNDERFLOW)
    assert found.t[-1] == pytest.approx(1.0, abs=1e-6)
    assert "'y'" in found.message or "'x'" in found.message
    assert np.isfinite(found.y).all()
