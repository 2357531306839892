"""Figures of the paper from our runs."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..presentation.figures import COLOURS, STYLES, save
from .canvas import axes, draw
from .experiment import PAIRS, Experiment, History, experiment
from .findings import Finding, findings
from .mechanism import motion

DEGREES = 180.0 / np.pi


@dataclass(frozen=True, slots=True)
class Figures:
    """The files of the figures, and the findings."""

    paths: tuple[Path, ...]
    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        lines = [f"drawn to {path}" for path in self.paths]
        for one in self.findings:
            lines += ["", f"Figure {one.figure}: {one.statement}", f"  {one.verdict}: {one.measured}"]
        return "\n".join(lines)


def write_figures(directory: Path | str, only: Collection[int] = ()) -> Figures:
    """Run the paper's experiment and draw Figures 2 to 8, or only those in `only`, as `directory`/figure_N.png.

    Raises
    ------
    ModelError
        matplotlib, of the extra `plot`, is missing.
    """
    folder, data = Path(directory), experiment()
    paths = tuple(
        save(figure(data), folder / f"figure_{number}.png")
        for number, figure in FIGURES.items()
        if not only or number in only
    )
    statements = findings(data)
    return Figures(paths, tuple(finding for finding in statements if not only or finding.figure in only))


def _motion(data: Experiment) -> Any:
    return motion(data.eigenfactor.published)


def _coordinates(data: Experiment) -> Any:
    history = data.eigenfactor.published
    figure, ax = axes("Figure 3: coordinates", "angle [°], stretch [cm]")
    names = (r"$\theta_1$", r"$\theta_2$", r"$100\,\theta_3$", r"$\theta_4$")
    scales = (DEGREES, DEGREES, 100.0, DEGREES)
    rows = [(name, scale * x) for name, scale, x in zip(names, scales, history.x, strict=True)]
    draw(ax, history.t, rows, STYLES)
    return figure


def _quasi_velocities(data: Experiment) -> Any:
    history = data.eigenfactor.published
    figure, ax = axes(r"Figure 4: quasi-velocities $\eta = S\,C\,\dot x$", r"$\eta$ [J$^{1/2}$]")
    draw(ax, history.t, [(rf"$\eta_{i + 1}$", row) for i, row in enumerate(history.eta)], STYLES)
    return figure


def _eigenvalues(data: Experiment) -> Any:
    history = data.eigenfactor.published
    figure, ax = axes("Figure 5: eigenvalues of the mass matrix", r"$\lambda$ (SI units of $M$)")
    draw(ax, history.t, [(rf"$\lambda_{i + 1}$", row) for i, row in enumerate(history.eigenvalues)], STYLES)
    ax.set_ylim(bottom=0)
    return figure


def _turning(data: Experiment) -> Any:
    history = data.eigenfactor.published
    figure, ax = axes(r"Figure 6: angular velocities of the eigenvectors ($\Omega_{3i} = 0$)", r"$\Omega$ [rad/s]")
    rows = [(rf"$\Omega_{{{i + 1}{j + 1}}}$", history.Omega[i, j]) for i, j in PAIRS]
    draw(ax, history.t, rows, STYLES)
    return figure


def _both(data: Experiment, of: Callable[[History], Vector], title: str, ylabel: str) -> Any:
    """Draw both formulations over time on a logarithmic scale, without t = 0, where the error is 0."""
    figure, ax = axes(title, ylabel)
    ax.set_yscale("log")
    for k, (name, runs) in enumerate((("eigenfactor", data.eigenfactor), ("brute force", data.inverse))):
        history = runs.published
        ax.plot(history.t[1:], of(history)[1:], STYLES[k], color=COLOURS[k], linewidth=1.6, label=name)
    ax.set_ylim(bottom=1e-6 * ax.get_ylim()[1])
    ax.legend(loc="lower right", frameon=False)
    return figure


def _violations(data: Experiment) -> Any:
    title = "Figure 7: constraint violation, mean step 0.024 s, nothing projected"
    return _both(data, lambda history: history.violation, title, r"$|y(t) - y(0)|$ [m]")


def _accuracy(data: Experiment) -> Any:
    title = "Figure 8: integral of the energy error, mean step 0.024 s, nothing projected"
    label = r"$\int_0^t |P(\tau) - P(0)|\,d\tau$ [J s]"
    return _both(data, lambda history: history.energy_error, title, label)


FIGURES: dict[int, Callable[[Experiment], Any]] = {
    2: _motion,
    3: _coordinates,
    4: _quasi_velocities,
    5: _eigenvalues,
    6: _turning,
    7: _violations,
    8: _accuracy,
}
