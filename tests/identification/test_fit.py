"""Fits to motions: exact ones, closed forms with noise, intervals, and what is refused."""

from functools import cache

import numpy as np
import pytest
from scipy.optimize import curve_fit
from sympy import Abs, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError, System

from ..support.generation import system_for, system_of

TIMES = np.linspace(0.1, 4.0, 40)
TRUTH = {"k": 5.0, "c": 0.4, "x": 0.8, "x'": -0.6}
GUESS = {"k": 4.0, "c": 0.1, "x": 1.0, "x'": 0.0}
TIGHT = {"rtol": 1e-12, "atol": 1e-13}


@cache
def oscillator() -> System:
    """m x'' + c x' + k x = u, and a sensor that lags behind."""
    x, z, u = dynamicsymbols("x z u")
    m, k, c, lag = symbols("m k c lag", positive=True)
    model = em.Model(
        name="measured_oscillator", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2,
        potential_energy=k * x**2 / 2, forces=[u - c * x.diff()], inputs={u: 0.0}, states={z: (x - z) / lag},
        outputs={"acceleration": x.diff().diff(), "spring": k * x}, parameters={m: 1.0, k: 4.0, c: 0.1, lag: 0.5},
        initial={x: 1.0},
    )  # fmt: skip
    return system_for(model, "lagrange")


@cache
def ball() -> System:
    z, (g, e) = dynamicsymbols("z"), symbols("g e", positive=True)
    return system_for(
        em.Model(name="fitted_ball", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
                 parameters={g: 9.81, e: 0.9}, events={"floor": em.Event(z, direction=-1, impact=(z, e))},
                 initial={z: 1.0}), "lagrange")  # fmt: skip


def position(t, k, c, x, v):
    """The oscillator's x of mass 1, below critical damping."""
    w, d = np.sqrt(k - c**2 / 4), c / 2
    return np.exp(-d * t) * (x * np.cos(w * t) + (v + d * x) / w * np.sin(w * t))


def slopes(function, t, values):
    """Derivatives by complex steps."""
    steps = 1e-30j * np.eye(len(values))
    return np.array([function(t, *(values + step)).imag / 1e-30 for step in steps]).T


def run_of(system, values, times, **given):
    """A run with parameters and initial values by name."""
    kinds = {name: name in system.parameters for name in values}
    parameters = {name: value for name, value in values.items() if kinds[name]}
    x0 = {name: value for name, value in values.items() if not kinds[name] and not name.endswith("'")}
    v0 = {name[:-1]: value for name, value in values.items() if name.endswith("'")}
    return system.simulate((0.0, times[-1]), x0=x0, v0=v0, parameters=parameters, t_eval=times, **TIGHT, **given)


def close(fit, truth, rel=1e-8):
    assert fit.success, fit.message
    assert fit.values == pytest.approx(truth, rel=rel, abs=rel)


def test_positions_without_noise():
    close(em.fit(oscillator(), GUESS, TIMES, {"x": position(TIMES, *TRUTH.values())}, rtol=1e-11), TRUTH)


def test_states_outputs_and_rates_without_noise():
    truth = {"k": 5.0, "lag": 0.3, "z": 0.4, "x'": 0.2, "m": 1.5}
    run = run_of(oscillator(), truth, TIMES)
    measured = {"z": run.states["z"], "acceleration": run.outputs["acceleration"], "x'": run.v[0],
                "spring": run.outputs["spring"]}  # fmt: skip
    guess = {"k": 4.0, "lag": 0.5, "z": 0.0, "x'": 0.0, "m": 1.0}
    close(em.fit(oscillator(), guess, TIMES, measured, rtol=1e-11), truth)


def test_missing_samples_and_an_input():
    run = run_of(oscillator(), {"k": 5.0}, TIMES, inputs={"u": 1.5})
    holes = np.where(np.arange(40) % 3, run.x[0], np.nan)
    fit = em.fit(oscillator(), {"u": 1.0, "k": 4.0}, TIMES, {"x": holes, "x'": run.v[0]}, rtol=1e-11)
    close(fit, {"u": 1.5, "k": 5.0})
    assert fit.freedoms == 26 + 40 - 2
    np.testing.assert_array_equal(np.isnan(fit.residual["x"]), np.isnan(holes))


