"""Motions as functions of JAX: a primitive with its rules, so that every transformation of JAX applies.

The primitive has three kinds. "values" are runs; "push" is the derivative along directions, by sensitivities; "pull" is
its transpose, by the adjoint. All take arrays with any leading axes, which vmap adds: a batch is one call.
"""

from collections.abc import Mapping
from functools import partial
from threading import Lock
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir

from ...codegen.model.normalise import ModelError
from .motion_map import MotionMap, check_names

_TRANSPOSES = {"push": "pull", "pull": "push"}

_ALONE = Lock()
"""Held during a callback. XLA makes callbacks in several threads, which would wait 5 ms for each other's turn in
Python; a batch has threads of its own."""

motion_p = Primitive("eigenmotion")


def check_precision() -> None:
    """Raise ModelError if JAX computes in float32."""
    if jnp.result_type(float) != np.float64:
        raise ModelError(
            "to_jax: JAX computes in float32, in which a motion has no accurate derivatives. Ask for float64 first: "
            'jax.config.update("jax_enable_x64", True)'
        )


def motion_of(motion: MotionMap, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return arrays of a motion at values by name."""
    check_precision()
    given = check_names("to_jax", motion, values)
    point = jnp.stack([_scalar(name, given[name]) for name in motion.names])
    return motion.arranged(motion_p.bind(point, motion=motion, kind="values"))


def _scalar(name: str, value: Any) -> Any:
    number = jnp.asarray(float(value) if type(value) is int else value)
    if number.shape != () or number.dtype != np.float64:
        raise ModelError(
            f"to_jax: the value of {name!r} is {number.dtype}{list(number.shape)}; give a float64 number, and many by "
            "jax.vmap"
        )
    return number


def _shape(arrays: tuple[Any, ...], motion: MotionMap, kind: str) -> tuple[int, ...]:
    return (*np.broadcast_shapes(*(one.shape[:-1] for one in arrays)), motion.length(kind))


def _call(*arrays: Any, motion: MotionMap, kind: str) -> Any:
    return jnp.asarray(motion.product(kind, *arrays))


def _abstract(*arrays: Any, motion: MotionMap, kind: str) -> Any:
    return jax.core.ShapedArray(_shape(arrays, motion, kind), np.dtype(np.float64))


def _on_host(*arrays: Any, motion: MotionMap, kind: str) -> Any:
    result = jax.ShapeDtypeStruct(_shape(arrays, motion, kind), np.dtype(np.float64))
    return jax.pure_callback(partial(_alone, motion, kind), result, *arrays)


def _alone(motion: MotionMap, kind: str, *arrays: Any) -> Any:
    """Return a product; callbacks wait for each other."""
    with _ALONE:
        return motion.product(kind, *arrays)


def _batched(arrays: tuple[Any, ...], axes: tuple[int | None, ...], **which: Any) -> tuple[Any, int]:
    """Return the result for arrays with one more leading axis; values that are shared keep length 1 there."""
    count = next(one.shape[axis] for one, axis in zip(arrays, axes, strict=True) if axis is not None)
    pairs = zip(arrays, axes, strict=True)
    values, *vectors = (one[None] if axis is None else jnp.moveaxis(one, axis, 0) for one, axis in pairs)
    whole = [jnp.broadcast_to(one, (count, *one.shape[1:])) for one in vectors]  # so that transposes add nothing up
    return motion_p.bind(values, *whole, **which), 0


def _derivative(arrays: tuple[Any, ...], tangents: tuple[Any, ...], *, motion: MotionMap, kind: str) -> Any:
    result = motion_p.bind(*arrays, motion=motion, kind=kind)
    if kind == "values":
        return result, motion_p.bind(arrays[0], ad.instantiate_zeros(tangents[0]), motion=motion, kind="push")
    if type(tangents[0]) is not ad.Zero:
        raise ModelError(f"to_jax: {motion.system.name}: a motion has first derivatives only; "
                         f"this asks for a second one by {', '.join(motion.names)}")  # fmt: skip
    return result, motion_p.bind(arrays[0], ad.instantiate_zeros(tangents[1]), motion=motion, kind=kind)


def _transposed(cotangent: Any, values: Any, vector: Any, *, motion: MotionMap, kind: str) -> tuple[None, Any]:
    if type(cotangent) is ad.Zero:
        return None, ad.Zero(vector.aval)
    return None, motion_p.bind(values, cotangent, motion=motion, kind=_TRANSPOSES[kind])


motion_p.def_impl(_call)
motion_p.def_abstract_eval(_abstract)
mlir.register_lowering(motion_p, mlir.lower_fun(_on_host, multiple_results=False))
batching.primitive_batchers[motion_p] = _batched
ad.primitive_jvps[motion_p] = _derivative
ad.primitive_transposes[motion_p] = _transposed
