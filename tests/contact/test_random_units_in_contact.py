"""Contacts, frictions, constraints and tables in random units, signs, orders, origins and clocks: as in one unit.

What holds in one unit has oracles of its own; here nothing may depend on the choice.
"""

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion import ModelError, Solution, System

from ..support.generation import system_for
from ..support.random_units_in_contact import Choice, Scene

FOUND = [109, 177, 245, 277]
"""Steps by the thousand where a cone stops, and a reset refused beside a contact whose gap is 1e-40."""
CASES = [*range(5), *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(5, 60))]
JOINS = [pytest.param(seed, marks=pytest.mark.nightly) for seed in (98, 247)]
"""As 47: a step of derivatives ended beside a join of a table, and said that a force jumps there."""
METHODS = ("dop853", "ra15", "auto", "radau9", "dopri5")
RTOL, MOTION, FORCE, SLOPES = 1e-9, 1e-5, 1e-4, 1e-4


def events(run: Solution, units: Choice) -> list[np.ndarray]:
    return [(times - units.t_0) * units.k for times in run.t_events or ()]


@pytest.mark.parametrize("seed", [*CASES, *FOUND])
def test_motions_events_and_forces(seed: int):
    of = Scene(seed)
    system, random = system_for(of.model(), ("lagrange", "eigenfactor")[seed % 2]), np.random.default_rng(seed)
    tau, plain = np.linspace(0.0, of.end, 9), Choice(of, random, 0.0)
    for method in METHODS:
        right = system.simulate((0.0, of.end), t_eval=tau, method=method, **plain.given(system.parameters, RTOL))
        assert right.success, right.message
        motion, units = plain.back(right.x, right.v), Choice(of, random)
        times, given = units.times(tau), units.given(system.parameters, RTOL) | {"method": method}
        run = system.simulate((times[0], times[-1]), t_eval=times, **given)
        assert run.success, run.message
        assert units.back(run.x, run.v) == pytest.approx(motion, abs=MOTION)
        for found, wanted in zip(events(run, units), events(right, plain), strict=True):
            assert found == pytest.approx(wanted, abs=MOTION)
        assert units.forces(run.multipliers) == pytest.approx(plain.forces(right.multipliers), abs=FORCE)
        assert run.nsteps <= 2 * right.nsteps + 20
        starts = given["x0"] | {"q0": np.full(8, given["x0"]["q0"])}
        runs = em.simulate_ensemble(system, (times[0], times[-1]), t_eval=times, **given | {"x0": starts})
        assert units.back(runs.x[3], runs.v[3]) == pytest.approx(motion, abs=MOTION)
        if method != "auto":
            stepper = system.stepper(t=times[0], **given)
            for one in times[1:]:
                stepper.advance(one)
            assert units.back(stepper.x[:, None], stepper.v[:, None]) == pytest.approx(motion[:, -1:], abs=MOTION)
        check_linear(system, (right, plain), (run, units), times[-1])


def check_linear(system: System, right: tuple[Solution, Choice], found: tuple[Solution, Choice], end: float) -> None:
    """The eigenvalues of the linear model at the end of a run; where modes meet, none is asked for."""
    (run, plain), (other, units) = right, found
    try:
        wanted = eigenvalues(system, run, plain, plain.of.end)
        values = eigenvalues(system, other, units, end)
    except ModelError as error:
        assert "modes meet" in str(error)  # noqa: PT017
        return
    assert len(wanted) == len(values), (wanted, values)
    apart = np.abs(wanted[:, None] - values)
    if len(values):
        assert max(apart.min(axis=0).max(), apart.min(axis=1).max()) < FORCE * max(1.0, np.abs(wanted).max())


def eigenvalues(system: System, run: Solution, units: Choice, t: float) -> np.ndarray:
    """Of a state without what is rounding of numbers of order one: at rest, nothing else says so."""
    parameters, n = units.given(system.parameters, RTOL)["parameters"], units.of.n
    x, v = run.x[:, -1], run.v[:, -1]
    x, v = (np.where(np.abs(size[:, 0] * one) < 1e-20, 0.0, one)
            for size, one in ((units.of_rows[:n], x), (units.of_rows[n:], v)))  # fmt: skip
    if units.of.Z is not None:
        x = np.append(x, [rows[-1] for rows in run.states.values()])
    return system.linearize(x, v, t, parameters=parameters).eigenvalues() / units.k


@pytest.mark.parametrize("seed", [*CASES, *JOINS])
def test_derivatives(seed: int):
    of = Scene(seed)
    system, random = system_for(of.model(), ("lagrange", "eigenfactor")[seed % 2]), np.random.default_rng(seed)
    tau, plain = np.linspace(0.0, of.end, 9), Choice(of, random, 0.0)
    for method in ("dop853", "ra15"):
        right = system.simulate((0.0, of.end), t_eval=tau, method=method, sensitivities=of.names,
                                **plain.given(system.parameters, RTOL))  # fmt: skip
        units = Choice(of, random)
        times, given = units.times(tau), units.given(system.parameters, RTOL) | {"method": method}
        run = system.simulate((times[0], times[-1]), t_eval=times, sensitivities=of.names, **given)
        slopes = np.array(
            [plain.back(right.sensitivity[name].dx, right.sensitivity[name].dv, 0.0) for name in of.names]
        )
        for name, wanted in zip(of.names, slopes, strict=True):
            one, size = run.sensitivity[name], units.size(name)
            within = SLOPES * max(1.0, np.abs(wanted).max())
            assert units.back(one.dx, one.dv, 0.0) / size == pytest.approx(wanted, abs=within), (method, name)
            for dt, dt_wanted in zip(one.dt_events or (), right.sensitivity[name].dt_events or (), strict=True):
                within = SLOPES * max(1.0, np.abs(dt_wanted).max(initial=0.0))
                assert dt * units.k / size == pytest.approx(dt_wanted, abs=within), (method, name)
        _, pullback = em.vjp(system, (times[0], times[-1]), t_eval=times, by=of.names, **given)
        weight = random.standard_normal((2 * of.n, 9))
        rows = weight[np.concatenate([of.order, of.n + of.order])] * units.of_rows
        found, wanted = pullback(dx=rows[: of.n], dv=rows[of.n :]), np.einsum("it,kit->k", weight, slopes)
        within = 3 * SLOPES * max(1.0, np.abs(slopes).max())
        assert [found[name] / units.size(name) for name in of.names] == pytest.approx(wanted, abs=within)