def test_restitution_through_impacts():
    truth = {"e": 0.75, "z": 1.05, "g": 9.7}
    times = np.linspace(0.05, 1.6, 30)
    close(em.fit(ball(), {"e": 0.8, "z": 1.0, "g": 9.81}, times, run_of(ball(), truth, times).x, rtol=1e-11), truth)


def test_a_loop_keeps_what_is_unknown_and_closes_the_rest():
    system, times = system_of("four_bar", "lagrange"), np.linspace(0.1, 1.0, 15)
    x, v = em.assemble(system, {"q1": 1.5}, {"q1": 3.7}, keep=["q1"], parameters={"a": 0.42})
    run = system.simulate((0, 1), x0=x, v0=v, parameters={"a": 0.42}, t_eval=times, **TIGHT)
    fit = em.fit(system, {"a": 0.4, "q1": 1.55, "q1'": 4.0}, times, {"q3": run.x[2], "q1": run.x[0]}, rtol=1e-11)
    close(fit, {"a": 0.42, "q1": 1.5, "q1'": 3.7})
    assert [*fit.x0.values(), *fit.v0.values()] == pytest.approx([*x, *v], rel=1e-8)
    assert not fit.held
    given = em.fit(system, {"a": 0.4}, times, {"q3": run.x[2]}, x0={"q1": 1.5}, v0={"q1": 3.7}, rtol=1e-11)
    close(given, {"a": 0.42})
    assert em.fit(system, {"a": 0.41}, times, {"q3": run.x[2]}).held == ("q1", "q1'")


def test_directions_along_constraints_are_those_of_whole_runs():
    """Central differences of runs that each close the loop, through another code path: `em.assemble`."""
    system, times, step = system_of("four_bar", "lagrange"), np.array([0.4, 0.8]), 1e-5
    names, at = ("b", "q2", "q2'"), np.array([1.02, 0.6, 1.0])
    guess = dict(zip(names, at, strict=True))

    def rows(values):
        x, v = em.assemble(system, {"q2": values[1]}, {"q2": values[2]}, keep=["q2"], parameters={"b": values[0]})
        return system.simulate((0, 0.8), x0=x, v0=v, parameters={"b": values[0]}, t_eval=times, **TIGHT).x

    fit = em.fit(system, guess, times, rows(at), deviations=1.0, rtol=1e-11)
    moves = step * np.eye(3)
    J = np.array([(rows(at + d) - rows(at - d)).ravel() / (2 * step) for d in moves]).T
    assert fit.covariance == pytest.approx(np.linalg.inv(J.T @ J), rel=1e-6)


def test_rolling_without_slip():
    system, times = system_of("rolling_disk", "lagrange"), np.linspace(0.1, 1.0, 12)
    truth = {"g": 9.7, "theta": 0.32, "theta'": 0.05, "phi'": 1.1, "psi'": 6.0}
    start = em.assemble(system, {"theta": 0.32}, {"theta": 0.05, "phi": 1.1, "psi": 6.0})
    run = system.simulate((0, 1), x0=start.x, v0=start.v, parameters={"g": 9.7}, t_eval=times, **TIGHT)
    guess = {"g": 9.81, "theta": 0.3, "theta'": 0.0, "phi'": 1.0, "psi'": 5.8}
    close(em.fit(system, guess, times, run.x, rtol=1e-11), truth)


