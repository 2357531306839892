"""Pictures of error against run time, by solver and method, and against the number of steps.

Each curve has its own marker and line style, so that it can be told apart without its colour.
"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from ..arguments import methods
from ..presentation.figures import BLACK, FORMULATIONS, ORANGE, SKY, Picture, blank, picture, uncluttered
from .examine import Findings
from .recommend import Curve
from .solvers import METHODS, OURS

_WINE = "#882255"  # our implicit methods
_LOOKS: dict[str, tuple[str, str, Any]] = {
    "eigenfactor": (FORMULATIONS["eigenfactor"], "o", "-"),
    "cholesky": (FORMULATIONS["cholesky"], "s", "-"),
    "lagrange": (FORMULATIONS["lagrange"], "^", "-"),
    "inverse": (FORMULATIONS["inverse"], "D", "--"),
    "radau5": (_WINE, "X", "-."),
    "radau9": (_WINE, "d", (0, (5, 1))),
    "heyoka.py Taylor": (BLACK, "*", "--"),
    "CVODES Adams": (ORANGE, "P", ":"),
    "CVODES BDF": (ORANGE, "p", (0, (1, 3))),
    "SciPy DOP853": (SKY, "v", "-."),
    "SciPy LSODA": (SKY, "<", "-."),
    "SciPy Radau": (SKY, ">", "-."),
}
_HOLLOW = "inverse"  # often on top of "lagrange", which must show through
_ERROR = "largest error, max $|x - x_{ref}| / (1 + |x_{ref}|)$"
_BEST, _NODES = "dop853", "ra15"
_GUIDED = methods.METHODS["radau5"].order  # order of the guide line for implicit methods


def pictures(findings: Findings) -> tuple[Picture, ...]:
    """Draw all pictures of a model."""
    return (_against_peers(findings), _by_method(findings), _convergence(findings))


def _against_peers(findings: Findings) -> Picture:
    """Draw all solvers on the left; on the right, enlarged, those of about the run times of our explicit methods."""
    chosen = [
        c for c in findings.curves if c.points and (c.family != OURS or c.is_implicit or c.method in (_BEST, _NODES))
    ]
    near = _near(chosen)
    shown = {f"{findings.name}, {findings.options.t_end:g} s of motion": chosen}
    if _decades(near) < 0.6 * _decades(chosen):
        shown["the fast solvers, enlarged"] = near
    figure, panels = _figure(len(shown), 4.5 + 3.25 * len(shown), 5.2)
    for axes, (title, lines) in zip(panels, shown.items(), strict=True):
        for curve in lines:
            _draw(axes, curve, [1e3 * s for s in curve.seconds], curve.errors, spread=True)
        _finish(axes, findings, "run time of one call [ms]", _ERROR if axes is panels[0] else "")
        axes.set_title(title)
    _legend(figure, panels[0])
    return _picture(
        figure, findings, "time", "error against run time",
        f"Our formulations with {_BEST} and with {_NODES} (dotted), our implicit methods, and other solvers. Bars: "
        "quartiles of the repeats. Lower left is better.",
    )  # fmt: skip


def _near(curves: Sequence[Curve]) -> list[Curve]:
    """Return the curves of our explicit methods (or all of ours), and others that take at most 3 times as long."""
    ours = [c for c in curves if c.family == OURS]
    base = [c for c in ours if not c.is_implicit] or ours
    longest = max((max(c.seconds) for c in base), default=0.0)
    return [c for c in curves if c in base or max(c.seconds) < 3 * longest]


def _decades(curves: Sequence[Curve]) -> float:
    every = [seconds for curve in curves for seconds in curve.seconds]
    return float(np.log10(max(every) / min(every))) if every else 0.0


def _by_method(findings: Findings) -> Picture:
    figure, panels = _figure(len(METHODS) + 1, 13.5, 4.8)
    for axes, (title, lines, _) in zip(panels, _panels(findings), strict=True):
        for curve in lines:
            _draw(axes, curve, [1e3 * s for s in curve.seconds], curve.errors)
        _finish(axes, findings, "run time of one call [ms]", _ERROR if axes is panels[0] else "")
        axes.set_title(title)
    figure.suptitle(f"{findings.name}, {findings.options.t_end:g} s of motion")
    _legend(figure, *panels, below=True)
    return _picture(
        figure, findings, "methods", "formulations by method",
        "One panel for each explicit method, and one for the implicit methods; same axes.",
    )  # fmt: skip


def _convergence(findings: Findings) -> Picture:
    """Draw error against steps: a method of order p gives a line of slope -p."""
    figure, panels = _figure(len(METHODS) + 1, 13.5, 4.8)
    for axes, (title, lines, order) in zip(panels, _panels(findings), strict=True):
        for curve in lines:
            _draw(axes, curve, [p.nsteps or 0 for p in curve.points], curve.errors)
        is_guided = _guide(axes, lines, order, findings.floor)
        _finish(axes, findings, "accepted steps", _ERROR if axes is panels[0] else "")
        axes.set_title(f"{title}; grey: order {order}" if is_guided else title)
    figure.suptitle(f"{findings.name}, {findings.options.t_end:g} s of motion")
    _legend(figure, *panels, below=True)
    return _picture(
        figure, findings, "order", "order of convergence",
        "Error against accepted steps: a method of order p follows a line of slope -p (grey; for implicit methods the "
        "order of radau5).",
    )  # fmt: skip


def _panels(findings: Findings) -> list[tuple[str, list[Curve], int]]:
    """Return title, curves and order of each panel: one for each explicit method, one for all implicit methods."""
    panels = [(method, _ours(findings, method), order) for method, order in METHODS.items()]
    return [*panels, ("implicit", [c for c in findings.curves if c.is_implicit and c.points], _GUIDED)]


def _ours(findings: Findings, method: str) -> list[Curve]:
    return [c for c in findings.curves if c.family == OURS and c.method == method and c.points]


def _figure(panels: int, width: float, height: float) -> tuple[Any, list[Any]]:
    figure = blank(width, height)
    axes = figure.subplots(1, panels, sharey=True, squeeze=False)[0]
    for ax in axes:
        ax.set(xscale="log", yscale="log")
    return figure, list(axes)


def _draw(axes: Any, curve: Curve, x: Sequence[float], y: Iterable[float], spread: bool = False) -> None:
    name = curve.group
    colour, marker, style = _LOOKS.get(curve.method if curve.is_implicit else name, ("#666666", "x", "--"))
    heights = [max(e, 1e-17) for e in y]
    label = name
    if spread and curve.family == OURS and curve.method == _NODES:
        label, style = f"{name} {_NODES}", ":"
    look = {"markersize": 7, "markerfacecolor": "none"} if name == _HOLLOW else {"markersize": 4.5}
    axes.plot(x, heights, linestyle=style, color=colour, marker=marker, linewidth=1.3, label=label, **look)
    if spread:
        low, high = ([1e3 * (getattr(p, side) or 0) for p in curve.points] for side in ("seconds_low", "seconds_high"))
        axes.hlines(heights, low, high, color=colour, linewidth=1, alpha=0.5)


def _guide(axes: Any, lines: Sequence[Curve], order: int, floor: float) -> bool:
    """Draw a line with the slope of the method through the median point; return False if there are too few points."""
    fixed = [c for c in lines if methods.METHODS[c.method].order == order and c.order(floor) is not None]
    every = [(p.nsteps or 0, p.error_max or 0.0) for curve in fixed for p in curve.points]
    points = [(steps, error) for steps, error in every if steps and floor < error < 1e-2]
    if not points:
        return False
    steps = sorted(n for n, _ in points)
    at, error = sorted(points)[len(points) // 2]
    axes.plot(steps, [error * (n / at) ** -order for n in steps], color="0.75", linewidth=6, alpha=0.6, zorder=0)
    return True


def _finish(axes: Any, findings: Findings, xlabel: str, ylabel: str) -> None:
    from matplotlib.ticker import LogLocator  # noqa: PLC0415, an optional package

    axes.set(xlabel=xlabel, ylabel=ylabel)
    axes.axhline(findings.options.error, color="0.4", linewidth=0.9, linestyle=(0, (6, 3)), label="requested accuracy")
    own = max(float(findings.reference.errors.max()), 1e-17)
    errors = [e for c in findings.curves for e in c.errors if e > 0] or [findings.options.error]
    low, high = min(errors) / 5, max(errors) * 5
    if own > low:
        axes.axhspan(low, own, color="0.92", zorder=-1, label="below the reference's own error")
    axes.set_ylim(max(low, 1e-17), high)
    axes.yaxis.set_major_locator(LogLocator(numticks=10))
    _label_times(axes)
    uncluttered(axes, linewidth=0.7)


def _label_times(axes: Any) -> None:
    """Label 1, 2, 5, 10, 20, ... in plain numbers, few enough not to overlap."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: PLC0415, an optional package

    first, last = axes.get_xlim()
    if last < 10 * first:
        middle = np.sqrt(first * last)
        first, last = axes.set_xlim(middle / np.sqrt(10), middle * np.sqrt(10))
    decades = np.log10(last / first)
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 2 else (1, 3) if decades < 3 else (1,)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}" if value < 1e4 else _power(value)))
    axes.xaxis.set_minor_formatter(NullFormatter())


def _power(value: float) -> str:
    """Return a large number in short form: 3e4."""
    mantissa, exponent = f"{value:e}".split("e")
    return f"{float(mantissa):g}e{int(exponent)}"


def _legend(figure: Any, *panels: Any, below: bool = False) -> None:
    """Draw a legend with the entries of all panels, each once."""
    every = [zip(*axes.get_legend_handles_labels(), strict=True) for axes in panels]
    known = {label: handle for pairs in every for handle, label in pairs}
    if below:
        figure.legend(known.values(), known, loc="outside lower center", ncols=(len(known) + 1) // 2, frameon=False)
    else:
        figure.legend(known.values(), known, loc="outside right upper", frameon=False)


def _picture(figure: Any, findings: Findings, kind: str, title: str, text: str) -> Picture:
    return picture(figure, f"{findings.name}_{kind}", f"{findings.name}: {title}", text)
