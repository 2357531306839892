"""Following of equilibria and cycles along a parameter."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...arguments.named_values import Vector, spelled, unknown
from ...arguments.tables import refuse_tables
from ...codegen.model.normalise import ModelError, number, shown
from ...compiled.compiled_system import CompiledSystem
from ..cycles.cycle import Cycle
from ..cycles.periodic_problem import NO_LIMIT
from ..cycles.returns import Return
from ..equilibrium.equilibrium import Equilibrium, balance_of
from ..state.active_contacts import switches_of
from ..state.contact_bounds import Bounds
from ..state.operating_point import OperatingPoint
from . import cycle_curve, equilibrium_curve
from .branch import Branch, Origin, SpecialPoint
from .cycle_curve import CycleCurve
from .equilibrium_curve import EquilibriumCurve
from .indicators import BRANCHING, DOUBLING, HOPF
from .oscillation import oscillating
from .path import Node, Path, begun, followed
from .switching import crossing, doubled

_BETWEEN = np.linspace(0.0, 1.0, 9)
"""Places in a step of a run at which extents are measured."""


def follow(
    start: Cycle | Equilibrium | SpecialPoint,
    name: Any = None,
    *,
    to: float,
    back: float | None = None,
    free: Sequence[Any] | None = None,
    constant: Sequence[Any] | None = None,
    max_steps: int = 500,
) -> Branch:
    """Return the branch of equilibria or cycles through one of them along a parameter, by steps of arclength.

    The branch may turn back, and ends where the parameter is `to` or `back`, or where it is closed. Folds, Hopf
    bifurcations, period doublings, tori, branch points, and flutter of undamped equilibria are located. Conditions and
    free parameters of a cycle stay so. Where two events of a cycle happen at once, the branch goes on if they do not
    disturb each other; it ends where they do, and where a contact is only touched. Equilibria in contact are followed
    in their mode, until a contact opens or closes, or a friction begins or ceases to slide.

    Parameters
    ----------
    start
        A result of `find_equilibrium` or `find_cycle`. Or one of `Branch.special`, to follow the branch that leaves
        there: at a Hopf bifurcation, cycles; at a doubling, cycles of twice the period; at a branch point, the other
        branch.
    name
        The parameter, or an input that is constant; None: that of the branch of a special point.
    to
        The value at which the branch ends.
    back
        The value on the other side of the start at which it ends, too; None: as far from the start as `to`.
    free, constant
        For equilibria, as in `find_equilibrium`: the unknowns beside the parameter, and which rates are constant.
    max_steps
        Number of steps after which the branch ends.

    Returns
    -------
    Branch
        Also if it ends before: see `success` and `message`.

    Raises
    ------
    ModelError
        The start was not found; unknown names; `to` is the value at the start; the start is one of a family; contact
        modes meet at an equilibrium; a stated symmetry depends on the parameter; the forcing's period depends on it,
        but that of the cycle is a number.

    Notes
    -----
    Newton's method and tangents use exact derivatives, of runs by `sensitivities`. Bifurcations are roots of functions
    that are regular there: the parameter's part of the tangent, and products over eigenvalues or multipliers.
    Y. A. Kuznetsov, Elements of Applied Bifurcation Theory, chapter 10.

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/compass_gait.py")
    >>> gait = em.find_cycle(system, section="heel strike")
    >>> print(em.follow(gait, "gamma", to=0.012))
    compass_gait: cycles along gamma from 0.009 to 0.012: no bifurcations
    """
    if isinstance(start, SpecialPoint):
        return _leaving(start, name, (number(to, "to"), back), max_steps)
    if not isinstance(start, Cycle | Equilibrium):
        raise ModelError(f"follow: the start is {shown(start)}. Give a result of find_equilibrium or find_cycle")
    system, by, goal = start.system, spelled(name), number(to, "to")
    known = (*system.inputs, *system.parameters)
    if by not in known:
        raise ModelError(f"{system.name}: {unknown('name to follow', [by], known)}")
    refuse_tables(system.compiled, (by,), "follow")
    if not start.success:
        raise ModelError(f"{system.name}: the start was not found: {start.message}")
    with np.errstate(all="ignore"):  # numbers that are not finite are reported by name
        if isinstance(start, Cycle):
            return _cycles(start, by, (goal, back), max_steps)
        return _equilibria(start, by, (goal, back), free, constant, max_steps)


def _interval(system: CompiledSystem, by: str, value: float, ends: tuple[float, float | None]) -> tuple[float, float]:
    """Return both ends of the interval: the goal, and the other one."""
    to, back = ends[0], 2.0 * value - ends[0] if ends[1] is None else number(ends[1], "back")
    if to == value or not (back - value) * (to - value) < 0.0:
        raise ModelError(f"{system.name}: {by} is {value:g} at the start. Give another value of `to`, and `back` on "
                         "the other side")  # fmt: skip
    return to, back


def _equilibria(start: Equilibrium, by: str, ends: tuple[float, float | None], free: Any, constant: Any, max_steps: int
                ) -> Branch:  # fmt: skip
    system = start.system
    value = start.inputs[by] if by in start.inputs else start.parameters[by]
    to, back = _interval(system, by, value, ends)
    x0 = dict(zip(system.coordinates, start.x.tolist(), strict=True)) | start.states
    v0 = dict(zip(system.coordinates, start.v.tolist(), strict=True))
    chosen = [*system.coordinates, *system.states] if free is None else list(free)
    if by in map(spelled, chosen):
        raise ModelError(f"{system.name}: {by} is followed; leave it out of free")
    balance = balance_of(system, x0, [*chosen, by], v0, start.t, start.inputs, start.parameters, constant)
    curve = equilibrium_curve.curve_of(balance, balance.start, abs(to - value))
    _check_mode(system, balance.point(balance.start))
    try:
        first = begun(curve, balance.start, to)
    except ModelError as error:
        raise ModelError(f"{system.name}: {error}{_of_sticking(balance.point(balance.start))}") from error
    path = followed(curve, (first,), (to, back), False, max_steps)
    return _of_equilibria(system, by, curve, path)


def _of_sticking(at: OperatingPoint) -> str:
    """Return that a sticking friction leaves a choice, or ""."""
    names = [at.model.events[one.event] for one in switches_of(at.model)
             if not one.is_contact and at.prepared.parameters[one.holds]]  # fmt: skip
    if not names:
        return ""
    return (f". While {names[0]!r} sticks, equilibria beside each other are possible: leave the coordinate that it "
            "holds out of free")  # fmt: skip


def _check_mode(system: CompiledSystem, at: OperatingPoint) -> None:
    """Raise ModelError if contact modes meet at the start of a branch, which has one."""
    if system.compiled.switches and (meeting := next(Bounds(at).at_bound(), None)):
        raise ModelError(f"{system.name}: contact modes meet at the start: {meeting[1]}. Begin at another value")


def _of_equilibria(system: CompiledSystem, by: str, curve: EquilibriumCurve, path: Path) -> Branch:
    n = system.n
    states = [curve.balance.point(node.place.sample.w) for node in path.nodes]
    rows = np.array([[*at.x[:n], *at.v[at.model.n_coordinates :], *at.v[:n]] for at in states])
    here = rows[:, : n + len(system.states)]
    return _branch(system, (by, curve), path, rows, np.zeros(len(rows)), (here, here))


def _cycles(start: Cycle, by: str, ends: tuple[float, float | None], max_steps: int) -> Branch:
    system, search = start.system, start.search
    assert search is not None
    if by in search.unknowns.names:
        raise ModelError(f"{system.name}: {by} is free in this cycle, and cannot be followed, too. Follow another one")
    if by in search.problem.symmetry.names:
        raise ModelError(f"{system.name}: the symmetry depends on {by}, so cycles along it are not followed")
    signal = search.problem.point(search.problem.projected(_start(start), search.problem.prepared), start.t,
                                  search.problem.prepared)  # fmt: skip
    value = float(signal.u[system.compiled.inputs.index(by)]) if by in system.inputs else start.parameters[by]
    to, back = _interval(system, by, value, ends)
    search.problem.count.most = NO_LIMIT
    curve = cycle_curve.curve_of(search, _start(start), start.period, by, abs(to - value))
    first = curve.at(np.concatenate([_start(start), [start.period], [*start.free.values(), value]]))
    path = followed(curve, (begun(curve, first.w, to),), (to, back), True, max_steps)
    return _of_cycles(system, by, curve, path)


def _of_cycles(system: CompiledSystem, by: str, curve: CycleCurve, path: Path) -> Branch:
    problem, motions = curve.search.problem, [node.place.sample.detail for node in path.nodes]
    rows = np.array([np.concatenate(problem.start(one.q)) for one in motions])
    periods = np.array([one.period for one in motions])
    ends_of = [_ends(one, system.n, problem.c.n) for one in motions]
    highest, lowest = (np.array([one[k] for one in ends_of]) for k in (0, 1))
    return _branch(system, (by, curve), path, rows, periods, (highest, lowest))


def _leaving(point: SpecialPoint, name: Any, ends: tuple[float, float | None], max_steps: int) -> Branch:
    """Return the branch that leaves another one at a special point."""
    system, curve, by, at = point.origin
    if name is not None and spelled(name) != by:
        raise ModelError(f"{system.name}: the branch of the {point.kind} is along {by}, not {spelled(name)}")
    if point.kind not in {DOUBLING, BRANCHING, HOPF}:
        raise ModelError(f"{system.name}: at a {point.kind}, no branch leaves that can be followed")
    interval = _interval(system, by, point.parameter, ends)
    with np.errstate(all="ignore"):  # numbers that are not finite are reported by name
        along = at.tangent * at.sample.unit
        if isinstance(curve, EquilibriumCurve) and point.kind == HOPF:
            cycles, first = oscillating(system, curve, by, at)
            return _of_cycles(system, by, cycles, followed(cycles, (first,), interval, True, max_steps))
        if isinstance(curve, CycleCurve):
            if point.kind == DOUBLING:
                curve, at = doubled(curve, at)
                along = at.tangent * at.sample.unit
            path = followed(curve, crossing(curve, at, along), interval, True, max_steps)
            return _of_cycles(system, by, curve, path)
        path = followed(curve, crossing(curve, at, along), interval, False, max_steps)
        return _of_equilibria(system, by, curve, path)


def _start(cycle: Cycle) -> Vector:
    """Return q (2 n,) of the start of a cycle."""
    c = cycle.system.compiled
    n, every, q = c.n_coordinates, c.n, np.zeros(2 * c.n)
    values = np.array(list(cycle.x0.values()))
    q[:n], q[every + n :] = values[:n], values[n:]
    q[every : every + n] = list(cycle.v0.values())
    return q


def _ends(one: Return, n: int, every: int) -> tuple[Vector, Vector]:
    """Return the largest and the least values of coordinates and states along a motion, between rows by Hermite."""
    s, r = _BETWEEN[:, None, None], 1.0 - _BETWEEN[:, None, None]
    x, v, h = one.rows[:, :n], one.rows[:, every : every + n], np.diff(one.times)[:, None]
    inner = x[:-1] * (1 + 2 * s) * r**2 + x[1:] * (3 - 2 * s) * s**2 + h * s * r * (v[:-1] * r - v[1:] * s)
    states = one.rows[:, every + n :]
    every_x = inner.reshape(-1, n)
    return (np.concatenate([every_x.max(axis=0), states.max(axis=0)]),
            np.concatenate([every_x.min(axis=0), states.min(axis=0)]))  # fmt: skip


def _branch(system: CompiledSystem, along: tuple[str, CycleCurve | EquilibriumCurve], path: Path, rows: Vector,
            periods: Vector, ends: tuple[Vector, Vector]) -> Branch:  # fmt: skip
    names, n, (by, curve) = (*system.coordinates, *system.states), system.n, along
    split = len(names)
    special = tuple(
        SpecialPoint(node.kind, node.parameter, k, _named(names, rows[k, :split]),
                     _named(names[:n], rows[k, split:]), float(periods[k]), node.spectrum.values,
                     Origin(system, curve, by, node.place), node.events)
        for k, node in enumerate(path.nodes) if node.kind
    )  # fmt: skip
    return Branch(
        system, by, isinstance(curve, CycleCurve), path.complete, path.message,
        np.array([node.place.sample.parameter for node in path.nodes]), _columns(names, rows[:, :split]),
        _columns(names[:n], rows[:, split:]), periods, _values(path.nodes),
        tuple(node.spectrum.stable for node in path.nodes), _columns(names, ends[0]), _columns(names, ends[1]), special,
        _free(curve, path),
    )  # fmt: skip


def _free(curve: CycleCurve | EquilibriumCurve, path: Path) -> dict[str, Vector]:
    """Return the values of what is free in cycles beside their starts."""
    if isinstance(curve, EquilibriumCurve):
        return {}
    names = curve.search.unknowns.names
    rows = np.array([node.place.sample.w[len(curve.first.q) + 1 : -1] for node in path.nodes])
    return _columns(names, rows)


def _values(nodes: list[Node]) -> Any:
    """Return (rows, k) values; where there are fewer than elsewhere, the others are not a number."""
    most = max(len(node.spectrum.values) for node in nodes)
    values = np.full((len(nodes), most), np.nan, dtype=complex)
    for row, node in enumerate(nodes):
        values[row, : len(node.spectrum.values)] = node.spectrum.values
    return values


def _named(names: tuple[str, ...], values: Vector) -> dict[str, float]:
    return dict(zip(names, values.tolist(), strict=True))


def _columns(names: tuple[str, ...], rows: Vector) -> dict[str, Vector]:
    return {name: rows[:, k] for k, name in enumerate(names)}
