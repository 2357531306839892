"""Places of the bodies of a compiled model, and Jacobians of their points."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.named_values import Vector, unknown, vector
from ..codegen.model.normalise import ModelError
from ..runtime import CompiledModel


def names_of_bodies(c: CompiledModel) -> tuple[str, ...]:
    """Return the names of the bodies, without parts of joints made of several."""
    return tuple(name for name in c.bodies if name)


def number_of_body(c: CompiledModel, body: Any) -> int:
    """Return the number of a body, given by its name or as a `Body` of a `Tree`.

    Raises
    ------
    ModelError
        There is none of this name, or there are two.
    """
    name = getattr(body, "name", body)
    if not c.bodies:
        raise ModelError(
            f"{c.name} has no bodies: its energies are expressions. State its bodies by eigenmotion.Tree, or read them "
            "from a file by load_urdf or load_mjcf; places of points may be outputs."
        )
    found = [number for number, one in enumerate(c.bodies) if one and one == name]
    if not found:
        raise ModelError(f"{c.name}: {unknown('body', [str(name)], names_of_bodies(c))}")
    if len(found) > 1:
        raise ModelError(f"{c.name}: two trees have a body {name!r}. Rename one of them.")
    return found[0]


def many_positions(c: CompiledModel, x: Any) -> Vector | None:
    """Return rows (k, n + p) of an array x (n, k), or None if it is one position."""
    if not isinstance(x, Sequence | np.ndarray) or np.ndim(x) != 2:
        return None
    values, n = vector(x, "x"), c.n_coordinates
    if values.shape[0] != n:
        raise ModelError(f"x has shape {values.shape}. Give (n, k) with n = {n}: {', '.join(c.coordinates[:n])}.")
    return np.ascontiguousarray(np.pad(values.T, ((0, 0), (0, c.n_states))))


def point_of(point: ArrayLike) -> Vector:
    """Return a point (3,)."""
    values = vector(point, "point")
    if values.shape != (3,) or not np.isfinite(values).all():
        raise ModelError(f"point is {point!r}. Give three finite numbers, in the body's frame.")
    return values


def last_axis(rows: Vector, many: bool) -> Vector:
    """Return rows (k, ...) as (..., k); the only row, if one position was given."""
    return np.moveaxis(rows, 0, -1) if many else rows[0]
