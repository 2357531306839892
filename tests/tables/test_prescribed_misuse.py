"""Prescribed motions as a user may get them wrong, or go on to the edge of what they are for."""

import pickle
import time
from dataclasses import replace

import numpy as np
import pytest
import sympy
from scipy.interpolate import CubicSpline, RectBivariateSpline, make_interp_spline
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import multiplier

from ..support.generation import system_for

q, y, path, speed, force = dynamicsymbols("q y path speed force")
TIMES = np.linspace(0.0, 10.0, 2001)


def motion(times, order=0):
    """A motion of a crank, or a derivative of it."""
    phase = order * np.pi / 2
    return np.sin(times + phase) + 0.1 * 3**order * np.sin(3 * times + phase)


def driven(**others) -> em.Model:
    fields = {"name": "driven", "coordinates": [q, y], "kinetic_energy": q.diff() ** 2 * (2 + sympy.cos(q)) / 2
              + y.diff() ** 2 / 2, "holonomic_constraints": {"drive": q - path}, "forces": {y: force},
              "inputs": {path: 0.0, force: 0.0}}  # fmt: skip
    return em.Model(**fields | others)


PATH = em.Signal(make_interp_spline(TIMES, motion(TIMES), k=5))
START = {"q": motion(0.0, 1)}


@pytest.fixture(scope="module")
def system():
    return system_for(driven(), "eigenfactor")


@pytest.mark.parametrize("name", ["lambda", "λ", "x'", "x_{1}", "a b", "int", "NAN", "em_run"])
def test_any_name_that_an_input_may_have_prescribes_a_motion(name):
    u = sympy.Function(name)(em.t)
    model = driven(holonomic_constraints={"drive": q - u}, inputs={u: 0.0}, forces={})
    found = system_for(model, "lagrange").simulate((0, 1), inputs={name: PATH}, v0=START)
    np.testing.assert_allclose(found.x[0], motion(found.t), rtol=0, atol=1e-12)
    assert pickle.loads(pickle.dumps(model)).canonical() == model.canonical()


def test_a_copy_of_a_model_takes_another_default():
    other = replace(driven(), inputs={path: 2.0, force: 1.0}, initial={q: 2.0})
    assert other.prescribed == ("path",)
    assert other.canonical() == driven(inputs={path: 2.0, force: 1.0}, initial={q: 2.0}).canonical()
    assert system_for(other, "lagrange").simulate((0, 1)).x[0] == pytest.approx(2.0, rel=1e-14)


def test_higher_derivatives_are_those_of_the_signal():
    """In a force, and in an output; the velocity of y is then the second derivative."""
    rows = np.linspace(0, 2, 21)
    model = driven(forces={y: path.diff(em.t, 3)}, inputs={path: 0.0}, outputs={"jerk": path.diff(em.t, 3)})
    found = system_for(model, "lagrange").simulate((0, 2), inputs={"path": PATH}, v0=START, rtol=1e-9, t_eval=rows)
    np.testing.assert_allclose(found.outputs["jerk"], motion(rows, 3), rtol=0, atol=1e-5)
    np.testing.assert_allclose(found.v[1], motion(rows, 2) - motion(0, 2), rtol=0, atol=1e-6)


def test_a_belt_takes_a_block_along():
    """An input in the slip: y = t^2 / 4 until the spring needs more than the friction, at t = 1, and then it swings."""
    model = em.Model(
        name="belt", coordinates=[y], kinetic_energy=y.diff() ** 2 / 2, potential_energy=y**2, inputs={speed: 0.0},
        contacts={"rub": em.Friction(y.diff() - speed, limit=1.0)},
    )  # fmt: skip
    rows = np.linspace(0, 3, 61)
    ramp = em.Signal([0.0, 10.0], [0.0, 5.0])
    found = system_for(model, "lagrange").simulate((0, 3), inputs={"speed": ramp}, rtol=1e-10, atol=1e-12, t_eval=rows)
    w, after = np.sqrt(2.0), rows - 1.0
    right = np.where(after < 0, rows**2 / 4, 0.5 - 0.25 * np.cos(w * after) + 0.5 / w * np.sin(w * after))
    np.testing.assert_allclose(found.x[0], right, rtol=0, atol=1e-9)
    assert found.modes[1][0] == pytest.approx(1.0, rel=1e-9)


PERIOD = np.linspace(0.0, 2 * np.pi, 101)
TURNS = make_interp_spline(PERIOD, np.append(np.sin(PERIOD[:-1]), 0.0), k=5, bc_type="periodic")


def test_a_table_keeps_what_it_is_beyond_its_range(system):
    given = em.Table(TURNS, outside="periodic", name="turns")
    found = system.simulate((0, 20), inputs={"path": given}, v0={"q": 1.0}, rtol=1e-9)
    assert found.success
    np.testing.assert_allclose(found.x[0], np.sin(found.t), rtol=0, atol=1e-8)
    with pytest.raises(em.ModelError, match=r"sampled on \[0, 6\.28319\]"):
        system.simulate((0, 20), inputs={"path": TURNS}, v0={"q": 1.0})


