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
    modes: dict[tuple[tuple[int, float], ...], list[int]] = {}
    for row in range(len(motion.t)):
        modes.setdefault(_mode(motion, row), []).append(row)
    for mode, rows in modes.items():
        part = motion.rows(rows)
        yield np.array(rows), part.in_mode(with_parameters(_point(part, 0), dict(mode)).prepared)


def _point(motion: Motion, row: int) -> OperatingPoint:
    """Return a row with all contacts open and no friction."""
    at = OperatingPoint(
        motion.model, motion.prepared, float(motion.t[row]), motion.x[row], motion.v[row], motion.u[row]
    )
    return all_open(at)


def _mode(motion: Motion, row: int) -> tuple[tuple[int, float], ...]:
    """Return (index, value) of the parameters that let frictions slide; none for those at rest."""
    at = _point(motion, row)
    surfaces = Surfaces(at)
    if closed := surfaces.closed():
        raise ModelError(
            f"{at.model.name}: {closed[0].words(at.model)} is closed, and whether it pushes is not known. State it "
            "as a constraint in a model for inverse dynamics, or choose a motion along which its gap is open."
        )
    frictions = [one for one in switches_of(at.model) if not one.is_contact]
    return tuple(pair for one in frictions for pair in _sliding(surfaces, motion.a[row], one))


def _sliding(surfaces: Surfaces, a: Vector, one: Switch) -> Iterator[tuple[int, float]]:
    """Yield the parameters of one friction; of a cone also those that turn it, if its slip begins to move."""
    rows = slice(one.row, one.row + (2 if one.shift >= 0 else 1))
    rate, within = (part[rows] for part in surfaces.rates)
    begins = bool((np.abs(rate) <= within).all())
    along, size = surfaces.accelerations(a)[rows], np.abs(surfaces.A[rows]) @ np.abs(a)
    if begins and (np.abs(along) <= _STILL * size).all():
        return
    moving = along if begins else rate
    yield one.slides, 1.0 if one.shift >= 0 else float(np.sign(moving[0]))
    if begins and one.shift >= 0:
        yield from zip((one.shift, one.shift + 1), moving / np.linalg.norm(moving) - rate, strict=True)
