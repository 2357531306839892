"""`eigenmotion linearize`."""

from pathlib import Path
from typing import Any

import click

from eigenmotion.analysis.linear.text import description, plane
from eigenmotion.analysis.state.active_contacts import named_modes
from eigenmotion.building.build import system_of
from eigenmotion.presentation.figures import FORMATS, require_matplotlib, save
from eigenmotion.progress import clock

from ..options import Shape, check_writable, model, shaping, values
from ..starts import assembled


@click.command("linearize")
@model
@click.option("--at", "settings", multiple=True, metavar="NAME=VALUE",
              help="The state: a coordinate or state, theta'=1 for a rate, a parameter or an input. Other values are "
              "the model's initial ones, or follow from constraints. floor_held=0 selects a contact mode.")  # fmt: skip
@click.option("--plot", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help="Draw the eigenvalues, to FILE.png, .svg or .pdf; needs matplotlib.")  # fmt: skip
@shaping
def command(model: Path, settings: tuple[str, ...], plot: Path | None, **shape: Any) -> None:
    """Linearise MODEL at a state: print eigenvalues with frequency and damping, and describe the modes."""
    check_plot(plot)
    request = Shape(**shape).request(model)
    arguments = values(request.model, settings, "--at")
    with clock():
        system = system_of(request)
        closed, _ = assembled(system, arguments)
        parameters = arguments.get("parameters")
        result = system.linearize(
            closed["x0"],
            closed["v0"],
            parameters=parameters,
            inputs=arguments.get("inputs"),
            mode=named_modes(system.compiled, parameters or {}),
        )
    click.echo(description(result))
    if plot:
        click.echo(f"drawn to {save(plane(result), plot)}")


def check_plot(plot: Path | None) -> None:
    """Check the target before the work."""
    if not plot:
        return
    require_matplotlib()
    if plot.suffix not in FORMATS:
        raise click.UsageError(f"--plot {plot}: known endings are {', '.join(FORMATS)}")
    if not plot.absolute().parent.is_dir():
        raise click.UsageError(f"--plot {plot}: there is no folder {plot.parent}")
    check_writable(plot.absolute().parent, "--plot")
