"""Identifiable combinations of parameters: those that the forces along a motion tell apart."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError, number
from ...compiled.compiled_system import CompiledSystem
from .given_motion import Given, given_motion
from .regressor import chosen_of, regressor_of

_NOTHING = 1e-12
"""A column of the regressor, relative to the longest, that counts as zero."""
_NONE = 1e-9
"""A coefficient of columns of length 1 that counts as zero."""


@dataclass(frozen=True)
class Identifiable:
    """Base parameters of a motion: combinations that its forces tell apart (Gautier and Khalil 1990).

    Attributes
    ----------
    parameters : (k) names
    rank : their number
    base : (rank) names, a parameter for each combination
    combinations : (rank, k): combinations @ p is what forces tell; 1 for the parameter in `base`
    condition : of the regressor's columns of `base`, each of length 1: how much worse the least certain one is known
    singular_values : (k,) of the regressor with columns of length 1, the largest first
    unseen : names on which no force depends

    Examples
    --------
    Of a cart that drags another mass along, the sum:

    >>> import eigenmotion as em
    >>> from sympy import symbols
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> (x,), (M, m, d) = dynamicsymbols("x:1"), symbols("M m d")
    >>> model = em.Model(name="carts", coordinates=[x], kinetic_energy=(M + m) * x.diff() ** 2 / 2,
    ...                  forces={x: -d * x.diff()}, parameters={M: 2.0, m: 1.0, d: 0.5})
    >>> print(em.identifiable(em.build(model), ["M", "m", "d"], ([[0, 0, 0]], [[1, 2, 3]], [[1, 1, -1]])))
    2 of 3 are identifiable, condition 1:
      M + m
      d
    """

    parameters: tuple[str, ...]
    rank: int
    base: tuple[str, ...]
    combinations: Vector
    condition: float
    singular_values: Vector
    unseen: tuple[str, ...]

    @property
    def texts(self) -> tuple[str, ...]:
        """(rank) the combinations as text."""
        return tuple(_text(self.parameters, row, name) for row, name in zip(self.combinations, self.base, strict=True))

    @property
    def dependent(self) -> tuple[str, ...]:
        """Names that forces know in combinations alone, besides `base`."""
        return tuple(name for name in self.parameters if name not in (*self.base, *self.unseen))

    def __str__(self) -> str:
        lines = [
            f"{self.rank} of {len(self.parameters)} are identifiable, condition {self.condition:.3g}:",
            *self.texts,
        ]
        return "\n  ".join(lines) + (f"\nno force depends on {', '.join(self.unseen)}" if self.unseen else "")


def identifiable(
    system: CompiledSystem,
    parameters: Iterable[Any],
    motion: Given,
    *,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
    values: Any = None,
    tolerance: float = 1e-8,
) -> Identifiable:
    """Return which combinations of parameters the forces along a motion tell apart.

    The rank is that of the regressor of all states, with columns of length 1, along the motions that the constraints
    allow, so that no reaction is in it. QR decomposition with column pivoting chooses the base parameters.

    Parameters
    ----------
    parameters
        Names of parameters in which forces are linear, as for `System.regressor`.
    motion
        A Solution, or arrays (x, v, a) or (x, v, a, t) as for `System.inverse_dynamics`, of many states.
    inputs, values
        As for `System.regressor`; a Solution has its own.
    tolerance
        A singular value, relative to the largest, that counts as zero. With noise in x, v and a, all that is below the
        noise is not known: give its relative size.

    Raises
    ------
    ModelError
        As `System.regressor`; constraints depend on parameters, or friction on reactions; no force depends on any.

    Examples
    --------
    >>> import numpy as np
    >>> import eigenmotion as em
    >>> from sympy import symbols
    >>> m, h, J = symbols("m h J")
    >>> tree = em.Tree()
    >>> _ = tree.body("rod", joint="revolute", axis="y", mass=m, moment=(0, 0, -h), inertia=(0, J, 0))
    >>> model = em.Model(name="rod", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
    ...                  potential_energy=tree.potential_energy, parameters={m: 2.0, h: 0.5, J: 0.4})
    >>> x = np.linspace(0, 2, 9)[None]
    >>> found = em.identifiable(em.build(model), ["m", "h", "J"], (x, 0 * x, np.cos(5 * x)))
    >>> sorted(found.texts), found.unseen
    (['J', 'h'], ('m',))
    """
    names = chosen_of(system.compiled, parameters)
    found = regressor_of(given_motion(system, motion, inputs, values), names)
    return base_of(system.compiled.name, names, found.free[0], found.values, tolerance)


def base_of(model: str, names: tuple[str, ...], W: Vector, values: Vector, tolerance: float) -> Identifiable:
    """Return the base parameters of a regressor W (rows, k), of parameters that are at values (k,)."""
    if not 0.0 < number(tolerance, "tolerance") < 1.0:
        raise ModelError(f"tolerance is {tolerance:g}. Give a number between 0 and 1.")
    length = np.linalg.norm(W, axis=0)
    force = length * np.abs(values)  # a column is large or small by the unit of its parameter, a force is not
    nothing = [_NOTHING * size.max(initial=0.0) for size in (length, force)]
    seen = np.flatnonzero((length > nothing[0]) | (force > nothing[1]))
    if not seen.size:
        raise ModelError(f"{model}: no force along this motion depends on {', '.join(names)}")
    scaled = W[:, seen] / length[seen]
    R, order = scipy.linalg.qr(scaled, mode="r", pivoting=True)
    sizes = np.linalg.svd(R, compute_uv=False)
    rank = int((sizes > tolerance * sizes[0]).sum())
    places = seen[order]
    rest = scipy.linalg.solve_triangular(R[:rank, :rank], R[:rank, rank:])
    rest = np.where(np.abs(rest) > _NONE, rest, 0.0) * length[places[rank:]] / length[places[:rank], None]
    combinations = np.zeros((rank, len(names)))
    combinations[np.arange(rank), places[:rank]] = 1.0
    combinations[:, places[rank:]] = rest
    of_base = np.linalg.svd(R[:rank, :rank], compute_uv=False)
    all_sizes = np.concatenate([sizes, np.zeros(len(names) - len(sizes))])
    return Identifiable(
        names, rank, tuple(names[k] for k in places[:rank]), combinations, float(of_base[0] / of_base[-1]), all_sizes,
        tuple(name for k, name in enumerate(names) if k not in seen),
    )  # fmt: skip


def _text(names: tuple[str, ...], row: Vector, own: str) -> str:
    """Return a combination, its base parameter first."""
    terms = [own]
    for name, factor in zip(names, row, strict=True):
        if factor and name != own:
            size = f"{abs(factor):.6g}"
            terms.append(f"{'-' if factor < 0 else '+'} {name if size == '1' else f'{size} {name}'}")
    return " ".join(terms)
