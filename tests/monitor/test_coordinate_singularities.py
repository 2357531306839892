"""Near singularities of the coordinates a run keeps what its tolerance promises, or says why it ends."""

import numpy as np
import pytest
from sympy import cos, log, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System
from eigenmotion.runtime import StopReason
from eigenmotion.stability import CASES
from eigenmotion.stability.cases.case import Trial

from ..support.failing_runs import X, check_honest, plane
from ..support.generation import FORMULATIONS, system_for

Q, R = dynamicsymbols("q r")
NAMED = {StopReason.SINGULAR_MASS_MATRIX, StopReason.STEP_SIZE_UNDERFLOW}
LINE = (Q - 1) ** 2 * Q.diff() ** 2 / 2
LOSING = {  # inertia, at q = 1 or on q - r = 1, which each reaches with a rate beyond bounds
    "line": {"kinetic_energy": LINE, "coordinates": [Q]},
    "sine": {"kinetic_energy": sin(Q - 1) ** 2 * Q.diff() ** 2 / 2, "coordinates": [Q]},
    "tied": {"kinetic_energy": (Q - 1) ** 2 * (Q.diff() ** 2 + R.diff() ** 2) / 2, "holonomic_constraints": [R - Q]},
    "turned": {"kinetic_energy": ((Q.diff() + R.diff()) ** 2 + (Q - R - 1) ** 2 * (Q.diff() - R.diff()) ** 2) / 2},
    "coupled": {
        "kinetic_energy": ((Q.diff() + R.diff() * cos(R)) ** 2 + (Q - 1) ** 2 * (Q.diff() ** 2 + R.diff() ** 2)) / 2
    },
}


def losing(name: str) -> Model:
    return Model(**{"name": f"losing_{name}", "coordinates": [Q, R], **LOSING[name]})


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky"])
@pytest.mark.parametrize("name", [name for name in LOSING if name != "coupled"])
def test_no_run_passes_where_inertia_is_lost(name, formulation):
    system = system_for(losing(name), formulation)
    for start in (0.0, 0.27, 0.9, 0.99):
        x0 = {"tied": [start, start], "turned": [start / 2, -start / 2]}.get(name, [start])
        v0 = {"tied": [1, 1], "turned": [1, -0.7]}.get(name, [1])
        for method, rtol in (("rk34", 1e-4), ("dopri5", 1e-3), ("dopri5", 1e-6), ("dop853", 1e-6), ("dop853", 1e-11)):
            for way in (1.0, -1.0):
                found = system.simulate((0, 3 * way), x0=x0, v0=way * np.array(v0), method=method, rtol=rtol)
                check_honest(found)
                assert found.stop in NAMED, (start, method, rtol, way)


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky"])
def test_no_long_step_passes_it_by_chance(formulation):
    """At loose tolerances one in forty did, whose error was small by accident."""
    system, random = system_for(losing("line"), formulation), np.random.default_rng(1)
    for _ in range(400):
        q, v = random.uniform(-2, 0.9), random.uniform(0.2, 3)
        end = (1 - q) / v / 2  # (1 - q)^2 falls evenly to zero
        for rtol in (1e-3, 1e-4):
            assert not system.simulate((0, 2 * end), x0=[q], v0=[v], rtol=rtol, atol=rtol).success, (q, v, rtol)
        found = system.simulate((0, 2 * end), x0=[q], v0=[v], rtol=1e-2, atol=1e-2)
        assert not found.success or found.x[0, -1] < 1, (q, v)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("stabilisation", ["project", "none"])
def test_rows_up_to_where_inertia_is_lost_are_right(formulation, stabilisation):
    found = system_for(losing("line"), formulation).simulate(
        (0, 1), x0=[0], v0=[1], rtol=1e-9, atol=1e-12, stabilisation=stabilisation
    )
    assert found.stop in NAMED
    assert "'q'" in found.message
    assert 0.49 < found.t[-1] < 0.5 + 1e-8
    np.testing.assert_allclose((1 - found.x[0]) ** 2, 1 - 2 * found.t, atol=1e-7)


