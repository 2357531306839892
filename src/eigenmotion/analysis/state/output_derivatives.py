"""Derivatives of outputs at a state, accelerations and multipliers included."""

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime.variations import output_partials
from .active_contacts import absent_rows
from .operating_point import OperatingPoint
from .tangent_space import tangent


def output_derivatives(at: OperatingPoint) -> Vector:
    """Return the derivatives (n_outputs, n_arguments) of outputs by x, v, inputs, parameters and time.

    Raises
    ------
    ModelError
        An output holds a multiplier of constraint rows that depend on each other.
    """
    n, m = at.model.n, at.model.m
    a, multipliers, da, dm = at.motion
    D = output_partials(at.model, at.t, at.x, at.v, a, multipliers, at.prepared, at.u)
    by_a, by_multipliers, by_arguments = np.split(D, [n, n + m], axis=1)
    _refuse_shared_reactions(at, by_multipliers)
    return np.asarray(by_arguments + by_a @ da + by_multipliers @ dm)


def _refuse_shared_reactions(at: OperatingPoint, by_multipliers: Vector) -> None:
    used = np.argwhere(by_multipliers)
    n, absent = at.model.n, absent_rows(at)
    rows, holonomic = (sum(k not in absent for k in range(count)) for count in (at.model.m, at.model.h))
    dependent = rows - (n - sum(k >= n for k in tangent(at).free))
    if len(used) and dependent:
        raise ModelError(
            f"{at.model.name}: output {at.model.outputs[used[0][0]]!r} holds a multiplier of constraint rows that "
            f"depend on each other ({dependent} of {rows} do, {holonomic} of them holonomic), and how they share the "
            "reaction has no derivative. Leave out the rows that are not needed, or the output"
        )
