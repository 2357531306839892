"""`eigenmotion report`."""

from importlib import import_module
from pathlib import Path

import click

from eigenmotion.building.request import Request, request
from eigenmotion.presentation.figures import require_matplotlib
from eigenmotion.report import ReportOptions, examine
from eigenmotion.report.output import recommendation, write_report

from ..options import (
    ABOVE_ZERO,
    assignments,
    bar_until_interrupted,
    check_writable,
    define,
    distinct,
    ending,
    folder,
    setting,
    values,
)


@click.command("report")
@click.argument("models", metavar="MODEL...", nargs=-1, type=click.Path(path_type=Path))
@folder("report", "page, pictures and numbers")
@click.option("--error", type=ABOVE_ZERO, default=1e-8, show_default=True, metavar="E",
              help="The error for which to recommend a method.")  # fmt: skip
@ending(ABOVE_ZERO)
@setting
@define
@click.option("--all", "everything", is_flag=True, help="Draw all curves in the pictures, not one of each kind.")
@click.option("--paper", is_flag=True, help="Also draw the figures of the paper's experiment.")
def command(
    models: tuple[Path, ...],
    output: Path,
    error: float,
    t_end: float,
    settings: tuple[str, ...],
    define: tuple[str, ...],
    everything: bool,
    paper: bool,
) -> None:
    """Measure error against run time of each MODEL for all formulations and methods, SciPy and other packages.

    Prints the formulation, method and tolerance that reach the given error in the least time on this machine. Writes
    report.html, which shows the numbers of every run, report.json, report.csv and pictures. These show one curve of
    each kind, at most eight; --all and a switch on the page show all.
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
        _report(requests, options, output, everything)
    if paper:
        _draw_paper(output)


def _report(requests: list[Request], options: list[ReportOptions], output: Path, everything: bool) -> None:
    reports = []
    for each, settings in zip(requests, options, strict=True):
        with bar_until_interrupted(each.model.name) as progress:
            reports.append(examine(each.model, settings, progress))
    page, *others = write_report(reports, output, everything)
    advice = {report.name: recommendation(report) for report in reports}
    for name, (first, *_) in advice.items():
        click.echo(f"{name}: {first}")
    for name, (_, *rest) in advice.items():
        for sentence in [f"{name}:"] * (len(reports) > 1) + [f"  {sentence}" for sentence in rest]:
            click.echo(sentence)
    click.echo(f"wrote {page} and {len(others)} files beside it")


def _draw_paper(output: Path) -> None:
    click.echo(str(import_module("eigenmotion.paper").write_figures(output)))
