"""`eigenmotion drive`."""

import csv
import math
from pathlib import Path
from typing import Any

import click
import numpy as np
import sympy
from scipy.integrate import trapezoid
from scipy.interpolate import make_interp_spline

from eigenmotion.analysis.driving.drive import drive
from eigenmotion.building.build import system_of
from eigenmotion.codegen.model import t as time
from eigenmotion.presentation.figures import save as save_figure
from eigenmotion.progress import clock
from eigenmotion.results.drive import SAVERS, Drive
from eigenmotion.results.pictures.animation import ANIMATIONS, save_animation
from eigenmotion.results.pictures.moving_shapes import require_drawing

from ..options import Finite, Shape, distinct_assignments, listed, model, setting, shaping, values
from .targets import check_results

_DEGREE = 5
"""Of the spline through samples: its second derivative, which forces depend on, is accurate."""
_END = 10.0


@click.command("drive")
@model
@click.option("--path", "paths", multiple=True, required=True, metavar="NAME=PATH",
              help="The motion of a coordinate: an expression in t, such as q1='pi/2*sin(2*t)', or FILE.csv with the "
              "columns t and NAME.")  # fmt: skip
@click.option(
    "--actuators",
    default=None,
    metavar="NAMES",
    help="Coordinates and inputs that act, separated by commas. Default: the coordinates with a path.",
)
@click.option("--t-end", type=Finite(above_zero=True), default=None, metavar="T",
              help="End time in seconds; motions start at 0. Default: that of the files, or 10.")  # fmt: skip
@click.option("--rows", type=click.IntRange(min=2), default=1001, show_default=True, help="Number of times.")
@setting
@click.option(
    "-o",
    "--output",
    "target",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help=f"Save the motion and the forces, to {' or '.join(f'FILE{ending}' for ending in SAVERS)}.",
)
@click.option(
    "--plot",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="Draw motion, forces and powers, to FILE.png, .svg or .pdf; needs matplotlib.",
)
@click.option("--animate", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help=f"Animate the mechanism, to FILE{', '.join(ANIMATIONS)}; needs matplotlib.")  # fmt: skip
@shaping
def command(
    model: Path,
    paths: tuple[str, ...],
    actuators: str | None,
    t_end: float | None,
    rows: int,
    settings: tuple[str, ...],
    target: Path | None,
    plot: Path | None,
    animate: Path | None,
    **shape: Any,
) -> int:
    """Find the forces that drive MODEL along a prescribed motion.

    As many coordinates have a path as the mechanism has degrees of freedom; the others follow from the constraints. For
    each actuator the largest force, its root mean square, and the largest speed and power are printed.
    """
    check_results(plot, animate, ("-o", target, SAVERS))
    request = Shape(**shape).request(model)
    if animate and not request.model.drawing:
        require_drawing(None, request.model.name)
    arguments = values(request.model, settings)
    if "v0" in arguments:
        raise click.UsageError("--set: rates follow from the paths")
    motion, last = _motion(distinct_assignments(paths, "--path"))
    with clock():
        system = system_of(request)
        times = np.linspace(0.0, t_end or last or _END, rows)
        result = drive(system, times, motion, actuators=listed(actuators), **arguments)
    click.echo(summary(result))
    if plot:
        click.echo(f"drawn to {save_figure(result.plot(), plot)}")
    if animate:
        click.echo(f"moves in {save_animation(result.animate(), animate)}")
    if target:
        result.save(target)
        click.echo(f"saved to {target}")
    return 0


def _motion(paths: dict[str, str]) -> tuple[dict[str, Any], float | None]:
    """Return name -> path, and the last time that all files know; None without files."""
    motion: dict[str, Any] = {}
    ends = []
    for name, text in paths.items():
        if Path(text).suffix == ".csv":
            at, sampled = _samples(Path(text), name)
            motion[name] = make_interp_spline(at, sampled, k=_DEGREE)
            ends.append(float(at[-1]))
        else:
            motion[name] = _expression(name, text)
    return motion, min(ends, default=None)


def _expression(name: str, text: str) -> sympy.Expr:
    try:
        made = sympy.sympify(text, locals={"t": time})
    except (sympy.SympifyError, SyntaxError, TypeError, AttributeError) as error:
        raise click.UsageError(f"--path {name}={text}: {text} is no expression in t") from error
    if not isinstance(made, sympy.Expr) or made.has(sympy.Lambda):
        raise click.UsageError(f"--path {name}={text}: {text} is no expression in t")
    return made


def _samples(file: Path, name: str) -> tuple[Any, Any]:
    """Return t and values from the columns `t` and `name` of a file, behind which there may be units in brackets."""
    try:
        with file.open(encoding="utf-8", newline="") as text:
            reader = csv.DictReader(text)
            reader.fieldnames = [name.partition(" [")[0] for name in reader.fieldnames or ()]
            table = list(reader)
    except OSError as error:
        raise click.UsageError(f"--path {name}={file}: {error.strerror}") from error
    head = list(table[0]) if table else []
    if not {"t", name} <= set(head):
        raise click.UsageError(f"--path {name}={file}: the first line names the columns, t and {name}; it has {head}")
    try:
        columns = np.array([[float(row["t"]), float(row[name])] for row in table]).T
    except (TypeError, ValueError) as error:
        raise click.UsageError(f"--path {name}={file}: {error}") from error
    if len(table) <= _DEGREE or not np.isfinite(columns).all() or not (np.diff(columns[0]) > 0.0).all():
        raise click.UsageError(f"--path {name}={file}: more than {_DEGREE} rows are needed, with times that increase")
    return columns[0], columns[1]


def summary(result: Drive) -> str:
    """Return a line for each actuator; numbers have their units if the model has any."""
    unit = result.units["t"]
    span = f"t = {result.t[0]:g} ... {result.t[-1]:g}{unit and ' '}{unit} in {len(result.t)} rows"
    head = ("actuator", "largest force", "at t", "rms", "largest speed", "largest power")
    rows = [head, *(_of_actuator(result, k) for k in range(len(result.actuators)))]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ["  ".join([row[0].ljust(widths[0]), *map(str.rjust, row[1:], widths[1:])]).rstrip() for row in rows]
    return "\n".join([f"{result.model.name}, {span}", "", *lines])


def _of_actuator(result: Drive, k: int) -> tuple[str, ...]:
    name, force, power, units = result.actuators[k], result.forces[k], result.power[k], result.units
    peak = int(np.abs(force).argmax())
    rms = math.sqrt(trapezoid(force**2, result.t) / (result.t[-1] - result.t[0]))
    by = {"force": force[peak], "t": result.t[peak], "rms": rms, "power": np.abs(power).max()}
    of = {
        "force": units[f"force_{name}"],
        "t": units["t"],
        "rms": units[f"force_{name}"],
        "power": units[f"power_{name}"],
    }
    texts = {what: f"{value:.6g} {of[what]}".rstrip() for what, value in by.items()}
    speed = ""
    if name in result.coordinates:
        speed = f"{np.abs(result.v[result.coordinates.index(name)]).max():.6g} {units[name + chr(39)]}".rstrip()
    return name, texts["force"], texts["t"], texts["rms"], speed, texts["power"]
