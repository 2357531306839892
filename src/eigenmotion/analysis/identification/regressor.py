"""Regressor: forces of a motion as a linear function of parameters."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector, spelled, unknown
from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from ...runtime import CompiledModel
from ..inverse.contact_modes import by_mode
from ..inverse.motion_arguments import Motion, motion_of
from ..state.active_contacts import switches_of
from .freedoms import free_motions, obstacle_of
from .linearity import check_linear
from .slopes import required, slopes


@dataclass(frozen=True)
class Regressor:
    """Forces = Y p + rest at one state or at many, exactly, for parameters p; unpacks as (Y, rest).

    Attributes
    ----------
    parameters : (k) names
    values : (k,) p: the values at which they are
    Y : (n, k), or (n, k, states), of n coordinates
    rest : (n,), or (n, states)
    freedoms : of each state N (n, freedoms), motions that the constraints allow; reactions do no work along them
    obstacle : why forces along N are not linear in the parameters, or ""

    Examples
    --------
    >>> import eigenmotion as em
    >>> found = em.build("models/four_bar.py").regressor(["density"], [1.6, 0.6, 1.5], [0, 0, 0], [1, 0.2, 0.4])
    >>> found.Y.shape, found.freedoms[0].shape, bool(abs(found.rest).max() < 1e-12)
    ((3, 1), (3, 1), True)
    """

    parameters: tuple[str, ...]
    values: Vector
    Y: Vector
    rest: Vector
    freedoms: tuple[Vector, ...]
    obstacle: str = ""

    def __iter__(self) -> Iterator[Vector]:
        """Return Y and rest, one after the other."""
        return iter((self.Y, self.rest))

    @property
    def free(self) -> tuple[Vector, Vector]:
        """N^T Y (rows, k) and N^T rest (rows,) of all states, one below the other: forces without reactions.

        Raises
        ------
        ModelError
            N depends on the parameters, or friction on reactions.
        """
        if self.obstacle:
            raise ModelError(self.obstacle)
        Y, rest = np.atleast_3d(self.Y), self.rest.reshape(len(self.rest), -1)
        rows = [(N.T @ Y[..., j], N.T @ rest[:, j]) for j, N in enumerate(self.freedoms)]
        return np.vstack([one for one, _ in rows]), np.concatenate([one for _, one in rows])


def regressor(
    system: CompiledSystem,
    parameters: Iterable[Any],
    x: Mapping[Any, Any] | ArrayLike,
    v: Mapping[Any, Any] | ArrayLike,
    a: Mapping[Any, Any] | ArrayLike,
    t: ArrayLike = 0.0,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
    values: Any = None,
) -> Regressor:
    """Return the forces of accelerations a as Y p + rest, for parameters p in which they are linear.

    The forces are M a - f: those of `inverse_dynamics` without actuators, without reactions of constraints. With
    constraints, forces that are measured contain reactions, which do no work along the motions N that the constraints
    allow: `Regressor.free` has N^T Y and N^T rest. Frictions slide as in `inverse_dynamics`.

    Parameters
    ----------
    parameters
        Names. That forces are linear in them is tried at random values of them, at these states and at random ones: Y
        stays the same to 1e-9, and forces are Y p + rest to that. A dependence that is weaker is not seen.
    x, v, a, t, inputs
        As in `inverse_dynamics`.
    values
        Parameters, as elsewhere; those that are asked for are given for `Regressor.values` alone.

    Raises
    ------
    ModelError
        Forces are not linear in a parameter (names it and what it is multiplied with), a name is unknown, a contact is
        closed, or the model was written by hand.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from sympy import symbols
    >>> m, h = symbols("m h")
    >>> tree = em.Tree()
    >>> _ = tree.body("rod", joint="revolute", axis="y", mass=m, moment=(0, 0, -h), inertia=(0.4, 0.4, 0))
    >>> model = em.Model(name="rod", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
    ...                  potential_energy=tree.potential_energy, parameters={m: 2.0, h: 0.5})
    >>> em.build(model).regressor(["m", "h"], [0.5], [0.0], [2.0]).Y.round(6)
    array([[0.      , 4.703165]])
    """
    return regressor_of(motion_of(system, x, v, a, t, values, inputs), chosen_of(system.compiled, parameters))


def chosen_of(c: CompiledModel, parameters: Iterable[Any]) -> tuple[str, ...]:
    """Return the names of chosen parameters.

    Raises
    ------
    ModelError
        There are none, one is unknown or a table, or is given twice.
    """
    names = () if isinstance(parameters, str) else tuple(map(spelled, parameters))
    modes = {c.parameters[k] for one in switches_of(c) for k in one.parameters}
    known = [name for name in c.parameters if name not in c.tables and name not in modes]
    if not names:
        raise ModelError(
            f"{c.name}: parameters is {parameters!r}. Give names, as ({', '.join(map(repr, known[:2]))},)."
        )
    if wrong := set(names) - set(known):
        raise ModelError(f"{c.name}: {unknown('parameter', wrong, known)}")
    if twice := [name for name in names if names.count(name) > 1]:
        raise ModelError(f"{c.name}: parameter {twice[0]!r} is given twice")
    return names


def regressor_of(motion: Motion, names: tuple[str, ...]) -> Regressor:
    """Return the regressor of a motion's rows."""
    c, n = motion.model, motion.model.n_coordinates
    if not c.inverts:
        raise ModelError(f"{c.name} was written by hand, and has no derivatives of its equations by parameters")
    columns = [c.parameters.index(name) for name in names]
    Y, r = np.empty((len(motion.t), n, len(names))), np.empty((len(motion.t), n))
    freedoms, obstacle = [np.eye(n)] * len(motion.t), ""
    for rows, part in by_mode(motion) if c.switches else [(np.arange(len(motion.t)), motion)]:
        check_linear(part, columns)
        Y[rows], r[rows] = slopes(part, columns), required(part)
        obstacle = obstacle or obstacle_of(part, columns)
        for row, N in zip(rows, free_motions(part), strict=True):
            freedoms[row] = N
    p = np.array(motion.prepared.parameters)[columns]
    return Regressor(names, p, motion.out(Y), motion.out(r - Y @ p), tuple(freedoms), obstacle)
