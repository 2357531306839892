"""Axes and line labels of the figures."""

from __future__ import annotations

from typing import Any

from ..arguments.named_values import Vector
from ..presentation.figures import COLOURS, blank, spread_labels, uncluttered

WIDTH, HEIGHT = 7.5, 4.2
FAINT = "0.88"


def axes(title: str, ylabel: str) -> tuple[Any, Any]:
    """Return a figure with one pair of axes over time."""
    figure = blank(WIDTH, HEIGHT)
    ax = figure.add_subplot()
    ax.set(xlabel="$t$ [s]", ylabel=ylabel, xlim=(0, 10))
    ax.set_title(title, loc="left", fontsize=11)
    uncluttered(ax, FAINT)
    return figure, ax


def draw(ax: Any, t: Vector, rows: list[tuple[str, Vector]], styles: tuple[str, ...] = ("-",)) -> None:
    """Draw one line for each row, with its name at its right end; names do not overlap."""
    for k, (name, values) in enumerate(rows):
        ax.plot(t, values, styles[k % len(styles)], color=COLOURS[k], linewidth=1.6, label=name)
    low, high = ax.get_ylim()
    ends = spread_labels([(values[-1] - low) / (high - low) for _, values in rows], 0.065)
    for k, ((name, _), end) in enumerate(zip(rows, ends, strict=True)):
        place = t[-1], low + end * (high - low)
        ax.annotate(name, place, (6, 0), textcoords="offset points", va="center", color=COLOURS[k],
                    annotation_clip=False)  # fmt: skip
