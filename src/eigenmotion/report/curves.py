"""Pictures: error against run time, against right-hand sides and against the tolerance.

Colours are Okabe and Ito's; each curve also has a marker and a line style of its own, so that none needs its colour.
"""

import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..plot import require_matplotlib
from .examine import Findings
from .recommend import Curve
from .solvers import METHODS, OURS

_LOOKS = {
    "eigenfactor": ("#0072B2", "o", "-"),
    "cholesky": ("#D55E00", "s", "-"),
    "lagrange": ("#009E73", "^", "-"),
    "inverse": ("#CC79A7", "D", "--"),
    "heyoka.py Taylor": ("#000000", "*", "--"),
    "CVODES Adams": ("#E69F00", "P", ":"),
    "CVODES BDF": ("#E69F00", "p", (0, (1, 3))),
    "SciPy DOP853": ("#56B4E9", "v", "-."),
    "SciPy LSODA": ("#56B4E9", "<", "-."),
    "SciPy Radau": ("#56B4E9", ">", "-."),
}
_HOLLOW = "inverse"  # often on top of "lagrange", which must show through
_ERROR = "largest error, max $|x - x_{ref}| / (1 + |x_{ref}|)$"
_BEST = "dop853"


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure in both formats. `stem` is what its files are called, `title` and `text` go with it on the page."""

    stem: str
    title: str
    text: str
    svg: str
    png: bytes


def pictures(found: Findings) -> tuple[Picture, ...]:
    """Draw all of a model's."""
    require_matplotlib()
    return (_against_peers(found), _by_method(found), _convergence(found))


def _against_peers(found: Findings) -> Picture:
    """Everyone on the left; on the right those that our curves can be told from only at a larger scale."""
    figure, panels = _figure(2, 11.0, 5.2)
    chosen = [c for c in found.curves if c.points and (c.family != OURS or c.method == _BEST)]
    for axes, lines in zip(panels, (chosen, _near(chosen)), strict=True):
        for curve in lines:
            _draw(axes, curve, [1e3 * s for s in curve.seconds], curve.errors, spread=True)
        _finish(axes, found, "run time of one call [ms]", _ERROR if axes is panels[0] else "")
    panels[0].set_title(f"{found.name}, {found.ask.t_end:g} s of motion")
    panels[1].set_title("the quick ones, enlarged")
    _legend(figure, panels[0])
    return _picture(
        figure, found, "time", f"{found.name}: error against run time",
        f"Our formulations with {_BEST}, and what else there is. Bars: quartiles of the repeats. Lower left is better.",
    )  # fmt: skip


def _near(curves: Sequence[Curve]) -> list[Curve]:
    """Return ours, and those that never take more than a few times as long as we ever do."""
    longest = max((max(c.seconds) for c in curves if c.family == OURS), default=0.0)
    return [c for c in curves if c.family == OURS or max(c.seconds) < 3 * longest]


def _by_method(found: Findings) -> Picture:
    figure, panels = _figure(len(METHODS), 11.0, 4.6)
    for axes, method in zip(panels, METHODS, strict=True):
        for curve in _ours(found, method):
            _draw(axes, curve, [1e3 * s for s in curve.seconds], curve.errors)
        _finish(axes, found, "run time of one call [ms]", _ERROR if axes is panels[0] else "")
        axes.set_title(method)
    figure.suptitle(f"{found.name}, {found.ask.t_end:g} s of motion")
    _legend(figure, panels[0], below=True)
    return _picture(
        figure, found, "methods", f"{found.name}: formulations by method",
        "The same axes for each of the compiled methods.",
    )  # fmt: skip


def _convergence(found: Findings) -> Picture:
    """Error against steps, where order p is a line of slope -p."""
    figure, panels = _figure(len(METHODS), 11.0, 4.6)
    for axes, (method, order) in zip(panels, METHODS.items(), strict=True):
        lines = _ours(found, method)
        for curve in lines:
            _draw(axes, curve, [p.nsteps or 0 for p in curve.points], curve.errors)
        _guide(axes, lines, order, found.floor)
        _finish(axes, found, "accepted steps", _ERROR if axes is panels[0] else "")
        axes.set_title(f"{method}; grey: order {order}")
    figure.suptitle(f"{found.name}, {found.ask.t_end:g} s of motion")
    _legend(figure, panels[0], below=True)
    return _picture(
        figure, found, "order", f"{found.name}: order of convergence",
        "Error against accepted steps: a method of order p falls along a line of slope -p (grey).",
    )  # fmt: skip


