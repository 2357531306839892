"""Branches that leave another one at a doubling or a branch point."""

from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from ..cycles.symmetry import Symmetry
from .curve import Curve, NoPointError, Place, place, point
from .cycle_curve import CycleCurve

_AWAY = (0.01, 1e-3, 1e-4, 1e-5)
"""First steps away from the branch, in units."""


def doubled(curve: CycleCurve, at: Place) -> tuple[CycleCurve, Place]:
    """Return the curve of cycles of twice the period, and the point of a doubling on it."""
    search = curve.search
    problem, section = search.problem, search.section
    G, h = problem.symmetry.G, problem.symmetry.h
    twice = Symmetry(G @ G, G @ h + h, problem.symmetry.stated, problem.symmetry.names)
    stated = problem.stated_period
    if stated is not None:
        stated = stated.doubled()
    problem = replace(problem, symmetry=twice, stated_period=stated)
    section = replace(section, times=2 * section.times)
    conditions = tuple(one.of_half() for one in search.unknowns.conditions)
    unknowns = replace(search.unknowns, conditions=conditions)
    curve = replace(curve, search=replace(search, problem=problem, section=section, unknowns=unknowns))
    w, along, place_of_period = at.sample.w.copy(), at.tangent * at.sample.unit, len(curve.first.q)
    w[place_of_period] *= 2.0
    along[place_of_period] *= 2.0
    return curve, place(curve.at(w), along)


def crossing(curve: Curve, at: Place, along: Vector) -> tuple[Place, Place]:
    """Return a branch point, and a point beside it on the branch that crosses the one in the direction `along` (N,).

    Raises
    ------
    NoPointError
        No other branch is found.
    """
    sample, unit = at.sample, at.sample.unit
    tangent = along / unit / np.linalg.norm(along / unit)
    plane = sample.E @ np.linalg.svd(sample.J)[2][-2:].T / unit[:, None]
    across = np.linalg.svd(plane - np.outer(tangent, tangent @ plane))[0][:, 0]
    for h in _AWAY:
        w = sample.w + h * across * unit
        try:
            leaves = point(curve, w, across * unit, (across / unit, w))
        except NoPointError:
            continue
        if abs(leaves.tangent @ (across / np.linalg.norm(across))) > 0.5:
            return place(sample, across * unit), leaves
    raise NoPointError("no other branch is found there")
