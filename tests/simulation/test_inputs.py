"""Inputs given at run time, against the driven oscillator on paper; and what is conserved."""

from functools import cache

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from scipy.interpolate import CubicSpline
from sympy import Rational, cos, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError, System, t
from eigenmotion.arguments.methods import METHODS
from eigenmotion.arguments.signals import Signal
from eigenmotion.results.output.summary import summary

from ..support.generation import FORMULATIONS, system_for, system_of

K, M, X0, V0 = 9.0, 2.0, 0.3, -0.4
TIMES, VALUES = np.array([0.0, 0.5, 0.7, 1.6, 2.4, 3.0]), np.array([1.0, -2.0, 0.5, 3.0, -1.0, 2.0])
TIGHT = {"rtol": 1e-11, "atol": 1e-13}


@cache
def oscillator(formulation: str = "eigenfactor") -> System:
    """A mass on a spring under u(t), and an unrelated pendulum on a cart so that M varies."""
    x, cart, angle = dynamicsymbols("x cart angle")
    u = dynamicsymbols("u")
    m, k = symbols("m k", positive=True)
    swing = cart.diff() ** 2 + angle.diff() ** 2 / 2 + cart.diff() * angle.diff() * cos(angle)
    return system_for(
        Model(
            name="oscillator",
            coordinates=[x, cart, angle],
            kinetic_energy=Rational(1, 2) * m * x.diff() ** 2 + swing,
            potential_energy=Rational(1, 2) * k * x**2 - cos(angle),
            forces={x: u},
            inputs={u: 1.5},
            parameters={m: M, k: K},
            outputs={"u": u},
            initial={x: X0, x.diff(): V0, angle: 1.0},
        ),
        formulation,
    )


def forced(at: np.ndarray, pieces: list[tuple[float, Polynomial]], end: float) -> np.ndarray:
    """(x, v) of m x'' + k x = u, u a polynomial of third degree from each time on: x_p = u / k - m u'' / k^2."""
    w, x, v = np.sqrt(K / M), X0, V0
    found = np.full((2, len(at)), np.nan)
    ends = [start for start, _ in pieces[1:]] + [end]
    for (start, u), stop in zip(pieces, ends, strict=True):
        special = u / K - u.deriv(2) * (M / K**2)
        a, b = x - special(start), (v - special.deriv()(start)) / w

        def motion(time: np.ndarray, a=a, b=b, start=start, special=special) -> np.ndarray:
            angle = w * (time - start)
            swing, rate = a * np.cos(angle) + b * np.sin(angle), w * (b * np.cos(angle) - a * np.sin(angle))
            return np.array([swing + special(time), rate + special.deriv()(time)])

        inside = (at >= start) & (at <= stop)
        found[:, inside] = motion(at[inside])
        x, v = motion(np.array(stop))
    return found


def pieces(kind: str) -> list[tuple[float, Polynomial]]:
    """(start, u as a polynomial of the time) for each piece between the samples."""
    if kind == "hold":
        return [(start, Polynomial([u])) for start, u in zip(TIMES[:-1], VALUES[:-1], strict=True)]
    if kind == "linear":
        slopes = np.diff(VALUES) / np.diff(TIMES)
        rows = zip(TIMES[:-1], VALUES[:-1], slopes, strict=True)
        return [(start, Polynomial([u - slope * start, slope])) for start, u, slope in rows]
    spline = CubicSpline(TIMES, VALUES)
    local = [(start, Polynomial(spline.c[::-1, j])) for j, start in enumerate(TIMES[:-1])]
    return [(start, u(Polynomial([-start, 1.0]))) for start, u in local]


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("kind", ["hold", "linear", "cubic"])
def test_sampled_inputs_drive_the_oscillator_in_closed_form(kind, formulation):
    at = np.linspace(0, 3, 61)
    found = oscillator(formulation).simulate((0, 3), inputs={"u": Signal(TIMES, VALUES, kind)}, t_eval=at, **TIGHT)
    right = forced(at, pieces(kind), 3.0)
    np.testing.assert_allclose([found.x[0], found.v[0]], right, atol=1e-9)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", ["hold", "linear"])
