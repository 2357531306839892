"""Contacts that let go under methods whose steps are made in Python: what opens as slowly as t^3 is not shut again."""

from functools import cache

import numpy as np
import pytest
from sympy import Rational, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Model, System, t
from eigenmotion.running.leaving import joined
from eigenmotion.running.methods import IMPLICIT

from .generation import system_for, system_of

METHODS = tuple(name for name, one in IMPLICIT.items() if not one.is_compiled and one.is_installed)


@cache
def shaken() -> System:
    """A mass on a table that shakes, and another on a spring on top of it."""
    z, y = dynamicsymbols("z y")
    m, g, a, w, k, d = symbols("m g a w k d", positive=True)
    pull = d * (y.diff() - z.diff())
    return system_for(
        Model(name="shaken_pair", coordinates=[z, y], kinetic_energy=m * (z.diff() ** 2 + y.diff() ** 2) / 2,
              potential_energy=m * g * (z + y) + k * (y - z - 1) ** 2 / 2, forces={z: pull, y: -pull},
              contacts={"table": Contact(z - a * sin(w * t), restitution=Rational(1, 5), rest=Rational(1, 10))},
              parameters={m: 2.0, g: 9.81, a: 0.1, w: 9.0, k: 1e4, d: 20.0},
              initial={z.diff(): 0.9, y: 1.0, y.diff(): 0.9}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("tolerance", [1e-4, 1e-9])
@pytest.mark.parametrize("parameters", [{}, {"k": 100.0, "w": 12.0}, {"k": 1e3, "d": 1.0}], ids=str)
def test_a_table_that_falls_faster_is_left(method, tolerance, parameters):
    truth = shaken().simulate((0.0, 1.0), parameters=parameters, rtol=1e-12, atol=1e-12)
    run = shaken().simulate((0.0, 1.0), parameters=parameters, method=method, rtol=tolerance, atol=tolerance)
    assert run.success, run.message
    assert len(run.modes) == len(truth.modes)
    assert run.t_events[0] == pytest.approx(truth.t_events[0], abs=tolerance**0.6)
    assert run.x[:, -1] == pytest.approx(truth.x[:, -1], abs=tolerance**0.6)


@pytest.mark.parametrize("method", METHODS)
def test_the_last_bounces_are_as_many_at_any_tolerance(method):
    """They are lower than a tolerance of 1e-2, by far."""
    runs = [system_of("bouncing_ball", "lagrange").simulate((0.0, 10.0), parameters={"e": 0.5}, method=method, rtol=of,
                                                            atol=of) for of in (1e-2, 1e-4)]  # fmt: skip
    assert [run.success for run in runs] == [True, True]
    assert runs[0].t_events[0] == pytest.approx(runs[1].t_events[0], abs=1e-9)


def test_a_step_is_joined_by_what_holds_at_its_ends():
    """Of x = t^5, and of what falls back within the step it says nothing."""
    ends = (
        (np.array([0.5**5, 5 * 0.5**4]), np.array([1.0, 5.0])),
        (np.array([5 * 0.5**4, 20 * 0.5**3]), np.array([5.0, 20.0])),
    )
    at = np.linspace(0.5, 1.0, 7)
    assert joined((0.5, 1.0), *ends)(at) == pytest.approx(np.array([at**5, 5 * at**4]), rel=1e-14)
    assert joined((0.0, 1.0), (np.zeros(2), np.zeros(2)), (np.array([0.0, 1e3]), np.zeros(2))) is None
