"""`eigenmotion run`."""

import time
from pathlib import Path
from typing import Any

import click

from eigenmotion.build import load, make
from eigenmotion.codegen.model import ModelError
from eigenmotion.plot import FORMATS, draw_coordinates, require_matplotlib
from eigenmotion.runtime import StopReason
from eigenmotion.saving import SAVERS, save
from eigenmotion.simulate import simulate
from eigenmotion.solution import Solution
from eigenmotion.summary import summary
from eigenmotion.system import System
from eigenmotion.toolchain import toolchain

from .options import Shape, ending, model, setting, shaping, values


@click.command("run")
@model
@ending(click.FLOAT)
@click.option("--rtol", type=float, default=1e-6, show_default=True, help="Relative tolerance.")
@click.option("--atol", type=float, default=1e-9, show_default=True, help="Absolute tolerance.")
@click.option("--method", default="dop853", show_default=True,
              help="rk34, dopri5, dop853; implicit, for stiff models: Radau, BDF, LSODA, cvode.")  # fmt: skip
@setting
@click.option("--estimate-error", is_flag=True, help="Run again more accurately, and say how large the error is.")
@click.option("--plot", type=click.Path(path_type=Path, dir_okay=False), help="Draw the coordinates over time.")
@click.option("--save", "target", type=click.Path(path_type=Path, dir_okay=False), help="Save to FILE.npz or FILE.csv.")
@shaping
def command(
    model: Path,
    t_end: float,
    rtol: float,
    atol: float,
    method: str,
    settings: tuple[str, ...],
    estimate_error: bool,
    plot: Path | None,
    target: Path | None,
    **shape: Any,
) -> int:
    """Simulate MODEL and print a summary.

    A run that a terminal event ends is done (exit code 0). One that stops early for another reason prints the reason
    and what was reached, and exits with 2; interrupted, with 130.
    """
    _check_targets(plot, target)
    order = Shape(**shape).order(model)
    given = values(order.model, settings)
    options = {"rtol": rtol, "atol": atol, "method": method, "estimate_error": estimate_error}
    system = load(make(order, toolchain()))
    start = time.perf_counter()
    solution = _simulated(system, t_end, dense_output=bool(plot), **options, **given)
    click.echo(summary(system, solution, time.perf_counter() - start))
    if plot:
        draw_coordinates(system, solution, plot)
        click.echo(f"drawn to {plot}")
    if target:
        save(system, solution, target)
        click.echo(f"saved to {target}")
    return _exit_code(solution)


def _check_targets(plot: Path | None, target: Path | None) -> None:
    """Find out before the run what would fail after it."""
    if plot:
        require_matplotlib()
    for option, file, endings in (("--plot", plot, FORMATS), ("--save", target, SAVERS)):
        if file and file.suffix not in endings:
            raise click.UsageError(f"{option} {file}: known endings are {', '.join(endings)}")
        if file and not file.absolute().parent.is_dir():
            raise click.UsageError(f"{option} {file}: there is no folder {file.parent}")


def _simulated(system: System, t_end: float, **options: Any) -> Solution:
    try:
        return simulate(system, (0.0, t_end), **options)
    except ModelError:
        raise
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _exit_code(solution: Solution) -> int:
    if solution.stop is StopReason.INTERRUPTED:
        return 130
    return 0 if solution.success else 2
