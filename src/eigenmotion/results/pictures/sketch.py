"""Sketch of a drawing with matplotlib; needs the extra `plot`."""

from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...presentation.figures import BLACK, BLUE, SKY, VERMILION, plain_text
from ...presentation.units import Units, on_axis, time_unit, unit_of
from .moving_shapes import Drawing
from .outlines import Outlines, outlines

_GREY = "0.75"
_GHOSTS = 6
_TICKS = 3  # of the longest side of a box in space


class Sketch:
    """A drawing on its own axes; `show` moves it to a row.

    Parameters
    ----------
    figure, place
        A matplotlib figure, and the argument of `add_subplot` for the axes.
    """

    def __init__(self, figure: Any, place: Any, drawing: Drawing, title: str = "") -> None:
        self.drawing = drawing
        self.axes = _framed(figure, place, drawing)
        self.axes.set_title(title)
        width = {"faces": 0.8, "wheels": 1.4, "paths": 1.0, "lines": 1.2, "bars": 3.0}
        looks = {"wheels": (BLUE, SKY), "faces": ("0.35", _GREY), "paths": (VERMILION, None),
                 "lines": (BLACK, None), "bars": (BLUE, None)}  # fmt: skip
        self.layers = {
            name: self._layer(*looks[name], linewidth=width[name], zorder=2 + k) for k, name in enumerate(width)
        }

    def _layer(self, edge: str, face: str | None, **look: Any) -> Any:
        from matplotlib.collections import LineCollection, PolyCollection  # noqa: PLC0415, an optional package
        from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection  # noqa: PLC0415

        space = self.drawing.dimension == len("xyz")
        if face is None:
            layer = (Line3DCollection if space else LineCollection)([], colors=edge, capstyle="round", **look)
        elif space:
            layer = Poly3DCollection([np.zeros((3, 3))], facecolors=face, edgecolors=edge, alpha=0.5, **look)
        else:
            layer = PolyCollection([], facecolors=face, edgecolors=edge, **look)
        if space:
            self.axes.add_collection3d(layer, autolim=False)
        else:
            self.axes.add_collection(layer, autolim=False)
        return layer

    def show(self, row: int) -> list[Any]:
        """Draw the mechanism at one row; return the artists that changed."""
        shapes = outlines(self.drawing, row)
        for name, layer in self.layers.items():
            lines = [line for line in getattr(shapes, name) if np.isfinite(line).all()]
            if name in ("wheels", "faces"):
                layer.set_verts(lines)
            else:
                layer.set_segments(lines)
        return list(self.layers.values())

    def ghosts(self, rows: Vector) -> None:
        """Draw bars and springs of other rows in a light colour."""
        for row in rows:
            shapes: Outlines = outlines(self.drawing, int(row))
            for line in (*shapes.bars, *shapes.lines):
                self.axes.plot(*line.T, color="0.85", linewidth=1.0, zorder=1)


def _framed(figure: Any, place: Any, drawing: Drawing) -> Any:
    low, high = drawing.box
    names = [on_axis(name, plain_text(unit_of(drawing.units, "length"))) for name in ("$x$", "$y$", "$z$")]
    if drawing.dimension == len("xy"):
        axes = figure.add_subplot(place, aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.set(xlabel=names[0], ylabel=names[1])
        axes.spines[["top", "right"]].set_visible(False)
        return axes
    axes = figure.add_subplot(place, projection="3d")
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set(xlabel=names[0], ylabel=names[1], zlabel=names[2])
    axes.set_box_aspect(high - low, zoom=0.85)  # room for the names of the axes, which the layout does not know
    axes.tick_params(labelsize=9)
    for axis, side in zip((axes.xaxis, axes.yaxis, axes.zaxis), high - low, strict=True):
        axis.pane.set_facecolor("0.97")
        axis.set_major_locator(_few(max(1, round(_TICKS * side / (high - low).max()))))
    return axes


def _few(count: int) -> Any:
    from matplotlib.ticker import MaxNLocator  # noqa: PLC0415, an optional package

    return MaxNLocator(count, min_n_ticks=1)


def at_time(t: float, units: Units) -> str:
    """Return the title of a position."""
    return f"$t$ = {t:g} {plain_text(time_unit(units))}".rstrip()


def draw_motion(figure: Any, place: Any, drawn: Drawing) -> None:
    """Draw the mechanism at the end of a motion, faint copies of earlier positions, and the traces."""
    sketch = Sketch(figure, place, drawn, at_time(drawn.t[-1], drawn.units))
    sketch.axes.set_anchor("N")
    sketch.ghosts(np.linspace(0, len(drawn.t) - 1, _GHOSTS, dtype=int)[:-1])
    sketch.show(len(drawn.t) - 1)
