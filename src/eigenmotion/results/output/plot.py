"""Plot of a solution; needs the extra `plot` (matplotlib)."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...compiled.compiled_system import CompiledSystem
from ...presentation.figures import blank, plain_text
from ..pictures.labelled_lines import draw_lines, name_lines
from ..pictures.moving_shapes import Drawing
from ..pictures.sketch import draw_motion
from ..solution import Solution

_FEW = 30  # the most events that get a line across the picture, which more would hide


def coordinates(system: CompiledSystem, solution: Solution) -> Any:
    """Return a figure of x and states over t, with a row for each event below, and the mechanism on the right.

    Each line has a style, markers and its name at its end, so that it can be told apart without its colour. The unit of
    time is the second; the units of the coordinates are not known here.
    """
    rows = len(system.events)
    names = (*system.coordinates, *system.states)
    heights = [max(4.0, 0.5 + 0.2 * len(names)), *([0.2 * rows + 0.05] if rows else [])]
    drawn = _drawn(solution)
    figure = blank(8 if drawn is None else 12.5, sum(heights) + 0.6)
    places = figure.add_gridspec(len(heights), 1 if drawn is None else 2, height_ratios=heights,
                                 width_ratios=(8,) if drawn is None else (8, 4.5))  # fmt: skip
    axes = figure.add_subplot(places[0, 0])
    strip = [figure.add_subplot(places[1, 0], sharex=axes)] if rows else []
    axes.tick_params(labelbottom=not strip)
    t, x = _smooth(system, solution)
    draw_lines(axes, t, x, names)
    name_lines(axes, x, names)
    axes.set(ylabel="coordinates and states" if system.states else "coordinates", title=system.name.replace("_", " "))
    for events in strip:
        _draw_events(events, axes, system.events, solution.t_events)
    if t[0] != t[-1]:
        axes.set_xlim(t[0], t[-1])
    figure.axes[-1].set_xlabel("time $t$ [s]")
    if drawn is not None:
        draw_motion(figure, places[:, 1], drawn)
    return figure


def _drawn(solution: Solution) -> Drawing | None:
    if solution.drawing is None or not len(solution.t):
        return None
    return solution.drawn(np.linspace(solution.t[0], solution.t[-1], 600))


def _draw_events(strip: Any, axes: Any, names: Sequence[str], times: Sequence[Vector] | None) -> None:
    """Draw a row of ticks for each event, and lines across the picture if events are few."""
    data = [np.asarray(row) for row in times] if times is not None else [np.empty(0)] * len(names)
    strip.eventplot(data, lineoffsets=range(len(names)), linelengths=0.8, colors="black", linewidths=1.2, clip_on=False)
    strip.set(yticks=range(len(names)), yticklabels=list(map(plain_text, names)), ylim=(len(names) - 0.5, -0.5))
    strip.tick_params(axis="y", length=0)
    strip.spines[["top", "right", "left"]].set_visible(False)
    if sum(map(len, data)) <= _FEW:
        for time in np.concatenate(data):
            axes.axvline(time, color="0.6", linewidth=0.8, linestyle=(0, (1, 2)), zorder=0)


def _smooth(system: CompiledSystem, solution: Solution) -> tuple[Vector, Vector]:
    """Return t (k,) and x, states (n + p, k): 2000 points of a dense solution, else the rows."""
    if solution.sol is None:
        return solution.t, np.vstack([solution.x, *solution.states.values()])
    t = np.linspace(solution.t[0], solution.t[-1], 2000)
    rows = solution.sol(t)
    return t, np.vstack([rows[system.layout["x"]], rows[system.layout.get("z", slice(0))]])
