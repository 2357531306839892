"""The motion that errors are measured against, and how far it can be trusted."""

from dataclasses import dataclass

import numpy as np

from ..codegen.model import ModelError
from ..names import Vector
from .classical import Classical
from .extended import EPSILON, Extended, NotReachedError, extended, trajectory

ROWS = 201
HOW = (
    "Extrapolated midpoint steps of order 16 in extended precision ({digits:.1f} digits) on Lagrange's equations, "
    "derived by SymPy apart from the code generator; nothing is projected. Its error is estimated by a second run, of "
    "order 12, at a hundred times the tolerance, and from a start that differs by {shift} units in the last place, so "
    "that the estimate is that of the worse of the two and holds how much the motion magnifies rounding."
)
_SHIFT = 16


@dataclass(frozen=True, slots=True)
class Reference:
    """Rows on the common time grid, k of them.

    Attributes
    ----------
    t : (k,) [s]; x, v : (k, n), rounded to double
    errors : (k,) estimate of the reference's own error, scaled as in `scaled_error`
    """

    t: Vector
    x: Vector
    v: Vector
    errors: Vector
    how: str


def scaled_error(x: Vector | Extended, exact: Vector | Extended) -> Vector:
    """Return max_k |x_k - exact_k| / (1 + |exact_k|) of each row: (rows, n) -> (rows,). NaN stays NaN."""
    return np.asarray(np.max(np.abs(x - exact) / (1 + np.abs(exact)), axis=-1), dtype=np.float64)


def reference(equations: Classical, y: Vector, t_end: float) -> Reference:
    """Integrate from y (2n,) at t = 0 over a grid of ROWS times that ends at t_end.

    Raises
    ------
    ModelError
        The motion cannot be followed to t_end in extended precision; says where it ends.
    """
    times = np.linspace(0.0, t_end, ROWS)
    finest = max(1e-17, 50 * EPSILON)
    n, rhs = len(equations.x), extended(equations)
    try:
        with np.errstate(all="ignore"):
            fine = trajectory(rhs, y, times, finest, columns=8)
            other = trajectory(rhs, _shifted(y), times, 100 * finest, columns=6)
    except (NotReachedError, ZeroDivisionError, ValueError) as error:
        raise ModelError(f"there is no reference to compare with: {error}; shorten the span with --t-end") from error
    x, v = fine[:, :n].astype(np.float64), fine[:, n:].astype(np.float64)
    how = HOW.format(digits=-np.log10(EPSILON), shift=_SHIFT)
    return Reference(times, x, v, scaled_error(other[:, :n], fine[:, :n]), how)


def _shifted(y: Vector) -> Extended:
    """A start apart by rounding, in directions that alternate."""
    signs = np.where(np.arange(len(y)) % 2, -1.0, 1.0)
    return np.asarray(y.astype(np.longdouble) + _SHIFT * EPSILON * signs * (1 + np.abs(y)))
