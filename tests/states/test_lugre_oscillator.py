"""models/lugre_oscillator.py: stick-slip against an independent integration of equations by hand."""

import math
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ..support.generation import FORMULATIONS, system_of
from ..support.shown import check_page, check_picture, integrals

TIMES = np.linspace(0.0, 24.0, 49)
TIGHT = {"rtol": 1e-10, "atol": {"x": 1e-11, "z": 1e-15}}


def by_hand(t: float, y: np.ndarray) -> list[float]:
    """Rates of (x, x', z), with the numbers of Canudas de Wit and others (1995)."""
    place, rate, z = y.tolist()
    v = 0.1 - rate
    dz = v - 1e5 * abs(v) * z / (1.0 + 0.5 * math.exp(-((v / 1e-3) ** 2)))
    return [rate, -2.0 * place + 1e5 * z + math.sqrt(1e5) * dz + 0.4 * v, dz]


@cache
def expected() -> np.ndarray:
    run = solve_ivp(by_hand, (0.0, 24.0), [0.0] * 3, "Radau", TIMES, rtol=1e-10, atol=[1e-12, 1e-12, 1e-16])
    assert run.success
    return run.y


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_it_sticks_and_slips_as_by_hand(formulation, method):
    found = system_of("lugre_oscillator", formulation).simulate((0, 24), t_eval=TIMES, method=method, **TIGHT)
    assert found.success
    rows = np.vstack([found.x, found.v])
    np.testing.assert_allclose(rows, expected()[:2], rtol=0, atol=1e-7)
    np.testing.assert_allclose(found.states["z"], expected()[2], rtol=0, atol=1e-11)


def test_the_limit_cycle_repeats_itself():
    """Slips begin where the spring pulls with nearly Fs = 1.5 N: at x = 0.75; the times between them are equal."""
    times = np.linspace(0.0, 40.0, 40001)
    found = system_of("lugre_oscillator").simulate((0, 40), t_eval=times, method="radau9", **TIGHT)
    tops = [k for k in range(1, len(times) - 1) if found.x[0, k - 1] < found.x[0, k] >= found.x[0, k + 1]]
    assert len(tops) >= 5
    places = found.x[0, tops]
    assert 0.74 < places.min() <= places.max() < 0.76
    assert np.ptp(np.diff(times[tops])[1:]) < 2.1e-3  # two rows
    sticking = np.abs(found.outputs["relative_speed"]) < 1e-3
    assert 0.3 < np.mean(sticking) < 0.8


def test_the_work_of_the_belt_is_energy_and_heat():
    run, (work, heat) = integrals(
        system_of("lugre_oscillator"), (0.0, 16.0), ("belt_power", "heat"), method="radau9", **TIGHT
    )
    assert heat > 0.3
    assert run.energy[-1] - run.energy[0] == pytest.approx(work - heat, abs=1e-8 * work)


def test_page_and_picture(scene, hurried):
    check_picture("lugre_oscillator", scene.parent, "--method", "radau9")
    check_page("lugre_oscillator", scene.parent)
