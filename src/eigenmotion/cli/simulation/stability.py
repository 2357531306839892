"""`eigenmotion stability`."""

import os
from pathlib import Path

import click

from eigenmotion.building.request import request
from eigenmotion.presentation.figures import require_matplotlib
from eigenmotion.stability import (
    BUDGET,
    CASES,
    Matrix,
    Outcome,
    limits_of,
    summary,
    summary_of,
    survey,
    write_limits,
    write_matrix,
)

from ..options import (
    ABOVE_ZERO,
    assignments,
    bar_until_interrupted,
    check_writable,
    define,
    ending,
    folder,
    setting,
    values,
)

_WORKERS = min(2, os.cpu_count() or 1)


@click.command("stability")
@click.argument("model", metavar="[MODEL]", required=False, type=click.Path(path_type=Path))
@folder("stability", "page, pictures and numbers")
@click.option("--budget", type=ABOVE_ZERO, default=BUDGET, show_default=True, metavar="SECONDS",
              help="Time for a MODEL. The summary names what was not run.")  # fmt: skip
@ending(ABOVE_ZERO)
@setting
@define
@click.option("--case", "names", multiple=True, type=click.Choice(list(CASES)), metavar="CASE",
              help="Without a MODEL: only this case; may be given several times. "
              f"Cases: {', '.join(CASES)}.")  # fmt: skip
@click.option("--workers", type=click.IntRange(min=1), default=_WORKERS, show_default=True,
              help="Number of parallel processes.")  # fmt: skip
def command(
    model: Path | None,
    output: Path,
    budget: float,
    t_end: float,
    settings: tuple[str, ...],
    define: tuple[str, ...],
    names: tuple[str, ...],
    workers: int,
) -> int:
    """Drive a MODEL, or the built-in extreme cases, to their limits with every formulation and method.

    With a MODEL: multiplies each parameter by factors from 1e-6 to 1e6, starts near singular positions, tightens the
    tolerances and lengthens the span. Compares each run with an independent reference where there is one, and says
    which formulation and method is right, up to which limits, and why others are not.

    Without a MODEL: runs the built-in cases, which takes a quarter of an hour.

    Writes stability.html, stability.json and the pictures. Exits with 3 if a run that reports success is wrong. Ctrl-C
    ends a MODEL's examination with what was found until then.
    """
    if model is None and (settings or define):
        raise click.UsageError("--set and -D are for a MODEL: name one")
    if model is not None and names:
        raise click.UsageError(f"--case {names[0]} is a built-in case: leave it out, or leave out {model}")
    require_matplotlib()
    check_writable(output, "-o")
    if model is None:
        return _built_in(names, output, workers)
    return _own(model, output, budget, t_end, settings, define, workers)


def _own(
    file: Path, output: Path, budget: float, t_end: float, settings: tuple[str, ...], define: tuple[str, ...],
    workers: int,
) -> int:  # fmt: skip
    model = request(file, assignments(define, "-D")).model
    with bar_until_interrupted(model.name) as progress:
        found = limits_of(
            model, values(model, settings), t_end=t_end, budget=budget, workers=workers, progress=progress
        )  # fmt: skip
    code = _told(summary_of(found), write_limits(found, output), found.matrix)
    return 130 if found.interrupted else code


def _built_in(names: tuple[str, ...], output: Path, workers: int) -> int:
    with bar_until_interrupted("stability") as progress:
        matrix: Matrix = survey(names or tuple(CASES), workers, progress)
    return _told(summary(matrix), write_matrix(matrix, output), matrix)


def _told(lines: tuple[str, ...], written: tuple[Path, ...], matrix: Matrix) -> int:
    page, *others = written
    for line in lines:
        click.echo(line)
    click.echo(f"wrote {page} and {len(others)} files beside it")
    return 3 if matrix.count(Outcome.WRONG) else 0
