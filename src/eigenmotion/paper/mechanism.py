"""Drawings of the mechanism at several instants, as in the paper's Figure 2."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..presentation.figures import COLOURS, blank, uncluttered
from .canvas import FAINT
from .experiment import History

INSTANTS = np.linspace(0.0, 3.5, 8)
"""[s]; the paper shows the motion up to 3.5 s."""
COILS, COIL_HEIGHT = 6, 0.035


def motion(history: History) -> Any:
    """Draw Figure 2: the mechanism at each instant, with the previous instant in grey."""
    figure = blank(9, 4.7)
    figure.suptitle("Figure 2: motion of the dual-link manipulator (lengths in m)", x=0.01, ha="left", fontsize=11)
    poses = [_at(history, t) for t in INSTANTS]
    grid = figure.subplots(2, 4, sharex=True, sharey=True)
    for k, ax in enumerate(grid.flat):
        if k:
            _draw(ax, history, poses[k - 1], faint=True)
        _draw(ax, history, poses[k], faint=False)
        _frame(ax, history, f"$t$ = {INSTANTS[k]:.1f} s")
    _name(grid[0, 0], history, poses[0])
    return figure


def _at(history: History, t: float) -> Vector:
    """Return x (4,) at t by linear interpolation between accepted steps, which is accurate enough for drawing."""
    return np.array([np.interp(t, history.t, row) for row in history.x])


def _frame(ax: Any, history: History, title: str) -> None:
    ax.axhline(history.hand[1][0], color="0.6", linewidth=0.8, linestyle=(0, (4, 3)), zorder=0)
    ax.set(aspect="equal", xlim=(-0.7, 1.0), ylim=(-0.2, 1.3))
    ax.set_title(title, fontsize=10)
    uncluttered(ax, FAINT)


def _masses(history: History, x: Vector) -> tuple[Vector, Vector, Vector]:
    """Return the positions of m1, m2, m3, each (2,) [m]."""
    p = history.system.parameters
    joint = (p["l1"] + x[2]) * _towards(x[0])
    return joint, joint + p["l2"] * _towards(x[1]), joint + p["l3"] * _towards(x[3])


def _draw(ax: Any, history: History, x: Vector, *, faint: bool) -> None:
    """Draw links, springs and masses. The links differ not only in colour: a coil, a solid and a dashed bar."""
    joint, hand, tip = _masses(history, x)
    first, second, third = ("0.8",) * 3 if faint else COLOURS[:3]
    layer = 1 if faint else 2
    ax.plot(*_spring(np.zeros(2), joint), color=first, linewidth=1.2, zorder=layer)
    ax.plot(*np.transpose([joint, tip]), color=third, linewidth=1.6, linestyle="--", zorder=layer)
    ax.plot(*np.transpose([joint, hand]), color=second, linewidth=2.4, zorder=layer)
    ax.plot(*np.transpose([joint, hand, tip]), "o", color="0.8" if faint else "black", markersize=5, zorder=layer + 1)
    if not faint:
        ax.plot(0, 0, "s", color="black", markersize=4)
        ax.plot(*np.transpose([hand, [0.0, 4.0]]), color="0.6", linewidth=0.8, linestyle=":", zorder=0)


def _name(ax: Any, history: History, x: Vector) -> None:
    """Label the masses, in the first drawing only."""
    offsets = ((7, -3), (3, 6), (-17, 2))
    for number, (place, offset) in enumerate(zip(_masses(history, x), offsets, strict=True), 1):
        ax.annotate(f"$m_{number}$", place, offset, textcoords="offset points", fontsize=9)


def _towards(angle: float) -> Vector:
    return np.array([np.cos(angle), np.sin(angle)])


def _spring(start: Vector, end: Vector) -> tuple[Vector, Vector]:
    """Return a coil of constant height between two points."""
    along = np.linspace(0.0, 1.0, 4 * COILS + 1)
    swing = COIL_HEIGHT * np.sin(2 * np.pi * COILS * along)
    direction = (end - start) / np.linalg.norm(end - start)
    line = start[:, None] + (end - start)[:, None] * along
    return line[0] - swing * direction[1], line[1] + swing * direction[0]
