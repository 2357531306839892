"""`eigenmotion explain`."""

from pathlib import Path
from typing import Any

import click

from .options import Shape, model, shaping


@click.command("explain")
@model
@shaping
def command(model: Path, **shape: Any) -> None:
    """Show the states, blocks and operation counts of MODEL, and what its code leaves out and why."""
    click.echo(Shape(**shape).order(model).explanation().rstrip("\n"))