@cache
def rod() -> System:
    """A point mass on a massless rod, by x and y; the force in the rod, and rates along x and y by name."""
    x, y, vx, vy = dynamicsymbols("x y vx vy")
    length, g = symbols("length g", positive=True)
    model = em.Model(
        name="rod_in_x_and_y", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=g * y, holonomic_constraints=[(x**2 + y**2 - length**2) / 2],
        quasi_velocities={vx: x.diff(), vy: y.diff()}, outputs={"tension": em.multiplier(0) * length},
        parameters={length: 1.0, g: 9.81}, initial={x: 0.6, y: -0.8},
    )  # fmt: skip
    return system_for(model, "lagrange")


def test_reactions_along_constraints():
    """Of a pendulum of length L at angle a the tension is g cos a + L a'^2, by another model's run."""
    length, g, times = 1.1, 9.7, np.linspace(0.0, 1.5, 20)
    swing = system_of("pendulum", "lagrange").simulate(
        (0, 1.5), x0=[0.7], v0=[0.4], parameters={"l": length, "g": g}, t_eval=times, **TIGHT
    )
    tension = g * np.cos(swing.x[0]) + length * swing.v[0] ** 2
    unknowns = {"length": 1.0, "g": 9.81, "x": 0.6, "x'": 0.2}
    fit = em.fit(rod(), unknowns, times, {"tension": tension}, rtol=1e-11)
    start = length * np.sin(0.7), length * 0.4 * np.cos(0.7)
    close(fit, {"length": length, "g": g, "x": start[0], "x'": start[1]})
    assert fit.x0["y"] == pytest.approx(-length * np.cos(0.7), rel=1e-8)


def noisy(seed, spread=0.02):
    return position(TIMES, *TRUTH.values()) + np.random.default_rng(seed).normal(0.0, spread, 40)


def test_the_closed_form_with_noise_by_curve_fit():
    samples = noisy(1)
    right, covariance = curve_fit(position, TIMES, samples, list(GUESS.values()), ftol=1e-15, xtol=1e-15, gtol=1e-15,
                                  jac=lambda t, *values: slopes(position, t, np.array(values)))  # fmt: skip
    fit = em.fit(oscillator(), GUESS, TIMES, {"x": samples}, rtol=1e-11)
    assert fit.estimates == pytest.approx(right, rel=1e-6)
    assert fit.covariance == pytest.approx(covariance, rel=1e-6)
    assert fit.noise["x"] == pytest.approx(np.sqrt(((samples - position(TIMES, *right)) ** 2).sum() / 36), rel=1e-6)
    assert fit.intervals[0] == pytest.approx(right[0] + np.array([-1, 1]) * 2.028094 * np.sqrt(covariance[0, 0]), 1e-6)


def test_known_deviations_weigh_samples():
    """Absolute ones, as curve_fit has them, with intervals of the normal distribution."""
    samples, x, v = noisy(2), 0.8, -0.6
    rates = slopes(lambda t, shift: position(t + shift, *TRUTH.values()), TIMES, np.zeros(1))[:, 0]
    rates = rates + np.random.default_rng(3).normal(0.0, 0.1, 40)

    def both(t, k, c):
        w, d = np.sqrt(k - c**2 / 4), c / 2
        rate = np.exp(-d * t) * (v * np.cos(w * t) - (k * x + d * v) / w * np.sin(w * t))
        return np.concatenate([position(t, k, c, x, v), rate])

    sigma = np.repeat([0.02, 0.1], 40)
    right, covariance = curve_fit(both, TIMES, np.concatenate([samples, rates]), [4.0, 0.1], sigma, True, ftol=1e-15,
                                  xtol=1e-15, gtol=1e-15,
                                  jac=lambda t, *values: slopes(both, t, np.array(values)))  # fmt: skip
    fit = em.fit(oscillator(), {"k": 4.0, "c": 0.1}, TIMES, {"x": samples, "x'": rates}, x0={"x": x}, v0={"x": v},
                 deviations={"x": 0.02, "x'": 0.1}, rtol=1e-11)  # fmt: skip
    assert fit.estimates == pytest.approx(right, rel=1e-6)
    assert fit.covariance == pytest.approx(covariance, rel=1e-6)
    assert np.diff(fit.intervals)[:, 0] == pytest.approx(2 * 1.959964 * np.sqrt(np.diag(covariance)), rel=1e-5)
    own = em.fit(oscillator(), {"k": 4.0, "c": 0.1}, TIMES, {"x": samples, "x'": rates}, x0={"x": x}, v0={"x": v})
    assert own.noise == pytest.approx({"x": 0.02, "x'": 0.1}, rel=0.3)
    assert own.estimates == pytest.approx(right, abs=2 * fit.deviations.max())