def _ours(found: Findings, method: str) -> list[Curve]:
    return [c for c in found.curves if c.family == OURS and c.method == method]


def _figure(panels: int, width: float, height: float) -> tuple[Any, list[Any]]:
    from matplotlib.figure import Figure  # noqa: PLC0415, an optional package

    figure = Figure(figsize=(width, height), layout="constrained")
    axes = figure.subplots(1, panels, sharey=True, squeeze=False)[0]
    for ax in axes:
        ax.set(xscale="log", yscale="log")
    return figure, list(axes)


def _draw(axes: Any, curve: Curve, x: Sequence[float], y: Iterable[float], spread: bool = False) -> None:
    name = curve.formulation if curve.family == OURS else curve.label
    colour, marker, style = _LOOKS.get(name, ("#666666", "x", "--"))
    heights = [max(e, 1e-17) for e in y]
    look = {"markersize": 7, "markerfacecolor": "none"} if name == _HOLLOW else {"markersize": 4.5}
    axes.plot(x, heights, linestyle=style, color=colour, marker=marker, linewidth=1.3, label=name, **look)
    if spread:
        low, high = ([1e3 * (getattr(p, side) or 0) for p in curve.points] for side in ("seconds_low", "seconds_high"))
        axes.hlines(heights, low, high, color=colour, linewidth=1, alpha=0.5)


def _guide(axes: Any, lines: Sequence[Curve], order: int, floor: float) -> None:
    """A line of the method's slope through the middle of the points it is about."""
    every = [(p.nsteps or 0, p.error_max or 0.0) for curve in lines for p in curve.points]
    points = [(steps, error) for steps, error in every if steps and floor < error < 1e-2]
    if not points:
        return
    steps = sorted(n for n, _ in points)
    at, error = sorted(points)[len(points) // 2]
    axes.plot(steps, [error * (n / at) ** -order for n in steps], color="0.75", linewidth=6, alpha=0.6, zorder=0)


def _finish(axes: Any, found: Findings, xlabel: str, ylabel: str) -> None:
    from matplotlib.ticker import LogLocator  # noqa: PLC0415, an optional package

    axes.set(xlabel=xlabel, ylabel=ylabel)
    axes.axhline(found.ask.error, color="0.4", linewidth=0.9, linestyle=(0, (6, 3)), label="accuracy asked for")
    own = max(float(found.reference.errors.max()), 1e-17)
    errors = [e for c in found.curves for e in c.errors if e > 0] or [found.ask.error]
    low, high = min(errors) / 5, max(errors) * 5
    if own > low:
        axes.axhspan(low, own, color="0.92", zorder=-1, label="below the reference's own error")
    axes.set_ylim(max(low, 1e-17), high)
    axes.yaxis.set_major_locator(LogLocator(numticks=10))
    _label_times(axes)
    axes.grid(color="0.9", linewidth=0.7)
    axes.spines[["top", "right"]].set_visible(False)


def _label_times(axes: Any) -> None:
    """Label few enough of 1, 2, 5, 10, 20, ... in plain numbers that none overlap."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: PLC0415, an optional package

    first, last = axes.get_xlim()
    decades = np.log10(last / first)
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 2 else (1, 3) if decades < 3 else (1,)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())


def _legend(figure: Any, axes: Any, below: bool = False) -> None:
    handles, labels = axes.get_legend_handles_labels()
    if below:
        figure.legend(handles, labels, loc="outside lower center", ncols=len(labels), frameon=False)
    else:
        figure.legend(handles, labels, loc="outside right upper", frameon=False)


def _picture(figure: Any, found: Findings, kind: str, title: str, text: str) -> Picture:
    import matplotlib as mpl  # noqa: PLC0415, an optional package

    stem, svg, png = f"{found.name}_{kind}", io.StringIO(), io.BytesIO()
    # names of its own for clip paths: several pictures share a page
    with mpl.rc_context({"svg.hashsalt": stem, "svg.fonttype": "path"}):
        figure.savefig(svg, format="svg", metadata={"Date": None, "Creator": None})
    figure.savefig(png, format="png", dpi=150)
    return Picture(stem, title, text, svg.getvalue()[svg.getvalue().index("<svg") :], png.getvalue())
