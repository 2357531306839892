"""Lines with a style, markers and their names at their ends, so that they can be told apart without colour."""

import re
from collections.abc import Sequence
from itertools import cycle
from typing import Any

import numpy as np
from sympy import Symbol, latex

from ...arguments.named_values import Vector
from ...presentation.figures import COLOURS, STYLES, plain_text, spread_labels, uncluttered

WIDTH, WIDTH_WITH_DRAWING = 7.5, 9.0  # [inch], so that type is legible where a page is 700 pixels wide
MARKERS = ("o", "s", "^", "D", "v")
_MARKS = 8  # markers on each line
_DOTS = {1: "dot", 2: "ddot"}
_LINE = 0.18  # [inch] between names
_WORD = 3  # letters from which a name is a word, not a symbol


def draw_lines(axes: Any, t: Vector, x: Vector, names: Sequence[str]) -> None:
    """Draw each line with its own colour, style and marker; the combination repeats after 140 lines."""
    looks = zip(names, x, cycle(COLOURS), cycle(STYLES), cycle(MARKERS), strict=False)
    for k, (name, row, colour, style, marker) in enumerate(looks):
        offset = (k + 0.5) / (_MARKS * len(names))  # so that markers of different lines do not coincide
        place = (offset, 1 / _MARKS) if t[0] != t[-1] else None
        axes.plot(t, row, style, color=colour, marker=marker, markevery=place, markersize=5, linewidth=1.6, label=name)
    uncluttered(axes)


def name_lines(axes: Any, last: Vector, names: Sequence[str], height: float) -> None:
    """Write each name, with a piece of its line, behind the end of the line; names of close ends are moved apart.

    last : (count,) values at the right end
    height : of the axes [inch]
    """
    from matplotlib.lines import Line2D  # noqa: PLC0415, an optional package

    low, high = axes.get_ylim()
    ends = np.clip(np.nan_to_num((last - low) / (high - low)), 0.0, 1.0)
    gap = min(_LINE / height, 1 / len(names))
    for line, name, end, place in zip(list(axes.get_lines()), names, ends, spread_labels(ends, gap), strict=True):
        look = {"color": line.get_color(), "transform": axes.transAxes, "clip_on": False}
        style = {"linestyle": line.get_linestyle(), "marker": line.get_marker(), "markevery": [1], "markersize": 5}
        axes.add_line(Line2D([1.0, 1.03], [end, place], linewidth=0.6, **look))
        axes.add_line(Line2D([1.03, 1.055, 1.08], [place] * 3, linewidth=1.6, **style, **look))
        axes.text(1.09, place, label(name), va="center", **look)


def label(name: str) -> str:
    """Return a name as mathematics, a rate with a dot; words, and what matplotlib cannot parse, as plain text."""
    from matplotlib.mathtext import MathTextParser  # noqa: PLC0415, an optional package

    symbol = name.rstrip("'")
    written = latex(Symbol(symbol))
    if "\\" not in written and len(re.split("[^A-Za-z]", symbol)[0]) >= _WORD:
        return plain_text(name)
    dotted = written if symbol == name else rf"\{_DOTS.get(len(name) - len(symbol), '')}{{{written}}}"
    try:
        MathTextParser("path").parse(f"${dotted}$")
    except ValueError:
        return plain_text(name)
    return f"${dotted}$"
