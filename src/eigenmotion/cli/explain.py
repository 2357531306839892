"""`eigenmotion explain`."""

import logging
from pathlib import Path
from typing import Any

import click

from eigenmotion.building.errors import BuildError
from eigenmotion.building.toolchain import toolchain

from .options import Shape, model, shaping
from .progress import clock

_log = logging.getLogger("eigenmotion")


@click.command("explain")
@model
@shaping
def command(model: Path, **shape: Any) -> None:
    """Show the states, blocks and operation counts of MODEL, and what its code leaves out and why."""
    with clock():
        order = Shape(**shape).order(model)
        _log.info("deriving %s", order.model.name)
        text = order.explanation()
        width = _width()
    click.echo(text.rstrip("\n"))
    click.echo(f"\nThis machine\n  {width}")


def _width() -> str:
    """Say how many lanes there are."""
    try:
        lanes = toolchain().lanes
    except BuildError as error:
        return f"its vectors are not known: {str(error).splitlines()[0]}"
    return f"{lanes} numbers in a vector" if lanes > 1 else "no vectors: lanes are taken one by one"
