"""Plots of ensembles; need the extra `plot` (matplotlib)."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from ...presentation.figures import BLUE, blank, folded, plain_text, uncluttered
from ...presentation.units import Units, on_axis, time_unit, unit_of_marked

_BAND = (5, 95)  # percentiles
_PANEL = 1.8  # [inch]


def over_time(title: str, names: Sequence[str], t: Vector, x: NDArray[np.float64], units: Units = None) -> Any:
    """Return a figure of x (K, n, nt) over time: the median and the range from 5 to 95 % of the runs."""
    figure = blank(8, 1.0 + _PANEL * len(names))
    axes = figure.subplots(len(names), sharex=True, squeeze=False)[:, 0]
    for k, (name, one) in enumerate(zip(names, axes, strict=True)):
        known = ~np.isnan(x[:, k]).all(axis=0)
        low, middle, high = np.nanpercentile(x[:, k][:, known], [_BAND[0], 50, _BAND[1]], axis=0)
        one.fill_between(t[known], low, high, color=BLUE, alpha=0.25, linewidth=0, label=f"{_BAND[0]} to {_BAND[1]} %")
        one.plot(t[known], middle, color=BLUE, linewidth=1.6, label="median")
        one.set_ylabel(folded(_named(name, units), _PANEL))
        uncluttered(one)
    axes[0].set_title(title)
    axes[0].legend(loc="upper left", frameon=False)
    axes[-1].set_xlabel(on_axis("time $t$", plain_text(time_unit(units))))
    return figure


def over_grid(
    title: str,
    names: Sequence[str],
    grid: Mapping[str, Sequence[float]],
    ends: NDArray[np.float64],
    units: Units = None,
) -> Any:
    """Return a figure of each final coordinate, ends (K, n), over the two values of a grid, the first slowest."""
    (slow, rows), (quick, columns) = grid.items()
    figure = blank(6.5, 0.6 + 4.2 * len(names))
    for k, (name, axes) in enumerate(zip(names, figure.subplots(len(names), squeeze=False)[:, 0], strict=True)):
        values = ends[:, k].reshape(len(rows), len(columns))
        image = axes.pcolormesh(columns, rows, values, shading="nearest", cmap="viridis", rasterized=True)
        axes.set(xlabel=_named(quick, units), ylabel=_named(slow, units), title=title if k == 0 else "")
        figure.colorbar(image, ax=axes, label=_named(name, units, " at the end"))
    return figure


def ends(
    title: str,
    names: Sequence[str],
    swept: Mapping[str, Vector],
    final: NDArray[np.float64],
    units: Units = None,
    sampled: Collection[str] = (),
) -> Any:
    """Return a figure of each final coordinate, final (K, n), over the first swept argument.

    A dot is a run. Over values of a grid, a line joins the medians; over values drawn at random, `sampled`, none does.
    """
    figure = blank(8, 1.0 + _PANEL * len(names))
    axes = figure.subplots(len(names), sharex=True, squeeze=False)[:, 0]
    label, values = next(iter(swept.items()), ("run", np.arange(len(final), dtype=np.float64)))
    for k, (name, one) in enumerate(zip(names, axes, strict=True)):
        one.plot(values, final[:, k], ".", color=BLUE, markersize=3, rasterized=True)
        if swept and label not in sampled:
            at, medians = _medians(np.asarray(values), final[:, k])
            one.plot(at, medians, "o-", color=BLUE, linewidth=1.2, markersize=5, markerfacecolor="white", zorder=3)
        one.set_ylabel(folded(_named(name, units, " at the end"), _PANEL))
        uncluttered(one)
    axes[0].set_title(title)
    kind = "" if not swept else ", sampled" if label in sampled else ", swept: circles are medians"
    axes[-1].set_xlabel(_named(label, units) + kind)
    return figure


def _medians(values: Vector, final: Vector) -> tuple[Vector, Vector]:
    """Return the different values, and the median of the runs at each that have a number."""
    known = values[~np.isnan(final)]
    at = np.unique(known)
    return at, np.array([np.median(final[~np.isnan(final)][known == one]) for one in at])


def _named(name: str, units: Units, more: str = "") -> str:
    """Return a name with its unit; a rate is marked ', and an initial value (0)."""
    return plain_text(on_axis(name + more, unit_of_marked(units, name)))
