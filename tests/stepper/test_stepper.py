"""Steppers: a mechanism that goes on as far as it is told, against runs in one go and motions on paper."""

import pickle
from functools import cache, partial

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from sympy import log, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, Signal, StopReason
from eigenmotion.arguments.methods import FIXED, METHODS, STEPPED
from eigenmotion.runtime import EvaluationError

from ..simulation.test_inputs import TIGHT, forced, oscillator
from ..support.generation import FORMULATIONS, relative, system_for, system_of

TIMES = np.linspace(0.0, 3.0, 31)
HELD = np.round(np.sin(5.0 * TIMES[:-1]), 3)


def stepped(stepper, times, held=None):
    """y (k, n_state) at times, with these inputs from the time before each on."""
    rows = []
    for k, t in enumerate(times):
        stepper.advance(t, None if held is None else {"u": held[k]})
        assert stepper.t == t
        rows.append(stepper.y)
    return np.array(rows)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("method", METHODS)
def test_inputs_held_by_hand_are_those_of_one_run(formulation, method):
    """To the last bit: the same steps, with the same history. And the motion is the one on paper."""
    system = oscillator(formulation)
    stepper = system.stepper(method=method, **TIGHT)
    rows = stepped(stepper, TIMES[1:], HELD)
    run = system.simulate(
        (0, 3), inputs={"u": Signal(TIMES[:-1], HELD, "hold")}, method=method, t_eval=TIMES[1:], **TIGHT
    )
    assert np.array_equal(rows, run.y.T)
    assert np.array_equal(stepper.x, run.x[:, -1])
    assert np.abs(stepper.v - run.v[:, -1]).max() < 1e-14
    xv = np.array([run.x[0], run.v[0]])
    on_paper = forced(TIMES[1:], [(t, Polynomial([u])) for t, u in zip(TIMES[:-1], HELD, strict=True)], 3.0)
    assert np.abs(xv - on_paper).max() < 1e-9


def test_without_inputs_steps_keep_their_size_and_history():
    """A step cut short at where an advance ends does not make the next ones short."""
    system = system_of("dual_link")
    stepper, whole = system.stepper(rtol=1e-9), system.simulate((0, 5), rtol=1e-9)
    stepped(stepper, np.linspace(0, 5, 6)[1:])
    assert stepper.nsteps <= whole.nsteps + 6
    assert relative(stepper.x, whole.x[:, -1]) < 1e-7
    assert stepper.energy == pytest.approx(whole.energy[0], rel=1e-8)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize(("method", "order", "cost"), [("rk4", 4, 4), ("midpoint", 2, 2)])
def test_steps_of_fixed_size_are_of_their_order_and_all_cost_the_same(formulation, method, order, cost):
    system, errors = oscillator(formulation), []
    on_paper = forced(np.array([1.0]), [(0.0, Polynomial([1.5]))], 1.0)[:, 0]
    for step in (0.02, 0.01):
        stepper = system.stepper(method=method, step=step)
        counts = []
        for t in np.linspace(0.0, 1.0, 11)[1:]:
            before = stepper.nfev
            stepper.advance(t)
            counts.append(stepper.nfev - before)
        assert set(counts[1:]) == {cost * round(0.1 / step)}
        assert stepper.nrejected == 0
        errors.append(np.abs(np.array([stepper.x[0], stepper.v[0]]) - on_paper).max())
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.2)


def test_a_step_that_does_not_fit_is_made_in_equal_parts():
    stepper = system_of("pendulum").stepper(method="rk4", step=0.3)
    stepper.advance(1.0)
    assert (stepper.t, stepper.nsteps, stepper.nfev) == (1.0, 4, 17)