def test_steps_end_at_samples(kind, method):
    found = oscillator().simulate((0, 3), inputs={"u": Signal(TIMES, VALUES, kind)}, method=method, rtol=1e-5)
    assert set(TIMES) <= set(found.t)
    np.testing.assert_allclose(found.x[0], forced(found.t, pieces(kind), 3.0)[0], atol=2e-3)


@pytest.mark.parametrize(("given", "value"), [({}, 1.5), ({"u": 4.0}, 4.0), ({dynamicsymbols("u"): -1}, -1.0)])
def test_constant_inputs(given, value):
    found = oscillator().simulate((0, 3), inputs=given, **TIGHT)
    np.testing.assert_allclose(found.x[0], forced(found.t, [(0.0, Polynomial([value]))], 3.0)[0], atol=1e-10)
    np.testing.assert_array_equal(found.outputs["u"], value)


def test_backwards_through_held_samples():
    u = {"u": Signal(TIMES, VALUES, "hold")}
    there = oscillator().simulate((0, 3), inputs=u, **TIGHT)
    back = oscillator().simulate((3, 0), x0=there.x[:, -1], v0=there.v[:, -1], inputs=u, **TIGHT)
    np.testing.assert_allclose([back.x[0, -1], back.v[0, -1]], [X0, V0], atol=1e-9)


def test_samples_that_end_too_early_are_refused_but_held_ones_last():
    for kind in ("linear", "cubic"):
        with pytest.raises(ModelError, match=r"'u'.*\[0, 3\].*does not cover"):
            oscillator().simulate((0, 3.5), inputs={"u": Signal(TIMES, VALUES, kind)})
    assert oscillator().simulate((0, 3.5), inputs={"u": Signal(TIMES, VALUES, "hold")}).success


# --- what is conserved ------------------------------------------------------------------------------------------------


def test_jacobi_integral_is_that_of_a_rotating_frame():
    system = system_of("rotating_spring")
    x, v = np.array([0.7, -0.4]), np.array([0.3, 1.1])
    p = system.parameters
    V = (p["k_x"] * x[0] ** 2 + p["k_y"] * x[1] ** 2) / 2
    by_hand = p["m"] / 2 * (v @ v - p["Omega"] ** 2 * x @ x) + V
    assert system.jacobi_integral(x, v) == pytest.approx(by_hand, rel=1e-14)
    inertial = v + p["Omega"] * np.array([-x[1], x[0]])
    assert system.energy(x, v) == pytest.approx(p["m"] / 2 * inertial @ inertial + V, rel=1e-14)


@pytest.mark.parametrize("name", ["rotating_spring", "rotating_hoop"])
def test_jacobi_integral_is_kept_where_energy_is_not(name):
    found = system_of(name).simulate((0, 5), **TIGHT)
    assert np.ptp(found.jacobi_integral) < 1e-9 * abs(found.jacobi_integral[0])
    assert np.ptp(found.energy) > 1e-3
    assert system_of(name).conserves_energy


def _particle(name: str, **given: object) -> Model:
    x = dynamicsymbols("x")
    return Model(**{"name": name, "coordinates": [x], "kinetic_energy": x.diff() ** 2 / 2, **given})


def _losing() -> dict[str, Model]:
    x, y, u = dynamicsymbols("x y u")
    plane = {"coordinates": [x, y], "kinetic_energy": (x.diff() ** 2 + y.diff() ** 2) / 2}
    return {
        "damped": _particle("damped", forces={x: -x.diff()}),
        "pushed": _particle("pushed", forces={x: u}, inputs={u: 0.0}),
        "heavier": _particle("heavier", kinetic_energy=(1 + t) * x.diff() ** 2 / 2),
        "lifted": _particle("lifted", potential_energy=x * t),
        "towed": _particle("towed", **plane, nonholonomic_constraints=[y.diff() - 1]),
        "moved": _particle("moved", **plane, holonomic_constraints=[y - t]),
    }


@pytest.mark.parametrize("name", list(_losing()))
def test_drift_is_reported_only_where_something_is_conserved(name):
    system = system_for(_losing()[name])
    assert not system.conserves_energy
    v = system.project_initial_state().v
    assert "energy drift" not in summary(system, system.simulate((0, 1), v0=v), 1.0)


def test_drift_is_reported_where_energy_is_conserved():
    system = system_of("rotating_spring")
    assert "energy drift" in summary(system, system.simulate((0, 1)), 1.0)
    assert not system_of("driven_pendulum").conserves_energy
