"""Motions as functions of JAX: `to_jax`."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import Any

from numpy.typing import ArrayLike

from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from .motion_map import motion_map


def to_jax(
    system: CompiledSystem,
    t_span: tuple[float, float],
    t_eval: ArrayLike,
    *,
    by: Sequence[Any],
    of: Sequence[str] = ("x", "outputs"),
    memory: float = 256.0,
    **options: Any,
) -> Callable[[Mapping[str, Any]], dict[str, Any]]:
    """Return a motion as a function of JAX, for jit, grad, jacfwd, jacrev, vmap and scan.

    Gradients are those of `vjp`, by the adjoint; derivatives forwards are the `sensitivities` of `simulate`. Under vmap
    the motions are one ensemble, and their gradients are computed in threads.

    Parameters
    ----------
    t_eval
        (nt,) the times of the rows.
    by
        Names of parameters ("K1"), constant inputs, initial positions ("theta1"), rates ("theta1'"), states or
        quasi-velocities, as for `sensitivities`.
    of
        Parts of the motion: some of "x", "v", "states", "outputs".
    memory
        [MB] bound on what is kept of the derivative of one motion, as for `vjp`.
    **options
        As for `simulate_ensemble`: x0, v0, parameters, inputs, method, rtol, atol, first_step, max_step, max_steps,
        stabilisation, dependent_constraints.

    Returns
    -------
    function
        f(values): a mapping name -> float64 number, of all names in `by`, to a dict part -> array: x, v (n, nt), states
        and outputs name -> (nt,). It has first derivatives.

    Raises
    ------
    ModelError
        An unknown name, part or option; JAX is not installed, or computes in float32. By the function: a motion fails,
        or a terminal event ends it before its last row (its reason, and under vmap which motion); a value that is not
        float64; a second derivative. In compiled functions, JAX raises an error with that message.

    Examples
    --------
    >>> import jax
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> jax.config.update("jax_enable_x64", True)
    >>> swing = em.to_jax(em.build(model), (0.0, 1.0), [1.0], by=["theta", "l"], x0={"theta": 1.0}, rtol=1e-9)
    >>> gradient = jax.grad(lambda values: swing(values)["x"][0, 0] ** 2)({"theta": 1.0, "l": 1.0})
    >>> {name: round(float(value), 6) for name, value in gradient.items()}
    {'l': -0.560406, 'theta': 1.776532}
    """
    functions = _jax()
    functions.check_precision()
    return partial(functions.motion_of, motion_map("to_jax", system, t_span, t_eval, by, of, memory, options))


def _jax() -> ModuleType:
    """Return the module that needs JAX.

    Raises
    ------
    ModelError
        It is not installed.
    """
    try:
        return import_module(f"{__package__}.jax_functions")
    except ImportError as error:
        raise ModelError("to_jax needs JAX: pip install 'eigenmotion[jax]'") from error
