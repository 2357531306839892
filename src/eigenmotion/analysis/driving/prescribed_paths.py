"""Paths of coordinates over time, with two derivatives."""

import math
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
import scipy
import sympy
from sympy.core.function import AppliedUndef

from ...arguments.named_values import Vector, by_spelling, is_named, unknown
from ...arguments.signals import Signal
from ...codegen.model import Table
from ...codegen.model.normalise import ModelError, number, shown
from ...runtime import CompiledModel

_DERIVATIVES = 3
_POINTS = 6
"""Of the Gauss quadrature that looks for jumps."""
_JUMPS = 1e-7
"""A change that differs from the integral of its rate by more than this part is a jump."""
_INTERVALS = 200
_INTERVALS_OF_SPAN = 1000
"""Into which the span of times is divided besides, so that jumps are found that cancel between two times."""
_BENT = (sympy.Abs, sympy.Heaviside, sympy.Max, sympy.Min, sympy.sign)
_ROUNDING = 1e3
"""Units in the last place of a path, or of its rate, that are rounding."""
_REMEDY = (
    "Give an expression in em.t, or a curve with a continuous velocity: through samples, make_interp_spline(times, "
    "values, k=5) of scipy.interpolate."
)


@dataclass(frozen=True, slots=True)
class Path:
    """One coordinate over time: its index, its name, and t -> (3,) value, rate and second rate."""

    index: int
    name: str
    at: Callable[[float], Any]

    def __call__(self, t: float) -> Vector:
        """Return the value, rate and second rate.

        Raises
        ------
        ModelError
            The path has no value there; names the coordinate and the time.
        """
        try:
            values = np.array(self.at(t), dtype=np.float64)
        except (ArithmeticError, NameError, TypeError, ValueError):
            values = np.full(_DERIVATIVES, math.nan)
        if not np.isfinite(values).all():
            raise ModelError(f"the path of {self.name!r} has no value, rate or second rate at t = {t:.9g}")
        return values


def paths_of(c: CompiledModel, motion: Mapping[Any, Any], times: Vector) -> list[Path]:
    """Return the paths of a mapping coordinate -> number, expression in t, Signal, Table or interpolant of SciPy.

    Raises
    ------
    ModelError
        An unknown coordinate; or a path that is none of these, or that jumps, or whose velocity does, within the times.
    """
    names = c.coordinates[: c.n_coordinates]
    if not is_named(motion) or not len(motion):
        raise ModelError(f"the motion is {shown(motion)}. Give a mapping, coordinate -> path.")
    given = by_spelling(motion, "motion")
    if wrong := given.keys() - set(names):
        raise ModelError(f"{c.name}: {unknown('coordinate of the motion', wrong, names)}")
    return [Path(names.index(name), name, _function(name, path, times)) for name, path in given.items()]


def _function(name: str, path: Any, times: Vector) -> Callable[[float], Any]:
    if isinstance(path, sympy.Expr):
        return _expression(name, path, times)
    if isinstance(path, Signal) and path.interpolant is None:
        raise ModelError(f"the path of {name!r}: a signal of kind {path.kind!r} has no continuous velocity. {_REMEDY}")
    if isinstance(path, Signal | Table) or (callable(path) and hasattr(path, "c")):
        return _curve(name, path.table if isinstance(path, Signal) else path, float(times[0]), float(times[-1]))
    if callable(path) or isinstance(path, tuple | list | np.ndarray):
        raise ModelError(f"the path of {name!r} is {shown(path)}. {_REMEDY}")
    return partial(_constant, number(path, f"the path of {name!r}"))


def _constant(value: float, _: float) -> tuple[float, float, float]:
    return value, 0.0, 0.0


