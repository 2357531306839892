"""Derivatives of whole motions, against closed forms, differences of runs, and through jumps of forces."""

import signal

import mpmath
import numpy as np
import pytest
from sympy import Piecewise, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError
from eigenmotion.runtime.variations import constraint_partials
from eigenmotion.simulation.sensitivity import sensitivities

from ..oracles import Lagrange
from ..support.generation import system_for, system_of
from ..support.models_table import BY_NAME
from .differences import differences

TIGHT = {"rtol": 1e-11, "atol": 1e-13}


@pytest.mark.parametrize(("name", "by"), [
    ("dual_link", ["K1", "l3", "theta1", "theta2'"]), ("four_bar", ["a", "q1", "q1'"]),
    ("rolling_disk", ["r", "theta", "psi'"]), ("driven_pendulum", ["l", "a", "x"]),
])  # fmt: skip
@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
def test_against_differences_of_runs(name, by, formulation):
    """Constraints included: starts that a length moves, and initial values that the others follow."""
    system = system_of(name, formulation)
    x, v = system.project_initial_state()
    run = system.simulate((0.0, 1.0), x0=x, v0=v, sensitivities=by, **TIGHT)
    for one in by:
        found, right = run.sensitivity[one], differences(system, one, 1.0)
        assert found.dx.shape == run.x.shape
        end = np.concatenate([found.dx[:, -1], found.dv[:, -1]])
        np.testing.assert_allclose(end, right, atol=1e-7 * np.abs(right).max())
        n = system.n
        for k in (0, -1):
            D = constraint_partials(system.compiled, run.t[k], run.x[:, k], run.v[:, k], system.prepare())
            z = np.concatenate([found.dx[:, k], found.dv[:, k]])
            given = D[:, 2 * n + list(system.parameters).index(one)] if one in system.parameters else 0.0
            np.testing.assert_allclose(D[:, : 2 * n] @ z + given, 0.0, atol=1e-11 * max(1.0, np.abs(z).max()))


def oscillator() -> em.Model:
    x, u = dynamicsymbols("x u")
    k, d = symbols("k d", nonnegative=True)
    return em.Model(
        name="oscillator", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=k * x**2 / 2,
        forces=[u - d * x.diff()], inputs={u: 0.0}, parameters={k: 4.0, d: 0.0}, initial={x: 1.0},
    )  # fmt: skip


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853", "ra15", "radau5", "radau9"])
@pytest.mark.parametrize("end", [3.0, -3.0])
def test_closed_form(method, end):
    """x = cos 2t: dx/dk = -t sin(2 t) / 4, dx/dx0 = cos 2t, dx/dv0 = sin(2 t) / 2, dx/du = (1 - cos 2 t) / 4."""
    run = system_for(oscillator(), "lagrange").simulate((0, end), method=method, sensitivities=["k", "x", "x'", "u"],
                                                        rtol=1e-10, atol=1e-12)  # fmt: skip
    t = run.t
    right = {"k": -t * np.sin(2 * t) / 4, "x": np.cos(2 * t), "x'": np.sin(2 * t) / 2, "u": (1 - np.cos(2 * t)) / 4}
    for name, expected in right.items():
        np.testing.assert_allclose(run.sensitivity[name].dx[0], expected, atol=1e-8)


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853", "ra15", "radau5", "radau9"])
def test_what_a_member_does_is_the_same_bits_with_derivatives(method):
    """Members that end early included: most methods run them once, which keeps what is between rows."""
    system = system_for(oscillator(), "lagrange")
    asked = {"x0": {"x": [0.0, 0.1, 1.0]}, "t_eval": [1.0, 3.0], "method": method, "max_steps": 12} | TIGHT
    with_them, without = (em.simulate_ensemble(system, (0, 3), **asked, **by) for by in ({"sensitivities": ["k"]}, {}))
    for name in ("x", "v", "t_end", "nfev", "nsteps", "success"):
        np.testing.assert_array_equal(getattr(with_them, name), getattr(without, name))
    assert [with_them.message(k) for k in range(3)] == [without.message(k) for k in range(3)]


def test_units_change_nothing():
    system = system_for(oscillator(), "lagrange")
    here = system.simulate((0, 3), t_eval=[3.0], sensitivities=["x", "k"], **TIGHT).sensitivity
    for length in (1e-6, 1e6):
        there = system.simulate((0, 3), x0=[length], t_eval=[3.0], sensitivities=["x", "k"], rtol=1e-11,
                                atol=1e-13 * length).sensitivity  # fmt: skip
        np.testing.assert_allclose(there["x"].dx, here["x"].dx, rtol=1e-9)
        np.testing.assert_allclose(there["k"].dx / length, here["k"].dx, rtol=1e-9)


def thrust(stated: bool) -> em.Model:
    """Free fall from x0, with a thrust F below the height s."""
    x = dynamicsymbols("x")
    F, s, g = symbols("F s g", positive=True)
    return em.Model(name=f"thrust{int(stated)}", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                    forces=[-g + F * Piecewise((1, x < s), (0, True))], parameters={F: 30.0, s: 1.0, g: 10.0},
                    initial={x: 2.25}, events={"on": x - s} if stated else {})  # fmt: skip


