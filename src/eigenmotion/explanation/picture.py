"""Picture of what is computed and left out: M with its blocks, A, terms, states and operations."""

from collections.abc import Sequence
from typing import Any

from ..codegen.anatomy import Variation
from ..codegen.equations.specialise import Block
from ..presentation.figures import BLUE, SKY, VERMILION, blank, plain_text
from ..presentation.units import on_axis, unit_of
from .savings import Savings
from .sentences import sentences, short

_WIDTH, _TYPE = 6.2, 11.0  # [inch], [point]: 10 pixels of type on a phone of 400
_LINE = 1.35 * _TYPE / 72  # [inch]
_LETTER = 0.6 * _TYPE / 72  # [inch]
_FILL = {Variation.CONSTANT: SKY, Variation.OF_TIME: "#7a9cc6", Variation.VARYING: BLUE}
_KEY = (("varies", BLUE), ("of time alone", "#7a9cc6"), ("constant", SKY), ("zero", "white"), ("block", VERMILION))


def figure(found: Savings) -> Any:
    """Return the figure: matrices above, lines of text below."""
    names = [short(on_axis(name, unit_of(found.units, name))) for name in found.anatomy.names]
    rows = [short(name) for name in found.rows]
    left = max(len(name) for name in (*names, *rows)) * _LETTER + 0.3
    side = min(_WIDTH - left - 0.2, max(1.5, 0.42 * len(names)))
    cell, lines = side / len(names), sentences(found)
    down = cell * len(rows)
    height = left + side + down + 0.35 * bool(rows) + _LINE * (len(lines) + 2.5) + 0.6
    drawn = blank(_WIDTH, height)
    drawn.set_layout_engine("none")
    below = height - left - side - 0.35
    axes = drawn.add_axes((left / _WIDTH, below / height, side / _WIDTH, side / height))
    _matrix(axes, found.anatomy.M, names, names, cell)
    for block in found.anatomy.blocks:
        _outline(axes, block)
    if rows:
        below -= 0.35 + down
        _matrix(drawn.add_axes((left / _WIDTH, below / height, side / _WIDTH, down / height)),
                found.anatomy.A, rows, (), cell)  # fmt: skip
    title = plain_text(f"{short(found.name)}: mass matrix M{', constraint rows A' * bool(rows)}")
    drawn.text(0.02, 1 - 0.1 / height, title, va="top", fontsize=_TYPE + 1, weight="bold")
    _key(drawn, below - 0.35, height)
    for k, (text, weight) in enumerate(lines):
        drawn.text(0.02, (below - 0.35 - _LINE * (k + 1.5)) / height, plain_text(text), fontsize=_TYPE, weight=weight)
    return drawn


def _matrix(
    axes: Any, entries: Sequence[Sequence[Variation]], rows: Sequence[str], columns: Sequence[str], cell: float
) -> None:
    """Draw squares of entries, with the names that fit: all, or every k-th."""
    from matplotlib.patches import Rectangle  # noqa: PLC0415, an optional package

    for i, row in enumerate(entries):
        for j, kind in enumerate(row):
            axes.add_patch(Rectangle((j, i), 1, 1, facecolor=_FILL.get(kind, "white"), edgecolor="0.85", linewidth=0.5))
    every = max(1, -int(-_LINE // cell))
    axes.set(xlim=(-0.05, len(entries[0]) + 0.05), ylim=(len(entries) + 0.05, -0.05))
    axes.set_yticks([k + 0.5 for k in range(0, len(rows), every)], map(plain_text, rows[::every]), fontsize=_TYPE)
    axes.set_xticks([k + 0.5 for k in range(0, len(columns), every)], map(plain_text, columns[::every]),
                    rotation=90, fontsize=_TYPE)  # fmt: skip
    axes.tick_params(length=0, labeltop=True, labelbottom=False)
    axes.spines[:].set_color("0.6")


def _outline(axes: Any, block: Block) -> None:
    """Draw the edges of a block, whose coordinates may lie apart."""
    own = set(block.coordinates)
    for i in own:
        for j in own:
            sides = {(0, -1): ((j, j), (i, i + 1)), (0, 1): ((j + 1, j + 1), (i, i + 1)),
                     (-1, 0): ((j, j + 1), (i, i)), (1, 0): ((j, j + 1), (i + 1, i + 1))}  # fmt: skip
            for (down, right), (x, y) in sides.items():
                if not (i + down in own and j + right in own):
                    axes.plot(x, y, color=VERMILION, linewidth=2, solid_capstyle="projecting", clip_on=False)


def _key(drawn: Any, y: float, height: float) -> None:
    """Draw the meanings of colours in one line."""
    from matplotlib.patches import Rectangle  # noqa: PLC0415, an optional package

    x = 0.12
    for text, colour in _KEY:
        look: dict[str, Any] = {"facecolor": colour, "edgecolor": "0.6", "linewidth": 0.8}
        if text == "block":
            look = {"facecolor": "white", "edgecolor": VERMILION, "linewidth": 2}
        drawn.add_artist(Rectangle((x / _WIDTH, y / height), 0.16 / _WIDTH, 0.16 / height, **look))
        drawn.text((x + 0.24) / _WIDTH, (y + 0.02) / height, text, fontsize=_TYPE)
        x += 0.5 + _LETTER * len(text)