@pytest.mark.parametrize("kinds", [("x",), ("x", "x'")])
def test_intervals_hold_the_truth_as_often_as_they_say(kinds):
    """100 fits with noise that is not known: a count of 95 % of 100 is below 89 once in a hundred times."""
    truth, times = {"k": 5.0, "c": 0.4}, np.linspace(0.1, 4.0, 12)
    run, random = run_of(oscillator(), truth, times), np.random.default_rng(7)
    exact = {"x": run.x[0], "x'": run.v[0]}
    inside = np.zeros(2)
    for _ in range(100):
        measured = {name: exact[name] + random.normal(0.0, 0.05, 12) for name in kinds}
        fit = em.fit(oscillator(), truth, times, measured, rtol=1e-7, atol=1e-9)
        inside += (fit.intervals[:, 0] < list(truth.values())) & (list(truth.values()) < fit.intervals[:, 1])
    assert inside.min() >= 89
    assert inside.max() < 100


@pytest.mark.parametrize(("mass", "length", "off"), [
    (2.0**-20, 2.0**10, 1e-13), (2.0**20, 2.0**-10, 1e-13), (1e-6, 1e3, 1e-7), (1e6, 1e-3, 1e-7), (1e6, 1e6, 1e-7),
])  # fmt: skip
def test_units_change_nothing(mass, length, off):
    """Where the ratio of units is a power of two, not even rounding is another."""
    samples = noisy(4)
    here = em.fit(oscillator(), GUESS, TIMES, {"x": samples})
    unit = np.array([mass, mass, length, length])
    guess = dict(zip(GUESS, np.array([*GUESS.values()]) * unit, strict=True))
    there = em.fit(oscillator(), guess, TIMES, {"x": samples * length}, parameters={"m": mass}, atol=1e-9 * length)
    assert off > 1e-13 or there.runs == here.runs
    assert there.estimates / unit == pytest.approx(here.estimates, rel=off)
    assert there.covariance / np.outer(unit, unit) == pytest.approx(here.covariance, rel=off)


def test_guesses_of_zero_in_any_unit():
    for length in (1e-6, 1.0, 1e6):
        samples = length * position(TIMES, 4.0, 0.1, 0.5, 0.3)
        fit = em.fit(oscillator(), {"x": 0.0, "x'": 0.0}, TIMES, {"x": samples}, rtol=1e-11, atol=1e-13 * length)
        close(fit, {"x": 0.5 * length, "x'": 0.3 * length})


def test_bounds():
    fit = em.fit(oscillator(), GUESS, TIMES, {"x": noisy(5)}, bounds={"k": (0.0, 4.8), "c": (0.0, np.inf)})
    assert fit.success
    assert fit.on_bound == ("k",)
    assert fit.values["k"] == pytest.approx(4.8, rel=1e-5)
    assert np.isnan(fit.deviations[0])
    assert np.isfinite(fit.deviations[1:]).all()
    assert "on a bound" in str(fit)
    with pytest.raises(ModelError, match="all unknowns are on their bounds"):
        em.fit(oscillator(), {"k": 3.0}, TIMES, {"x": noisy(5)}, bounds={"k": (0.0, 3.1)}, x0={"x": 0.8}, v0=[-0.6])


