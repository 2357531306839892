"""Ensembles whose inputs controllers set: the bits of single runs, and a controller for each run."""

from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion import ModelError, Sampled, StopReason

from ..simulation.test_inputs import oscillator
from ..simulation.test_sampled_controllers import PERIOD, Integral, both, damping, two_inputs

STARTS = np.linspace(-1.0, 1.0, 5)
GIVEN = {"rtol": 1e-9, "atol": 1e-9}


def runs_of(control, system=None, **how):
    return em.simulate_ensemble(system or oscillator(), (0.0, 1.0), inputs={"u": control}, x0={"x": STARTS},
                                **GIVEN, **how)  # fmt: skip


def alone(control, start, **how):
    return oscillator().simulate((0.0, 1.0), inputs={"u": control}, x0={"x": start}, **GIVEN, **how)


@pytest.mark.parametrize("control", [
    lambda: Sampled(damping, PERIOD, 0.03), lambda: Sampled(Integral(), PERIOD),
    lambda: Sampled(make=Integral, period=PERIOD), lambda: Sampled(Integral().__call__, PERIOD, PERIOD),
])  # fmt: skip
@pytest.mark.parametrize("t_eval", [None, [0.0, 0.33, 1.0]])
def test_the_bits_of_single_runs(control, t_eval):
    given = control()
    for workers in (1, 2):
        runs = runs_of(given, t_eval=t_eval, workers=workers)
        assert len(runs.failed) == 0
        for k, start in enumerate(STARTS):
            one = alone(control(), start, t_eval=t_eval)
            last = slice(-1, None) if t_eval is None else slice(None)
            assert np.all(runs[k].y == one.y[:, last])
            assert np.all(runs.outputs["u"][k] == one.outputs["u"][last])
            assert runs[k].message == one.message


def test_threads_share_the_runs(monkeypatch):
    monkeypatch.setattr("eigenmotion.batch.controlled_runs._LEAST", 1)
    one, three = (runs_of(Sampled(Integral(), PERIOD), workers=workers) for workers in (1, 3))
    assert np.all(one.y == three.y)


def test_a_controller_for_each_run_and_several_inputs():
    """A list of controllers, each at a pace of its own."""
    system = two_inputs()
    controls = [Sampled(both, period) for period in (0.1, 0.1, 0.07)]
    runs = em.simulate_ensemble(system, (0.0, 1.0), inputs={("b", "a"): controls}, **GIVEN)
    for k, control in enumerate(controls):
        one = system.simulate((0.0, 1.0), inputs={("b", "a"): control}, **GIVEN)
        assert np.all(runs.x[k, :, -1] == one.x[:, -1])


class Failing:
    """A controller that fails where its run comes too far."""

    def __init__(self, error):
        self.error = error

    def __call__(self, t, x, v):
        if t > 0.45 and x[0] * np.sign(STARTS[4]) < -0.2:
            if self.error is None:
                return np.nan
            raise self.error
        return 0.0


@pytest.mark.parametrize(
    ("error", "words"), [(ZeroDivisionError("no more"), "a controller raised ZeroDivisionError: no more"),
                         (None, "input 'u' at t = .*: a number is needed")],
)  # fmt: skip
def test_a_controller_that_fails_costs_its_run_alone(error, words, caplog):
    runs = runs_of(Sampled(Failing(error), PERIOD))
    assert 0 < len(runs.failed) < 5
    for k in range(5):
        if k in runs.failed:
            assert runs.stop[k] is StopReason.INTERRUPTED
            assert runs.t_end[k] < 1.0
            with pytest.raises(AssertionError, match=f"^At t = .*: member {k}: {words}"):
                raise AssertionError(runs.message(k))
        else:
            assert np.all(runs.x[k, :, -1] == alone(Sampled(Failing(error), PERIOD), STARTS[k]).x[:, -1])


def test_a_run_that_cannot_start_costs_itself_alone():
    runs = em.simulate_ensemble(oscillator(), (0.0, 1.0), inputs={"u": Sampled(damping, PERIOD)},
                                x0={"x": [0.5, np.nan, 0.5]}, **GIVEN)  # fmt: skip
    assert runs.failed.tolist() == [1]
    assert np.all(runs.x[0] == runs.x[2])
    assert np.isnan(runs.outputs["u"][1]).all()


