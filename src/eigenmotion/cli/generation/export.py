"""`eigenmotion export`."""

from pathlib import Path
from typing import Any

import click

from eigenmotion.arguments.methods import STEPPED
from eigenmotion.fmu.export import export_fmu
from eigenmotion.progress import clock

from ..options import ABOVE_ZERO, assignments, check_file, listed, model, shaping


@click.command("export")
@model
@click.option("--fmu", type=click.Path(path_type=Path, dir_okay=False), required=True, metavar="FILE.fmu",
              help="The Functional Mock-up Unit to write.")  # fmt: skip
@click.option("--method", type=click.Choice(list(STEPPED)), default="dop853", show_default=True,
              help="Integration method of the unit.")  # fmt: skip
@click.option("--step", type=ABOVE_ZERO, metavar="H", help="Step size in seconds, for rk4 and midpoint.")
@click.option("--rtol", type=ABOVE_ZERO, default=1e-6, show_default=True, metavar="R", help="Relative tolerance.")
@click.option("--atol", type=ABOVE_ZERO, default=1e-9, show_default=True, metavar="A", help="Absolute tolerance.")
@click.option("--inverse", metavar="NAMES",
              help="Give the forces of a motion: of these coordinates and inputs, separated by commas.")  # fmt: skip
@click.option("--path", "motion", metavar="NAMES",
              help="With --inverse and constraints: coordinates with a given motion. Default: those that "
              "act.")  # fmt: skip
@shaping
def command(
    model: Path, fmu: Path, define: tuple[str, ...], inverse: str | None, motion: str | None, **options: Any
) -> None:
    """Export MODEL as a Functional Mock-up Unit: FMI 2.0, co-simulation, with its C sources and a binary.

    The unit moves by forces; with --inverse it gives the forces of a motion.
    """
    check_file(fmu, "--fmu")
    with clock():
        export_fmu(
            model,
            fmu,
            inverse_dynamics=listed(inverse),
            motion=listed(motion),
            **options | assignments(define, "-D"),
        )
    click.echo(f"wrote {fmu} ({fmu.stat().st_size / 1e3:.0f} kB); import it in any tool that speaks FMI 2.0")
