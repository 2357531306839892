"""Check of the first steps of a run against proved accelerations: methods, settling and monitors."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from ...arguments.methods import METHODS
from ...arguments.named_values import Vector
from ...arguments.options import SHARED_FROM_START
from ...codegen.model import ModelError
from ...results.charts import in_charts_of
from ...results.solution import Solution
from ...runtime import EvaluationError, StopReason
from ...system.system import System
from .arithmetic.rounding_bounds import geometric

FAR = 1e9
STEPS = 2
"""Steps of each method; so short a run is the same in every formulation."""
SUBSTEPS = 32
"""Steps of the reference (classical fourth-order method) for each step."""
TOLERANCE = 1e-9
"""Tolerance of the run; errors of x and v above a thousand times this part of their change are wrong."""
SOUND = 1e-6
"""Above this least eigenvalue, a matrix with unit diagonal is certainly regular."""
_REASONS = (StopReason.SINGULAR_MASS_MATRIX, StopReason.DEPENDENT_CONSTRAINTS)


def first_steps(system: System, methods: Iterable[str] = tuple(METHODS)) -> Iterator[tuple[str, str]]:
    """Yield (method, what is wrong) for runs from the model's start that disagree with its accelerations.

    Methods are compiled ones, explicit ones first. A start that is refused, or a run that ends there for a reason of
    its own, decides nothing. Runs by implicit methods are not longer than those by explicit methods. A method that
    iterates has no first step from rest without an absolute tolerance; the size of its motion gives a second one, since
    a motion that stiff friction holds back may be smaller than the first.
    """
    x, far = system.compiled.initial_x, min(FAR, system.compiled.smooth_interval(0.0, 1.0, system.prepare())[0])
    end, rests = far, not system.compiled.initial_v.any()
    with np.errstate(all="ignore"):
        for name in methods:
            until = end if METHODS[name].implicit else far
            try:
                run = _run(system, name, until, atol=TOLERANCE if rests and METHODS[name].iterates else 0.0)
            except ModelError:
                return
            if _refuses(run) and _refuses(_run(system, name, far, atol=TOLERANCE)) and _is_sound(system, x):
                yield name, f"ends at the start ({run.message}), where nothing is singular"
            elif (error := _off(system, run)) and all(
                _off(system, _run(system, name, until, atol)) for atol in (TOLERANCE, TOLERANCE * _change(run))
            ):
                yield name, f"is off by {error:.1e} of the way after {run.nsteps} steps"
            end = min(end, run.t[-1]) if run.nsteps else end


def _run(system: System, method: str, end: float, atol: float) -> Solution:
    return system.simulate((0.0, end), method=method, rtol=TOLERANCE, atol=atol, max_steps=STEPS)


def _change(run: Solution) -> float:
    """Return the largest change of a velocity."""
    v = run.motion[1]
    return float(np.abs(v[:, -1] - v[:, 0]).max(initial=0.0))


def _refuses(run: Solution) -> bool:
    """Return whether the run ends at its start. Without an absolute tolerance, rounding of a zero may be the reason."""
    return run.stop in _REASONS and float(run.t[-1]) == 0.0


def _jumps(system: System, run: Solution) -> bool:
    """Return whether there was an event action, or a contact or friction holds (none does in the model's own mode)."""
    acted = any(len(times) for times, acts in zip(run.t_events or (), system.compiled.acting, strict=False) if acts)
    return acted or any(any(mode.values()) for _, mode in run.modes)


def _is_sound(system: System, x: Vector) -> bool:
    """Return whether M and A M^-1 A^T are certainly regular at the start."""
    M, A = system.mass_matrix(x), system.pfaffian(x)[0]
    return _least(M) > SOUND and _least(A @ np.linalg.solve(M, A.T)) > SOUND


def _least(W: Vector) -> float:
    scaled = W / geometric(W[None])[0]
    return float(np.linalg.eigvalsh(scaled).min(initial=1.0)) if np.isfinite(scaled).all() else 0.0


def _off(system: System, run: Solution) -> float:
    """Return the error of the run; 0 if it is within the tolerance, or may be the error of the reference.

    The error of the reference decreases with shorter substeps, for example if a force or M has a jump or kink at the
    start. Without an absolute tolerance, a motion from rest may be only rounding of accelerations; so the caller also
    checks a run with an absolute tolerance.
    """
    if not run.nsteps or _jumps(system, run) or _rests(system, run):
        return 0.0
    error = _error(system, run, SUBSTEPS)
    if not error > 1e3 * TOLERANCE:
        return 0.0
    return 0.0 if _error(system, run, 16 * SUBSTEPS) < error / 2 else error


def _rests(system: System, run: Solution) -> bool:
    """Return whether the run starts at rest, and accelerations at its start and end are only rounding.

    Rounding: the change of accelerations if x changes in its last digits, or the rest of reactions that cancel forces.
    """
    x, v = (part[:, 0] for part in run.motion)
    near = x * (1 + 4 * np.finfo(float).eps)
    try:
        pushed, moved = (np.array([_motion(system, at, v, t)[0] for t in (0.0, run.t[-1])]) for at in (x, near))
        cancelled = max(_cancelled(system, x, v, t) for t in (0.0, run.t[-1]))
    except EvaluationError:
        return False
    rounding = max(np.abs(np.abs(pushed) - np.abs(moved)).max(), np.finfo(float).eps * cancelled)
    return not v.any() and bool(np.abs(pushed).max() <= 8 * rounding)


def _cancelled(system: System, x: Vector, v: Vector, t: float) -> float:
    """Return the largest acceleration that the reactions alone would cause."""
    c, prepared = system.compiled, system.prepare()
    if not c.m:
        return 0.0
    reactions = np.abs(c.pfaffian(t, x, prepared)[0].T) @ np.abs(_motion(system, x, v, t)[1])
    M = c.factored_matrix(t, x, prepared)
    return float((np.abs(np.linalg.inv(M)) @ reactions).max(initial=0.0))


def _error(system: System, run: Solution, substeps: int) -> float:
    """Return the error relative to the distance of x and the change of v in the mass metric; NaN if unknown."""
    n, times = system.compiled.n, np.linspace(0.0, run.t[-1], substeps * run.nsteps + 1)
    start = z = np.concatenate([part[:, 0] for part in run.motion])
    try:
        for t, h in zip(times, np.diff(times), strict=False):
            z = _classical_step(system, t, z, h)
        M = system.compiled.factored_matrix(0.0, start[:n], system.prepare())
    except EvaluationError:
        return np.nan
    moved = in_charts_of(system.compiled, z[:n, None], *(part[:, -1:] for part in run.motion))
    end = np.concatenate(moved)[:, 0]
    off = [np.sqrt(d @ M @ d) for d in (end[:n] - z[:n], end[n:] - z[n:])]
    way = run.t[-1] * (np.sqrt(start[n:] @ M @ start[n:]) + np.sqrt(z[n:] @ M @ z[n:]))
    change = np.sqrt((z - start)[n:] @ M @ (z - start)[n:])
    rounding = [np.sqrt(s @ M @ s) * np.finfo(float).eps / TOLERANCE for s in (start[:n], start[n:])]
    return float(max(off[0] / (way + rounding[0]), off[1] / (change + way / run.t[-1] + rounding[1])))


def _classical_step(system: System, t: float, z: Vector, h: float) -> Vector:
    """Return the state after one step of the classical fourth-order method."""
    k1 = _rate(system, t, z)
    k2 = _rate(system, t + h / 2, z + h / 2 * k1)
    k3 = _rate(system, t + h / 2, z + h / 2 * k2)
    k4 = _rate(system, t + h, z + h * k3)
    return np.asarray(z + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))


def _rate(system: System, t: float, z: Vector) -> Vector:
    """Return (v, a) at t, moved into the smooth interval between the time events around the start."""
    n, (_, low, high) = system.compiled.n, system.compiled.smooth_interval(0.0, 1.0, system.prepare())
    t = min(max(t, low), high)
    return np.concatenate([z[n:], _motion(system, z[:n], z[n:], t)[0]])


def _motion(system: System, x: Vector, v: Vector, t: float) -> tuple[Vector, Vector]:
    """Return accelerations and multipliers at default parameters and inputs."""
    c, prepared = system.compiled, system.prepare()
    shares = c.shares(t, x, prepared, SHARED_FROM_START)
    return c.acceleration(float(t), x, v, prepared, c.input_defaults, shares)