@pytest.mark.parametrize("method", [*METHODS, *FIXED])
def test_saved_and_restored_to_the_last_bit(method):
    """On the way through eigenvalues that come close, where the triangular root takes over and gives back."""
    system, times = system_of("veering"), np.linspace(0, 22, 111)[1:]
    options = {"method": method, "rtol": 1e-8} | ({"step": 0.02} if method in FIXED else {})
    stepper, saved, rows = system.stepper(**options), [], []
    for t in times:
        saved.append(stepper.save())
        rows.append(stepped(stepper, [t])[0])
    bounded = system.simulate((0, 22), rtol=1e-8, method=method if method in METHODS else "dop853").n_bounded
    assert bounded > 0 or STEPPED[method].implicit  # these carry the motion, and no factors
    for k in range(0, len(times), 7):
        for other in (stepper, system.stepper(**options)):
            other.restore(saved[k])
            assert np.array_equal(stepped(other, times[k : k + 5]), rows[k : k + 5])
            assert other.save() == saved[k + 5] if k + 5 < len(saved) else True


def test_what_was_saved_elsewhere_is_refused():
    system = system_of("dual_link")
    saved = system.stepper().save()
    for other in (
        system_of("dual_link", "lagrange").stepper(),
        system.stepper(parameters={"K1": 1.1}),
        system.stepper(method="ra15"),
        system.stepper(rtol=1e-7),
        system_of("pendulum").stepper(),
    ):
        before = other.save()
        with pytest.raises(ValueError, match="saved by a stepper of another model, or with other parameters"):
            other.restore(saved)
        assert other.save() == before
    for bad in (saved[:-1], b"", b"\0" * len(saved)):
        with pytest.raises(ValueError, match="saved by a stepper of another model"):
            system.stepper().restore(bad)
    with pytest.raises(TypeError):
        system.stepper().restore("text")


def test_it_pickles_where_it_stands():
    system = oscillator("lagrange")
    system.compiled.recipe = partial(oscillator, "lagrange")
    stepper = system.stepper(inputs={"u": 0.3})
    stepped(stepper, TIMES[1:10], HELD)
    other = pickle.loads(pickle.dumps(stepper))
    assert type(other) is em.Stepper
    assert np.array_equal(stepped(other, TIMES[10:], HELD[9:]), stepped(stepper, TIMES[10:], HELD[9:]))


def test_to_the_same_time_and_back():
    stepper = system_of("dual_link").stepper(rtol=1e-11, atol=1e-11)
    start = stepper.x, stepper.v
    stepper.advance(0.0)
    assert stepper.nfev == 0
    for t in (1.0, 1.0, 0.3, 2.0, 0.0):
        stepper.advance(t)
        assert stepper.t == t
    assert max(np.abs(stepper.x - start[0]).max(), np.abs(stepper.v - start[1]).max()) < 1e-9
    stepper.advance(-1.0)
    back = system_of("dual_link").simulate((0, -1), rtol=1e-11, atol=1e-11)
    assert relative(stepper.x, back.x[:, -1]) < 1e-9


def test_signals_go_on_by_themselves_forwards_and_back():
    system = oscillator()
    given = Signal([-1.0, 0.5, 0.75, 5.0], [0.0, 2.0, -1.0, 1.0], "hold")
    stepper = system.stepper(inputs={"u": given}, **TIGHT)
    start = stepper.x
    stepper.advance(2.0)
    run = system.simulate((0, 2), inputs={"u": given}, **TIGHT)
    assert np.abs(stepper.x - run.x[:, -1]).max() < 1e-10
    assert stepper.outputs["u"] == -1.0
    stepper.advance(0.0)
    assert np.abs(stepper.x - start).max() < 1e-9
    with pytest.raises(ValueError, match="input 'u' is a signal of this stepper"):
        stepper.advance(1.0, {"u": 3.0})


@cache
def fragile():
    """x'' = log(1 - x) + u, which has no value from x = 1 on; an event at x = 1/2."""
    x, u = dynamicsymbols("x u")
    m = symbols("m", positive=True)
    return system_for(
        Model(
            name="fragile", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, forces={x: m * log(1 - x) + u},
            inputs={u: 0.0}, parameters={m: 1.0}, events={"half": x - 0.5, "end": em.Event(x - 0.75, terminal=True)},
        ),
        "lagrange",
    )  # fmt: skip


