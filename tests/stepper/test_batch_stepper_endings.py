"""Members of many steppers that end, fail, or are refused: by name, and at no cost to the others."""

from functools import cache

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from sympy import Rational, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, ModelError, StopReason

from ..support.generation import loaded, system_for, system_of
from .environments import K, one_by_one, opened


def falling(**options) -> Model:
    """A mass that falls to the ground, where its inertia is nothing at z = -1 and a horn blows at z = 1/2."""
    z = dynamicsymbols("z")
    return Model(
        name="falling",
        coordinates=[z],
        kinetic_energy=Rational(1, 2) * z.diff() ** 2,
        potential_energy=10 * z,
        forces={z: sin(z) / (1 + z) ** 2 * 1e-3},
        initial={z: 1.0},
        **options,
    )


@cache
def with_ground():
    z = dynamicsymbols("z")
    events = {"horn": z - Rational(1, 2), "ground": Event(z, terminal=True)}
    return system_for(falling(events=events), "lagrange")


def test_who_ends_stands_still_and_says_why():
    envs = with_ground().steppers(x0={"z": [1.0, 50.0, 3.0]}, rtol=1e-9)
    envs.advance(0.4)
    assert envs.events["horn"][0] == pytest.approx(np.sqrt(0.1), abs=1e-4)
    assert np.isnan(envs.events["horn"][1:]).all()
    envs.advance(1.0)
    assert envs.ended.tolist() == [True, False, True]
    assert envs.stop == [StopReason.TERMINAL_EVENT, StopReason.FINISHED, StopReason.TERMINAL_EVENT]
    assert envs.failed.size == 0
    assert envs.t == pytest.approx([np.sqrt(0.2), 1.0, np.sqrt(0.6)], abs=1e-4)
    assert envs.x[[0, 2]] == pytest.approx(0.0, abs=1e-12)
    envs.advance(2.0)
    assert envs.t[1] == 2.0
    assert envs.t[0] < 0.5
    assert np.isnan(envs.events["horn"][0])
    assert "terminal event" in envs.message(0)
    assert envs.message(1) == ""
    envs.reset(envs.ended)
    assert not envs.ended.any()
    assert envs.x[:, 0] == pytest.approx([1.0, 50 - 20.0, 3.0], abs=1e-3)


@pytest.mark.parametrize("lanes", [True, False])
def test_who_fails_costs_the_others_nothing(lanes):
    """z = -1 is a pole of the force: the one that starts there cannot step; too many steps are a reason, too."""
    sources = compiler.generate(falling(), Choices("lagrange"))
    system = loaded(sources, "-O0", lanes=True) if lanes else with_ground()
    envs = system.steppers(x0={"z": [1.0, -1.0, 2.0]}, method="rk4", step=0.01, max_steps=30)
    envs.advance([0.2, 0.2, 0.4])
    assert envs.stop == [StopReason.FINISHED, StopReason.NON_FINITE_STATE, StopReason.TOO_MANY_STEPS]
    assert envs.failed.tolist() == [1, 2]
    assert envs.t == pytest.approx([0.2, 0.0, 0.3])
    assert envs.x[0] == pytest.approx(1 - 5 * 0.04, abs=1e-4)
    assert "member 1 at t = 0" in envs.message(1)


def test_contacts_hold_and_let_go_in_each():
    """Balls that bounce, and come to rest, are those of single runs; modes are saved, too."""
    system = system_of("bouncing_ball")
    height = np.array([0.5, 1.0, 0.01])
    envs = system.steppers(x0={"z": height}, parameters={"e": [0.5, 0.9, 0.3]})
    envs.advance(0.7)
    saved = envs.save()
    envs.advance(2.0)
    rows = np.hstack([envs.x, envs.v])
    for k, e in enumerate((0.5, 0.9, 0.3)):
        single = system.stepper(x0={"z": height[k]}, parameters={"e": e})
        single.advance(0.7)
        single.advance(2.0)
        assert np.array_equal(np.hstack([single.x, single.v]), rows[k])
        assert np.array_equal(single.multipliers, envs.multipliers[k])
    assert envs.multipliers[2] == pytest.approx(-9.81)  # at rest, and the floor bears it
    envs.restore(saved)
    envs.advance(2.0)
    assert np.array_equal(np.hstack([envs.x, envs.v]), rows)
    envs.reset(envs.t > 0)
    envs.advance(0.7)
    envs.advance(2.0)
    assert np.array_equal(np.hstack([envs.x, envs.v]), rows)


def test_a_start_that_cannot_be_is_refused_by_number_and_nobody_moves():
    system = system_of("four_bar")
    envs = system.steppers(4, rtol=1e-8)
    envs.advance(0.2)
    before = envs.save()
    with pytest.raises(ModelError, match="member 2 of 4: four_bar: x0 is off holonomic constraint row 0"):
        envs.reset([1, 2], x0={system.coordinates[0]: [9.0, envs.starts.x[1, 0], 0.1, 0.2]})
    assert envs.save() == before
    single = system.stepper(rtol=1e-8)
    single.advance(0.2)
    assert np.array_equal(envs.x[3], single.x)
    with pytest.raises(ModelError, match="member 1 of 2: four_bar"):
        system.steppers(x0={system.coordinates[0]: [envs.starts.x[0, 0], 0.1]})


REFUSED = (
    ({"count": 0}, "the number of steppers is 0"),
    ({"count": 3, "x0": {"theta": [1.0, 2.0]}}, "3 steppers, but arrays of 2"),
    ({"x0": {"thera": 1.0}}, "did you mean 'theta'"),
    ({"x0": {"theta": [1.0, np.nan]}}, "member 1 of 2: x0 'theta' is not a finite number"),
    ({"inputs": {"u": ([0.0, 1.0], [1.0, 2.0])}}, "a number for each member"),
    ({"inputs": [[1.0, 2.0]], "count": 1}, "inputs has shape"),
    ({"method": "rk4"}, "needs step="),
    ({"method": "Radau"}, "is SciPy's"),
    ({"method": "auto"}, "give it 'dop853'"),
    ({"workers": 0}, "workers is 0"),
    ({"tolerance": 1}, "unknown option"),
)


@pytest.mark.parametrize(("given", "words"), REFUSED)
def test_what_cannot_be_asked(given, words):
    given = dict(given)
    with pytest.raises(ModelError, match=f"(?i){words}"):
        one_by_one().steppers(given.pop("count", None), **given)


def test_what_cannot_be_told():
    envs = opened("fixed")
    for call, words in (
        (lambda: envs.advance(np.nan), "t holds a number that is not finite"),
        (lambda: envs.advance([1.0, 2.0]), r"t has shape \(2,\)"),
        (lambda: envs.advance(1.0, {"v": 1.0}), "unknown input"),
        (lambda: envs.advance(1.0, np.ones((K, 2))), r"inputs has shape \(21, 2\)"),
        (lambda: envs.advance(1.0, np.where(np.arange(K) == 3, np.inf, 1.0)), "input 'u' of member 3"),
        (lambda: envs.reset(0.5), "mask is 0.5"),
        (lambda: envs.reset([K]), "mask names members from 21"),
        (lambda: envs.reset(x0={"theta": [1.0]}), r"has shape \(1,\)"),
        (lambda: envs.reset(x0=np.full((K, 1), np.nan)), "of member 0 is not a finite number"),
        (lambda: envs.reset(t=np.inf), "t is"),
    ):
        before = envs.save()
        with pytest.raises(ModelError, match=words):
            call()
        assert envs.save() == before
    envs.reset([])
    envs.advance(0.1)
