"""`eigenmotion report`."""

from importlib import import_module
from pathlib import Path

import click

from eigenmotion.building.request import Request, request
from eigenmotion.presentation.figures import require_matplotlib
from eigenmotion.progress import bar
from eigenmotion.report import ReportOptions, examine, recommendation, write_report

from ..options import ABOVE_ZERO, assignments, check_writable, define, distinct, ending, folder, setting, values


@click.command("report")
@click.argument("models", metavar="MODEL...", nargs=-1, type=click.Path(path_type=Path))
@folder("report", "page, pictures and numbers")
@click.option("--error", type=ABOVE_ZERO, default=1e-8, show_default=True, metavar="E",
              help="The error for which to recommend a method.")  # fmt: skip
@ending(ABOVE_ZERO)
@setting
@define
@click.option("--paper", is_flag=True, help="Also draw the figures of the paper's experiment.")
def command(
    models: tuple[Path, ...],
    output: Path,
    error: float,
    t_end: float,
    settings: tuple[str, ...],
    define: tuple[str, ...],
    paper: bool,
) -> None:
    """Measure error against run time of each MODEL for all formulations and methods, SciPy and other packages.

    Writes report.html, report.json, report.csv and the pictures, and recommends the formulation, method and tolerance
    that reach the given error in the least time on this machine.
    """
    if not (models or paper):
        raise click.UsageError("name at least one MODEL, or --paper")
    if settings and not models:
        raise click.UsageError("--set is for a MODEL: name one")
    require_matplotlib()
    check_writable(output, "-o")
    if models:
        requests = distinct([request(file, assignments(define, "-D")) for file in models])
        options = [ReportOptions(error=error, t_end=t_end, settings=values(each.model, settings)) for each in requests]
        _report(requests, options, output)
    if paper:
        _draw_paper(output)


def _report(requests: list[Request], options: list[ReportOptions], output: Path) -> None:
    reports = []
    for each, settings in zip(requests, options, strict=True):
        with bar(each.model.name) as progress:
            reports.append(examine(each.model, settings, progress))
    page, *others = write_report(reports, output)
    for report in reports:
        click.echo(f"{report.name}: " + "\n  ".join(recommendation(report)))
    click.echo(f"wrote {page} and {len(others)} files beside it")


def _draw_paper(output: Path) -> None:
    click.echo(str(import_module("eigenmotion.paper").write_figures(output)))
