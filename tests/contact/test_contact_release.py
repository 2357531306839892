"""Contacts that let go, by every method and at loose tolerances: what opens as slowly as t^3 is not shut again."""

from functools import cache

import numpy as np
import pytest
from sympy import Rational, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Model, Solution, System, t
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_for, system_of


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
              parameters={m: 2.0, g: 9.81, a: 0.1, w: 9.0, k: 1e4, d: 20.0}, initial={y: 1.0}), "lagrange")  # fmt: skip


SHAKEN = {
    "as stated": {},
    "soft": {"k": 100.0, "w": 12.0},
    "swinging": {"k": 1e3, "d": 1.0},
    "damped": {"k": 1.7e4, "d": 27.0, "w": 10.6},
    "ringing": {"k": 3.1e4, "d": 0.1, "w": 12.0, "a": 0.08},
    "stiff": {"k": 9.3e4, "d": 15.0, "w": 12.7, "a": 0.09},
}


def shake(name: str, **options: object) -> Solution:
    """For a second, from the table's own speed on."""
    given = {"a": 0.1, "w": 9.0} | SHAKEN[name]
    speed = given["a"] * given["w"]
    return shaken().simulate((0.0, 1.0), parameters=given, v0={"z": speed, "y": speed}, **options)


@cache
def truth(name: str) -> Solution:
    return shake(name, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", SHAKEN)
def test_a_table_that_falls_faster_is_left(method, name):
    """A step that left as if shut by its own error ended the run as EVENTS_PILE_UP."""
    for tolerance in (1e-2, 1e-3, 1e-4, 1e-6, 1e-9):
        run = shake(name, method=method, rtol=tolerance, atol=tolerance)
        assert run.success, (tolerance, run.message)
        assert np.abs(run.x[:, -1] - truth(name).x[:, -1]).max() < 100 * tolerance
    assert len(run.modes) == len(truth(name).modes)
    assert run.t_events[0] == pytest.approx(truth(name).t_events[0], abs=1e-6)


@pytest.mark.parametrize("method", METHODS)
def test_the_last_bounces_are_as_many_at_any_tolerance(method):
    """They are lower than a tolerance of 1e-2, by far."""
    runs = [system_of("bouncing_ball", "lagrange").simulate((0.0, 10.0), parameters={"e": 0.5}, method=method, rtol=of,
                                                            atol=of) for of in (1e-2, 1e-4)]  # fmt: skip
    assert [run.success for run in runs] == [True, True]
    assert runs[0].t_events[0] == pytest.approx(runs[1].t_events[0], abs=1e-9)
