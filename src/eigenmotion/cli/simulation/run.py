"""`eigenmotion run`."""

import logging
import time
from pathlib import Path
from typing import Any

import click
import numpy as np

from eigenmotion.arguments.methods import AUTO, IMPLICIT, METHODS
from eigenmotion.arguments.named_values import spelled
from eigenmotion.batch.memory import shortage
from eigenmotion.building.build import system_of
from eigenmotion.codegen.model import ModelError
from eigenmotion.presentation.figures import save as save_figure
from eigenmotion.progress import clock
from eigenmotion.results.motion_table import SAVERS
from eigenmotion.results.output.summary import summary
from eigenmotion.results.pictures.animation import ANIMATIONS, save_animation
from eigenmotion.results.pictures.moving_shapes import require_drawing
from eigenmotion.results.solution import Solution
from eigenmotion.runtime import StopReason
from eigenmotion.simulation.simulate import simulate
from eigenmotion.system.system import System

from ..options import ABOVE_ZERO, Finite, Shape, ending, model, setting, shaping, values
from ..starts import LABEL, assembled, assembling
from .targets import check_results

_ROW = 100  # [byte] memory for a row, at least
_log = logging.getLogger("eigenmotion")


@click.command("run")
@model
@ending(Finite())
@click.option("--rtol", type=Finite(), default=1e-6, show_default=True, metavar="R", help="Relative tolerance.")
@click.option("--atol", type=Finite(), default=1e-9, show_default=True, metavar="A", help="Absolute tolerance.")
@click.option("--method", default="dop853", show_default=True, metavar="NAME",
              help=f"{', '.join(name for name in METHODS if name not in IMPLICIT)}; implicit, for stiff models: "
              f"{', '.join(IMPLICIT)}; {AUTO}: chosen for the model and its start.")  # fmt: skip
@setting
@assembling
@click.option("--estimate-error", is_flag=True, help="Repeat the run more accurately, and print the error.")
@click.option("--plot", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help="Draw coordinates, outputs and named multipliers, to FILE.png, .svg or .pdf.")  # fmt: skip
@click.option("--animate", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help=f"Animate the mechanism, to FILE{', '.join(ANIMATIONS)}; needs matplotlib.")  # fmt: skip
@click.option("--save", "target", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help=f"Save the rows, to {' or '.join(f'FILE{ending}' for ending in SAVERS)}.")  # fmt: skip
@click.option("--rows", type=click.IntRange(min=2), default=None, metavar="N",
              help="With --save: N rows at equal distances. Default: a row for each step.")  # fmt: skip
@click.option("--every", type=ABOVE_ZERO, default=None, metavar="DT", help="With --save: a row every DT seconds.")
@click.option("--over", default=None, metavar="NAME",
              help="A coordinate in place of the time, for --rows and --every, and on the axis of --plot.")  # fmt: skip
@shaping
def command(
    model: Path,
    t_end: float,
    rtol: float,
    atol: float,
    method: str,
    settings: tuple[str, ...],
    closes: bool,
    estimate_error: bool,
    plot: Path | None,
    animate: Path | None,
    target: Path | None,
    rows: int | None,
    every: float | None,
    over: str | None,
    **shape: Any,
) -> int:
    """Simulate MODEL and print a summary.

    The exit code is 0 at the end time or at a terminal event. A run that stops early for another reason prints the
    reason and the time reached, and exits with 2, or with 130 if interrupted.
    """
    check_results(plot, animate, ("--save", target, SAVERS))
    _check_rows(target, rows, every)
    if over is None and (short := shortage(_ROW * (rows or (abs(t_end) / every if every else 0)))):
        raise click.UsageError(f"{'--rows' if rows else '--every'}: so many rows {short}. Ask for fewer")
    request = Shape(**shape).request(model)
    _check_over(over, [spelled(q) for q in request.model.coordinates], plot, rows or every)
    if animate and not request.model.drawing:
        require_drawing(None, request.model.name)
    arguments = values(request.model, settings)
    options = {"rtol": rtol, "atol": atol, "method": method, "estimate_error": estimate_error}
    with clock():
        system = system_of(request)
        _log.info("running %s to t = %g", system.name, t_end)
        if closes:
            arguments, moved = assembled(system, arguments)
            click.echo(f"{LABEL:<22} {moved}")
        start = time.perf_counter()
        dense = bool(plot or animate or rows or every)
        solution = _simulated(system, t_end, dense_output=dense, **options, **arguments)
        seconds = time.perf_counter() - start
    click.echo(summary(system, solution, seconds))
    if plot:
        click.echo(f"drawn to {save_figure(solution.plot(over=over), plot)}")
    if animate:
        click.echo(f"moves in {save_animation(solution.animate(), animate)}")
    if target:
        _spaced(solution, rows, every, over).save(target)
        click.echo(f"saved to {target}")
    return _exit_code(solution)


def _simulated(system: System, t_end: float, **options: Any) -> Solution:
    try:
        return simulate(system, (0.0, t_end), **options)
    except ModelError:
        raise
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _check_rows(target: Path | None, rows: int | None, every: float | None) -> None:
    """Check the options about the rows of a file."""
    if rows and every:
        raise click.UsageError("give --rows or --every, not both")
    if (rows or every) and not target:
        raise click.UsageError(f"{'--rows' if rows else '--every'} is for the rows of a file: give --save FILE too")


def _check_over(over: str | None, coordinates: list[str], *uses: object) -> None:
    """Check the coordinate of --over, and that there is a use for it."""
    if over is None:
        return
    if over not in coordinates:
        raise click.UsageError(f"--over {over}: the coordinates are {', '.join(coordinates)}")
    if not any(uses):
        raise click.UsageError("--over is for --plot, or for the rows of a file: give --rows or --every too")


def _spaced(solution: Solution, rows: int | None, every: float | None, over: str | None) -> Solution:
    """Return the motion at N places, or at every so much, of the time or a coordinate, up to where the run ended."""
    first, last = (solution.t if over is None else solution.table()[over])[[0, -1]].tolist()
    if rows:
        places = np.linspace(first, last, rows)
    elif every:
        count = np.floor(abs(last - first) / every * (1.0 + 1e-12))
        places = first + np.copysign(every, last - first) * np.arange(count + 1)
        places = np.clip(places, min(first, last), max(first, last))
    else:
        return solution
    return solution.at(places) if over is None else solution.over(over, places)


def _exit_code(solution: Solution) -> int:
    if solution.stop is StopReason.INTERRUPTED:
        return 130
    return 0 if solution.success else 2
