"""Result of a fit to a measured motion."""

from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...results.solution import Solution
from ..identification.intervals import lines_of


@dataclass(frozen=True)
class MotionFit:
    """Parameters and initial values that fit a measured motion, and what is known of their errors; k unknowns.

    Attributes
    ----------
    names : (k) of the unknowns
    estimates : (k,)
    covariance : (k, k) of the estimates; NaN for unknowns on a bound, and for all without success
    deviations : (k,) standard deviations
    intervals : (k, 2) confidence intervals, by Student's t where noise is estimated
    level : confidence of the intervals
    values : name -> estimate, of all unknowns
    parameters, x0, v0 : for `simulate`: the fitted parameters by name, and the start
    noise : quantity -> standard deviation of its samples, from the residuals; also where `deviations` are given;
        NaN if the samples are too few to tell
    freedoms : samples less estimates
    residual : quantity -> (nt,) measured less fitted, in units of its standard deviation; NaN where one is missing
    held : initial values that are neither given nor unknown, and which are kept while the constraints move others
    on_bound : unknowns that their bounds keep from a better fit
    solution : the run with the values found, at the times of the samples
    runs : number of runs
    success, message : whether the fit converged, and how it ended

    Examples
    --------
    >>> import numpy as np
    >>> import eigenmotion as em
    >>> system, times = em.build("models/pendulum.py"), np.linspace(0.1, 2.0, 20)
    >>> measured = system.simulate((0, 2), x0=[0.8], parameters={"l": 1.2}, t_eval=times).x
    >>> noisy = measured + 0.01 * np.sin(40 * times**2)
    >>> fit = em.fit(system, {"l": 1.0, "theta": 0.7}, times, noisy)
    >>> print(fit)
    l = 1.19997 +- 0.002
    theta = 0.79877 +- 0.0024
    """

    names: tuple[str, ...]
    estimates: Vector
    covariance: Vector
    intervals: Vector
    level: float
    parameters: dict[str, float]
    x0: dict[str, float]
    v0: dict[str, float]
    noise: dict[str, float]
    freedoms: int
    residual: dict[str, Vector]
    held: tuple[str, ...]
    on_bound: tuple[str, ...]
    solution: Solution
    runs: int
    success: bool
    message: str

    @property
    def deviations(self) -> Vector:
        """(k,)."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    @property
    def values(self) -> dict[str, float]:
        """Name -> estimate."""
        return dict(zip(self.names, self.estimates.tolist(), strict=True))

    def __str__(self) -> str:
        lines = lines_of(self.names, self.estimates, self.deviations)
        if self.on_bound:
            lines.append(f"on a bound, without an error: {', '.join(self.on_bound)}")
        if self.held:
            lines.append(f"initial values kept: {', '.join(self.held)}")
        return "\n".join(lines if self.success else [self.message, *lines])
