"""SUNDIALS' CVODE behind the interface of SciPy's solvers; needs the extra `stiff` (scikit-sundae)."""

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.interpolate import BarycentricInterpolator

from ..arguments.names import Vector
from ..codegen.model import ModelError
from .methods import IMPLICIT

ORDER = 5
"""Of BDF at the most: its interpolant within a step is a polynomial of that degree."""


def _cvode() -> Any:
    try:
        from sksundae.cvode import CVODE  # noqa: PLC0415  (an optional package)
    except ImportError as error:
        *others, last = (method.name for method in IMPLICIT.values() if not method.needs)
        raise ModelError(
            f"method CVODE needs SUNDIALS: pip install 'eigenmotion[{IMPLICIT['CVODE'].extra}]', "
            f"or use {', '.join(others)} or {last}"
        ) from error
    return CVODE


class Cvode:
    """Steps of CVODE (BDF, dense Newton) with the attributes of `scipy.integrate.OdeSolver` that are used here."""

    def __init__(
        self, fun: Callable[[float, Vector], Vector], t0: float, y0: Vector, t_bound: float, *,
        jac: Callable[[float, Vector], Vector], rtol: float, atol: Vector, first_step: float | None, max_step: float,
    ) -> None:  # fmt: skip
        def rhs(t: float, y: Vector, out: Vector) -> None:
            out[:] = fun(t, y)

        def jacobian(t: float, y: Vector, _: Vector, out: Vector) -> None:
            out[:, :] = jac(t, y)

        longest = 0.0 if np.isinf(max_step) else max_step
        self._solver = _cvode()(
            rhs, jacfn=jacobian, rtol=max(rtol, 1e-15), atol=atol, first_step=first_step or 0.0, max_step=longest
        )
        self._bound = t_bound
        self._solver.init_step(t0, y0)
        self.t, self.y, self.t_old, self.y_old = t0, np.array(y0, dtype=float), t0, np.array(y0, dtype=float)
        self.status = "running"
        self.nfev = self.njev = self.nlu = 0

    def step(self) -> str | None:
        """Take one step."""
        self.t_old, self.y_old = self.t, self.y
        result = self._solver.step(self._bound, method="onestep", tstop=self._bound)
        self.t, self.y = float(np.ravel(result.t)[-1]), np.array(np.atleast_2d(result.y)[-1])
        self.nfev, self.njev = int(result.nfev), int(result.njev)
        if not result.success:
            self.status = "failed"
            return str(result.message)
        if self.t == self._bound:
            self.status = "finished"
        return None

    def dense_output(self) -> Callable[[Any], Vector]:
        """Return the interpolant of the last step: CVODE's own polynomial, rebuilt from ORDER + 1 of its values."""
        nodes = 0.5 * (1.0 - np.cos(np.pi * np.arange(ORDER + 1) / ORDER))
        times = self.t_old + nodes * (self.t - self.t_old)
        inner = [np.atleast_2d(self._solver.step(float(t)).y)[-1] for t in times[1:-1]]
        self._solver.step(self.t)  # else the next step would begin by giving this one out again
        rows = np.array([self.y_old, *inner, self.y])
        polynomial = BarycentricInterpolator(times, rows, axis=0)
        return lambda t: np.asarray(polynomial(t)).T