CHART = RectBivariateSpline(np.arange(5.0), np.arange(5.0), np.zeros((5, 5)))


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"path": CHART}, "is given one of two arguments"),
        ({"path": em.Table(CHART, name="chart")}, "is given one of two arguments"),
        ({"path": CubicSpline(np.arange(5.0), np.zeros((5, 2)))}, "'path' of driven.*several values"),
        ({"path": ([0.0, 0.5], [0.0, 0.0])}, r"sampled on \[0, 0\.5\]"),
        ({"path": CubicSpline([0.0, 0.2, 0.5], [0.0, 0.0, 0.0])}, r"sampled on \[0, 0\.5\]"),
        ({("path", "force"): em.Sampled(lambda t, x, v: (0, 0), 0.1)}, "'path' of driven.*a controller holds"),
        ({"path": 0.0, path: 0.0}, "given twice"),
        ({"path": True}, "a number or a signal"),
    ],
)
def test_what_is_given_in_its_place_is_named(system, given, words):
    with pytest.raises(em.ModelError, match=words):
        system.simulate((0, 1), inputs=given)


def test_it_is_given_among_the_inputs_and_nowhere_else(system):
    for value in (PATH.interpolant, (TIMES, motion(TIMES)), 0.3):
        with pytest.raises(em.ModelError, match=r"'path' is an input, not a parameter: give it as inputs=\{'path'"):
            system.simulate((0, 1), parameters={"path": value})
    assert system.simulate((0, 1), parameters=dict(system.parameters), inputs={"path": PATH}, v0=START).success
    other = system_for(driven(name="other"), "eigenfactor")
    with pytest.raises(em.ModelError, match="prepared for other, another compiled model"):
        system.simulate((0, 1), parameters=other.prepare(), inputs={"path": PATH})
    with pytest.raises(em.ModelError, match="'path', an input that prescribes a motion"):
        system.simulate((0, 1), sensitivities=["path"])
    stepper = system.stepper(inputs={"path": PATH}, v0=START)
    with pytest.raises(ValueError, match=r"'path' prescribes a motion.*when the stepper opens"):
        stepper.advance(1.0, {"path": 0.3})


def test_members_that_are_not_covered_fail_alone(system):
    short = em.Signal(CubicSpline([0.0, 0.2, 0.5], [0.0, 0.0, 0.0]))
    with pytest.raises(em.ModelError, match=r"sampled on \[0, 0\.5\]"):
        em.simulate_ensemble(system, (0, 1), inputs={"path": short})
    runs = em.simulate_ensemble(system, (0, 1), inputs={"path": [0.0, short]})
    assert runs.success.tolist() == [True, False]
    assert "table 'path' at 0.5" in runs.message(1)


def test_a_signal_is_made_into_pieces_once(system):
    """`rhs` is called for every step of SciPy's solvers: 2,000 pieces anew each time would take half a second."""
    y0 = system.state([0.0, 0.0], [motion(0.0, 1), 0.0])
    system.rhs(0.0, y0, inputs={"path": PATH})
    before = time.perf_counter()
    for _ in range(20):
        system.rhs(0.0, y0, inputs={"path": PATH})
    assert time.perf_counter() - before < 0.5
    assert PATH.table is PATH.table


def test_many_steppers_each_follow_their_own(system):
    sizes = np.linspace(-1, 1, 200)
    paths = [em.Signal(CubicSpline(TIMES[::100], size * motion(TIMES[::100]))) for size in sizes]
    rates = [float(one.interpolant(0.0, 1)) for one in paths]
    many = system.steppers(inputs={"path": paths}, v0={"q": rates}, rtol=1e-6)
    many.advance(1.0, {"force": sizes})
    many.advance(2.5, {"force": sizes})
    np.testing.assert_allclose(many.x[:, 0], [float(one(2.5)) for one in paths], rtol=0, atol=1e-12)
    np.testing.assert_allclose(many.x[:, 1], sizes * 2.5**2 / 2, rtol=0, atol=1e-6)


def test_a_signal_of_a_table_is_refused():
    with pytest.raises(em.ModelError, match="has no values"):
        em.Signal(em.Table(TURNS))


def test_resets_and_events_follow_the_path():
    at = path - 0.3
    model = driven(events={"passes": em.Event(at, direction=1, reset={y: path + 1, y.diff(): path.diff()}),
                           "turns": em.Event(path.diff())}, outputs={"multiplier": multiplier("drive")})  # fmt: skip
    found = system_for(model, "lagrange").simulate((0, 2), inputs={"path": PATH}, v0=START, rtol=1e-10, atol=1e-12)
    (passes,), (turns,) = found.t_events
    assert motion(passes) == pytest.approx(0.3, abs=1e-10)
    assert motion(turns, 1) == pytest.approx(0.0, abs=1e-9)
    assert found.x[1, -1] == pytest.approx(1.3 + (2 - passes) * motion(passes, 1), abs=1e-9)