def _curve(name: str, path: Any, first: float, last: float) -> Callable[[float], Any]:
    table = path if isinstance(path, Table) else Table(path, name="path")
    if table.arguments != 1:
        raise ModelError(f"the path of {name!r} has {table.arguments} arguments. A path is a function of t alone.")
    pieces = table.pieces
    knots = pieces.axes[0].knots
    if pieces.outside == "refuse" and not (knots[0] <= first and last <= knots[-1]):
        raise ModelError(
            f"the path of {name!r} is known on [{knots[0]:g}, {knots[-1]:g}], and times reach from {first:g} to "
            f"{last:g}"
        )
    joins = [at for at, order in pieces.joins(0) if order < 2 and _meets(pieces.outside, at, first, last)]
    sizes = np.abs([[pieces.value((order,), (at,)) for order in range(2)] for at in knots]).max(axis=0)
    for at in joins:
        sides = [
            [pieces.value((order,), (t,)) for order in range(2)]
            for t in (math.nextafter(at, math.inf), math.nextafter(at, -math.inf))
        ]
        if (np.abs(np.diff(sides, axis=0)) > _JUMPS * sizes).any():
            raise ModelError(f"the velocity of the path of {name!r} jumps at t = {at:g}. {_REMEDY}")
    return lambda t: [pieces.value((order,), (t,)) for order in range(_DERIVATIVES)]


def _meets(outside: str, at: float, first: float, last: float) -> bool:
    """Return whether a motion meets a join: strictly between its times, or in some period."""
    return outside == "periodic" or first < at < last


# --- expressions ---


def _expression(name: str, path: sympy.Expr, times: Vector) -> Callable[[float], Any]:
    """Return value and rates of an expression in t; tables in it are differentiated exactly."""
    others = [one for one in path.free_symbols if str(one) != "t"] + list(path.atoms(AppliedUndef))
    if others:
        raise ModelError(
            f"the path of {name!r} has {', '.join(sorted(map(str, others)))} in it. It is an expression in t alone."
        )
    t = sympy.Symbol("t", real=True)
    path = path.xreplace(dict.fromkeys(path.free_symbols, t)).rewrite(_BENT, sympy.Piecewise)
    rates = [path.diff(t, order) for order in range(_DERIVATIVES)]
    try:
        made: Callable[[float], Any] = sympy.lambdify(t, rates, modules=["math", "scipy"], cse=True)
    except (NotImplementedError, ValueError, TypeError, AttributeError) as error:
        raise ModelError(f"the path of {name!r}, {path}, has no rates that can be evaluated. {_REMEDY}") from error
    _check_continuous(Path(0, name, made), times)
    return made


def _check_continuous(path: Path, times: Vector) -> None:
    """Raise ModelError if value or rate jumps: its change is then not the integral of its rate."""
    times = np.unique(np.concatenate([times, np.linspace(times[0], times[-1], _INTERVALS_OF_SPAN)]))
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    ends = np.array([path(float(t)) for t in times])
    rounding = _ROUNDING * np.finfo(float).eps * np.abs(ends[:, :2]).max(axis=0)
    for k, (start, end) in enumerate(pairwise(times)):
        half = (end - start) / 2
        inside = np.array([path(float(start + half * (1.0 + point))) for point in points])[:, 1:]
        left = np.abs(ends[k + 1, :2] - ends[k, :2] - half * (weights @ inside))
        for order in np.flatnonzero(left > _JUMPS * half * (weights @ np.abs(inside)) + rounding):
            _refine(path, int(order), (float(start), float(end)), ends[k + 1, order] - ends[k, order], rounding[order])


def _refine(path: Path, order: int, span: tuple[float, float], change: float, rounding: float) -> None:
    """Raise ModelError if an accurate integral of the rate of `order` differs from the change, too."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its error is taken into account
        integral, error = scipy.integrate.quad(lambda t: path(t)[order + 1], *span, limit=_INTERVALS)
    if abs(change - integral) > 10.0 * error + _JUMPS * abs(integral) + rounding:
        what = "velocity of the path" if order else "path"
        raise ModelError(f"the {what} of {path.name!r} jumps between t = {span[0]:g} and {span[1]:g}. {_REMEDY}")
