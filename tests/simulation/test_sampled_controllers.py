"""Controllers inside a run: asked every period, held in between, against steppers and runs with what was held."""

import pickle
import re
import signal

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion import ModelError, Sampled, Signal, StopReason
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_of
from .test_inputs import TIGHT, oscillator

PERIOD = 0.1


def damping(t, x, v):
    """What a Sampled input asks: it must be found where a pickle is loaded."""
    return -3.0 * v[0] - 2.0 * x[0] + t


def by_hand(system, end, method="dop853", delay=0):
    """The same by a stepper, a delay of so many periods; y at the end."""
    stepper, late = system.stepper(method=method, **TIGHT), [1.5] * delay
    for k in range(round(end / PERIOD)):
        late.append(damping(stepper.t, stepper.x, stepper.v))
        stepper.advance((k + 1) * PERIOD, {"u": late.pop(0)})
    return stepper.y


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("delay", [0, 1])
def test_as_a_stepper_would(method, delay):
    system = oscillator("lagrange")
    control = Sampled(damping, PERIOD, delay=delay * PERIOD)
    run = system.simulate((0, 2), inputs={"u": control}, method=method, **TIGHT)
    assert run.success
    assert run.method == method
    assert np.abs(run.y[:, -1] - by_hand(system, 2, method, delay)).max() < 1e-13
    assert np.unique(run.outputs["u"]).size == 20


@pytest.mark.parametrize("delay", [0.0, 0.03, PERIOD])
def test_the_solution_holds_what_was_held(delay):
    """Run again with those signals and without a controller, it is the same motion; rows and outputs are of them."""
    asked = []

    def ask(t, x, v):
        asked.append((t, x, v))
        return damping(t, x, v)

    system, rows = oscillator(), np.linspace(0, 1, 41)
    run = system.simulate(
        (0, 1), inputs={"u": Sampled(ask, PERIOD, delay, 0.25)}, t_eval=rows, dense_output=True, **TIGHT
    )
    assert [t for t, _, _ in asked] == [k * PERIOD for k in range(10)]
    answers = [(t + delay, damping(t, x, v)) for t, x, v in asked]
    times, values = map(list, zip(*[(t, u) for t, u in answers if t < 1.0], strict=True))
    if delay:
        times, values = [0.0, *times], [0.25, *values]
    held = Signal(times, values, "hold")
    again = system.simulate((0, 1), inputs={"u": held}, t_eval=rows, **TIGHT)
    assert np.abs(run.y - again.y).max() < 1e-12
    assert run.outputs["u"] == pytest.approx(held(rows), abs=1e-12)
    assert run.sol(0.5)[0] == pytest.approx(run.x[0, 20], abs=1e-10)
    for t, x, _ in asked:
        assert x[0] == pytest.approx(run.sol(t)[0], abs=1e-10)


def test_two_controllers_at_their_own_pace():
    """Each is asked at its times; at those of both, both."""
    told: dict[str, list[float]] = {"a": [], "b": []}
    system = two_inputs()

    def telling(name, value):
        def ask(t, x, v):
            told[name].append(t)
            return value(t)

        return ask

    a = Sampled(telling("a", np.sin), 0.2)
    b = Sampled(telling("b", np.cos), 0.3, delay=0.1)
    run = system.simulate((1.0, 2.0), inputs={"a": a, "b": b}, rtol=1e-10)
    assert told["a"] == pytest.approx([1.0, 1.2, 1.4, 1.6, 1.8])
    assert told["b"] == pytest.approx([1.0, 1.3, 1.6, 1.9])
    held_a = Signal(told["a"], np.sin(told["a"]), "hold")
    held_b = Signal([1.0, *(np.array(told["b"][:-1]) + 0.1)], [0.5, *np.cos(told["b"][:-1])], "hold")
    again = system.simulate((1.0, 2.0), inputs={"a": held_a, "b": held_b}, rtol=1e-10)
    assert run.x[:, -1] == pytest.approx(again.x[:, -1], abs=1e-9)


def two_inputs():
    from sympy import symbols  # noqa: PLC0415
    from sympy.physics.mechanics import dynamicsymbols  # noqa: PLC0415

    from ..support.generation import system_for  # noqa: PLC0415

    x, a, b = dynamicsymbols("x a b")
    m = symbols("m", positive=True)
    return system_for(
        em.Model(name="pushed", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, forces={x: a - b * x},
                 inputs={a: 0.0, b: 0.5}, parameters={m: 1.0}), "lagrange",
    )  # fmt: skip


