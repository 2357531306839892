"""Motions as functions of PyTorch: `to_torch`."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import Any

from numpy.typing import ArrayLike

from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from .motion_map import motion_map


def to_torch(
    system: CompiledSystem,
    t_span: tuple[float, float],
    t_eval: ArrayLike,
    *,
    by: Sequence[Any],
    of: Sequence[str] = ("x", "outputs"),
    memory: float = 256.0,
    **options: Any,
) -> Callable[[Mapping[str, Any]], dict[str, Any]]:
    """Return a motion as a function of PyTorch, for `backward` and the transformations of `torch.func`.

    Gradients are those of `vjp`, by the adjoint; derivatives forwards are the `sensitivities` of `simulate`. Under vmap
    the motions are one ensemble, and their gradients are computed in threads.

    Parameters
    ----------
    t_eval, by, of, memory, **options
        As for `to_jax`.

    Returns
    -------
    function
        f(values): a mapping name -> float64 tensor () or number, of all names in `by`, to a dict part -> tensor: x, v
        (n, nt), states and outputs name -> (nt,). It has first derivatives.

    Raises
    ------
    ModelError
        An unknown name, part or option; PyTorch is not installed. By the function: a motion fails, or a terminal event
        ends it before its last row (its reason, and under vmap which motion); a value that is not float64; a second
        derivative.

    Examples
    --------
    >>> import torch
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> swing = em.to_torch(em.build(model), (0.0, 1.0), [1.0], by=["theta", "l"], rtol=1e-9)
    >>> values = {name: torch.tensor(1.0, dtype=torch.float64, requires_grad=True) for name in ("theta", "l")}
    >>> (swing(values)["x"][0, 0] ** 2).backward()
    >>> {name: round(value.grad.item(), 6) for name, value in values.items()}
    {'theta': 1.776532, 'l': -0.560406}
    """
    functions = _torch()
    return partial(functions.motion_of, motion_map("to_torch", system, t_span, t_eval, by, of, memory, options))


def _torch() -> ModuleType:
    """Return the module that needs PyTorch.

    Raises
    ------
    ModelError
        It is not installed.
    """
    try:
        return import_module(f"{__package__}.torch_functions")
    except ImportError as error:
        raise ModelError("to_torch needs PyTorch: pip install 'eigenmotion[torch]'") from error
