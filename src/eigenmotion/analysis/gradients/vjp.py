"""Vector-Jacobian product of a run: the gradient of any function of a motion, by the adjoint."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector, unknown
from ...arguments.states import names_of_states
from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from ...results.solution import Solution
from ...simulation.derivable_run import DerivableRun, derivable_run
from ..state.operating_point import OperatingPoint
from ..state.output_derivatives import output_derivatives


@dataclass(frozen=True, slots=True, eq=False)
class Pullback:
    """Function from cotangents of the rows of a run to gradients, which `vjp` returns.

    It is pickled as what it was asked for: where it is unpickled, the run is made again, with the same bits if the
    model is compiled alike there. Copies are the same object.
    """

    _run: DerivableRun

    def __call__(
        self,
        dx: ArrayLike | None = None,
        dv: ArrayLike | None = None,
        states: Mapping[str, ArrayLike] | None = None,
        outputs: Mapping[str, ArrayLike] | None = None,
    ) -> dict[str, float]:
        """Return name -> gradient; see `vjp`."""
        gradient = pulled(self._run, dx, dv, states, outputs)
        return dict(zip(self._run.adjoint.varied.names, gradient.tolist(), strict=True))

    def __copy__(self) -> "Pullback":
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> "Pullback":
        return self


def vjp(
    system: CompiledSystem,
    t_span: tuple[float, float],
    *,
    by: Sequence[Any],
    t_eval: ArrayLike | None = None,
    memory: float = 256.0,
    **options: Any,
) -> tuple[Solution, Pullback]:
    """Simulate, and return a function that maps cotangents of the motion to gradients.

    The gradient is the adjoint of the derivatives that `simulate(sensitivities=...)` gives, through constraints,
    events, impacts and friction. Its time hardly depends on the number of names.

    Parameters
    ----------
    by
        Names of parameters ("K1"), constant inputs, initial positions ("theta1"), rates ("theta1'"), states or
        quasi-velocities, as for `sensitivities`.
    t_eval, **options
        As for `simulate`, but `dense_output`, `estimate_error` and `sensitivities`.
    memory
        [MB] bound on what is kept of the derivative. A run that needs more is made in parts, whose states are kept;
        each part is run again, with the same bits, when a gradient is asked for.

    Returns
    -------
    solution : Solution
        The motion.
    pullback : Pullback
        `pullback(dx=None, dv=None, states=None, outputs=None)` returns name -> derivative of a number L, given dL/dx
        and dL/dv (n, k) at the rows of the solution, and the derivatives by its states and outputs (name -> (k,)). It
        can be called again. A constrained start moves along the constraints. It pickles: other
        processes make the run again.

    Raises
    ------
    ModelError
        As `simulate` with `sensitivities`; or the run failed, with its reason.
    EvaluationError
        By the pullback: an independent check of the gradient failed.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> given = {"x0": {"theta": 1.0}, "t_eval": [1.0], "rtol": 1e-9}
    >>> sol, pullback = em.vjp(em.build(model), (0.0, 1.0), by=["theta", "l"], **given)
    >>> gradient = pullback(dx=2.0 * sol.x)  # of L = theta(1)^2
    >>> {name: round(value, 6) for name, value in gradient.items()}
    {'theta': 1.776532, 'l': -0.560406}
    """
    run = derivable_run("vjp", system, t_span, by, memory, t_eval=t_eval, **options)
    return run.solution, Pullback(run)


def pulled(
    run: DerivableRun,
    dx: ArrayLike | None = None,
    dv: ArrayLike | None = None,
    states: Mapping[str, ArrayLike] | None = None,
    outputs: Mapping[str, ArrayLike] | None = None,
) -> Vector:
    """Return the gradient (names,) for cotangents of the rows of a run, as the pullback of `vjp` takes them."""
    rows = _cotangents(run, dx, dv, states)
    if not outputs:
        return run.adjoint.pull(rows)
    added, forcing = _through_outputs(run, outputs)
    return np.asarray(run.adjoint.pull(rows + added) + forcing @ run.adjoint.varied.P)


def _cotangents(
    run: DerivableRun, dx: ArrayLike | None, dv: ArrayLike | None, states: Mapping[str, ArrayLike] | None
) -> Vector:
    """Return cotangents (k, 2 n) of x, v of compiled functions, whose states are the last of v."""
    c, count = run.task.model, len(run.solution.t)
    n, W = c.n_coordinates, np.zeros((len(run.solution.t), 2 * c.n))
    for name, given, first in (("dx", dx, 0), ("dv", dv, c.n)):
        if given is not None:
            W[:, first : first + n] = _array(c.name, name, given, (n, count)).T
    for name, values in _named(c.name, "states", states, names_of_states(c)).items():
        W[:, c.n + n + names_of_states(c).index(name)] = _array(c.name, f"states[{name!r}]", values, (count,))
    return W


def _array(model: str, name: str, given: ArrayLike, shape: tuple[int, ...]) -> Vector:
    array = np.asarray(given, dtype=float)
    if array.shape != shape:
        raise ModelError(f"{model}: {name} has shape {array.shape}; the rows of the solution ask for {shape}")
    if not np.isfinite(array).all():
        raise ModelError(f"{model}: {name} is not finite")
    return array


def _named(model: str, argument: str, given: Any, known: Sequence[str]) -> Mapping[str, Any]:
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise ModelError(f"{model}: {argument} is a mapping name -> derivatives at the rows; known: {', '.join(known)}")
    if wrong := set(given) - set(known):
        raise ModelError(f"{model}: {unknown(f'name in {argument}', wrong, known)}")
    return given


def _through_outputs(run: DerivableRun, outputs: Mapping[str, ArrayLike]) -> tuple[Vector, Vector]:
    """Return cotangents (k, 2 n) of x, v that outputs add, and the direct derivative (n_forcing,)."""
    c, along = run.task.model, run.solution.trajectory
    if along is None:
        raise RuntimeError("a run of this process has its rows")
    count = len(run.solution.t)
    weight = np.zeros((count, len(c.outputs)))
    for name, values in _named(c.name, "outputs", outputs, c.outputs).items():
        weight[:, c.outputs.index(name)] = _array(c.name, f"outputs[{name!r}]", values, (count,))
    D = np.zeros((count, c.n_arguments))
    for rows, prepared in along.modes:
        for k in range(*rows.indices(count)):
            if weight[k].any():
                at = OperatingPoint(c, prepared, float(along.t[k]), along.x[k], along.v[k], along.u[k])
                D[k] = weight[k] @ output_derivatives(at)
    return D[:, : 2 * c.n], D[:, 2 * c.n :].sum(axis=0)
