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

from .options import Shape, assignments, model, shaping


@click.command("run")
@model
@click.option("--t-end", type=float, default=10.0, show_default=True, help="Time at which to end; it starts at 0.")
@click.option("--rtol", type=float, default=1e-6, show_default=True, help="Relative tolerance.")
@click.option("--atol", type=float, default=1e-9, show_default=True, help="Absolute tolerance.")
@click.option("--method", default="dop853", show_default=True, help="rk34, dopri5, dop853.")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="A parameter or initial value: theta=0.5, theta'=1 for a rate; a quasi-velocity.")  # fmt: skip
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
    plot: Path | None,
    target: Path | None,
    **shape: Any,
) -> int:
    """Simulate MODEL and print a summary.

    A run that a terminal event ends is done (exit code 0). One that stops early for another reason prints the reason
    and what was reached, and exits with 2; interrupted, with 130.
    """
    _check_targets(plot, target)
    system = load(make(Shape(**shape).order(model), toolchain()))
    start = time.perf_counter()
    solution = _simulated(system, t_end, settings, rtol=rtol, atol=atol, method=method, dense_output=bool(plot))
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


def _simulated(system: System, t_end: float, settings: tuple[str, ...], **options: Any) -> Solution:
    try:
        return simulate(system, (0.0, t_end), **_sorted_out(system, settings), **options)
    except ModelError:
        raise
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _sorted_out(system: System, settings: tuple[str, ...]) -> dict[str, Any]:
    """NAME=VALUE ... -> the arguments parameters, x0 and v0 of `simulate`."""
    given = {name: _number(name, text) for name, text in assignments(settings, "--set").items()}
    positions = set(system.coordinates)
    rates = {f"{name}'" for name in system.coordinates} | set(system.quasi_velocities)
    unknown = sorted(given.keys() - positions - rates - system.parameters.keys())
    if unknown:
        known = ", ".join([*system.parameters, *system.coordinates, *sorted(rates)])
        raise click.UsageError(f"--set {unknown[0]}: not known to {system.name}, which has {known}")
    return {
        "parameters": {name: value for name, value in given.items() if name in system.parameters},
        "x0": {name: value for name, value in given.items() if name in positions},
        "v0": {name.removesuffix("'"): value for name, value in given.items() if name in rates},
    }


def _number(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError as error:
        raise click.UsageError(f"--set {name}={text}: {text} is not a number") from error


def _exit_code(solution: Solution) -> int:
    if solution.stop is StopReason.INTERRUPTED:
        return 130
    return 0 if solution.success else 2
