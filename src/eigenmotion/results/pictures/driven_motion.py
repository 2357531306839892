"""Picture of a driven motion: coordinates, forces and powers over time, forces over speeds, and the mechanism."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...presentation.figures import COLOURS, blank, folded, plain_text, uncluttered
from ...presentation.units import on_axis
from .labelled_lines import WIDTH, WIDTH_WITH_DRAWING, draw_lines, label, name_lines
from .moving_shapes import Drawing
from .sketch import draw_motion

Lines = tuple[str, Sequence[str], Vector]
_SPEED = r"\dot{%s}"


def driven_motion(
    name: str,
    along: tuple[str, Vector],
    lines: Sequence[Lines],
    speeds: Mapping[str, tuple[Vector, Vector, str, str]],
    drawing: Drawing | None,
) -> Any:
    """Return the figure.

    Parameters
    ----------
    along
        The label of the axis of the time, and times (k,).
    lines
        For each panel over time its label, the names of its lines, and their values (count, k).
    speeds
        Actuator -> its speed and force, (k,) each, and their units. A ring marks the root of the mean square of the
        force, which heats a motor, and a dot the largest force.
    """
    time, t = along
    beside = bool(speeds) + (drawing is not None)
    heights = [max(2.2, 0.4 + 0.2 * len(names)) for _, names, _ in lines]
    figure = blank(WIDTH_WITH_DRAWING if beside else WIDTH, sum(heights) + 0.6)
    halves = figure.add_gridspec(1, 1 + bool(beside), width_ratios=(8, 4.5)[: 1 + bool(beside)])
    places = halves[0, 0].subgridspec(len(lines), 1, height_ratios=heights)
    axes: Any = None
    for row, (text, names, values) in enumerate(lines):
        axes = figure.add_subplot(places[row, 0], sharex=axes)
        draw_lines(axes, t, values, names)
        name_lines(axes, values[:, -1], names, heights[row])
        axes.set(ylabel=folded(text, heights[row]), title=name.replace("_", " ") if row == 0 else "")
        axes.tick_params(labelbottom=row == len(lines) - 1)
    axes.set_xlabel(time)
    if t[0] != t[-1]:
        axes.set_xlim(t[0], t[-1])
    right: Any = halves[0, 1].subgridspec(beside, 1) if beside else None
    if drawing is not None:
        draw_motion(figure, right[0, 0], drawing)
    if speeds:
        _over_speeds(figure.add_subplot(right[beside - 1, 0]), speeds)
    return figure


def _over_speeds(axes: Any, speeds: Mapping[str, tuple[Vector, Vector, str, str]]) -> None:
    """Draw the force of each actuator over its speed: what its motor must be able to give."""
    for (name, (speed, force, *_)), colour in zip(speeds.items(), COLOURS * len(speeds), strict=False):
        axes.plot(speed, force, color=colour, linewidth=1.6, label=label(name))
        peak = int(np.abs(force).argmax())
        axes.plot(speed[peak], force[peak], "o", color=colour, markersize=5)
        axes.plot(
            np.sqrt(np.mean(speed**2)), np.sqrt(np.mean(force**2)), "o", color=colour, fillstyle="none", markersize=7
        )
    axes.axvline(0.0, color="0.6", linewidth=0.8, zorder=0)
    uncluttered(axes)
    one = label(next(iter(speeds))) if len(speeds) == 1 else None
    units = {tuple(map(plain_text, of)) for _, _, *of in speeds.values()}
    words = (f"speed of {one}", f"force on {one}") if one else ("speeds", "forces")
    axes.set(**{f"{axis}label": on_axis(word, unit) for axis, word, unit in
                zip("xy", words, units.pop() if len(units) == 1 else ("", ""), strict=True)})  # fmt: skip
    if one is None:
        axes.legend(frameon=False)
