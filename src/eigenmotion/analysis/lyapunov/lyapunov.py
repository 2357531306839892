"""Lyapunov exponents by exact derivatives of pieces of a run."""

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector
from ...arguments.options import is_system, no_system
from ...codegen.model.normalise import ModelError, number
from ...compiled.compiled_system import CompiledSystem
from ..cycles.find_cycle import problem_of
from ..cycles.periodic_problem import Problem
from ..cycles.returns import Return, Section, returned
from .exponents import Lyapunov

_PARTS = 20
"""Number of parts of a run whose means give the spread."""
_LOST = 1e-9
"""Least ratio of growths in a piece that rounding leaves; where it is smaller, the piece is halved."""
_VANISHED = 1e-13
"""Part of a deviation below which it has vanished."""


def lyapunov(
    system: CompiledSystem,
    t_end: float,
    *,
    x0: Mapping[Any, float] | ArrayLike | None = None,
    v0: Mapping[Any, float] | ArrayLike | None = None,
    t: float = 0.0,
    transient: float | None = None,
    pieces: int = 200,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | None = None,
    method: str = "dop853",
    rtol: float = 1e-9,
    atol: Any = None,
) -> Lyapunov:
    """Return the Lyapunov exponents of a motion: the mean rates at which small deviations from it grow.

    The motion may go through events, impacts, contacts and friction; the derivatives of its pieces do, too.

    Parameters
    ----------
    t_end
        [s] End of the run.
    x0, v0, t
        Start, over the model's `initial`.
    transient
        [s] Length of the run at its beginning that is not counted: the motion settles, and deviations turn into their
        directions. None: a tenth of the run.
    pieces
        Number of pieces, after each of which deviations are made orthogonal; more where they grow by more than 1e9.
    parameters, inputs, method, rtol, atol
        As in `simulate`.

    Returns
    -------
    Lyapunov
        The exponents, with their standard errors.

    Raises
    ------
    ModelError
        Unknown names; an inconsistent start; t_end or transient that leave no run; the run fails.

    Notes
    -----
    Deviations are multiplied by the derivatives of each piece and made orthogonal by QR. G. Benettin, L. Galgani,
    A. Giorgilli, J.-M. Strelcyn, Meccanica 15 (1980) 9. The sum of all exponents is the mean rate of the volume.

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/rimless_wheel.py")
    >>> found = em.lyapunov(system, 100.0, x0={"theta": -0.3}, v0={"theta": 1.2})
    >>> bool(abs(found.exponents[0]) < 0.02), found.exponents[1].round(1)
    (True, np.float64(-0.7))
    """
    if not is_system(system):
        raise no_system("lyapunov", system)
    begin, end = number(t, "t"), number(t_end, "t_end")
    settled = 0.1 * (end - begin) if transient is None else number(transient, "transient")
    if not 0.0 <= settled < end - begin or pieces < _PARTS:
        raise ModelError(f"{system.name}: t_end {end:g} and transient {settled:g} leave no run of {pieces} pieces. "
                         f"Give a later t_end, and at least {_PARTS} pieces")  # fmt: skip
    options = {"method": method, "rtol": number(rtol, "rtol")} | ({} if atol is None else {"atol": atol})
    with np.errstate(all="ignore"):  # numbers that are not finite are reported by name
        problem, q = problem_of(system, (x0, v0), begin, (parameters, inputs), options)
        first = max(1, round(pieces * settled / (end - begin - settled))) if settled else 0
        times = np.concatenate([np.linspace(begin, begin + settled, first + 1)[:-1],
                                np.linspace(begin + settled, end, pieces + 1)])  # fmt: skip
        return _measured(problem, q, times, first)


def _measured(problem: Problem, q: Vector, times: Vector, first: int) -> Lyapunov:
    start = returned(problem, Section(), problem.projected(q, problem.prepared), float(times[1] - times[0]))
    unit, local = start.scale, list[Vector]()
    deviations = _orthogonal(problem, start.basis.Z, unit)[0]
    for since, until in pairwise(times):
        pieces = _pieces(replace(problem, t=float(since)), q, float(until))
        grown = np.zeros(deviations.shape[1])
        for piece in pieces:
            ends = piece.S @ deviations[list(piece.basis.free)]
            deviations, growth = _orthogonal(problem, ends, unit)
            grown = grown + growth
            q = piece.end
        local.append(grown / (until - since))
    return _result(problem, q, np.array(local)[first:], times[first:])


def _pieces(problem: Problem, q: Vector, until: float) -> list[Return]:
    """Return the motion until a time with its derivatives, in pieces short enough for all deviations."""
    here = returned(problem, Section(), problem.projected(q, problem.prepared), until - problem.t)
    sizes = np.linalg.svd((here.S / here.scale[:, None] * here.scale[list(here.basis.free)]), compute_uv=False)
    kept = sizes[sizes > _VANISHED * sizes[0]]
    middle = 0.5 * (problem.t + until)
    if kept[-1] > _LOST * kept[0] or not problem.t < middle < until:
        return [here]
    first = _pieces(problem, q, middle)
    return [*first, *_pieces(replace(problem, t=middle), first[-1].end, until)]


def _orthogonal(problem: Problem, ends: Vector, unit: Vector) -> tuple[Vector, Vector]:
    """Return deviations (2 n, k) of unit length that span the same spaces, and the logarithms of their growths (k,)."""
    own = [*range(problem.c.n_coordinates), *range(problem.c.n, 2 * problem.c.n)]
    Q, R = scipy.linalg.qr((ends / unit[:, None])[own], mode="economic")
    sizes = np.abs(np.diag(R))
    made = np.zeros_like(ends)
    made[own] = Q * unit[own][:, None]
    return made, np.where(sizes > _VANISHED, np.log(sizes), -np.inf)


def _result(problem: Problem, q: Vector, local: Vector, times: Vector) -> Lyapunov:
    c = problem.c
    parts = [part.mean(axis=0) for part in np.array_split(local, _PARTS)]
    exponents, spread = local.mean(axis=0), np.std(parts, axis=0, ddof=1) / _PARTS**0.5
    order = np.argsort(-exponents, kind="stable")
    x, v = problem.start(q)
    return Lyapunov(
        problem.system, exponents[order], np.where(np.isfinite(spread), spread, 0.0)[order], local[:, order], times,
        dict(zip(c.coordinates, x.tolist(), strict=True)),
        dict(zip(c.coordinates[: c.n_coordinates], v.tolist(), strict=True)),
    )  # fmt: skip