def test_directions_jump_where_a_force_does():
    """At t_on = sqrt(2 (x0 - s) / g) = 1/2 the velocity is -g t_on; then x = s - g t_on w + (F - g) w^2 / 2."""
    end, t_on, w = 0.8, 0.5, 0.3
    run = system_for(thrust(True), "lagrange").simulate((0, end), t_eval=[end], sensitivities=["x", "s", "F"], **TIGHT)
    by_time = 10.0 * (t_on - w) - 20.0 * w  # dx / dt_on, and dt_on / dx0 = -dt_on / ds = 1 / (g t_on)
    right = {"x": by_time / 5.0, "s": 1.0 - by_time / 5.0, "F": w**2 / 2}
    for name, expected in right.items():
        assert run.sensitivity[name].dx[0, 0] == pytest.approx(expected, rel=1e-7)


def test_a_jump_that_no_event_states_is_refused():
    with pytest.raises(ModelError, match=r"a force jumps at about t = 0\.[45].*give the model an event"):
        system_for(thrust(False), "lagrange").simulate((0, 0.8), sensitivities=["x"])


def test_inputs_that_are_sampled():
    """The scene is linear: the derivative by x0 is that without inputs, whatever the samples."""
    system, t = system_for(oscillator(), "lagrange"), np.linspace(0, 3, 4)
    for kind in ("hold", "linear", "cubic"):
        signal = em.Signal(t, [0.0, 2.0, -1.0, 3.0], kind)
        run = system.simulate((0, 3), inputs={"u": signal}, sensitivities=["x"], **TIGHT)
        np.testing.assert_allclose(run.sensitivity["x"].dx[0], np.cos(2 * run.t), atol=1e-8)
    with pytest.raises(ModelError, match="'u' is sampled"):
        system.simulate((0, 3), inputs={"u": signal}, sensitivities=["u"])


def test_parameter_jacobian():
    system = system_for(oscillator(), "lagrange")
    np.testing.assert_array_equal(system.rhs_parameter_jacobian(0.0, [3.0, 5.0]), [[0, 0], [-3.0, -5.0]])
    with pytest.raises(ModelError, match="carries eta"):
        system_of("dual_link").rhs_parameter_jacobian(0.0, np.zeros(20))


@pytest.mark.parametrize("wrong", [{"sensitivities": ["q"]}, {"sensitivities": "k"}, {"sensitivities": 3}])
def test_mistakes(wrong):
    with pytest.raises(ModelError):
        system_for(oscillator(), "lagrange").simulate((0, 1), **wrong)


def test_nothing_to_do():
    system = system_for(oscillator(), "lagrange")
    assert system.simulate((0, 1), sensitivities=[]).sensitivity == {}
    np.testing.assert_array_equal(system.simulate((1, 1), sensitivities=["x", "k"]).sensitivity["x"].dx, [[1.0]])


def test_ensembles():
    """Members as runs of their own; events, which are few or none, and members that fail."""
    system, by, times = system_for(thrust(True), "lagrange"), ["x", "F"], [0.2, 0.8]
    heights = [2.25, 1.8, float("nan"), 9.0]
    runs = em.simulate_ensemble(system, (0, 0.8), x0={"x": heights}, t_eval=times, sensitivities=by, **TIGHT)
    assert runs.sensitivity["F"].dx.shape == (4, 1, 2)
    assert runs.failed.tolist() == [2]
    assert np.isnan(runs.sensitivity["x"].dx[2]).all()
    for k in (0, 1, 3):
        one = system.simulate((0, 0.8), x0={"x": heights[k]}, t_eval=times, sensitivities=by, **TIGHT)
        for name in by:
            np.testing.assert_array_equal(runs.sensitivity[name].dx[k], one.sensitivity[name].dx)
            np.testing.assert_array_equal(runs[k].sensitivity[name].dv, one.sensitivity[name].dv)
            np.testing.assert_array_equal(runs[k].sensitivity[name].dt_events[0], one.sensitivity[name].dt_events[0])
    ends = em.simulate_ensemble(system, (0, 0.8), x0={"x": heights[:2]}, sensitivities=by, **TIGHT)
    np.testing.assert_allclose(ends.sensitivity["x"].dx[:, 0, 0], runs.sensitivity["x"].dx[:2, 0, 1], rtol=1e-9)


def test_members_without_sensitivities_say_why():
    system = system_for(thrust(False), "lagrange")
    runs = em.simulate_ensemble(system, (0, 0.8), x0={"x": [2.25, 9.0]}, sensitivities=["x"])
    assert runs.success.all()
    assert "no sensitivities: thrust0: a force jumps" in runs.message(0)
    assert np.isnan(runs.sensitivity["x"].dx[0]).all()
    assert runs.sensitivity["x"].dx[1] == pytest.approx(1.0)