memory = []
counted = 0


def remembering(t, x, v):
    memory.append(x[0])
    return 0.0


def counting(t, x, v):
    global counted  # noqa: PLW0603, what is refused
    counted += 1
    return 0.0


def closure(kept):
    return lambda t, x, v: kept.__setitem__(0, t) or 0.0


def within(sum_=0.0):
    def control(t, x, v):
        nonlocal sum_
        sum_ += x[0]
        return sum_

    return control


@pytest.mark.parametrize(
    ("control", "name"),
    [(remembering, "memory"), (counting, "counted"), (closure([0.0]), "kept"), (within(), "sum_")],
)
def test_what_a_function_keeps_is_never_shared_silently(control, name):
    with pytest.raises(ModelError, match=f"input 'u': its controller changes '{name}', .*make="):
        runs_of(Sampled(control, PERIOD))


def test_what_make_returns_is_never_shared_silently():
    only = Integral()
    for make in (lambda: only, lambda: only.__call__):
        with pytest.raises(ModelError, match=r"make of input 'u' returned .* before"):
            runs_of(Sampled(make=make, period=PERIOD))
    with pytest.raises(ModelError, match="its controller changes 'only'"):
        runs_of(Sampled(make=lambda: lambda t, x, v: 2.0 * only(t, x, v), period=PERIOD))
    assert len(runs_of(Sampled(make=within, period=PERIOD)).failed) == 0


def test_a_make_that_fails_costs_its_run_alone():
    made = iter([Integral(), None])

    def make():
        return next(made) or 1 / 0

    runs = em.simulate_ensemble(oscillator(), (0.0, 1.0), inputs={"u": Sampled(make=make, period=PERIOD)},
                                x0={"x": [0.5, 0.5]}, **GIVEN)  # fmt: skip
    assert runs.failed.tolist() == [1]
    assert "make of input 'u' raised ZeroDivisionError" in runs.message(1)


def test_what_cannot_be_copied_or_watched_is_named():
    unwatched = (one for one in ())
    with pytest.raises(ModelError, match=r"refers to 'unwatched', of type generator.*make="):
        runs_of(Sampled(lambda t, x, v: 0.0 if unwatched else 1.0, PERIOD))
    held = Integral()
    held.lines = unwatched
    with pytest.raises(ModelError, match=r"cannot be copied for each run.*make="):
        runs_of(Sampled(held, PERIOD))


class Weak(Integral):
    """A controller that a small motor could follow."""

    def __call__(self, t, x, v):
        return 1e-3 * super().__call__(t, x, v)


def test_other_processes(monkeypatch):
    """What travels gives the same bits; what cannot is refused by name."""
    root = Path(__file__).parents[2]
    monkeypatch.setenv("PYTHONPATH", str(root))  # where workers find the controllers of this file
    system = em.build(root / "models" / "furuta_pendulum.py", formulation="lagrange")
    given = {"t_eval": [0.5, 1.0], "x0": {"phi": [0.1, 0.2, 0.3]}, **GIVEN}
    here = em.simulate_ensemble(system, (0.0, 1.0), inputs={"u": Sampled(Weak(), PERIOD)}, **given)
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        there = em.simulate_ensemble(system, (0.0, 1.0), inputs={"u": Sampled(Weak(), PERIOD)}, executor=pool, **given)
        with pytest.raises(ModelError, match=r"input 'u': the controller .* cannot travel .* workers="):
            em.simulate_ensemble(system, (0.0, 1.0), inputs={"u": Sampled(lambda *_: 0.0, PERIOD)}, executor=pool)
    assert len(there.failed) == 0
    assert np.all(there.y == here.y)
    assert np.all(there[2].multipliers == here[2].multipliers)


def test_what_controllers_cannot_be_asked_in():
    inputs = {"u": Sampled(damping, PERIOD)}
    with pytest.raises(ModelError, match="forwards in time"):
        em.simulate_ensemble(oscillator(), (1.0, 0.0), inputs=inputs)
    with pytest.raises(ModelError, match="sensitivities do not go through a controller"):
        em.simulate_ensemble(oscillator(), (0.0, 1.0), inputs=inputs, sensitivities=["m"])
