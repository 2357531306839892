"""`eigenmotion build`."""

from pathlib import Path
from typing import Any

import click

from eigenmotion.building.build import make
from eigenmotion.building.toolchain import toolchain
from eigenmotion.progress import clock, durations

from ..options import Shape, distinct, models, output, shaping


@click.command("build")
@models
@output
@shaping
def command(models: tuple[Path, ...], output: Path, **shape: Any) -> None:
    """Write the sources of each MODEL and, beside them, the compiled module.

    `from generated import NAME` imports it from the folder that contains `generated`; `NAME.system` is its System.
    A compiled module is for this Python on this kind of processor: commit the sources, not the module.
    """
    requests = distinct([Shape(**shape).request(model) for model in models])
    tools = toolchain()
    for request in requests:
        with clock() as stages:
            library = make(request, tools, output)
        click.echo(f"built {output / library.name}{durations(stages.spent)}")
