"""Looks of pictures at the width of a page: type is legible, no text covers another one, and none is cut off."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

import eigenmotion as em
from eigenmotion.results.output import ensemble_plot

from ..support.crane import measured_crane
from ..support.figure_looks import figure_faults
from ..support.generation import system_for, system_of

UNITS = {"s_trolley": "m", "swing": "rad", "drag": "kg s^-1", "push": "kg m/s^2"}
NAMES = ("s_trolley", "swing")


def crane():
    return system_for(measured_crane(), "lagrange")


def run_of(name: str, t_end: float):
    return system_of(name, "lagrange").simulate((0, t_end), dense_output=True)


def driven():
    return em.drive(system_of("slider_crank", "lagrange"), np.linspace(0, 1, 101), {"theta": 1 + 12 * em.t})


def sampled(*shape: int):
    return np.random.default_rng(1).uniform(-3, 3, shape)


PICTURES = {
    "run": lambda: crane().simulate((0, 5), dense_output=True).plot(),
    "run with events": lambda: run_of("pendulum_with_stop", 5).plot(),
    "run in space": lambda: run_of("gripper", 1).plot(),
    "columns": lambda: crane().simulate((0, 5), dense_output=True).plot("acceleration_of_gravity", over="s_trolley"),
    "drive": lambda: driven().plot(),
    "sweep over time": lambda: ensemble_plot.over_time("crane", NAMES, np.linspace(0, 3), sampled(9, 2, 50), UNITS),
    "sweep": lambda: ensemble_plot.ends("crane", NAMES, {"drag": np.arange(9.0)}, sampled(9, 2), UNITS),
    "sweep of two": lambda: ensemble_plot.over_grid(
        "crane", NAMES, {"drag": np.arange(3), "push": np.arange(4)}, sampled(12, 2), UNITS
    ),
}  # fmt: skip


@pytest.mark.parametrize("which", PICTURES)
def test_a_picture_is_legible(which, request, tmp_path):
    figure = PICTURES[which]()
    found = figure_faults(figure)
    folder = request.config.getoption("--screenshots") or tmp_path
    figure.savefig(Path(folder) / f"picture_{which.replace(' ', '_')}.png", dpi=150)
    assert not found


def test_faults_are_found():
    figure = Figure(figsize=(7, 3), layout="constrained")
    axes = figure.add_subplot()
    axes.set(xlabel="time", ylabel="a label of an axis that is much longer than the axis is in this picture")
    axes.text(0.5, 0.5, "one")
    axes.text(0.51, 0.5, "two")
    axes.text(0.1, 0.1, "tiny", fontsize=5)
    found = figure_faults(figure)
    assert {one.partition(":")[0] for one in found} == {"small", "overlap", "cut off"}
    assert "overlap: 'one' and 'two'" in found
