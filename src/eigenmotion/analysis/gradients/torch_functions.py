"""Motions as functions of PyTorch: an autograd function for each kind of product, so that its transformations apply.

"values" are runs; "push" is the derivative along directions, by sensitivities; "pull" is its transpose, by the adjoint.
All take arrays with any leading axes, which vmap adds: a batch is one call.
"""

from collections.abc import Mapping
from typing import Any

import torch

from ...codegen.model.normalise import ModelError
from .motion_map import MotionMap, check_names


def motion_of(motion: MotionMap, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return tensors of a motion at values by name."""
    given = check_names("to_torch", motion, values)
    point = torch.stack([_scalar(name, given[name]) for name in motion.names])
    return motion.arranged(_Values.apply(point, motion))


def _scalar(name: str, value: Any) -> Any:
    number = value if isinstance(value, torch.Tensor) else torch.tensor(float(value), dtype=torch.float64)
    if number.shape != () or number.dtype != torch.float64:
        raise ModelError(
            f"to_torch: the value of {name!r} is {number.dtype}{list(number.shape)}; give a torch.float64 number "
            "(dtype=torch.float64), and many by torch.func.vmap"
        )
    return number


def _product(motion: MotionMap, kind: str, *tensors: Any) -> Any:
    found = motion.product(kind, *(one.detach().cpu().numpy() for one in tensors))
    return torch.from_numpy(found).to(tensors[0].device)


def _leading(info: Any, axes: tuple[int | None, ...], tensors: tuple[Any, ...]) -> list[Any]:
    """Return tensors with one more leading axis; values that are shared keep length 1 there."""
    pairs = zip(tensors, axes, strict=True)
    values, *vectors = (one[None] if axis is None else one.movedim(axis, 0) for one, axis in pairs)
    return [values, *(one.expand(info.batch_size, *one.shape[1:]) for one in vectors)]


class _Values(torch.autograd.Function):  # type: ignore[misc]
    """Rows (..., size) at values (..., names)."""

    @staticmethod
    def forward(values: Any, motion: MotionMap) -> Any:
        return _product(motion, "values", values)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:  # noqa: ARG004, the interface of PyTorch
        ctx.save_for_backward(inputs[0])
        ctx.save_for_forward(inputs[0])
        ctx.motion = inputs[1]

    @staticmethod
    def backward(ctx: Any, cotangent: Any) -> tuple[Any, None]:
        return _Linear.apply(ctx.saved_tensors[0], cotangent, ctx.motion, "pull"), None

    @staticmethod
    def jvp(ctx: Any, tangent: Any, _: None) -> Any:
        return _Linear.apply(ctx.saved_tensors[0], tangent, ctx.motion, "push")

    @staticmethod
    def vmap(info: Any, axes: tuple[Any, ...], values: Any, motion: MotionMap) -> tuple[Any, int]:
        return _Values.apply(*_leading(info, axes[:1], (values,)), motion), 0


class _Linear(torch.autograd.Function):  # type: ignore[misc]
    """Product of the derivative, or of its transpose, at values (..., names) with vectors."""

    @staticmethod
    def forward(values: Any, vector: Any, motion: MotionMap, kind: str) -> Any:
        return _product(motion, kind, values, vector)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:  # noqa: ARG004, the interface of PyTorch
        ctx.motion = inputs[2]

    @staticmethod
    def backward(ctx: Any, _: Any) -> Any:
        raise _only_first(ctx.motion)

    @staticmethod
    def jvp(ctx: Any, *_: Any) -> Any:
        raise _only_first(ctx.motion)

    @staticmethod
    def vmap(
        info: Any, axes: tuple[Any, ...], values: Any, vector: Any, motion: MotionMap, kind: str
    ) -> tuple[Any, int]:
        return _Linear.apply(*_leading(info, axes[:2], (values, vector)), motion, kind), 0


def _only_first(motion: MotionMap) -> ModelError:
    return ModelError(f"to_torch: {motion.system.name}: a motion has first derivatives only; "
                      f"this asks for a second one by {', '.join(motion.names)}")  # fmt: skip
