"""Modes of frictions along prescribed motions."""

from collections.abc import Iterator

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ..state.active_contacts import Surfaces, Switch, all_open, switches_of, with_parameters
from ..state.operating_point import OperatingPoint
from .motion_arguments import Motion

_STILL = 1e-9
"""An acceleration of a slip, relative to its terms, that counts as zero."""


def by_mode(motion: Motion) -> Iterator[tuple[Vector, Motion]]:
    """Yield the rows of each mode of the frictions, with the motion of these rows in that mode.

    A friction slides as its slip moves or, where that rests, as it begins to. A friction that rests and stays at rest
    has no part in the forces: it could take anything up to its limit.

    Raises
    ------
    ModelError
        A contact is closed.
    """
    modes: dict[tuple[float, ...], list[int]] = {}
    for row in range(len(motion.t)):
        modes.setdefault(_mode(motion, row), []).append(row)
    for mode, rows in modes.items():
        part = motion.rows(rows)
        yield np.array(rows), part.in_mode(_in_mode(_point(part, 0), mode).prepared)


def _point(motion: Motion, row: int) -> OperatingPoint:
    """Return a row with all contacts open and no friction."""
    at = OperatingPoint(
        motion.model, motion.prepared, float(motion.t[row]), motion.x[row], motion.v[row], motion.u[row]
    )
    return all_open(at)


def _in_mode(at: OperatingPoint, mode: tuple[float, ...]) -> OperatingPoint:
    frictions = [one for one in switches_of(at.model) if not one.is_contact]
    return with_parameters(at, {one.slides: side for one, side in zip(frictions, mode, strict=True)})


def _mode(motion: Motion, row: int) -> tuple[float, ...]:
    """Return the direction in which each friction slides, 0 where it rests."""
    at = _point(motion, row)
    surfaces = Surfaces(at)
    if closed := surfaces.closed():
        raise ModelError(
            f"{at.model.name}: {closed[0].words(at.model)} is closed, and whether it pushes is not known. State it "
            "as a constraint in a model for inverse dynamics, or choose a motion along which its gap is open."
        )
    frictions = [one for one in switches_of(at.model) if not one.is_contact]
    return tuple(_side(surfaces, motion.a[row], one) for one in frictions)


def _side(surfaces: Surfaces, a: Vector, one: Switch) -> float:
    rate = surfaces.rates[0][one.row]
    if not surfaces.at_rest(one):
        return float(np.sign(rate))
    along, size = surfaces.accelerations(a)[one.row], float(np.abs(surfaces.A[one.row]) @ np.abs(a))
    return float(np.sign(along)) if abs(along) > _STILL * size else 0.0