def test_a_run_that_fails_shortens_the_step():
    """Beyond k = 6 the run ends at once; the first step of Gauss and Newton leads there."""
    x = dynamicsymbols("x")
    k = symbols("k", positive=True)
    stops = em.Model(name="stops", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=k * x**2 / 2,
                     events={"stiff": em.Event(k * em.t - 24, terminal=True)}, parameters={k: 1.0},
                     initial={x: 1.0})  # fmt: skip
    system, times = system_for(stops, "lagrange"), np.linspace(0.1, 4.0, 20)
    fit = em.fit(system, {"k": 4.0}, times, {"x": np.cos(np.sqrt(5.9) * times)}, rtol=1e-11)
    close(fit, {"k": 5.9})
    outside = em.fit(system, {"k": 5.5}, times, {"x": np.cos(np.sqrt(6.1) * times)})
    assert not outside.success
    assert "not converged" in str(outside)
    assert "before the last sample" in outside.message
    assert np.isnan(outside.deviations).all()
    with pytest.raises(ModelError, match=r"the run at the guesses fails.*before the last sample"):
        em.fit(system, {"k": 7.0}, times, {"x": times})


def test_a_kink_of_the_motion_is_no_success():
    """A block that slides down, or sticks once it has stopped: the best place is neither, at its limit."""
    x, b = dynamicsymbols("x"), symbols("b")
    system = system_for(
        em.Model(name="folded", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, outputs={"fold": Abs(b - 1) + x},
                 parameters={b: 3.0}), "lagrange")  # fmt: skip
    fit = em.fit(system, {"b": 1.5}, TIMES, {"fold": np.full(40, -0.5)})
    assert not fit.success
    assert "it is no minimum" in fit.message


def test_too_few_runs():
    fit = em.fit(oscillator(), GUESS, TIMES, {"x": noisy(1)}, max_runs=2)
    assert not fit.success
    assert "2 runs were not enough" in fit.message


def test_what_a_motion_does_not_tell_is_named():
    samples = {"x": position(TIMES, *TRUTH.values())}
    with pytest.raises(ModelError, match=r"of m, k, c the measured motion tells only .*Give (m|k|c) as known"):
        em.fit(oscillator(), ["m", "k", "c"], TIMES, samples, x0={"x": 0.8}, v0={"x": -0.6})
    with pytest.raises(ModelError, match=r"tells only k\. It tells nothing about lag\. Give lag as known"):
        em.fit(oscillator(), ["k", "lag"], TIMES, samples)
    with pytest.raises(ModelError, match="nothing that is measured depends on lag"):
        em.fit(oscillator(), ["lag"], TIMES, samples)


def test_a_mass_that_cancels_up_to_rounding_is_named():
    """Its derivative is no exact zero; the fit was a success at twice the mass."""
    system = system_of("rotating_hoop")
    run = system.simulate((0, 1), parameters={"m": 1.01}, t_eval=TIMES / 4, **TIGHT)
    with pytest.raises(ModelError, match="nothing that is measured depends on m"):
        em.fit(system, ["m"], TIMES / 4, run.x)


ONE = {"x": np.ones(40)}


@pytest.mark.parametrize(("unknowns", "measured", "more", "words"), [
    ({"q": 1.0}, ONE, {}, "unknown name in unknowns 'q'"),
    ("k", ONE, {}, "Give a mapping name -> guess"),
    ([], ONE, {}, "no unknowns are named"),
    (["k", "k"], ONE, {}, "'k' is given twice"),
    ({"k": np.nan}, ONE, {}, "unknown 'k' is nan"),
    (["u"], ONE, {"inputs": {"u": ([0, 9], [0, 1])}}, "'u' is sampled"),
    (["k"], {"y": np.ones(40)}, {}, "unknown name in measured 'y'"),
    (["k"], {}, {}, "nothing is measured"),
    (["k"], {"x": np.ones(3)}, {}, r"'x' has shape \(3,\), but there are 40 times"),
    (["k"], np.ones((2, 40)), {}, r"measured has shape \(2, 40\)"),
    (["k"], {"x": np.full(40, np.inf)}, {}, "'x' is infinite"),
    (["k"], {"x": np.full(40, np.nan)}, {}, "all samples of measured 'x' are missing"),
    (["k"], ONE, {"deviations": {"y": 1.0}}, "unknown name in deviations 'y'"),
    (["k"], ONE, {"deviations": 0.0}, "must be positive"),
    (["k"], ONE, {"bounds": {"m": (0, 1)}}, "unknown name in bounds 'm'"),
    (["k"], ONE, {"bounds": {"k": (1, 0)}}, r"Give \(low, high\)"),
    ({"k": 3.0}, ONE, {"bounds": {"k": (4, 9)}}, "not within its bounds"),
    (["k"], ONE, {"t_start": 1.0}, "before t_start"),
    (["k"], ONE, {"max_runs": 0}, "max_runs is 0"),
    (["k"], ONE, {"level": 1.0}, "between 0 and 1"),
    (["k", "x"], {"x": np.where(np.arange(40) < 2, 1.0, np.nan)}, {}, "2 samples of 'x' do not tell their own noise"),
])  # fmt: skip
def test_mistakes(unknowns, measured, more, words):
    with pytest.raises(ModelError, match=words):
        em.fit(oscillator(), unknowns, TIMES, measured, **more)


