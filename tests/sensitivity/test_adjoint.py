"""Gradients by the adjoint: against closed forms, and the sensitivities of runs, which are tested on their own."""

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from importlib import import_module
from multiprocessing import get_context
from typing import Any

import numpy as np
import pytest
from eigenmotion.models.pendulum import model as pendulum
from sympy import cos, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, ModelError, System, t
from eigenmotion.arguments.differentiation import names_of

from ..support.generation import system_for, system_of
from ..support.models_table import EVERY, Scenario

TIGHT = {"rtol": 1e-10, "atol": 1e-12}
z = dynamicsymbols("z")
g, e, m = symbols("g e m", positive=True)


def both(system: System, end: float, by: list[str], seed: int = 0, **options: Any) -> tuple[Any, Any, Any]:
    """Return gradients (names,) of a random function of the rows: adjoint, forwards, and the size of the terms."""
    memory = {"memory": options.pop("memory")} if "memory" in options else {}
    run = system.simulate((0.0, end), sensitivities=by, **options)
    assert run.success, run.message
    solution, pullback = em.vjp(system, (0.0, end), by=by, **options, **memory)
    np.testing.assert_array_equal(solution.y, run.y)
    dx, dv = np.random.default_rng(seed).standard_normal((2, *run.x.shape))
    found = pullback(dx=dx, dv=dv)
    assert list(found) == by
    terms = [(dx * run.sensitivity[name].dx, dv * run.sensitivity[name].dv) for name in by]
    right = np.array([one.sum() + other.sum() for one, other in terms])
    return np.array(list(found.values())), right, np.array([abs(one).sum() + abs(other).sum() for one, other in terms])


def all_names(system: System) -> list[str]:
    """Return what runs can be differentiated by."""
    c = system.compiled
    held = {f"{event}{end}" for event in c.events for end in ("_held", "_idle", "_way", "_sticks")}
    quasi = set(c.quasi_velocities) if c.initial_y is None else {f"{name}'" for name in c.coordinates}
    return [name for name in names_of(c) if name not in quasi | held | set(c.tables)]


@EVERY
def test_against_sensitivities_of_every_model(scenario: Scenario):
    """Quantities without influence included: Kepler's motion does not depend on the mass of the planet."""
    system, end = system_for(scenario.model(), "eigenfactor"), min(scenario.t_end, 2.0)
    found, right, size = both(system, end, all_names(system), t_eval=np.linspace(0.0, end, 7), **TIGHT)
    assert (np.abs(found - right) <= 1e-8 * size + 1e-12 * size.max()).all()


ACTING = ["bouncing_ball", "block_on_incline", "clock", "rimless_wheel", "compass_gait", "pendulum_with_stop",
          "cam_follower", "servo_pendulums", "governor"]  # fmt: skip
END = {"cam_follower": 0.3}  # with fifty impacts: 1,500 steps, from join to join of its table


@pytest.mark.parametrize("name", ACTING)
@pytest.mark.parametrize("memory", [256.0, 0.0])
def test_through_events(name: str, memory: float):
    """Impacts, contacts, frictions, resets, tables and states, as one part and in parts of sixteen steps."""
    system, end = system_of(name, "lagrange"), END.get(name, 1.5)
    found, right, size = both(system, end, all_names(system), t_eval=np.linspace(0.0, end, 12), memory=memory, **TIGHT)
    assert (np.abs(found - right) <= 1e-8 * size + 1e-12 * size.max()).all()


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853", "ra15", "radau5", "radau9"])
def test_every_method_and_row(method: str):
    """A row for every step, those before and after impacts included."""
    system = system_of("pendulum_with_stop", "lagrange")
    found, right, size = both(system, 1.5, all_names(system), method=method, rtol=1e-8, atol=1e-10)
    assert (np.abs(found - right) <= 1e-6 * size + 1e-12 * size.max()).all()


def test_impacts_that_stay_simultaneous():
    """A cradle: the balls at rest meet at once, however the first one starts."""
    system, by = system_of("newtons_cradle", "lagrange"), ["theta1", "g", "l"]
    found, right, size = both(system, 1.5, by, t_eval=np.linspace(0.0, 1.5, 12))
    assert (np.abs(found - right) <= 1e-8 * size).all()