def test_a_block_that_loses_rank_ends_by_name():
    system = system_for(losing("coupled"), "cholesky")
    for rtol in (1e-3, 1e-6, 1e-9):
        found = system.simulate((0, 3), x0=[0, 0.3], v0=[1, 0.2], rtol=rtol, max_steps=20_000)
        assert not found.success


def passing(name: str, miss: float) -> tuple[Model, Trial]:
    return CASES[name].model(miss), CASES[name].trial(miss)


def pass_by(system: System, point: Trial, rtol: float, method: str = "dop853"):
    """Run past the singularity; return the solution and its largest error."""
    found = system.simulate(
        (0, point.times[-1]), x0=point.x0, v0=point.v0, parameters=point.parameters, method=method, rtol=rtol,
        atol=rtol * point.units, t_eval=point.times, max_steps=100_000,
    )  # fmt: skip
    if not found.success:
        return found, np.inf
    truth = point.truth.rows(np.concatenate((point.x0, point.v0)), np.append(0.0, point.times), 0)[1:]
    return found, np.abs(np.exp(1j * found.x.T) - np.exp(1j * truth[:, : len(point.x0)])).max()


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
def test_rounding_at_gimbal_lock_is_weighed_against_the_tolerance(formulation):
    """The closer the passage, the fewer digits are left: near, at a loose tolerance; less near, at a tight one."""
    model, _ = passing("cardan", 1e-6)
    system = system_for(model, formulation)
    for miss, rtol, right in ((1e-6, 1e-6, True), (1e-5, 1e-8, True), (1e-6, 1e-8, False), (1e-4, 1e-12, False)):
        found, error = pass_by(system, passing("cardan", miss)[1], rtol)
        assert found.success == right, (miss, rtol)
        if right:
            assert error < 1000 * rtol
        else:
            assert found.stop is StopReason.SINGULAR_MASS_MATRIX
            assert "loosen rtol" in found.message


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("miss", [1e-2, 1e-5, 1e-8])
def test_what_the_tolerance_determines_is_not_refused(formulation, miss):
    model, point = passing("polar", miss)
    system = system_for(model, formulation)
    for method, rtol in (("dopri5", 1e-5), ("dop853", 1e-10 if miss > 1e-6 else 1e-7)):
        found, error = pass_by(system, point, rtol, method)
        assert found.success, (method, found.message)
        assert error < 1000 * rtol


def test_implicit_runs_are_held_against_their_energy_too():
    system = system_for(plane("logarithm", potential_energy=log(X)))
    for method in ("radau5", "radau9"):
        found = system.simulate((0, 1), x0=[-1, 0], method=method)
        check_honest(found)
        assert found.stop is StopReason.ENERGY_DRIFTED


def test_implicit_runs_weigh_rounding_at_gimbal_lock_too():
    model, point = passing("cardan", 1e-6)
    found, _ = pass_by(system_for(model, "lagrange"), point, 1e-9, "radau5")
    assert found.stop is StopReason.SINGULAR_MASS_MATRIX


@pytest.mark.parametrize("method", ["radau5", "radau9"])
@pytest.mark.parametrize(("name", "miss"), [("gimbal", 1e-8), ("gimbal", 1e-9), ("cardan", 1e-8), ("cardan", 1e-9)])
def test_no_implicit_step_passes_over_gimbal_lock(name, miss, method):
    """They need no short ones there: those of 1e-5 and 1e-6 did, and came out on the other side of it, in success."""
    model, point = passing(name, miss)
    for rtol in (1e-4, 1e-5, 1e-6):
        found, error = pass_by(system_for(model, "lagrange"), point, rtol, method)
        assert found.stop is StopReason.SINGULAR_MASS_MATRIX or error < 1000 * rtol


def test_unconstrained_runs_are_held_against_their_energy_without_stabilisation():
    found = system_for(plane("logarithm", potential_energy=log(X))).simulate((0, 1), x0=[-1, 0], stabilisation="none")
    assert found.stop is StopReason.ENERGY_DRIFTED
