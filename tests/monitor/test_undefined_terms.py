"""Names of what is not finite: a mass or constraint without a value is not called singular, or off by nan."""

from functools import cache

import numpy as np
import pytest
from sympy import Piecewise, log, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError, System, t
from eigenmotion.building.undefined_terms import undefined_terms
from eigenmotion.runtime import EvaluationError, StopReason

from ..support.failing_runs import FORMULATIONS, X, Y, plane
from ..support.generation import system_for

pytestmark = pytest.mark.filterwarnings("ignore:.*:RuntimeWarning")

Q, (U, Z) = symbols("q"), dynamicsymbols("u z")
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


TERMS = {  # what is not finite: the model, what is given, and what a message says of it
    "force": (plane("undefined_force", forces={X: log(Q)}, parameters={Q: 2.0}), {"parameters": {"q": -1.0}},
              "log(q) in forces[x] has no finite value or derivative, where q = -1."),
    "quotient": (plane("undefined_quotient", potential_energy=1 / Y, initial={Y: 1.0}), {"x0": {"y": 0.0}},
                 "1/y in potential_energy has no finite value or derivative, where y = 0."),
    "slope": (plane("undefined_slope", potential_energy=sqrt(Y), initial={Y: 1.0}), {"x0": {"y": 0.0}},
              "sqrt(y) in potential_energy has no finite value or derivative, where y = 0."),
    "rate": (plane("undefined_rate", forces={Y: sqrt(Y.diff())}, initial={Y.diff(): 1.0}), {"v0": {"y": -1.0}},
             "sqrt(y') in forces[y] has no finite value or derivative, where y' = -1."),
    "later": (plane("undefined_later", forces={X: sqrt(1 - t)}), {},
              "sqrt(1 - t) in forces[x] is next to the end of its domain, where 1 - t = "),
    "input": (plane("undefined_input", forces={X: log(U)}, inputs={U: 1.0}), {"inputs": {"u": -3.0}},
              "log(u) in forces[x] has no finite value or derivative, where u = -3."),
    "state": (plane("undefined_state", states={Z: log(Z)}, forces={X: Z}, initial={Z: 1.0}), {"x0": {"z": -2.0}},
              "log(z) in states[z] has no finite value or derivative, where z = -2."),
}  # fmt: skip


@pytest.mark.parametrize("method", ["dop853", "radau9", "ra15"])
@pytest.mark.parametrize("kind", list(TERMS))
def test_messages_have_the_term_and_its_arguments(kind, method):
    model, given, words = TERMS[kind]
    system = em.build(model, formulation="lagrange")
    assert words in system.simulate((0, 2), method=method, t_eval=[0.0, 0.3], **given).message
    with pytest.raises(EvaluationError) as caught:
        system.stepper(method=method, **given).advance(2.0)
    assert words in str(caught.value)


def test_branches_that_do_not_hold_are_not_looked_at():
    """And what is finite is not named."""
    model = plane(
        "branches",
        forces={X: Piecewise((sqrt(Y), Y > 0), (0, True)) + 6 * X**2, Y: -1},
        initial={X: 1.0, X.diff(): 2.0},
    )
    values = {"t": 0.0, "x": 1.0, "y": -1.0, "x'": 2.0, "y'": 0.0}
    assert undefined_terms(model, values) == ""
    assert "sqrt(y) in forces[x] is next to" in undefined_terms(model, values | {"y": 1e-9})
    found = em.build(model, formulation="lagrange").simulate((0, 2))
    assert found.stop is StopReason.STEP_SIZE_UNDERFLOW
    assert "domain" not in found.message
