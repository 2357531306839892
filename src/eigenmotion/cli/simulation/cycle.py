"""`eigenmotion cycle`."""

from pathlib import Path
from typing import Any

import click

from eigenmotion.analysis.continuation.branch import Branch
from eigenmotion.analysis.continuation.follow import follow
from eigenmotion.analysis.cycles.cycle import Cycle
from eigenmotion.analysis.cycles.find_cycle import find_cycle
from eigenmotion.building.build import system_of
from eigenmotion.presentation.figures import save as save_figure
from eigenmotion.progress import clock

from ..options import Shape, distinct_assignments, model, setting, shaping, values
from .targets import check_results


@click.command("cycle")
@model
@setting
@click.option("--period", default=None, metavar="T",
              help="A guess in seconds, or exactly, for equations that depend on time: a number or an expression of "
              "parameters, such as 2*pi/w. Default: the first return.")  # fmt: skip
@click.option("--section", default=None, metavar="NAME|EXPR",
              help="An event after which the motion starts and ends, or a number that keeps its value, or an "
              "expression that is zero at the start, such as \"theta - 2*phi'\".")  # fmt: skip
@click.option("--direction", type=click.Choice(["1", "-1"]), default=None,
              help="With an expression as section: whether it increases or decreases there. Default: as it first does."
              )  # fmt: skip
@click.option("--symmetry", "symmetries", multiple=True, metavar="NAME=IMAGE",
              help="The value of a coordinate after a period, such as theta=theta+2*pi.")  # fmt: skip
@click.option("--free", multiple=True, metavar="NAME",
              help="What may vary: a coordinate, theta' for a rate, or period. Default: all. Or a parameter or an "
              "input that is found, too, one for each condition.")  # fmt: skip
@click.option("--condition", "conditions", multiple=True, metavar="EXPR",
              help="An expression that is zero at the start, of coordinates, rates, parameters and period, such as "
              "\"theta' - 1.5\".")  # fmt: skip
@click.option("--follow", "along", default=None, metavar="NAME=TO",
              help="Follow the cycle along a parameter up to a value, and print the bifurcations.")  # fmt: skip
@click.option("--plot", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help="Draw the motion, or with --follow the branch, to FILE.png, .svg or .pdf; needs matplotlib."
              )  # fmt: skip
@shaping
def command(
    model: Path,
    settings: tuple[str, ...],
    period: str | None,
    section: str | None,
    direction: str | None,
    symmetries: tuple[str, ...],
    free: tuple[str, ...],
    conditions: tuple[str, ...],
    along: str | None,
    plot: Path | None,
    **shape: Any,
) -> int:
    """Find a periodic motion of MODEL near its start; print the period, the multipliers and the start.

    Multipliers are the factors of small deviations in one period; the motion is stable if all are smaller than 1. If no
    motion closes, the command says why and exits with code 2.
    """
    check_results(plot, None, ("--plot", None, ()))
    goal = _goal(along)
    request = Shape(**shape).request(model)
    arguments: dict[str, Any] = dict(values(request.model, settings))
    with clock():
        found = find_cycle(
            system_of(request), period=_period(period), section=section,
            direction=None if direction is None else int(direction), free=free or None, conditions=conditions or None,
            symmetry=distinct_assignments(symmetries, "--symmetry") or None, **arguments,
        )  # fmt: skip
        branch = follow(found, goal[0], to=goal[1]) if goal and found.success else None
    click.echo("\n".join(_described(found, branch)))
    if plot and found.solution:
        figure = branch.plot() if branch else found.solution.plot()
        click.echo(f"drawn to {save_figure(figure, plot)}")
    return 0 if found.success and (branch is None or branch.success) else 2


def _period(text: str | None) -> float | str | None:
    try:
        return None if text is None else float(text)
    except ValueError:
        return text


def _goal(text: str | None) -> tuple[str, float] | None:
    if text is None:
        return None
    [(name, value)] = distinct_assignments((text,), "--follow").items()
    try:
        return name, float(value)
    except ValueError:
        raise click.UsageError(f"--follow {text}: {value} is no number") from None


def _described(found: Cycle, branch: Branch | None) -> list[str]:
    """Return lines on a cycle and, if it was followed, its branch."""
    lines = str(found).splitlines()
    if found.success:
        lines += [f"{name} = {value + 0.0:.9g}" for name, value in found.x0.items()]
        lines += [f"{name}' = {value + 0.0:.9g}" for name, value in found.v0.items()]
    if branch is not None:
        lines += ["", *_of_branch(branch)]
    return lines


def _of_branch(branch: Branch) -> list[str]:
    ends = f"from {branch.parameter[0]:.6g} to {branch.parameter[-1]:.6g}"
    lines = [f"{len(branch.parameter)} cycles along {branch.name} {ends}: {branch.message}"]
    for one in branch.special:
        largest = max(one.values, key=abs)
        imaginary = f" {largest.imag:+.6g} i" if largest.imag else ""
        lines.append(f"{one}: period {one.period:.9g} s, largest multiplier {largest.real:.6g}{imaginary}")
    return lines
