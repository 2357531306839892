"""`eigenmotion stability`."""

import os
from pathlib import Path

import click

from eigenmotion.presentation.figures import require_matplotlib
from eigenmotion.progress import bar
from eigenmotion.stability import CASES, Matrix, Outcome, summary, survey, write_matrix

from ..options import check_writable, folder

_WORKERS = min(2, os.cpu_count() or 1)


@click.command("stability")
@folder("stability", "page, pictures and numbers")
@click.option("--case", "names", multiple=True, type=click.Choice(list(CASES)), metavar="CASE",
              help=f"Only this case; may be given several times. Cases: {', '.join(CASES)}.")  # fmt: skip
@click.option("--workers", type=click.IntRange(min=1), default=_WORKERS, show_default=True,
              help="Number of parallel processes.")  # fmt: skip
def command(output: Path, names: tuple[str, ...], workers: int) -> int:
    """Run extreme cases with every formulation, option and method, and classify the outcome of each run.

    Writes stability.html, stability.json and the pictures. Exits with 3 if a run that reports success is wrong.
    """
    require_matplotlib()
    check_writable(output, "-o")
    with bar("stability") as progress:
        matrix: Matrix = survey(names or tuple(CASES), workers, progress)
    page, *others = write_matrix(matrix, output)
    for line in summary(matrix):
        click.echo(line)
    click.echo(f"wrote {page} and {len(others)} files beside it")
    return 3 if matrix.count(Outcome.WRONG) else 0