@pytest.mark.parametrize("wrong", [{"sensitivities": ["q"]},
                                   {"sensitivities": ["u"], "inputs": {"u": ([0, 1], [0, 1])}}])  # fmt: skip
def test_mistakes_of_ensembles(wrong):
    with pytest.raises(ModelError, match="sensitivities"):
        em.simulate_ensemble(system_for(oscillator(), "lagrange"), (0, 1), x0={"x": [1, 2]}, **wrong)


def extrapolated(rate, z, end, steps, levels):
    """z (2 n,) at `end` by the midpoint rule in 2, 4, ... parts of equal steps, extrapolated: of order 2 `levels`."""
    H = mpmath.mpf(end) / steps
    for step in range(steps):
        first, table = rate(step * H, z), []
        for level in range(1, levels + 1):
            h, count = H / (2 * level), 2 * level
            before, here = z, [a + h * f for a, f in zip(z, first, strict=True)]
            for k in range(1, count):
                slopes = rate(step * H + k * h, here)
                before, here = here, [a + 2 * h * f for a, f in zip(before, slopes, strict=True)]
            slopes = rate((step + 1) * H, here)
            row = [[(a + b + h * f) / 2 for a, b, f in zip(before, here, slopes, strict=True)]]
            for k, other in enumerate(table[-1] if table else []):
                part = (mpmath.mpf(level) / (level - k - 1)) ** 2 - 1
                row.append([a + (a - b) / part for a, b in zip(row[k], other, strict=True)])
            table.append(row)
        z = table[-1][-1]
    return z


@pytest.mark.nightly
def test_thirty_digits():
    """The paper's ten seconds at 1e-9, against motions in arithmetic of 34 digits by SymPy's equations."""
    by, end = ["K1", "theta1"], 10.0
    runs = [system_of("dual_link", formulation).simulate((0.0, end), t_eval=[0.0, end], sensitivities=by, method=method,
                                                         rtol=1e-9, atol=1e-9)
            for formulation in ("eigenfactor", "lagrange") for method in ("dop853", "ra15")]  # fmt: skip
    system, oracle = system_of("dual_link"), Lagrange(BY_NAME["dual_link"].model(), "arbitrary")
    n, (x, v) = system.n, system.start()
    with mpmath.workdps(34):
        h = mpmath.mpf(10) ** -9

        def moved(name, change):
            given = {key: mpmath.mpf(value) for key, value in system.parameters.items()}
            start = runs[0].sensitivity[name]
            directions = np.concatenate([start.dx[:, 0], start.dv[:, 0]])
            z = [mpmath.mpf(a) + change * mpmath.mpf(b) for a, b in zip([*x, *v], directions, strict=True)]
            if name in given:
                given[name] += change
            return extrapolated(lambda t, z: [*z[n:], *oracle(z[:n], z[n:], t, given, {})[0]], z, end, 40, 8)

        for name in by:
            ends = zip(moved(name, h), moved(name, -h), strict=True)
            right = np.array([float((a - b) / (2 * h)) for a, b in ends])
            for run in runs:
                found = np.concatenate([run.sensitivity[name].dx[:, 1], run.sensitivity[name].dv[:, 1]])
                assert np.abs(found - right).max() < 1e-8 * np.abs(right).max()


def test_of_a_run_that_ends_at_a_reset_off_its_constraints():
    """They are those up to there; that the event had no state after it was an IndexError."""
    x, y = dynamicsymbols("x y")
    g = symbols("g", positive=True)
    model = em.Model(
        name="torn", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2, potential_energy=g * y,
        holonomic_constraints=[x**2 + y**2 - 1], events={"middle": em.Event(x, reset={x.diff(): 2 * x.diff(), y: 0})},
        parameters={g: 2.0}, initial={x: 0.6, y: -0.8},
    )  # fmt: skip
    system = system_for(model, "lagrange")
    run = system.simulate((0.0, 3.0), sensitivities=["g"], **TIGHT)
    assert run.stop is em.StopReason.RESET_OFF
    more, less = (system.simulate((0.0, 3.0), parameters={"g": 2.0 + d}, **TIGHT).t_events[0] for d in (1e-5, -1e-5))
    assert run.sensitivity["g"].dt_events[0] == pytest.approx((more - less) / 2e-5, rel=1e-6)


@pytest.mark.parametrize("error", [TimeoutError, KeyboardInterrupt])
def test_exceptions_of_signal_handlers_are_raised(monkeypatch, error):
    """While directions are integrated, which takes most of the time: a deadline was taken for Ctrl-C."""

    def complain(*_: object) -> None:
        raise error

    class Interrupted(sensitivities.Variations):
        def integrate(self):
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            return super().integrate()

    monkeypatch.setattr(sensitivities, "Variations", Interrupted)
    before = signal.signal(signal.SIGALRM, complain)
    try:
        with pytest.raises(error):
            system_of("dual_link").simulate((0.0, 3e2), t_eval=[3e2], sensitivities=["K1"], **TIGHT)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
