"""Picture of branches: solid where motions are stable, dashed where they are not, bifurcations marked."""

from dataclasses import dataclass
from typing import Any

from ...arguments.named_values import Vector
from ...presentation.figures import BLACK, BLUE, GREEN, ORANGE, PURPLE, VERMILION, blank, plain_text, uncluttered

_MARKS = {
    "fold": ("v", ORANGE), "branch point": ("D", GREEN), "Hopf": ("o", VERMILION), "doubling": ("s", PURPLE),
    "torus": ("^", BLACK), "flutter": ("P", BLACK), "corner": ("<", BLACK), "grazing": ("X", VERMILION),
    "mode change": ("X", BLACK),
}  # fmt: skip
_LOOKS = {True: ("-", BLUE, "stable"), False: ("--", VERMILION, "unstable"), None: (":", BLACK, "undecided")}


@dataclass(frozen=True)
class Line:
    """A curve over the parameter. x, y : (rows,); stable : (rows,); marks : rows and kinds of bifurcations"""

    x: Vector
    y: Vector
    stable: tuple[bool | None, ...]
    marks: list[tuple[int, str]]


def drawn(title: str, name: str, label: str, lines: list[Line]) -> Any:
    """Return the figure of all lines."""
    figure = blank(6.4, 4.4)
    axes = figure.add_subplot()
    uncluttered(axes)
    seen: dict[str, Any] = {}
    for line in lines:
        for rows, stable in _pieces(line):
            style, colour, words = _LOOKS[stable]
            [seen[words]] = axes.plot(line.x[rows], line.y[rows], style, color=colour, lw=1.6)
    for line in lines:
        for row, kind in line.marks:
            mark, colour = _MARKS[kind]
            [seen[kind]] = axes.plot(line.x[row], line.y[row], mark, color=colour, mec="white", ms=8, ls="none")
    axes.set(xlabel=plain_text(name), ylabel=plain_text(label))
    axes.set_title(plain_text(title), loc="left", fontsize="medium")
    axes.legend(seen.values(), seen.keys(), frameon=False)
    return figure


def _pieces(line: Line) -> list[tuple[slice, bool | None]]:
    """Return the rows of pieces of equal stability: a piece between two rows has that of its inner points."""
    kinds = [_between(line, k) for k in range(len(line.x) - 1)]
    pieces, first = list[tuple[slice, bool | None]](), 0
    for k in range(1, len(kinds) + 1):
        if k == len(kinds) or kinds[k] is not kinds[first]:
            pieces.append((slice(first, k + 1), kinds[first] if kinds else line.stable[0]))
            first = k
    return pieces


def _between(line: Line, k: int) -> bool | None:
    """Return the stability between two rows; a single one at which it is undecided does not count."""
    a, b = line.stable[k], line.stable[k + 1]
    if a is None or b is None:
        return a if b is None else b
    return a if a is b else None