def test_times_that_go_back():
    with pytest.raises(ModelError, match="not a list of increasing numbers"):
        em.fit(oscillator(), ["k"], TIMES[::-1], ONE)


def test_noise_that_does_not_settle(monkeypatch):
    monkeypatch.setattr("eigenmotion.analysis.fitting.fit._ROUNDS", 1)
    with pytest.raises(ModelError, match="the noise of x, x' does not settle"):
        em.fit(oscillator(), {"k": 4.0}, TIMES, {"x": noisy(6), "x'": noisy(7)})


def test_starts_that_constraints_do_not_allow():
    times = np.linspace(0.1, 1.0, 5)
    run = rod().simulate((0, 1), t_eval=times)
    with pytest.raises(ModelError, match="starts from rates, not from quasi-velocities"):
        em.fit(rod(), ["g"], times, run.x, v0={"vx": 0.0, "vy": 0.0})
    with pytest.raises(ModelError, match="the constraints cannot be closed with x kept"):
        em.fit(rod(), {"length": 1.0, "x": 1.2}, times, run.x)
    short = em.fit(rod(), {"length": 1.02, "x": 1.0}, times, {"x": np.full(5, 1.05)}, parameters={"g": 1e-9})
    assert not short.success
    assert "the constraints cannot be closed at the start with x kept" in short.message


def test_progress(capsys, monkeypatch):
    monkeypatch.setattr("eigenmotion.progress._SELDOM", 0.0)
    em.fit(oscillator(), {"k": 4.0}, TIMES, {"x": noisy(6)}, progress=True)
    assert "run 1 of at most 200" in capsys.readouterr().err


def test_mistakes_on_constraints():
    system, times = system_of("four_bar", "lagrange"), np.linspace(0.1, 1.0, 5)
    run = system.simulate((0, 1), t_eval=times)
    with pytest.raises(ModelError, match="'q1', 'q2' are unknown, but the constraints do not let them vary apart"):
        em.fit(system, ["q1", "q2"], times, run.x)
    x = dict(zip(system.coordinates, system.start()[0], strict=True))
    with pytest.raises(ModelError, match=r"x0 gives 'q\d', but with the constraints it follows"):
        em.fit(system, ["a"], times, run.x, x0=x)
    assert em.fit(system, ["g"], times, run.x, x0=x).success
    with pytest.raises(ModelError, match=r"tells only g\. It tells nothing about density"):
        em.fit(system, ["density", "g"], times, run.x)


def test_one_sample_does_not_tell_its_noise():
    system = em.build("models/pendulum.py")
    times = np.array([2.0])
    measured = system.simulate((0, 2), t_eval=times, rtol=1e-9).x + 1e-3
    fit = em.fit(system, {"l": 0.9}, times, measured, deviations={"theta": 1e-3})
    assert fit.success
    assert np.isnan(fit.noise["theta"])
