"""Path of a run: its rows and events in order of time, with the states before and after changes of the state.

These are event actions and changes of rotation parameters.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from ...arguments.tasks import Task
from ...results.solution import Solution
from ...runtime import Prepared, Run
from ...runtime.checkpoints import CheckpointedRun

Occurrence = tuple[int, int]
"""(number of an event, number of its occurrence)"""

CHART_CHANGE = -1
"""In place of the number of an event: a change of rotation parameters (EM_CHART_CHANGE of em_variation_pass.h)."""
Charts = tuple[Vector, Vector, Vector]
"""`Run.charts`."""

_NONE = np.empty(0, dtype=int)


class Path(NamedTuple):
    """The nodes of a run in the order of time; each time has one node, and a change of the state adds that after it.

    t : (k,); z : (k, 2 n) x and v; without events, rows at equal times have separate nodes
    mark_row, mark_event : (marks,) the node of an occurrence, and its event or CHART_CHANGE; if the state changes, the
    next node is that after it
    of_rows : the node of each row of the run; of_events : the marks (e,) of each event
    prepared : the prepared parameters in the mode of the first node
    """

    t: Vector
    z: Vector
    mark_row: NDArray[np.int_]
    mark_event: NDArray[np.int_]
    of_rows: NDArray[np.int_]
    of_events: list[NDArray[np.int_]]
    prepared: Prepared


def path_of(task: Task, solution: Solution, run: Run | None = None) -> Path:
    """Return the path of a solution; `run`: its run, if that is not the one of its dense output."""
    run = run or dense_run(solution)
    start, prepared = _start(task, run)
    charts = charts_of(run)
    if not any(map(len, (*(solution.t_events or ()), charts[0]))):
        return _undisturbed(task, solution, start, prepared)
    times, states, marks = _added_nodes(task, solution, charts)
    sign = 1.0 if task.t_end >= task.t_start else -1.0
    t = np.concatenate([[task.t_start], solution.t, times])
    y = np.concatenate([start[None], solution.y.T, states])
    first = len(t) - len(times)
    order = np.lexsort((np.arange(len(t)), np.arange(len(t)) < first, sign * t))
    seen: set[float] = set(times.tolist())
    nodes = [k for k in order.tolist() if k >= first or not (t[k] in seen or seen.add(t[k]))]  # type: ignore[func-returns-value]
    place = {k: node for node, k in enumerate(nodes)}
    t, y = t[nodes], y[nodes]
    mark_row = np.array([place[first + at] for at, _ in marks], dtype=int)
    keep = np.argsort(mark_row, kind="stable")
    of_event = {mark: number for number, mark in enumerate(marks[k][1] for k in keep)}
    counts = [len(each) for each in solution.t_events or ()]
    return Path(
        t, rows_of_motion(task, t, np.ascontiguousarray(y)), mark_row[keep],
        np.array([marks[k][1][0] for k in keep], dtype=int), _of_rows(t, solution.t, task.t_eval is None),
        [np.array([of_event[event, time] for time in range(count)], dtype=int) for event, count in enumerate(counts)],
        prepared,
    )  # fmt: skip


def _undisturbed(task: Task, solution: Solution, start: Vector, prepared: Prepared) -> Path:
    """Return the path of a solution without events."""
    t, y = solution.t, solution.y.T
    first = 0 if len(t) and t[0] == task.t_start else 1
    if first:
        t, y = np.concatenate(((task.t_start,), t)), np.concatenate((start[None], y))
    events = [_NONE for _ in solution.t_events or ()]
    return Path(t, rows_of_motion(task, t, y), _NONE, _NONE, np.arange(first, len(t)), events, prepared)


def rows_of_motion(task: Task, t: Vector, y: Vector) -> Vector:
    """Return z (k, 2 n) = x, v of states y (k, n_state)."""
    return np.concatenate((y[:, : task.model.n], task.model.velocity_rows(t, y, task.prepared)), axis=1)


def _start(task: Task, run: Run | None) -> tuple[Vector, Prepared]:
    """Return y (n_state,) and the prepared parameters in the mode in which the run starts.

    They are the run's own: a velocity that is rounding may count as zero there, in a friction that sticks.
    """
    if isinstance(run, CheckpointedRun):
        return run.checkpoints[0].y, run.checkpoints[0].prepared
    if run is None or not run.segments:
        return task.y, task.prepared
    y = run.interpolate(np.array([task.t_start]))[0] if run.n_dense else task.y
    return y, task.model.prepare(np.array(run.segments[0][2]))


def dense_run(solution: Solution) -> Run | None:
    """Return the run with its dense output; None if it has no steps."""
    run = getattr(getattr(solution.get("sol"), "_rows_at", None), "__self__", None)
    return run if isinstance(run, Run) else None


def charts_of(run: Run | None) -> Charts:
    """Return the changes of rotation parameters of a run with dense output."""
    return run.charts if run else (np.empty(0), np.empty((0, 0)), np.empty((0, 0)))


def _added_nodes(task: Task, solution: Solution, charts: Charts) -> tuple[Vector, Vector, list[tuple[int, Occurrence]]]:
    """Return the times and states that events and changes add to a path, in order, and where each occurrence is."""
    c, states = task.model, [*(solution.y_events or []), charts[1]]
    after = [*((solution.y_after_events if c.acts else None) or states[:-1]), charts[2]]
    at_once: dict[float, list[Occurrence]] = {}
    for event, times in (*enumerate(solution.t_events or ()), (CHART_CHANGE, charts[0])):
        for time, t in enumerate(times.tolist()):
            at_once.setdefault(t, []).append((event, time))
    t_added: list[float] = []
    added: list[Vector] = []
    marks: list[tuple[int, Occurrence]] = []
    for t, occurrences in at_once.items():
        # an event that ended the run has no state after it
        acted = [(k, time) for k, time in occurrences if (k == CHART_CHANGE or c.acting[k]) and time < len(after[k])]
        groups = _in_turns(acted, states, after)
        others = [one for one in occurrences if one not in acted]
        marks += [(len(added), one) for one in others]
        t_added.append(t)
        added.append(
            states[occurrences[0][0]][occurrences[0][1]] if not groups else states[groups[0][0][0]][groups[0][0][1]]
        )
        for group in groups:
            marks += [(len(added) - 1, one) for one in group]
            t_added.append(t)
            added.append(after[group[0][0]][group[0][1]])
    return np.array(t_added), np.array(added).reshape(-1, c.n_state), marks


def _in_turns(
    occurrences: list[Occurrence], states: Sequence[Vector], after: Sequence[Vector]
) -> list[list[Occurrence]]:
    """Return the occurrences at one time in groups that act together, each on the state after the previous group."""
    groups: dict[bytes, list[Occurrence]] = {}
    for event, time in occurrences:
        groups.setdefault(states[event][time].tobytes(), []).append((event, time))
    added = {before: after[group[0][0]][group[0][1]].tobytes() for before, group in groups.items()}
    turn = next((before for before in groups if before not in added.values()), None)
    ordered = []
    while turn in groups:
        ordered.append(groups.pop(turn))
        turn = added[turn]
    return ordered + list(groups.values())


def _of_rows(t: Vector, rows: Vector, every_step: bool) -> NDArray[np.int_]:
    """Return the node of each row. Rows at equal times have a node each if every step has a row; else the first."""
    first: dict[float, int] = {}
    for node, time in enumerate(t.tolist()):
        first.setdefault(time, node)
    nodes, last = [], -1
    for time in rows.tolist():
        again = every_step and last >= 0 and t[last] == time and last + 1 < len(t) and t[last + 1] == time
        last = last + 1 if again else first[time]
        nodes.append(last)
    return np.array(nodes, dtype=int)
