"""Cycles that leave an equilibrium at a Hopf bifurcation."""

from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from ..cycles.find_cycle import problem_of
from ..cycles.newton import Search, Unknowns
from ..cycles.periodic_problem import Problem
from ..cycles.returns import NoReturnError, Section, returned
from ..cycles.time_dependence import advancing, depends_on_time
from ..linear.linearize import linearized
from .curve import NoPointError, Place, point
from .cycle_curve import CycleCurve
from .equilibrium_curve import EquilibriumCurve

_AMPLITUDES = (1e-2, 1e-3, 1e-4)
"""Amplitudes of the first cycle, in units of the equilibrium's curve."""
_RTOL = 1e-11


def oscillating(system: CompiledSystem, curve: EquilibriumCurve, by: str, at: Place) -> tuple[CycleCurve, Place]:
    """Return the curve of cycles that begins at a Hopf bifurcation, and its first cycle.

    Raises
    ------
    ModelError
        The equations depend on time; no cycle is found.
    """
    point = curve.balance.point(at.sample.w)
    n, every = system.n, point.model.n
    direction, frequency = _critical(curve, at)
    rest = curve.balance.arguments(at.sample.w)[2 * every :].tolist()
    inputs = dict(zip(system.inputs, rest[: len(system.inputs)], strict=True))
    parameters = dict(zip(point.model.parameters, rest[len(system.inputs) :], strict=True))
    start = [*point.x[:n], *point.v[n:]], list(point.v[:n])
    problem, q = problem_of(system, start, point.t, (parameters, inputs), {"method": "dop853", "rtol": _RTOL})
    period = 2 * np.pi / frequency
    if depends_on_time(problem, q, period):
        raise ModelError(f"{system.name}: the equations depend on time, so no cycles of their own begin at the Hopf "
                         "bifurcation")  # fmt: skip
    problem = replace(problem, free_advance=advancing(problem, q, period), by=(by,))
    for size in _AMPLITUDES:
        try:
            return _begun(problem, q, size * direction, (period, at.sample.parameter, curve.extent))
        except (NoPointError, NoReturnError) as error:
            reason = str(error)
    raise ModelError(f"{system.name}: no cycle is found beside the Hopf bifurcation: {reason}")


def _critical(curve: EquilibriumCurve, at: Place) -> tuple[Vector, float]:
    """Return the direction (2 n,) of the critical oscillation, of unit size, and its angular frequency."""
    point = curve.balance.point(at.sample.w)
    linear = linearized(point)
    values, vectors = np.linalg.eig(linear.A)
    turning = np.where(values.imag > 1e-9 * np.abs(values).max(), np.abs(values.real), np.inf)
    k = int(turning.argmin())
    n, every = point.coordinates, point.model.n
    whole = np.zeros(2 * every)
    whole[[*range(n), *range(every, 2 * every)]] = (linear.Z @ vectors[:, k]).real
    unit = curve.balance.scale(curve.balance.start)[: len(curve.balance.free) - 1]
    chosen = [place for place in curve.balance.free[:-1] if place < 2 * every]
    sizes = np.abs(whole[chosen]) / unit[: len(chosen)]
    return whole / sizes.max(), float(values[k].imag)


def _begun(problem: Problem, q: Vector, change: Vector, numbers: tuple[float, float, float]
           ) -> tuple[CycleCurve, Place]:  # fmt: skip
    """Return the curve and the cycle beside the equilibrium, whose start is changed."""
    period, value, extent = numbers
    begin = problem.projected(q + change, problem.prepared)
    rough = returned(problem, Section(), begin, period)
    problem = problem.with_tolerance(_RTOL, rough.scale)
    first = returned(problem, Section(), begin, period)
    curve = CycleCurve(Search(problem, Section(), Unknowns(True, ())), first, extent)
    w = np.concatenate([begin, [period, value]])
    outward = np.concatenate([change, [0.0, 0.0]])
    unit = curve.at(w).unit
    across = outward / unit / np.linalg.norm(outward / unit)
    return curve, point(curve, w, outward, (across / unit, w))