def ball() -> System:
    return system_for(
        Model(name="let_fall", coordinates=[z], kinetic_energy=m * z.diff() ** 2 / 2, potential_energy=m * g * z,
              events={"floor": Event(z, direction=-1, impact=(z, e))}, parameters={m: 2.0, g: 9.81, e: 0.9},
              outputs={"weight": m * z.diff(), "force": m * z.diff().diff()}, initial={z: 1.0}),
        "lagrange")  # fmt: skip


def test_closed_form_after_a_bounce():
    """z(t) = e s (t - t_1) - g (t - t_1)^2 / 2 after t_1 = sqrt(2 h / g), with s = g t_1."""
    time, height, gravity, bounce = symbols("t h G E", positive=True)
    first = sqrt(2 * height / gravity)
    place = bounce * gravity * first * (time - first) - gravity * (time - first) ** 2 / 2
    values = {time: 0.7, height: 1.0, gravity: 9.81, bounce: 0.9}
    _, pullback = em.vjp(ball(), (0.0, 0.7), by=["z", "g", "e", "m"], t_eval=[0.7], **TIGHT)
    for of, cotangents in ((place, {"dx": [[1.0]]}), (place.diff(time), {"dv": [[1.0]]})):
        right = [float(of.diff(name).subs(values)) for name in (height, gravity, bounce)]
        np.testing.assert_allclose(list(pullback(**cotangents).values()), [*right, 0.0], rtol=1e-9, atol=1e-13)
    weight = 2.0 * place.diff(time)
    right = [
        *(float(weight.diff(name).subs(values)) for name in (height, gravity, bounce)),
        float(place.diff(time).subs(values)),
    ]
    np.testing.assert_allclose(list(pullback(outputs={"weight": [1.0]}).values()), right, rtol=1e-9)
    np.testing.assert_allclose(list(pullback(outputs={"force": [1.0]}).values()), [0.0, -2.0, 0.0, -9.81], atol=1e-12)


def test_states_are_pulled_back():
    """A filter s' = (x - s) / T of a mass at constant speed: s = v (t - T + T exp(-t / T))."""
    place, filtered = dynamicsymbols("x s")
    time = symbols("T", positive=True)
    system = system_for(
        Model(name="filtered", coordinates=[place], kinetic_energy=place.diff() ** 2 / 2, parameters={time: 0.5},
              states={filtered: (place - filtered) / time}, initial={place.diff(): 2.0}), "lagrange")  # fmt: skip
    _, pullback = em.vjp(system, (0.0, 1.0), by=["x'", "T", "s"], t_eval=[1.0], **TIGHT)
    decay = np.exp(-2.0)
    right = [1.0 - 0.5 + 0.5 * decay, 2.0 * (-1.0 + decay + 2.0 * decay), decay]
    np.testing.assert_allclose(list(pullback(states={"s": [1.0]}).values()), right, rtol=1e-9)


def test_a_long_run_in_bounded_memory():
    """What is kept of a run in parts does not grow with its steps, and the gradient is that of the run as a whole."""
    system = system_of("driven_pendulum", "lagrange")
    options = {"by": ["l", "a", "x"], "t_eval": np.linspace(0.0, 100.0, 11), "rtol": 1e-9, "max_step": 0.05}
    whole, parts = (em.vjp(system, (0.0, 100.0), **options, memory=memory)[1] for memory in (256.0, 0.05))
    dx = np.zeros((system.n, 11))
    dx[:, 1] = 1.0
    np.testing.assert_allclose(list(parts(dx=dx).values()), list(whole(dx=dx).values()), rtol=1e-9)


@pytest.mark.parametrize(("wrong", "words"), [
    ({"by": ["h"]}, "unknown name in by"), ({"by": ["z"], "sensitivities": ["z"]}, "unknown option"),
    ({"by": ["z"], "max_steps": 3}, "no gradient, because it failed"),
    ({"by": ["z"], "dense_output": True}, "unknown option"),
])  # fmt: skip
def test_mistakes(wrong: dict[str, Any], words: str):
    with pytest.raises(ModelError, match=words):
        em.vjp(ball(), (0.0, 1.0), **wrong)


