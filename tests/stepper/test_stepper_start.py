"""Starts of steppers: those they take, and those they refuse."""

import re

import numpy as np
import pytest

from eigenmotion import ModelError

from ..simulation.test_inputs import TIGHT, oscillator
from ..support.generation import FORMULATIONS, relative, system_of


@pytest.mark.parametrize(
    ("t", "inputs", "words"),
    [
        (np.nan, None, "t is nan, not a finite number"),
        (np.inf, None, "t is inf, not a finite number"),
        (1.0, {"u": np.nan}, "input 'u' is nan, not a finite number"),
        (1.0, [np.inf], "input 'u' is inf, not a finite number"),
        (1.0, {"w": 1.0}, "unknown input 'w'; known: u"),
        (1.0, [1.0, 2.0], "inputs has shape"),
    ],
)
def test_what_is_no_time_or_input_is_refused_and_nothing_moves(t, inputs, words):
    stepper = oscillator().stepper()
    stepper.advance(0.5)
    before = stepper.save()
    with pytest.raises(ValueError, match=re.escape(words)):
        stepper.advance(t, inputs)
    assert stepper.save() == before


@pytest.mark.parametrize("inputs", [{"u": "fast"}, {"u": None}, 3, {"u": 1j}])
def test_what_is_no_number_is_refused(inputs):
    stepper = oscillator().stepper()
    with pytest.raises((TypeError, ValueError)):
        stepper.advance(1.0, inputs)
    assert stepper.t == 0.0


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"method": "Radau"}, "method 'Radau' is SciPy's"),
        ({"method": "Auto"}, "method 'auto' chooses for a whole run"),
        ({"method": "rk4"}, "method 'rk4' needs step"),
        ({"step": 0.1}, "step is for methods of fixed step"),
        ({"method": "rk4", "step": 0.0}, "step is 0.0, but must be above 0"),
        ({"t0": 1.0}, "unknown option 't0'"),
        ({"x0": {"theta": 0.0}}, "theta"),
        ({"start": (0.0, np.zeros(3)), "x0": np.zeros(4)}, "start= says all of t, x0 and v0"),
        ({"start": (0.0, np.zeros(3))}, "has shape (3,)"),
        ({"start": 3}, "neither a Solution nor a pair"),
    ],
)
def test_what_no_stepper_can_be_opened_with(options, words):
    with pytest.raises(ModelError, match=re.escape(words)):
        system_of("dual_link").stepper(**options)


def test_goes_on_from_a_solution_or_a_state():
    system = system_of("dual_link")
    first = system.simulate((0, 2), **TIGHT)
    whole = system.simulate((0, 4), **TIGHT)
    for start in (first, (first.t[-1], first.y[:, -1])):
        second = system.simulate((2, 4), start=start, **TIGHT)
        assert relative(second.x[:, -1], whole.x[:, -1]) < 1e-9
        assert np.abs(second.y[:, 0] - first.y[:, -1]).max() < 1e-12  # signs and order of eigenvectors, too
        stepper = system.stepper(start=start, **TIGHT)
        stepper.advance(4.0)
        assert relative(stepper.x, whole.x[:, -1]) < 1e-9
    other = system_of("dual_link", "lagrange").simulate((2, 4), start=first, **TIGHT)
    assert relative(other.x[:, -1], whole.x[:, -1]) < 1e-9


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_goes_on_with_other_parameters_from_the_same_motion(formulation):
    """eta, C and s of the run before are of another M: the coordinates and their rates go on."""
    system = system_of("dual_link", formulation)
    first, heavier = system.simulate((0, 2), **TIGHT), {"m2": 2.5, "K1": 3.0}
    whole = system.simulate((2, 3), x0=first.x[:, -1], v0=first.v[:, -1], parameters=heavier, **TIGHT)
    found = system.simulate((2, 3), start=first, parameters=heavier, **TIGHT)
    assert np.abs(found.v[:, 0] - first.v[:, -1]).max() < 1e-12
    assert relative(found.x[:, -1], whole.x[:, -1]) < 1e-9


def test_a_start_that_is_none_is_refused():
    system = system_of("dual_link")
    y = system.state()
    spoilt = y.copy()
    spoilt[system.layout["s"]] *= 1.5
    for start, words in (
        ((1.0, y), "start is a state at t = 1.0, but t_span begins at 0.0"),
        ((0.0, np.full_like(y, np.nan)), "not finite"),
        ((0.0, spoilt), "C and s are not the eigenfactors"),
        (system_of("pendulum").simulate((0, 1)), "start is a Solution of pendulum"),
    ):
        with pytest.raises(ModelError, match=re.escape(words)):
            system.simulate((0, 1), start=start)
    with pytest.raises(ModelError, match="give one of them"):
        system.simulate((0, 1), start=(0.0, y), x0=np.zeros(4))
