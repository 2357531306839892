"""Random machines with loops, driven along a motion that they make by themselves: it takes no forces."""

import numpy as np
import pytest
from scipy.interpolate import BPoly, PPoly

import eigenmotion as em
from eigenmotion.analysis.state.tangent_space import null_space

from ..support.random_machines import Machine

SPAN, ROWS = 0.2, 81


def free_motion(system, model):
    """t, x, v, a of a run, (k,) and (n, k); None if it meets a position at which the constraints lose rank."""
    random = np.random.default_rng(len(model.name))
    try:
        start = system.project_initial_state(v0=0.5 * random.normal(size=system.n))
        run = system.simulate((0.0, SPAN), x0=start.x, v0=start.v, t_eval=np.linspace(0.0, SPAN, ROWS), rtol=1e-12,
                              atol=1e-13)  # fmt: skip
        rows = zip(run.t, run.x.T, run.v.T, strict=True)
        return run.t, run.x, run.v, np.array([system.acceleration(x, v, t)[0] for t, x, v in rows]).T
    except em.EvaluationError:
        return None


def independent(system, t, x):
    """Coordinates that determine the others all along, or None."""
    unit = 1.0 / np.sqrt(np.diag(system.mass_matrix(x[:, 0], t[0])))
    free = null_space(system.pfaffian(x[:, 0], t[0])[0], unit)[0]
    dependent = [k for k in range(system.n) if k not in free]
    signs = []
    for at, place in zip(t, x.T, strict=True):
        A = system.pfaffian(place, at)[0] * unit
        if len(A) != len(dependent) or np.linalg.norm(A, axis=1).min() < 1e-6 or np.linalg.cond(A[:, dependent]) > 1e3:
            return None
        signs.append(np.linalg.det(A[:, dependent]))
    return free if min(np.abs(signs)) > 0.02 * max(np.abs(signs)) and min(signs) * max(signs) > 0.0 else None


def check(seed):
    """Return whether a machine has loops and keeps away from singular positions."""
    made = Machine(seed)
    if not made.model.holonomic_constraints:
        return False
    system = em.build(made.model, formulation="lagrange")
    motion = free_motion(system, made.model)
    free = None if motion is None or not np.isfinite(motion[1]).all() else independent(system, *motion[:2])
    if free is None:
        return False
    t, x, v, a = motion
    curves = [BPoly.from_derivatives(t, np.array([x[k], v[k], a[k]]).T) for k in free]
    paths = {system.coordinates[k]: PPoly.from_bernstein_basis(curve) for k, curve in zip(free, curves, strict=True)}
    driven = em.drive(system, t[::8], paths, x0=x[:, 0])
    scale = np.abs(x).max() + np.abs(v).max() * SPAN
    assert np.abs(driven.x - x[:, ::8]).max() < 1e-9 * scale
    assert np.abs(driven.v - v[:, ::8]).max() < 1e-7 * (np.abs(v).max() + 1.0)
    needed = [
        np.abs(system.mass_matrix(x, t)) @ np.abs(a) for t, x, a in zip(driven.t, driven.x.T, driven.a.T, strict=True)
    ]
    assert np.abs(driven.forces).max() < 1e-5 * np.max(needed)
    return True


@pytest.mark.parametrize(
    "block", [0, *(pytest.param(block, marks=pytest.mark.nightly("random cases")) for block in range(1, 20))]
)
def test_a_free_motion_takes_no_forces(block):
    assert sum(check(10 * block + k) for k in range(10)) >= 1
