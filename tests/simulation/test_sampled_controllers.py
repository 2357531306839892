"""Controllers inside a run: asked every period, held in between, against steppers and runs with what was held."""

import pickle
import re
import signal

import numpy as np
import pytest
import sympy
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError, Sampled, Signal, StopReason, System
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_of
from .test_inputs import TIGHT, oscillator

PERIOD = 0.1


def damping(t, x, v):
    """What a Sampled input asks: it must be found where a pickle is loaded."""
    return -3.0 * v[0] - 2.0 * x[0] + t


class Integral:
    """A controller with a state of its own."""

    def __init__(self):
        self.sum = 0.0

    def __call__(self, t, x, v):
        self.sum += PERIOD * x[0]
        return -4.0 * self.sum - v[0]


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
        ((damping,), "period of a Sampled input is 0.0, but must be above 0"),
        ((None, 0.1), "needs a function, or make="),
        ((damping, 0.1, 0.0, None, Integral), "needs a function, or make="),
        ((None, 0.1, 0.0, None, 3), "the make of a Sampled input is 3, which cannot be called"),
        ((damping, np.nan), "the period of a Sampled input"),
        ((damping, 0.1, 0.2), "delay of a Sampled input is 0.2"),
        ((damping, 0.1, -0.1), "delay of a Sampled input is -0.1"),
        ((damping, 0.1, 0.0, "x"), "the initial value of a Sampled input"),
    ],
)
def test_what_is_no_controller(given, words):
    with pytest.raises(ModelError, match=re.escape(words)):
        Sampled(*given)


@pytest.mark.parametrize("function", [lambda x, v, t: 0.0, lambda v, x, t: 0.0, lambda t, y: 0.0, lambda: 0.0])
def test_another_order_of_arguments_is_named(function):
    """Such a function would take the time for a position, without an error."""
    with pytest.raises(ModelError, match=r"called with \(t, x, v\), but <lambda> takes \("):
        Sampled(function, PERIOD)
    with pytest.raises(ModelError, match=r"called with \(t, x, v\)"):
        Sampled(make=lambda: function, period=PERIOD).controller()


def test_other_names_of_arguments_are_taken():
    for function in (lambda *given: 0.0, lambda time, q, qdot: 0.0, lambda t, x, v, gain=1.0: 0.0, damping, Integral()):
        assert Sampled(function, PERIOD).controller() is function


@pytest.mark.parametrize("steppers", [System.stepper, lambda system, inputs: system.steppers(2, inputs=inputs)])
def test_steppers_do_not_ask(steppers):
    with pytest.raises(ModelError, match=r"Sampled.* between two advances"):
        steppers(oscillator(), inputs={"u": Sampled(damping, 0.1)})


def both(t, x, v):
    """Answers for a and b of `two_inputs`."""
    return np.array([np.sin(t) - x[0], 0.5 + 0.1 * v[0]])


@pytest.mark.parametrize("delay", [0, 1])
@pytest.mark.parametrize("order", [("a", "b"), ("b", "a")])
def test_one_controller_of_several_inputs(order, delay):
    """Against a stepper in a loop; it is asked once a period for all of them."""
    system, asked = two_inputs(), []

    def control(t, x, v):
        asked.append(t)
        return list(both(t, x, v)) if order == ("a", "b") else tuple(both(t, x, v)[::-1])

    control = Sampled(control, PERIOD, delay * PERIOD, initial=(0.25, 0.75))
    run = system.simulate((0, 1), inputs={order: control}, **TIGHT)
    stepper, late = system.stepper(**TIGHT), [dict(zip(order, (0.25, 0.75), strict=True))] * delay
    for k in range(10):
        late.append(dict(zip("ab", both(stepper.t, stepper.x, stepper.v), strict=True)))
        stepper.advance((k + 1) * PERIOD, late.pop(0))
    assert len(asked) == 10
    assert np.abs(run.x[:, -1] - stepper.x).max() < 1e-13
    again = system.simulate((0, 1), inputs=dict(zip("ab", run._rows.task.inputs.signals, strict=True)), **TIGHT)
    assert np.abs(again.x[:, -1] - stepper.x).max() < 1e-12


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ([1.0], "inputs 'a', 'b' at t = 0.2: a sequence of 2 numbers is needed"),
        (1.0, "inputs 'a', 'b' at t = 0.2: a sequence of 2 numbers is needed"),
        ("ab", "inputs 'a', 'b' at t = 0.2: a sequence of 2 numbers is needed"),
        ((1.0, np.nan), "input 'b' at t = 0.2: a number is needed"),
        ((1.0, None), "input 'b' at t = 0.2: a number is needed"),
    ],
)
def test_wrong_answers_for_several_inputs_are_named(said, words):
    control = Sampled(lambda t, x, v: said if t > 0.15 else (0.0, 0.0), PERIOD)
    with pytest.raises(ModelError, match=re.escape(words)):
        two_inputs().simulate((0, 1), inputs={("a", "b"): control})


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ({("a", "b"): 1.0}, "inputs 'a', 'b' are given 1.0 at once"),
        ({("a", "c"): Sampled(both, PERIOD)}, "unknown input 'c'"),
        ({("a", "b"): Sampled(both, PERIOD), "a": 1.0}, "input 'a' is given twice"),
        ({("a", "a"): Sampled(both, PERIOD)}, "input 'a' is given twice"),
        ({(): Sampled(both, PERIOD)}, "a tuple of no names"),
        ({("a", "b"): Sampled(both, PERIOD, initial=(1.0,))}, "initial is (1.0,), but must be a sequence of 2 numbers"),
        ({("a", "b"): Sampled(both, PERIOD, initial=1.0)}, "initial is 1.0, but must be a sequence of 2 numbers"),
        ({"a": Sampled(both, PERIOD, initial=(1.0,))}, "initial is (1.0,), but must be a number"),
    ],
)
def test_what_several_inputs_cannot_be_given(inputs, words):
    with pytest.raises(ModelError, match=re.escape(words)):
        two_inputs().simulate((0, 1), inputs=inputs)


def test_each_run_has_a_controller_that_is_made_for_it():
    system, control = oscillator(), Sampled(make=Integral, period=PERIOD)
    first, second = (system.simulate((0, 1), inputs={"u": control}).x[:, -1] for _ in range(2))
    assert np.all(first == second)
    kept = Sampled(Integral(), PERIOD)
    assert np.any(first != [system.simulate((0, 1), inputs={"u": kept}).x[:, -1] for _ in range(2)][1])


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


def test_a_row_in_time_is_no_jump_where_a_run_began_at_a_time_event():
    """The controller changes its input where nothing else happens; the force jumps at the start, and later."""
    x, y, push = dynamicsymbols("x y push")
    model = em.Model(name="begun", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                     holonomic_constraints=[y - sympy.sin(2 * em.t)], inputs={push: 0.0},
                     forces={x: push + sympy.Mod(em.t, sympy.Rational(1, 2))}, initial={y.diff(): 2.0})  # fmt: skip
    given = em.Sampled(lambda t, x, v: t, 0.25)
    sol = em.simulate(em.build(model), (0.0, 1.0), inputs={"push": given}, rtol=1e-10)
    assert sol.success
    assert sol.v[0, -1] == pytest.approx(2 / 8 + 0.25 * (0.25 + 0.5 + 0.75), abs=1e-12)
    assert sol.x[1] == pytest.approx(np.sin(2 * sol.t), abs=1e-12)
