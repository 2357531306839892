"""Modes of contacts and frictions along prescribed motions."""

from collections.abc import Iterator

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime import Actuators
from ..state.active_contacts import Surfaces, Switch, all_open, switches_of, with_parameters
from ..state.operating_point import OperatingPoint
from .motion_arguments import Motion

_STILL = 1e-9
"""An acceleration of a gap or a slip, relative to its terms, that counts as zero."""
_ROUNDED = 1e-12
"""The same, relative to the accelerations that the acting forces cause."""


def by_mode(motion: Motion, of: Actuators | None = None) -> Iterator[tuple[Vector, Motion]]:
    """Yield the rows of each mode of contacts and frictions, with the motion of these rows in that mode.

    A closed contact whose gap stays closed holds, with a reaction that is unknown; one whose gap opens has no force.
    A friction slides as its slip moves or, where that rests, as it begins to. A friction whose slip stays at rest
    sticks if a closed contact presses it. Otherwise it has no part in the forces: it could take anything up to its
    limit.

    Raises
    ------
    ModelError
        A contact is closed, and no actuators are named (None, or all coordinates); or the motion leads into one.
    """
    modes: dict[tuple[tuple[int, float], ...], list[int]] = {}
    for row in range(len(motion.t)):
        modes.setdefault(_mode(motion, row, of), []).append(row)
    for mode, rows in modes.items():
        part = motion.rows(rows)
        yield np.array(rows), part.in_mode(with_parameters(_point(part, 0), dict(mode)).prepared)


def _point(motion: Motion, row: int) -> OperatingPoint:
    """Return a row with all contacts open and no friction."""
    at = OperatingPoint(
        motion.model, motion.prepared, float(motion.t[row]), motion.x[row], motion.v[row], motion.u[row]
    )
    return all_open(at)


def _mode(motion: Motion, row: int, of: Actuators | None) -> tuple[tuple[int, float], ...]:
    """Return (index, value) of the parameters of the mode; none for frictions at rest that no contact presses."""
    at = _point(motion, row)
    surfaces = Surfaces(at)
    if inside := surfaces.inside():
        one, gap = inside[0]
        raise ModelError(f"{at.model.name}: at t = {at.t:g} x is inside {one.words(at.model)}: its gap is {gap:.3g}. "
                         "Choose a motion that stays outside.")  # fmt: skip
    held = [one for one in surfaces.closed() if _stays_closed(surfaces, motion.a[row], one)]
    if held and not (of and of.names):
        remedy = "Name the actuators, state" if of else "State"
        raise ModelError(
            f"{at.model.name}: {held[0].words(at.model)} is closed, and with a force on every coordinate its push is "
            f"not known. {remedy} the contact as a constraint, or choose a motion along which its gap is open."
        )
    pairs = [(one.holds, 1.0) for one in held]
    for one in switches_of(at.model):
        if not one.is_contact:
            pairs += _of_friction(surfaces, motion.a[row], one, held)
    return tuple(pairs)


def _stays_closed(surfaces: Surfaces, a: Vector, one: Switch) -> bool:
    """Whether the gap of a closed contact stays zero, or opens.

    Raises
    ------
    ModelError
        It would become negative.
    """
    model, rate, within = surfaces.at.model, *(part[one.row] for part in surfaces.rates)
    along, rounded = (float(part[one.row]) for part in _accelerations(surfaces, a))
    still = abs(rate) <= within
    if still and abs(along) <= rounded:
        return True
    if (along if still else rate) > 0.0:
        return False
    raise ModelError(
        f"{model.name}: at t = {surfaces.at.t:g} the motion leads into {one.words(model)}, which is closed. Choose a "
        "motion that stays outside."
    )


def _accelerations(surfaces: Surfaces, a: Vector) -> tuple[Vector, Vector]:
    """Return the accelerations (m,) A a + gamma of gaps and slips, and how much of them counts as zero."""
    along = surfaces.accelerations(a)
    terms = surfaces.A * a
    size = np.abs(terms).sum(axis=1) + np.abs(along - terms.sum(axis=1))
    return along, _STILL * size + _ROUNDED * surfaces.units * surfaces.push


def _of_friction(surfaces: Surfaces, a: Vector, one: Switch, held: list[Switch]) -> Iterator[tuple[int, float]]:
    """Yield the parameters of one friction; of a cone also those that turn it, if its slip begins to move.

    An open contact presses no friction.
    """
    if one.over >= 0 and switches_of(surfaces.at.model)[one.over] not in held:
        return
    rows = slice(one.row, one.row + (2 if one.shift >= 0 else 1))
    rate, within = (part[rows] for part in surfaces.rates)
    begins = bool((np.abs(rate) <= within).all())
    along, rounded = (part[rows] for part in _accelerations(surfaces, a))
    if begins and (np.abs(along) <= rounded).all():
        if one.over >= 0:
            yield one.holds, 1.0
        return
    moving = along if begins else rate
    yield one.slides, 1.0 if one.shift >= 0 else float(np.sign(moving[0]))
    if begins and one.shift >= 0:
        yield from zip((one.shift, one.shift + 1), moving / np.linalg.norm(moving) - rate, strict=True)