def test_what_a_controller_raises_comes_out_as_it_is():
    class BrokenError(Exception):
        pass

    def ask(t, x, v):
        if t > 0.45:
            raise BrokenError("no more")
        return 1.0

    system = oscillator()
    with pytest.raises(BrokenError, match="no more") as caught:
        system.simulate((0, 2), inputs={"u": Sampled(ask, PERIOD)})
    kept = caught.value.solution
    assert kept.t[-1] == pytest.approx(0.5)
    assert (kept.success, kept.stop) == (False, StopReason.INTERRUPTED)
    whole = system.simulate((0, 0.5), inputs={"u": 1.0})
    assert kept.x[:, -1] == pytest.approx(whole.x[:, -1], abs=1e-5)


@pytest.mark.parametrize("said", [np.nan, np.inf, None, "fast", [1.0, 2.0]])
def test_what_is_no_number_is_named(said):
    with pytest.raises(ModelError, match=r"input 'u' at t = 0.2: a number is needed") as caught:
        oscillator().simulate((0, 1), inputs={"u": Sampled(lambda t, x, v: said if t > 0.15 else 0.0, PERIOD)})
    assert caught.value.solution.t[-1] == pytest.approx(0.2)


def test_a_run_that_ends_early_asks_no_more():
    """Too many steps, or Ctrl-C while it is compiled code's turn."""
    system, asked = oscillator(), []
    run = system.simulate((0, 50), inputs={"u": Sampled(lambda t, x, v: asked.append(t) or 0.0, PERIOD)}, max_steps=60)
    assert run.stop is StopReason.TOO_MANY_STEPS
    assert run.nsteps == 60
    assert asked[-1] <= run.t[-1]

    def interrupt(t, x, v):
        signal.raise_signal(signal.SIGINT)
        return 0.0

    with pytest.raises(KeyboardInterrupt) as caught:
        system.simulate((0, 5), inputs={"u": Sampled(interrupt, 1.0)})
    assert caught.value.solution.t[-1] == 0.0


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"t_span": (1.0, 0.0)}, "for runs forwards in time"),
        ({"estimate_error": True}, "estimate_error asks a controller twice"),
    ],
)
def test_what_controllers_cannot_be_asked_in(options, words):
    with pytest.raises(ModelError, match=re.escape(words)):
        oscillator().simulate(**({"t_span": (0.0, 1.0), "inputs": {"u": Sampled(damping, 0.1)}} | options))


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ((3, 0.1), "cannot be called"),
        ((damping, 0.0), "period of a Sampled input is 0.0, but must be above 0"),
        ((damping, np.nan), "the period of a Sampled input"),
        ((damping, 0.1, 0.2), "delay of a Sampled input is 0.2"),
        ((damping, 0.1, -0.1), "delay of a Sampled input is -0.1"),
        ((damping, 0.1, 0.0, "x"), "the initial value of a Sampled input"),
    ],
)
def test_what_is_no_controller(given, words):
    with pytest.raises(ModelError, match=re.escape(words)):
        Sampled(*given)


def test_only_simulate_asks():
    system, inputs = oscillator(), {"u": Sampled(damping, 0.1)}
    for call in (
        lambda: system.stepper(inputs=inputs),
        lambda: em.simulate_ensemble(system, (0, 1), inputs=inputs, x0={"x": [0.0, 1.0]}),
    ):
        with pytest.raises(ModelError, match="Sampled"):
            call()


def test_it_travels():
    """A controller, and what came of a run with one."""
    control = pickle.loads(pickle.dumps(Sampled(damping, 0.1, 0.05)))
    assert (control.function, control.period, control.delay, control.initial) == (damping, 0.1, 0.05, None)
    system = system_of("furuta_pendulum")
    run = system.simulate((0, 1), inputs={"u": Sampled(lambda t, x, v: x[1] + 0.1 * v[1], 0.01)})
    assert run.success
    assert run.model.name == "furuta_pendulum"


def test_auto_takes_an_explicit_method_where_a_controller_is_to_be_asked():
    system = system_of("furuta_pendulum", "lagrange")
    run = system.simulate((0.0, 0.1), inputs={"u": em.Sampled(lambda t, x, v: -v[0], 0.01)}, method="auto", rtol=1e-9)
    assert run.success
    assert run.method in ("dop853", "ra15")


def test_a_function_as_an_input_is_told_what_to_be():
    with pytest.raises(em.ModelError, match=r"input 'u' is a function.*\(times, f\(times\)\).*em\.Sampled"):
        system_of("furuta_pendulum", "lagrange").simulate((0.0, 0.1), inputs={"u": lambda t: 0.0})
