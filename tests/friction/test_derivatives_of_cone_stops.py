"""Derivatives of when and where friction cones stop: a closed form, and differences of stops by SciPy.

The event of a stop is a slip that the tolerances cannot tell from zero, so its direction there is noise. Derivatives
must not show it, at any tolerance.
"""

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Friction, Model, ModelError, System

x, y = dynamicsymbols("x y")
m, M, f = symbols("m M f", positive=True)
k, F = symbols("k F", nonnegative=True)
NAMES = ("x", "y", "x'", "y'", "m", "M", "k", "f", "F")
GIVEN = {"m": 1.5, "M": 1.2, "k": 1.3, "f": 0.9, "F": 0.4}
METHODS = ("dop853", "ra15", "radau9")
STARTS = (
    (0.4, 0.3, 0.9, 0.6),
    (-0.3, 0.2, 0.5, -0.8),
    (0.6, -0.5, -0.2, 0.9),
    (0.1, 0.5, 0.7, 0.1),
    (0.32, 0.0, -0.3, 0.02),
)


@cache
def puck() -> System:
    """A puck on springs that is heavier along x, as if a rail moved with it."""
    model = Model(
        name="puck_on_springs",
        coordinates=[x, y],
        kinetic_energy=m * x.diff() ** 2 / 2 + M * y.diff() ** 2 / 2,
        potential_energy=k * (x**2 + y**2) / 2,
        forces={x: F},
        contacts={"rub": Friction((x.diff(), y.diff()), f)},
        parameters={symbol: GIVEN[symbol.name] for symbol in (m, M, k, f, F)},
    )
    return em.build(model)


def stop(start: NDArray[np.float64], given: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return when it stops, and x, y there, by SciPy down to a slip of 1e-8, and from there on a straight line."""
    masses, (k, f, F) = given[:2], given[2:]

    def rates(_: float, z: NDArray[np.float64]) -> NDArray[np.float64]:
        pushes = np.array([F, 0.0]) - k * z[:2] - f * z[2:] / np.hypot(*z[2:])
        return np.concatenate([z[2:], pushes / masses])

    def slip(_: float, z: NDArray[np.float64]) -> float:
        return float(np.hypot(*z[2:])) - 1e-8

    slip.terminal = True  # type: ignore[attr-defined]
    run = solve_ivp(rates, (0.0, 9.0), start, "DOP853", rtol=3e-14, atol=1e-15, events=slip)
    assert run.status == 1
    z = run.y[:, -1]
    rest = 1e-8 / -float(z[2:] @ rates(0.0, z)[2:] / np.hypot(*z[2:]))
    return np.array([run.t[-1] + rest, *(z[:2] + rest / 2 * z[2:])])


@cache
def derivatives(start: tuple[float, ...]) -> NDArray[np.float64]:
    """Return those of the stop by everything varied: (3, names), by differences of fourth order."""
    point, h = np.array([*start, *GIVEN.values()]), 2e-3
    at = lambda step: stop((point + step)[:4], (point + step)[4:])  # noqa: E731
    steps = h * np.eye(len(point))
    return np.array([(8 * (at(one) - at(-one)) - at(2 * one) + at(-2 * one)) / (12 * h) for one in steps]).T


def found(
    start: tuple[float, ...],
    method: str,
    rtol: float,
    names: tuple[str, ...] = NAMES,
    given: dict[str, float] | None = None,
) -> NDArray[np.float64]:
    run = em.simulate(
        puck(), (0.0, 4.0), x0=start[:2], v0=start[2:], method=method, rtol=rtol, atol=1e-2 * rtol, sensitivities=names,
        parameters=given,
    )  # fmt: skip
    assert run.success, run.message
    assert run.t_events is not None
    assert len(run.t_events[0]) == 1
    ways = [run.sensitivity[name] for name in names]
    return np.array([[one.dt_events[0][0], *one.dx[:, -1]] for one in ways if one.dt_events]).T


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("start", STARTS)
def test_of_when_and_where_a_puck_stops(method: str, start: tuple[float, ...]):
    right = derivatives(start)
    for rtol in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12):
        assert found(start, method, rtol) == pytest.approx(right, abs=max(300 * rtol, 1e-6) * np.abs(right).max()), rtol


def test_of_a_straight_stop():
    """Without springs, a puck of speed c stops after m c / f, and c^2 m / (2 f) further on."""
    start, c, names = (0.0, 0.0, 0.6, 0.8), 1.0, ("x'", "y'", "f")
    t, way = GIVEN["m"] * c / GIVEN["f"], np.array([0.6, 0.8])
    places = np.column_stack([(t * np.eye(2) + t * np.outer(way, way)) / 2, -t / 2 / GIVEN["f"] * way])
    right = np.vstack([[*(t * way), -t / GIVEN["f"]], places])
    for method in METHODS:
        for rtol in (1e-6, 1e-9, 1e-12):
            free = {"k": 0.0, "F": 0.0, "M": GIVEN["m"]}
            assert found(start, method, rtol, names, free) == pytest.approx(right, abs=max(50 * rtol, 1e-9))


def test_what_tolerances_do_not_show_is_refused():
    """By name: what is smaller than the error at rtol 1e-4 decides when this puck stops."""
    with pytest.raises(ModelError, match="'rub' stops while its slip turns so fast that derivatives of when it stops"):
        found(STARTS[1], "dop853", 1e-4)
