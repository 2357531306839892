"""Derivatives of right-hand sides by what users give."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.named_values import Vector, vector
from ..arguments.options import SHARED_FROM_START
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

    Exact to rounding, in every formulation; where the right-hand side has a kink, that of one of its sides. What
    carries eta in place of xdot is compiled once more, for that, at the first call, and kept in the cache.

    Raises
    ------
    EvaluationError
        As `rhs`.
    BuildError
        There is no compiler for what is to be compiled, or it refused.
    ModelError
        This model carries eta, and its module was not made by `build`, which keeps what it is compiled from.
    """
    c = self.compiled
    if c.formulation in ("eigenfactor", "cholesky") and c.later is None and not c.differentiates:
        raise ModelError(f"{c.name}: the Jacobian of formulation {c.formulation!r} is compiled from its sources, which "
                         "only systems of eigenmotion.build know; or build with 'lagrange'")  # fmt: skip
    t, y = real(t, "t"), vector(y, "y")
    try:
        return c.jacobian(t, y, self.prepare(parameters), self.signals(inputs, t))
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
    _, _, da, _ = motion_derivatives(
        c, t, y[:n], y[n:], self.prepare(parameters), self.signals(inputs, t), SHARED_FROM_START
    )
    first = 2 * n + c.n_inputs
    return np.vstack([np.zeros((n, len(c.parameters))), da[:, first : first + len(c.parameters)]])


def ours(error: Exception) -> Exception:
    """Return what the compiled functions raised, as an error of ours: they know none but their own."""
    return error if isinstance(error, EvaluationError | ModelError) else ModelError(str(error))
