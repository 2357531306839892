"""`eigenmotion explain`."""

import logging
from pathlib import Path
from typing import Any

import click

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
    click.echo(text.rstrip("\n"))
