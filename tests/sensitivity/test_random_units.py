"""Motions and their derivatives in random units, signs, orders, origins and clocks, against SciPy's in one unit."""

import numpy as np
import pytest

import eigenmotion as em

from ..support.generation import system_for
from ..support.random_units import Mechanism, Units

CASES = [*range(4), *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(4, 45))]
RTOL, MOTION, SLOPES = 1e-9, 3e-6, 1e-5


@pytest.mark.parametrize("seed", CASES)
def test_motions_and_derivatives_in_random_units(seed: int):
    of = Mechanism(seed)
    tau, motion, slopes = of.motion
    system, random = system_for(of.model(), ("lagrange", "eigenfactor")[seed % 2]), np.random.default_rng(seed)
    size = np.maximum(1.0, np.abs(slopes).max(axis=(0, 2)))
    for method in ("dop853", "ra15", "auto"):
        units = Units(of, random)
        given, times = units.given(system.parameters, RTOL) | {"method": method}, units.times(tau)
        span = (times[0], times[-1])
        run = system.simulate(span, t_eval=times, sensitivities=of.names, **given)
        assert run.success, run.message
        assert units.back(run.x, run.v) == pytest.approx(motion, abs=MOTION)
        every = system.simulate(span, **given)
        assert units.back(every.x[:, -1:], every.v[:, -1:]) == pytest.approx(motion[:, -1:], abs=MOTION)
        for k, name in enumerate(of.names):
            found = run.sensitivity[name]
            found = units.back(found.dx, found.dv, 0.0) / units.size(name)
            assert found == pytest.approx(slopes[:, k], abs=SLOPES * size[k]), (method, name)
        _, pullback = em.vjp(system, span, t_eval=times, by=of.names, **given)
        weight = random.standard_normal((2 * of.n, 9))
        rows = weight[np.concatenate([of.order, of.n + of.order])] * units.of_rows
        found, right = pullback(dx=rows[: of.n], dv=rows[of.n :]), np.einsum("it,ikt->k", weight, slopes)
        assert [found[name] / units.size(name) for name in of.names] == pytest.approx(right, abs=1e-4 * size.max())
        runs = em.simulate_ensemble(system, span, t_eval=times, **given | {"x0": _eight(given["x0"])})
        assert units.back(runs.x[0], runs.v[0]) == pytest.approx(motion, abs=MOTION)


def _eight(x0: dict[str, float]) -> dict:
    """Eight starts; the first one is that given."""
    return x0 | {"q0": x0["q0"] * np.linspace(1.0, 1.2, 8)}
