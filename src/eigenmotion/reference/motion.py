"""Reference motion, against which errors are measured, and its own error."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..arguments.named_values import Vector
from ..codegen.model import ModelError
from ..codegen.model.symbolic.lagrange import Lagrange
from .collocation import Collocation, jacobian
from .extended_precision import EPSILON, Extended, Rhs, extended
from .integration import Midpoint, NotReachedError, Scheme, integrate_adaptive

ROWS = 201
_HOW = (
    "{steps} in extended precision ({digits:.1f} digits) on Lagrange's equations, derived by SymPy apart from the code "
    "generator; nothing is projected. Its error is estimated by a second run, of order {lower}, at a hundred times the "
    "tolerance, and from a start that differs by {shift} units in the last place, so that the estimate is that of the "
    "worse of the two and includes the growth of rounding errors by the motion."
)
_SHIFT = 16
_DECAYS = 1e4  # with more e-foldings of the fastest decay in the span, stability would limit explicit steps
_SAMPLES = 9  # rows at which the decay is determined


@dataclass(frozen=True, slots=True)
class Reference:
    """Rows on the common time grid, k of them.

    Attributes
    ----------
    t : (k,) [s]; x : (k, n + p) coordinates and first-order states, v : (k, n), rounded to double
    errors : (k,) estimated error of the reference, scaled as in `scaled_error`
    how : description of the computation
    why : why it is not independent of the runs that are compared with it; "": it is
    """

    t: Vector
    x: Vector
    v: Vector
    errors: Vector
    how: str
    why: str = ""


@dataclass(frozen=True, slots=True)
class _Pair:
    """The schemes of the reference and of its check, and their description."""

    fine: Scheme
    rough: Scheme
    tolerance: float
    steps: str
    lower: int


def scaled_error(x: Vector | Extended, exact: Vector | Extended) -> Vector:
    """Return max_k |x_k - exact_k| / (1 + |exact_k|) for each row: (rows, n) -> (rows,). NaN stays NaN."""
    return np.asarray(np.max(np.abs(x - exact) / (1 + np.abs(exact)), axis=-1), dtype=np.float64)


class Run(Protocol):
    """A run of any kind: x, v (n, k) and states by name (k,)."""

    @property
    def x(self) -> Vector: ...

    @property
    def v(self) -> Vector: ...

    @property
    def states(self) -> Mapping[str, Vector]: ...


def rows_of(run: Run) -> Vector:
    """Return the rows (k, 2n + p) of (x, v, z) of a run."""
    return np.concatenate([run.x, run.v, *(z[None] for z in run.states.values())]).T


Rows = TypeVar("Rows", Vector, Extended)


def positions(rows: Rows, n: int) -> Rows:
    """Return the coordinates and states (k, n + p) of rows (k, 2n + p)."""
    return np.delete(rows, np.s_[n : 2 * n], axis=1)


def reference(equations: Lagrange, y: Vector, t_end: float, along: tuple[Vector, Vector] | None = None) -> Reference:
    """Integrate from y = (x, v, z), (2n + p,), at t = 0 over a grid of ROWS times that ends at t_end.

    Parameters
    ----------
    along
        Times (k,) and rows (k, 2n + p) of an approximate motion, to determine whether parts are strongly damped.

    Raises
    ------
    ModelError
        The integration in extended precision does not reach t_end; says where it ends.
    """
    times, rhs, n = np.linspace(0.0, t_end, ROWS), extended(equations), len(equations.x)
    try:
        with np.errstate(all="ignore"):
            pair = _pair(rhs, t_end, along or (times[:1], y[None]))
            fine = integrate_adaptive(pair.fine, rhs, y, times, pair.tolerance)
            other = integrate_adaptive(pair.rough, rhs, _shifted(y), times, 100 * pair.tolerance)
    except (NotReachedError, ZeroDivisionError, ValueError) as error:
        raise ModelError(f"there is no reference to compare with: {error}; shorten the span with --t-end") from error
    x, v = positions(fine, n).astype(np.float64), fine[:, n : 2 * n].astype(np.float64)
    how = _HOW.format(steps=pair.steps, digits=-np.log10(EPSILON), lower=pair.lower, shift=_SHIFT)
    return Reference(times, x, v, scaled_error(positions(other, n), positions(fine, n)), how)


def _pair(rhs: Rhs, t_end: float, along: tuple[Vector, Vector]) -> _Pair:
    rates = rates_of(rhs, *along)
    if -rates.real.min() * t_end < _DECAYS:
        rounding = EPSILON * max(50.0, 10.0 * np.abs(rates).max())  # in one period of a stiff spring
        finest = max(1e-17, float(rounding))
        return _Pair(Midpoint(8), Midpoint(6), finest, "Extrapolated midpoint steps of order 16", 12)
    steps = "As parts of the motion are strongly damped: implicit steps, Radau IIA collocation of order 13,"
    return _Pair(Collocation(7), Collocation(5), 1e-14, steps, 9)


def rates_of(rhs: Rhs, times: Vector, rows: Vector) -> NDArray[np.complex128]:
    """Return the eigenvalues [1/s] of the Jacobian (growth, decay, rotation) at a few of the rows."""
    samples = np.unique(np.linspace(0, len(times) - 1, _SAMPLES).astype(int))
    jacobians = [jacobian(rhs, np.longdouble(times[k]), rows[k].astype(np.longdouble)) for k in samples]
    return np.array([0.0, *(rate for J in jacobians if np.isfinite(J).all() for rate in np.linalg.eigvals(J))], complex)


def _shifted(y: Vector) -> Extended:
    """Return a start that differs by rounding errors with alternating signs."""
    signs = np.where(np.arange(len(y)) % 2, -1.0, 1.0)
    return np.asarray(y.astype(np.longdouble) + _SHIFT * EPSILON * signs * (1 + np.abs(y)))
