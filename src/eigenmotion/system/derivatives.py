"""Derivatives of right-hand sides by what users give."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.names import Vector, vector
from ..codegen.model.normalise import ModelError, real
from ..runtime import EvaluationError
from ..runtime.variations import motion_derivatives

if TYPE_CHECKING:
    from .system import System


def jacobian(
    self: "System",
    t: float,
    y: ArrayLike,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
) -> Vector:
    """Return d rhs / d y, (n_state, n_state), row i the derivatives of dy_i: `jac` of SciPy's implicit methods.

    By differences in compiled code that find their own steps: some 15 right-hand sides for each number of y.

    Raises
    ------
    EvaluationError
        As `rhs`.
    """
    t, y = real(t, "t"), vector(y, "y")
    try:
        return self.compiled.jacobian(t, y, self.prepare(parameters), self.signals(inputs, t))
    except (TypeError, ValueError, OverflowError) as error:
        raise ours(error) from error


def rhs_parameter_jacobian(
    self: "System",
    t: float,
    y: ArrayLike,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
) -> Vector:
    """Return d rhs / d parameters, (n_state, n_parameters), exact: for users of SciPy who integrate sensitivities.

    Raises
    ------
    ModelError
        The formulation carries eta in place of xdot: "lagrange" and "inverse" have this.
    EvaluationError
        As `rhs`.
    """
    c, n = self.compiled, self.n
    if c.formulation not in ("lagrange", "inverse"):
        raise ModelError(f"{c.name}: formulation {c.formulation!r} carries eta, which depends on parameters, too; "
                         "build with 'lagrange' or 'inverse', or ask simulate for sensitivities")  # fmt: skip
    t, y = real(t, "t"), vector(y, "y")
    if y.shape != (2 * n,):
        raise ModelError(f"y has shape {y.shape}, but this model needs {(2 * n,)}")
    _, _, da, _ = motion_derivatives(c, t, y[:n], y[n:], self.prepare(parameters), self.signals(inputs, t), False)
    first = 2 * n + c.n_inputs
    return np.vstack([np.zeros((n, len(c.parameters))), da[:, first : first + len(c.parameters)]])


def ours(error: Exception) -> Exception:
    """Return what the compiled functions raised, as an error of ours: they know none but their own."""
    return error if isinstance(error, EvaluationError | ModelError) else ModelError(str(error))
