"""Pictures of charts, as PNG and SVG: labels at the ends of curves, type that is read at 400 pixels of width."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...presentation.figures import Picture, blank, picture, plain_text, spread_labels, uncluttered
from .chart import Chart, Line
from .looks import dashes, ink
from .ticks import height_in_words, heights_to_label, powers_of_ten

_WIDTH, _HEIGHT, _TYPE = 6.2, 5.0, 11  # [inch, inch, point]: 10 pixels of type on a phone of 400
_ROW = 1.3 * _TYPE / 72  # [inch]


def pictures(charts: Sequence[Chart], everything: bool = False) -> tuple[Picture, ...]:
    """Draw the few curves of each chart, or all."""
    return tuple(picture(figure_of(chart, everything), chart.stem, chart.title, chart.text) for chart in charts)


def figure_of(chart: Chart, everything: bool = False) -> Any:
    """Return the figure of a chart."""
    lines = chart.lines(everything)
    height = max(_HEIGHT, _ROW * (len(lines) + 6))
    figure = blank(_WIDTH, height)
    figure.set_layout_engine("none")
    letters = max((len(line.label) for line in lines), default=0)
    right = 1 - (0.56 * _TYPE / 72 * letters + 0.4) / _WIDTH
    axes = figure.add_axes((0.8 / _WIDTH, 0.6 / height, right - 0.8 / _WIDTH, 1 - 1.1 / height))
    first, last, low, high = chart.limits(lines)
    axes.set(xscale="log", yscale="log", xlim=(first, last), ylim=(low, high))
    for line in lines:
        _draw(axes, chart, line, 3.2 if everything else 4.5)
    _finish(axes, chart)
    _label(axes, lines, _ROW / (height - 1.1))
    return figure


def _draw(axes: Any, chart: Chart, line: Line, size: float) -> None:
    errors, heights, runs = zip(*line.points, strict=True)
    colour, on_off = ink(line.kind).light, dashes(line.method)
    axes.plot(errors, heights, color=colour, linestyle=(0, on_off) if on_off else "-", marker="o", markersize=size,
              linewidth=1.5, clip_on=False, label=line.label)  # fmt: skip
    if chart.is_time:
        low, high = [m.seconds_low or m.seconds for m in runs], [m.seconds_high or m.seconds for m in runs]
        axes.vlines(errors, low, high, color=colour, linewidth=1, alpha=0.5)
    for error, height, m in line.points:
        if m == chart.recommended:
            axes.plot([error], [height], "o", markersize=13, markerfacecolor="none", markeredgecolor="0.1", zorder=5)


def _finish(axes: Any, chart: Chart) -> None:
    from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator  # noqa: PLC0415, an optional package

    first, last = axes.get_xlim()
    if chart.own > last:
        axes.axvspan(last, chart.own, color="0.93", zorder=-1)
    inches = axes.get_position().width * _WIDTH
    axes.xaxis.set_major_locator(FixedLocator(powers_of_ten(last, first, inches * 72 / (4.2 * _TYPE))))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda error, _: f"{error:.0e}"))
    axes.yaxis.set_major_locator(FixedLocator(heights_to_label(*axes.get_ylim())))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda height, _: height_in_words(height, chart.is_time)))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_locator(NullLocator())
    axes.tick_params(labelsize=_TYPE, length=0)
    axes.set_xlabel("largest error, more accurate to the right", fontsize=_TYPE, loc="right")
    uncluttered(axes, linewidth=0.8)
    axes.set_axisbelow(True)
    _request(axes, chart)
    axes.figure.text(0.02, 1 - 0.08 / axes.figure.get_figheight(), f"{_name(chart)}, {chart.height}",
                     va="top", fontsize=_TYPE + 1)  # fmt: skip


def _request(axes: Any, chart: Chart) -> None:
    """Mark the requested error, if the axis has it."""
    first, last = axes.get_xlim()
    if not last <= chart.requested <= first:
        return
    words = f"requested: {chart.requested:g}"
    share = float(np.log(first / chart.requested) / np.log(first / last))
    half = 0.56 * _TYPE / 72 * len(words) / 2 / (axes.get_position().width * _WIDTH)
    axes.axvline(chart.requested, color="0.4", linewidth=1, linestyle=(0, (5, 4)), zorder=0)
    axes.text(min(max(share, half), 1 - half), 1.02, words, transform=axes.transAxes, ha="center", color="0.35",
              fontsize=_TYPE)  # fmt: skip


def _name(chart: Chart) -> str:
    """Return the name of the model, shortened so that it fits."""
    name = chart.stem.rpartition("_")[0]
    return plain_text(name if len(name) <= 32 else f"{name[:31]}\N{HORIZONTAL ELLIPSIS}")


def _label(axes: Any, lines: Sequence[Line], gap: float) -> None:
    """Label curves at the right, as near to their ends as they do not overlap, and lead to the ends."""
    if not lines:
        return
    shares = [axes.transAxes.inverted().transform(axes.transData.transform(line.end)) for line in lines]
    places = spread_labels([y for _, y in shares], gap)
    for line, (x, y), place in zip(lines, shares, places, strict=True):
        colour = ink(line.kind).light
        axes.plot([x, 1.015, 1.05], [y, place, place], transform=axes.transAxes, color=colour, linewidth=0.9,
                  alpha=0.6, clip_on=False)  # fmt: skip
        axes.text(1.065, place, plain_text(line.label), transform=axes.transAxes, va="center", fontsize=_TYPE)
