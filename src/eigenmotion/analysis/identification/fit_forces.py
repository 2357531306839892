"""Parameters from measured forces, by linear least squares."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from .given_motion import Given, given_motion
from .identifiable import Identifiable, base_of
from .intervals import intervals_of, level_of, lines_of
from .measured_forces import Along, measured_forces
from .regressor import chosen_of, regressor_of


@dataclass(frozen=True)
class Fit:
    """Base parameters from forces, and what is known of their errors.

    Attributes
    ----------
    identifiable : the combinations of parameters that the motion tells apart
    estimates : (rank,) values of these combinations
    covariance : (rank, rank) of the estimates, from the residuals
    deviations : (rank,) standard deviations
    intervals : (rank, 2) confidence intervals of each, by Student's t
    level : confidence of the intervals
    parameters : name -> value: those of `identifiable.base` fitted while all others keep the values given (`kept`)
    kept : names of parameters that the motion does not tell, alone or from others, and which keep their values
    noise : standard deviation of a force of weight 1, from the residuals
    freedoms : of the estimate of the noise: measured forces less estimates
    residual : (rows,) measured less fitted forces along the motions that the constraints allow, in units of `noise`

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/pendulum.py")
    >>> fit = em.fit_forces(system, ["m"], ([[0, 1, 2]], [[0, 0, 0]], [[1, 2, 3]]), [[1.1, 10.2, 12.0]])
    >>> print(fit)
    m = 1.00197 +- 0.0061
    """

    identifiable: Identifiable
    estimates: Vector
    covariance: Vector
    intervals: Vector
    level: float
    parameters: dict[str, float]
    kept: tuple[str, ...]
    noise: float
    freedoms: float
    residual: Vector

    @property
    def deviations(self) -> Vector:
        """(rank,)."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    def __str__(self) -> str:
        lines = lines_of(self.identifiable.texts, self.estimates, self.deviations)
        if self.kept:
            lines.append(f"not told by this motion, kept as given: {', '.join(self.kept)}")
        return "\n".join(lines)


def fit_forces(
    system: CompiledSystem,
    parameters: Iterable[Any],
    motion: Given,
    forces: Mapping[Any, Any] | ArrayLike,
    *,
    actuators: Iterable[Any] | None = None,
    weights: Mapping[Any, float] | ArrayLike | None = None,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
    values: Any = None,
    level: float = 0.95,
    tolerance: float = 1e-8,
) -> Fit:
    """Return parameters from measured forces of actuators along a motion, by linear least squares.

    Reactions are eliminated: with N the motions that the constraints allow, N^T Y p = N^T (B forces - rest). Errors are
    those of independent forces of equal variance, or of a variance proportional to 1 / weight; x, v and a are exact.

    Parameters
    ----------
    parameters, motion, inputs, values, tolerance
        As for `identifiable`.
    forces
        (actuators, states), or a mapping actuator -> (states,).
    actuators
        Names of coordinates and of inputs, as for `System.inverse_dynamics`; None: all coordinates. No other force
        acts, so that along motions that no actuator drives the forces are known to be zero. Such a row counts as much
        as an average measured one, and adds nothing to the noise.
    weights
        Of the squared error of each actuator's force, (actuators,) or a mapping; None: 1.
    level
        Confidence of the intervals.

    Raises
    ------
    ModelError
        As `identifiable`; forces have another shape, or are fewer than the base parameters; a weight is not positive.

    Examples
    --------
    The density of the bars of a four-bar from the torque of its crank:

    >>> import numpy as np
    >>> import eigenmotion as em
    >>> system = em.build("models/four_bar.py")
    >>> run = system.simulate((0, 2), t_eval=np.linspace(0, 2, 50))
    >>> a = np.array([system.acceleration(x, v)[0] for x, v in zip(run.x.T, run.v.T)]).T
    >>> motion = run.x, 1.5 * run.v, 2.25 * a  # the same path, faster
    >>> torque = system.inverse_dynamics(*motion, actuators=["q1"], parameters={"density": 1.3}).forces
    >>> fit = em.fit_forces(system, ["density"], motion, torque, actuators=["q1"])
    >>> round(fit.parameters["density"], 6)
    1.3
    """
    c, names = system.compiled, chosen_of(system.compiled, parameters)
    rows = given_motion(system, motion, inputs, values)
    measured = measured_forces(c, len(rows.t), forces, actuators, weights)
    confidence = level_of(level)
    rows = replace(rows, u=measured.as_inputs(rows.u), many=True)
    found = regressor_of(rows, names)
    W, rest = found.free
    along = measured.along(rows, found.freedoms)
    base = base_of(c.name, names, W, found.values, tolerance)
    return _solved(c.name, base, found.values, W, along.forces - rest, along, confidence)


def _solved(
    model: str, base: Identifiable, given: Vector, W: Vector, forces: Vector, measured: Along, level: float
) -> Fit:
    """Return the fit of W combinations^+ beta = forces, in rows of which each has the variance 1 or 0."""
    chosen = [base.parameters.index(name) for name in base.base]
    W, forces, noisy = measured.whitened(W[:, chosen]), measured.whitened(forces), measured.noisy
    length = np.linalg.norm(W, axis=0)
    Q, R = np.linalg.qr(W / length)
    beta = scipy.linalg.solve_triangular(R, Q.T @ forces) / length
    gain = scipy.linalg.solve_triangular(R, Q.T) / length[:, None]
    freedoms = float((noisy * (1.0 - (Q**2).sum(axis=1))).sum())
    if freedoms < 0.5:
        raise ModelError(f"{model}: {int(noisy.sum())} forces do not tell the errors of {base.rank} base parameters. "
                         "Give more states.")  # fmt: skip
    residual = forces - W @ beta
    variance = float(residual @ residual) / freedoms
    covariance = variance * (gain * noisy) @ gain.T
    others = np.array([0.0 if name in base.base else value for name, value in zip(base.parameters, given, strict=True)])
    own = dict(zip(base.base, beta - base.combinations @ others, strict=True))
    fitted = {name: float(own.get(name, value)) for name, value in zip(base.parameters, given, strict=True)}
    kept = tuple(name for name in base.parameters if name not in base.base)
    noise = float(np.sqrt(variance))
    return Fit(base, beta, covariance, intervals_of(beta, covariance, freedoms, level), level, fitted, kept, noise,
               freedoms, residual / noise if noise else residual)  # fmt: skip
