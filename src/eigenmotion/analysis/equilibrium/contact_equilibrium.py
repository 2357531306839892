"""Equilibria of mechanisms with contacts and friction, where the contact mode is unknown too.

The equations are solved in one mode. The complementarity problem of runs then gives the mode of the solution, and
contacts that it penetrates are added. This is repeated until the two modes agree.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain, combinations, islice

import numpy as np
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from ...codegen.model import ModelError
from ...runtime import EvaluationError
from ..state.active_contacts import Surfaces, Switch, all_open, holding, in_consistent_mode, mode_of, switches_of
from ..state.operating_point import OperatingPoint
from .equilibrium_equations import Balance

_MODES = 50
"""Most modes tried from one initial guess."""
_GUESSES = 64
"""Most sets of contacts tried as guesses, if the downhill search finds no equilibrium."""
_STEPS = 200
"""Most steps of the downhill search."""
_SAMPLES = 16
"""Points in each step at which gaps are evaluated."""
_CLOSE = 1e-12
"""Relative accuracy of the first contact in a step."""
_LEFT = 1e-12
"""The search ends at accelerations below this part of the reactions."""
_STRAIGHT = 0.1
"""If forces change less than this in a step, the next step is twice as long."""
_NOWHERE = (EvaluationError, ModelError, np.linalg.LinAlgError)
"""Exceptions at points without values, or without a consistent mode."""


def solve_with_modes(balance: Balance) -> tuple[Balance, Vector]:
    """Return the balance in the mode of its solution, and the solution; or the best approximation found.

    Newton's method and the downhill search both start at the given state; the nearer solution counts. If neither
    converges, sets of contacts are held as guesses.
    """
    start, solutions = balance.start, list[tuple[Balance, Vector]]()
    here = _in_start_mode(balance)
    first, solution, holds = _with_modes(here, start)
    if holds:
        solutions.append((first, solution))
    stays = np.array_equal(solution, start) or (first.given is here.given and not any(_mode(here)))
    if balance.of_coordinates_alone and not (holds and stays):
        below, q, holds = _with_modes(*_downhill(here, start))
        solutions += [(below, q)] * holds
    if solutions:
        unit = balance.point(start).inertia[list(balance.free)] if balance.of_coordinates_alone else 1.0
        return min(solutions, key=lambda one: float(np.linalg.norm(unit * (one[1] - start))))
    guessed = (_with_modes(begin, start) for begin in islice(_guesses(balance), _GUESSES))
    return next(((begin, q) for begin, q, holds in guessed if holds), (first, solution))


def _mode(balance: Balance) -> list[float]:
    """Return the values of the parameters of the mode."""
    at = balance.point(balance.start)
    return list(mode_of(at.model, at.prepared).values())


def _guesses(balance: Balance) -> Iterator[Balance]:
    """Yield the balance with each set of contacts held."""
    at = all_open(balance.point(balance.start))
    contacts = [one for one in switches_of(at.model) if one.is_contact]
    for held in chain.from_iterable(combinations(contacts, count) for count in range(len(contacts) + 1)):
        yield _in_mode(balance, holding(at, list(held)))


def _in_mode(balance: Balance, at: OperatingPoint) -> Balance:
    """Return the balance in the mode of a state."""
    count = len(at.model.parameters)
    given = balance.given.copy()
    for one in switches_of(at.model):
        for k in (one.holds, one.slides, one.idles):
            if k >= 0:
                given[k - count] = at.prepared.parameters[k]
    return replace(balance, given=given)


def _in_start_mode(balance: Balance) -> Balance:
    """Return the balance in the mode of the given state; contacts that it penetrates are held."""
    at = balance.point(balance.start)
    inside = [one for one, _ in Surfaces(at).inside()]
    try:
        return _in_mode(balance, in_consistent_mode(_touching(at)))
    except _NOWHERE:
        return _in_mode(balance, holding(all_open(at), inside))


def _with_modes(balance: Balance, q: Vector) -> tuple[Balance, Vector, bool]:
    """Return the balance in the last mode tried, its solution, and whether that is consistent with the mode."""
    start, seen = balance.start, set[bytes]()
    while (mode := balance.given.tobytes()) not in seen and len(seen) < _MODES:
        seen.add(mode)
        try:
            q = balance.solve(q)
            if not balance.satisfied(q, start):
                return balance, q, False
            at = balance.point(q)
            if entered := [one for one, _ in Surfaces(at).inside()]:
                balance = _in_mode(balance, holding(at, entered))
                continue
            balance = _in_mode(balance, in_consistent_mode(_touching(at)))
            if balance.satisfied(q, start):
                return balance, balance.solve(q), True
        except _NOWHERE:
            break
    return balance, q, False


def _touching(at: OperatingPoint) -> OperatingPoint:
    """Return the state with all touching contacts closed beforehand, so that rounding does not open them."""
    values = at.prepared.parameters
    near = [one for one in Surfaces(at).closed() if not values[one.holds] and not values[one.idles]]
    return holding(at, near) if near else at


# --- downhill ---------------------------------------------------------------------------------------------------------


def _downhill(balance: Balance, q: Vector) -> tuple[Balance, Vector]:
    """Follow dx/dt = a(x) by implicit steps to an equilibrium, with changes of the contact mode on the way."""
    step, before = 0.0, np.inf
    try:
        at = in_consistent_mode(_touching(balance.point(q)))
    except _NOWHERE:
        return balance, q
    try:
        for _ in range(_STEPS):
            slope, push = _scaled(at)
            left = float(np.linalg.norm(push))
            if not _LEFT * float(np.linalg.norm(at.inertia * at.reaction_terms)) < left < np.inf:
                break
            step = _next_step(step, float(np.linalg.norm(slope)), before / left)
            dx = np.linalg.solve(np.eye(len(push)) / step - slope, push) / at.inertia
            there = _moved(at, dx)
            same = mode_of(at.model, at.prepared) == mode_of(at.model, there.prepared)
            at, before, step = there, left if same else np.inf, step if same else 0.0
    except _NOWHERE:
        pass
    return _in_mode(balance, at), at.x


def _scaled(at: OperatingPoint) -> tuple[Vector, Vector]:
    n = at.model.n
    return at.inertia[:, None] * at.slopes[:, :n] / at.inertia, at.inertia * at.motion[0]


def _next_step(step: float, slope: float, slower: float) -> float:
    """Return the length of the next step, which grows if the motion slows down or forces hardly change."""
    if not step:
        return 0.1 / (slope or 1.0)
    return step * (2.0 if step * slope <= _STRAIGHT else min(2.0, slower))


def _moved(at: OperatingPoint, dx: Vector) -> OperatingPoint:
    """Return the state after dx, or at the first contact on the way, in its mode there."""
    values = at.prepared.parameters
    open_ = [one for one in switches_of(at.model) if one.is_contact and not values[one.holds] and not values[one.idles]]
    part, struck = _first_touch(at, dx, open_)
    x = at.x + part * dx
    there = at.at(at.t, x, at.v)
    if at.model.h:
        there = holding(there, struck) if struck else there
        there = there.at(at.t, at.model.project(at.t, x, at.v, there.prepared, True)[0], at.v)
    return in_consistent_mode(_touching(there))


def _first_touch(at: OperatingPoint, dx: Vector, contacts: list[Switch]) -> tuple[float, list[Switch]]:
    """Return the part of dx after which the first contacts close, and these contacts; else 1 and none."""
    if not contacts:
        return 1.0, []
    surfaces, rows = Surfaces(at), [one.row for one in contacts]

    def entered(parts: Vector) -> NDArray[np.bool_]:
        x = at.x + parts[:, None] * dx
        gaps = at.model.position_rows(np.full(len(parts), at.t), x, surfaces.all.prepared)
        return np.asarray(gaps[:, rows] < -surfaces.gaps[1][rows])

    low, high = 0.0, 1.0
    while high - low > _CLOSE * high:
        parts = np.linspace(low, high, _SAMPLES + 1)[1:]
        inside = entered(parts).any(axis=1)
        if not inside.any():
            return 1.0, []
        first = int(inside.argmax())
        low, high = parts[first] - (high - low) / _SAMPLES, float(parts[first])
    struck = entered(np.array([high]))[0]
    return high, [one for one, is_struck in zip(contacts, struck, strict=True) if is_struck]
