"""Picture of a run: quantities over time, events, and the mechanism; needs the extra `plot` (matplotlib)."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...presentation.figures import BLUE, blank, folded, plain_text, uncluttered
from .labelled_lines import WIDTH, WIDTH_WITH_DRAWING, draw_lines, label, name_lines
from .moving_shapes import Drawing
from .sketch import draw_motion

Panel = tuple[str, Mapping[str, Vector]]
"""The label of a vertical axis, and name -> (k,) of its lines"""
_FEW = 30  # the most events that get a line across the picture, which more would hide


def motion_over_time(
    title: str,
    t: tuple[str, Vector],
    panels: Sequence[Panel],
    events: Mapping[str, Vector],
    drawn: Drawing | None,
) -> Any:
    """Return a figure of panels over time, with a row for each event below, and the mechanism on the right.

    Each line has a style, markers and its name at its end, so that it can be told apart without its colour.

    Parameters
    ----------
    t
        The label of the axis, and times (k,).
    events
        Name -> the times at which it happened.
    """
    heights = _heights(panels, len(events))
    figure = blank(WIDTH if drawn is None else WIDTH_WITH_DRAWING, sum(heights) + 0.6)
    places = figure.add_gridspec(len(heights), 1 if drawn is None else 2, height_ratios=heights,
                                 width_ratios=(1,) if drawn is None else (2, 1))  # fmt: skip
    axes: list[Any] = []
    for row, panel in enumerate(panels):
        axes.append(figure.add_subplot(places[row, 0], sharex=axes[0] if axes else None))
        _draw_panel(axes[-1], t[1], panel, heights[row])
    strip = [figure.add_subplot(places[len(panels), 0], sharex=axes[0])] if events else []
    for events_axes in strip:
        _draw_events(events_axes, axes, events)
    _finish([*axes, *strip], t, title)
    if drawn is not None:
        draw_motion(figure, places[:, 1], drawn)
    return figure


def _heights(panels: Sequence[Panel], events: int) -> list[float]:
    """Return the heights of the panels and of the rows of events [inch]: a single panel is larger."""
    least = 4.0 if len(panels) == 1 else 2.8 if len(panels) == 2 else 2.0
    heights = [max(least, 0.5 + 0.2 * len(lines)) for _, lines in panels]
    return [*heights, *([0.2 * events + 0.05] if events else [])]


def _draw_panel(axes: Any, t: Vector, panel: Panel, height: float) -> None:
    """Draw the lines of a panel; a single line whose name is in the label of the axis is not named twice."""
    text, lines = panel
    axes.set_ylabel(folded(text, height))
    name = next(iter(lines))
    if len(lines) == 1 and (text.startswith(label(name)) or text.endswith(f" of {plain_text(name)}")):
        axes.plot(t, *lines.values(), color=BLUE, linewidth=1.6, label=next(iter(lines)))
        uncluttered(axes)
        return
    values = np.vstack([*lines.values()])
    draw_lines(axes, t, values, tuple(lines))
    name_lines(axes, values[:, _right_end(t)], tuple(lines), height)


def _right_end(t: Vector) -> int:
    """Return the row at the right: the last one over the time, the largest value over a coordinate that turns back."""
    steps = np.diff(t)
    return -1 if (steps >= 0.0).all() or (steps <= 0.0).all() else int(np.argmax(t))


def _finish(axes: Sequence[Any], along: tuple[str, Vector], title: str) -> None:
    text, t = along
    axes[0].set_title(title)
    for one in axes[:-1]:
        one.tick_params(labelbottom=False)
    if t[_right_end(t)] == t[-1] != t[0]:
        axes[0].set_xlim(t[0], t[-1])
    elif t.min() != t.max():
        axes[0].set_xlim(t.min(), t.max())
    axes[-1].set_xlabel(text)
    axes[0].get_figure().align_ylabels(axes)


def _draw_events(strip: Any, axes: Sequence[Any], events: Mapping[str, Vector]) -> None:
    """Draw a row of ticks for each event, and lines across the panels if events are few."""
    data, names = [np.asarray(times) for times in events.values()], tuple(events)
    strip.eventplot(data, lineoffsets=range(len(names)), linelengths=0.8, colors="black", linewidths=1.2, clip_on=False)
    strip.set(yticks=range(len(names)), yticklabels=list(map(plain_text, names)), ylim=(len(names) - 0.5, -0.5))
    strip.tick_params(axis="y", length=0)
    strip.spines[["top", "right", "left"]].set_visible(False)
    if sum(map(len, data)) <= _FEW:
        for one in axes:
            for time in np.concatenate(data):
                one.axvline(time, color="0.6", linewidth=0.8, linestyle=(0, (1, 2)), zorder=0)
