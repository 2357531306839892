"""What the pictures share: axes, direct labels, files. Needs the extra `plot` (matplotlib)."""

from __future__ import annotations

import io
from itertools import pairwise
from pathlib import Path
from typing import Any

from ..arguments.names import Vector
from ..files import write
from ..results.plot import COLOURS, require_matplotlib

WIDTH, HEIGHT = 7.5, 4.2
FAINT = "0.88"


def axes(title: str, ylabel: str) -> tuple[Any, Any]:
    """Return a figure and its only axes, over the time."""
    require_matplotlib()
    from matplotlib.figure import Figure  # noqa: PLC0415, an optional package

    figure = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
    ax = figure.add_subplot()
    ax.set(xlabel="$t$ [s]", ylabel=ylabel, xlim=(0, 10))
    ax.set_title(title, loc="left", fontsize=11)
    ax.grid(color=FAINT)
    ax.spines[["top", "right"]].set_visible(False)
    return figure, ax


def draw(ax: Any, t: Vector, rows: list[tuple[str, Vector]], styles: tuple[str, ...] = ("-",)) -> None:
    """Draw one line a row, each with its name at its right end, names kept apart."""
    for k, (name, values) in enumerate(rows):
        ax.plot(t, values, styles[k % len(styles)], color=COLOURS[k], linewidth=1.6, label=name)
    low, high = ax.get_ylim()
    heights = _apart([float(values[-1]) for _, values in rows], 0.065 * (high - low))
    for k, ((name, _), height) in enumerate(zip(rows, heights, strict=True)):
        ax.annotate(name, (t[-1], height), (6, 0), textcoords="offset points", va="center", color=COLOURS[k],
                    annotation_clip=False)  # fmt: skip


def _apart(heights: list[float], least: float) -> list[float]:
    """Move heights until neighbours are `least` apart, about where they were."""
    order = sorted(range(len(heights)), key=heights.__getitem__)
    moved = list(heights)
    for _ in range(50):
        for below, above in pairwise(order):
            lack = least - (moved[above] - moved[below])
            if lack > 0:
                moved[below], moved[above] = moved[below] - lack / 2, moved[above] + lack / 2
    return moved


def save(figure: Any, path: Path) -> Path:
    """Write a figure to a file, in full or not at all."""
    picture = io.BytesIO()
    figure.savefig(picture, format=path.suffix[1:], dpi=150)
    write(path, picture.getvalue())
    return path
