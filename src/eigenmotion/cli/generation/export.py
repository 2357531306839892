"""`eigenmotion export`."""

from pathlib import Path
from typing import Any

import click

from eigenmotion.arguments.methods import STEPPED
from eigenmotion.fmu.export import export_fmu
from eigenmotion.progress import clock

from ..options import ABOVE_ZERO, assignments, check_file, model, shaping


@click.command("export")
@model
@click.option("--fmu", type=click.Path(path_type=Path, dir_okay=False), required=True, metavar="FILE.fmu",
              help="The Functional Mock-up Unit to write.")  # fmt: skip
@click.option("--method", type=click.Choice(list(STEPPED)), default="dop853", show_default=True,
              help="Integration method of the unit.")  # fmt: skip
@click.option("--step", type=ABOVE_ZERO, metavar="H", help="Step size in seconds, for rk4 and midpoint.")
@click.option("--rtol", type=ABOVE_ZERO, default=1e-6, show_default=True, metavar="R", help="Relative tolerance.")
@click.option("--atol", type=ABOVE_ZERO, default=1e-9, show_default=True, metavar="A", help="Absolute tolerance.")
@shaping
def command(model: Path, fmu: Path, define: tuple[str, ...], **options: Any) -> None:
    """Export MODEL as a Functional Mock-up Unit: FMI 2.0, co-simulation, with its C sources and a binary."""
    check_file(fmu, "--fmu")
    with clock():
        export_fmu(model, fmu, **options | assignments(define, "-D"))
    click.echo(f"wrote {fmu} ({fmu.stat().st_size / 1e3:.0f} kB); import it in any tool that speaks FMI 2.0")
