"""Every formulation and option beside `lagrange` at the same tolerance: at most ten times its error."""

from functools import cache

import numpy as np
import pytest

from eigenmotion.stability import CASES as EXTREME

from ..support.generation import system_for, system_of
from ..support.models_table import BY_NAME, Scenario
from .test_eigenproblem_scaling import CASES, scaled

CHOSEN = (
    *({"formulation": name} for name in ("eigenfactor", "cholesky", "inverse")),
    {"close_eigenvalues": "extrapolate"},
    {"schur": "eigenfactor"},
    {"schur": "factor"},
    {"close_eigenvalues": "extrapolate", "schur": "eigenfactor"},
)
TOLERANCES = (1e-6, 1e-8, 1e-10)
NEAR = (0.8, 0.9, 1.0, 1.1, 1.25)
"""Times a tolerance. On four_bar `lagrange` is off by 32, 28, 4, 34, 115 times 1e-6 there, and schur="eigenfactor" by
14 times its error in the middle, but by twice the mean."""
MEET = {"sphere", "veering", "quaternion_top", "drone"}
"""Eigenvalues of one block meet: what extrapolation leaves there is in docs/theory.md."""
DRIFTS = {("andrews", "extrapolate-eigenfactor", "none"): 100}
"""Six eigenvalues of Delta that come close, whose C and s nothing settles: 53 to 73 tolerances, at every tolerance,
where the best of others are off by less than one."""
STABILISATIONS = ("project", "none")


@cache
def truth(scenario: Scenario):
    run = system_of(scenario.file, "cholesky").simulate(
        (0.0, scenario.t_end), rtol=1e-13, atol=1e-13, max_step=scenario.t_end / 200, dense_output=True
    )
    assert run.success, run.message
    return run.sol


def error(scenario: Scenario, system, tolerance: float, stabilisation: str) -> float:
    """Largest error of x at the accepted steps, no less than the tolerance: less was not asked for."""
    run = system.simulate((0.0, scenario.t_end), rtol=tolerance, atol=tolerance, stabilisation=stabilisation)
    assert run.success, (system.formulation, system.close_eigenvalues, system.schur, run.message)
    return max(np.abs(run.x - truth(scenario)(run.t)[: system.n]).max(), tolerance)


def errors(scenario: Scenario, system, stabilisation: str) -> np.ndarray:
    """The error at each tolerance: the geometric mean over some close to it, as one run's is much a matter of luck."""
    runs = [[error(scenario, system, near * tolerance, stabilisation) for near in NEAR] for tolerance in TOLERANCES]
    return np.exp(np.log(runs).mean(axis=1))


@cache
def yardstick(scenario: Scenario, stabilisation: str) -> np.ndarray:
    return errors(scenario, system_of(scenario.file, "lagrange"), stabilisation)


def worse(scenario: Scenario, system, stabilisation: str) -> np.ndarray:
    """How many times the error of `lagrange`, for each tolerance."""
    return errors(scenario, system, stabilisation) / yardstick(scenario, stabilisation)


def within_ten(times: np.ndarray, stabilisation: str, most: float = 10) -> bool:
    """At each tolerance; without projection at most of them, as drift adds up to different sums by chance."""
    return bool((times.max() if stabilisation == "project" else np.median(times)) < most)


BY_DAY_AND_NIGHT = [
    pytest.param(scenario, marks=[pytest.mark.nightly] if k % 8 else [], id=name)
    for k, (name, scenario) in enumerate(sorted(BY_NAME.items()))
]


@pytest.mark.parametrize("stabilisation", STABILISATIONS)
@pytest.mark.parametrize("scenario", BY_DAY_AND_NIGHT)
def test_choices_of_build(scenario, stabilisation):
    known = [chosen for chosen in CHOSEN if "extrapolate" not in chosen.values() or scenario.file not in MEET]
    times = {
        "-".join(chosen.values()): worse(scenario, system_of(scenario.file, **chosen), stabilisation)
        for chosen in known
    }
    most = {name: DRIFTS.get((scenario.file, name, stabilisation), 10) for name in times}
    assert {name: found for name, found in times.items() if not within_ten(found, stabilisation, most[name])} == {}


@pytest.mark.parametrize("stabilisation", STABILISATIONS)
@pytest.mark.parametrize(("name", "choice"), CASES)
def test_scales(name, choice, stabilisation):
    times = worse(BY_NAME[name], scaled(name, choice), stabilisation)
    assert within_ten(times, stabilisation), times


@pytest.mark.parametrize("gap", [1e-12, 1e-9, 1e-7])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_extrapolation_past_a_near_miss_leaves_no_error(gap, tolerance):
    """Beyond EM_EPSILON, of 1e-6: below it Omega is not followed, whatever the tolerance."""
    options = {"parameters": {"gap": gap}, "rtol": tolerance, "atol": tolerance}
    exact = system_of("veering", "cholesky").simulate((0, 22), parameters={"gap": gap}, rtol=1e-13, atol=1e-13)
    run = system_of("veering", close_eigenvalues="extrapolate").simulate((0, 22), **options)
    assert run.success
    assert np.abs(run.x[:, -1] - exact.x[:, -1]).max() < 20 * tolerance


@pytest.mark.parametrize("miss", [1e-8, 1e-9])
def test_momentum_is_the_same_after_an_extrapolation(miss):
    """A particle in polar coordinates: as r falls, r^2 meets another eigenvalue, and the coupling is the miss."""
    case, point = EXTREME["polar"], EXTREME["polar"].trial(miss)
    system = system_for(case.model(miss), close_eigenvalues="extrapolate")
    for method, rtol in (("dopri5", 1e-4), ("dopri5", 1e-8), ("dop853", 1e-4), ("rk34", 1e-3)):
        run = system.simulate((0, 0.5), x0=point.x0, v0=point.v0, rtol=rtol, atol=rtol * point.units, method=method)
        assert np.abs(run.x[2] ** 2 * run.v[1] / point.v0[1] - 1).max() < 100 * rtol, (method, rtol)
