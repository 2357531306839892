"""Symmetry of a cycle: where the motion is after a period, as a function of where it starts."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arguments.named_values import Vector, by_name
from ...codegen.model.normalise import ModelError, shown
from ...runtime import CompiledModel, Prepared


@dataclass(frozen=True)
class Symmetry:
    """The map q -> G q + h of states q (2 n,) of compiled functions that a cycle closes up to.

    stated : whether the user stated one; names : of parameters that it depends on
    """

    G: Vector
    h: Vector
    stated: bool
    names: frozenset[str] = frozenset()

    def __call__(self, q: Vector) -> Vector:
        return np.asarray(self.G @ q + self.h, dtype=np.float64)

    def back(self, end: Vector, start: Vector, advancing: tuple[int, ...]) -> Vector:
        """Return the state before the symmetry, with coordinates that advance freely as at the start."""
        q = np.asarray(np.linalg.solve(self.G, end - self.h), dtype=np.float64)
        q[list(advancing)] = start[list(advancing)]
        return q

    def undone(self, matrix: Vector) -> Vector:
        """Return G^-1 matrix."""
        undone = np.asarray(np.linalg.solve(self.G, matrix), dtype=np.float64)
        return undone if self.stated else matrix


def symmetry_of(c: CompiledModel, prepared: Prepared, argument: Any) -> Symmetry:
    """Return the symmetry that users state: coordinate or state -> its value after a period, as an expression.

    Raises
    ------
    ModelError
        A name is unknown, or the map is not linear with constant coefficients, or cannot be inverted.
    """
    n, every = c.n_coordinates, c.n
    if argument is None:
        return Symmetry(np.eye(2 * every), np.zeros(2 * every), False)
    if not isinstance(argument, Mapping):
        raise ModelError(f'{c.name}: symmetry is {shown(argument)}. Give a mapping, such as {{"x": "x + L"}}.')
    linear, offset = np.eye(every), np.zeros(every)
    for name, value in by_name(argument, c.coordinates, "coordinate in symmetry").items():
        k = c.coordinates.index(name)
        linear[k], offset[k] = _linear(c, prepared, name, value)
    if np.linalg.matrix_rank(linear) < every:
        raise ModelError(f"{c.name}: symmetry cannot be inverted. State the images of all that it exchanges.")
    G, h = np.zeros((2 * every, 2 * every)), np.zeros(2 * every)
    G[:every, :every], G[every:, every:] = linear, linear
    h[:n], h[every + n :] = offset[:n], offset[n:]
    words = re.findall(r"\w+", " ".join(map(str, argument.values())))
    return Symmetry(G, h, True, frozenset(words) & set(c.parameters))


def _linear(c: CompiledModel, prepared: Prepared, name: str, value: Any) -> tuple[Vector, float]:
    """Return the coefficients (n,) and the constant of the image of one coordinate."""
    import sympy  # noqa: PLC0415, not needed without a symmetry

    own = {one: sympy.Dummy(one) for one in c.coordinates}
    given = dict(zip(c.parameters, map(sympy.Float, prepared.parameters), strict=True))
    try:
        image = sympy.sympify(str(value).replace("(t)", ""), locals=given | own)
        row = [sympy.diff(image, one) for one in own.values()]
        constant = image.subs(dict.fromkeys(own.values(), 0))
        return np.array([float(one) for one in row]), float(constant)
    except (sympy.SympifyError, TypeError, AttributeError, SyntaxError) as error:
        raise ModelError(
            f"{c.name}: symmetry of {name!r} is {shown(value)}. Give a sum of coordinates with constant factors, "
            f"numbers and parameters, such as '{name} + 2*pi'"
        ) from error