@pytest.mark.parametrize("method", [*METHODS, *FIXED])
def test_where_it_cannot_go_on_it_says_why_and_stands_where_it_came_to(method):
    step = {"step": 0.01} if method in FIXED else {}
    stepper = fragile().stepper(inputs={"u": 5.0}, method=method, **step)
    with pytest.raises(EvaluationError, match=r"fragile: at t = .*not finite") as caught:
        stepper.advance(2.0)
    assert caught.value.stop is StopReason.NON_FINITE_STATE
    t, x = stepper.t, stepper.x[0]
    assert 0.5 < t < 1.0
    assert 0.75 < x < 1.0
    assert np.isfinite(stepper.v).all()
    stepper.advance(t - 0.1, {"u": 0.0})
    assert stepper.t == t - 0.1


def test_events_are_told_and_none_ends_an_advance():
    stepper = fragile().stepper(inputs={"u": 2.0}, rtol=1e-10)
    found = [(stepper.advance(t), stepper.events)[1] for t in (0.5, 0.9, 0.95)]
    counts = [(len(one["half"]), len(one["end"])) for one in found]
    assert counts == [(0, 0), (1, 0), (0, 1)]
    run = fragile().simulate((0, 1.2), inputs={"u": 2.0}, rtol=1e-10)
    assert run.stop is StopReason.TERMINAL_EVENT
    assert found[1]["half"] == pytest.approx(run.t_events[0], abs=1e-9)
    assert found[2]["end"] == pytest.approx(run.t_events[1], abs=1e-9)


@pytest.mark.parametrize(("name", "end"), [("bouncing_ball", 1.5), ("block_on_incline", 1.0)])
def test_events_that_act_do_so_within_an_advance(name, end):
    """Impacts, friction that sticks: as in one run, and to the last bit from moments saved before and after."""
    system, times = system_of(name, "lagrange"), np.linspace(0, end, 31)[1:]
    stepper, saved = system.stepper(rtol=1e-10), []
    for t in times:
        saved.append(stepper.save())
        stepper.advance(t)
    last = stepper.y
    run = system.simulate((0, end), rtol=1e-10, t_eval=[end])
    assert np.abs(last - run.y[:, -1]).max() < 1e-9
    for k in (3, 15, 28):
        stepper.restore(saved[k])
        assert np.array_equal(stepped(stepper, times[k:])[-1], last)


def test_what_holds_in_a_contact_is_told_in_its_mode():
    """A ball at rest on the floor: no acceleration, and the floor carries its weight."""
    stepper = system_of("bouncing_ball", "lagrange").stepper(x0={"z": 0.01}, parameters={"e": 0.0, "m": 2.0})
    assert stepper.acceleration[1] == pytest.approx(-9.81)
    stepper.advance(1.0)
    assert stepper.acceleration == pytest.approx([0.0, 0.0], abs=1e-12)
    assert abs(stepper.multipliers) == pytest.approx([2.0 * 9.81])
    assert stepper.energy == pytest.approx(0.04, abs=1e-9)


def test_limits_are_of_one_advance():
    stepper = system_of("pendulum").stepper(max_steps=30, max_step=0.1)
    for t in (1.0, 3.0, 5.0):
        stepper.advance(t)
    with pytest.raises(EvaluationError) as caught:
        stepper.advance(9.0)
    assert caught.value.stop is StopReason.TOO_MANY_STEPS
    assert stepper.t == pytest.approx(8.0, abs=0.1)
    stepper.advance(9.0)


def test_where_it_stands():
    """Energies, accelerations, multipliers, outputs: those of the system there."""
    system = system_of("dual_link")
    stepper = system.stepper(rtol=1e-9)
    stepper.advance(1.5)
    x, v = stepper.x, stepper.v
    assert stepper.energy == system.energy(x, v)
    assert stepper.jacobi_integral == system.jacobi_integral(x, v)
    a, multipliers = system.acceleration(x, v)
    assert np.array_equal(stepper.acceleration, a)
    assert np.array_equal(stepper.multipliers, multipliers)
    assert relative(system.rhs(1.5, stepper.y)[:4], v) < 1e-12
    assert repr(stepper) == "<Stepper of dual_link at t = 1.5>"
    driven = oscillator().stepper(inputs={"u": 2.0})
    assert driven.u == [2.0]
    assert driven.outputs == {"u": 2.0}