@pytest.mark.parametrize(("wrong", "words"), [
    ({"dx": [1.0]}, "dx has shape"), ({"outputs": {"heavy": [1.0]}}, "weight"), ({"outputs": [1.0]}, "a mapping"),
    ({"dv": [[np.nan]]}, "not finite"), ({"outputs": {"weight": 1.0}}, "has shape"),
])  # fmt: skip
def test_mistakes_of_cotangents(wrong: dict[str, Any], words: str):
    _, pullback = em.vjp(ball(), (0.0, 1.0), by=["z"], t_eval=[1.0])
    with pytest.raises(ModelError, match=words):
        pullback(**wrong)


@pytest.mark.parametrize("small", [1e-2, 1e-6, 1e-12])
@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_a_small_quantity_beside_a_large_one(small: float, method: str):
    """Forces q cos t + p x cos 200 t: steps resolve what p does, however small it is beside q."""
    x, q, p = dynamicsymbols("x"), *symbols("q p", positive=True)
    system = system_for(
        Model(name="two_forces", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
              forces=[q * cos(t) + p * x * cos(200 * t)], parameters={q: 1.0, p: 1.0}, initial={x: 1.0}),
        "lagrange")  # fmt: skip
    options = {"t_eval": [3.0], "parameters": {"p": small}}
    exact = system.simulate((0, 3), sensitivities=["p"], rtol=1e-12, atol=1e-14, max_step=0.005, **options)
    _, pullback = em.vjp(system, (0, 3), by=["q", "p", "x", "x'"], rtol=1e-8, method=method, **options)
    assert pullback(dx=[[1.0]])["p"] == pytest.approx(exact.sensitivity["p"].dx[0, 0], rel=1e-5)


def test_rows_before_events_and_at_the_end():
    """No row lies after the last event, or the run ends at one."""
    for at in ([0.1, 0.2], [0.5], [0.1, 1.2]):
        found, right, size = both(ball(), 1.2, ["z", "e"], t_eval=at, **TIGHT)
        assert (np.abs(found - right) <= 1e-8 * size + 1e-14).all()


def test_what_simulate_refuses_or_says():
    with pytest.raises(ModelError, match="backwards"):
        em.vjp(ball(), (1.0, 0.0), by=["z"])
    for memory in (np.nan, -1.0, "much"):
        with pytest.raises(ModelError, match="megabytes"):
            em.vjp(ball(), (0.0, 1.0), by=["z"], memory=memory)
    assert em.vjp(ball(), (0.0, 0.1), by=["z"], memory=np.inf)[0].success


@pytest.mark.parametrize("name", ["pendulum_with_stop", "block_on_incline", "cam_follower", "servo_pendulums"])
@pytest.mark.parametrize("memory", [256.0, 0.0])
def test_a_pullback_pickles(name: str, memory: float):
    """It was a function within a function, which does not; it makes the run again, with the same bits."""
    system, rows = (
        em.build(import_module(f"eigenmotion.models.{name}").model, formulation="lagrange"),
        np.linspace(0.0, END.get(name, 1.5), 12),
    )
    options = {"by": all_names(system), "t_eval": rows, "method": "auto", "memory": memory}
    solution, pullback = em.vjp(system, (0.0, rows[-1]), **options)
    again, other = pickle.loads(pickle.dumps((solution, pullback)))
    dx = np.random.default_rng(1).standard_normal(solution.x.shape)
    outputs = {one: np.cos(rows) for one in solution.outputs}
    np.testing.assert_array_equal(again.y, solution.y)
    assert other(dx=dx, outputs=outputs) == pullback(dx=dx, outputs=outputs)
    assert copy.deepcopy(pullback) is pullback


def test_a_pullback_works_in_another_process():
    """Of a system that em.build returned, which other processes can make, too."""
    solution, pullback = em.vjp(em.build(pendulum, formulation="lagrange"), (0.0, 1.0), by=["l", "theta"])
    dx = np.ones_like(solution.x)
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        assert pool.submit(pullback, dx=dx).result() == pullback(dx=dx)
