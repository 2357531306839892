"""`eigenmotion explain`."""

import logging
from pathlib import Path
from typing import Any

import click

from eigenmotion.building.errors import BuildError
from eigenmotion.building.request import Request
from eigenmotion.building.toolchain import toolchain
from eigenmotion.progress import clock

from ..options import Shape, model, shaping

_log = logging.getLogger("eigenmotion")


@click.command("explain")
@model
@click.option("--latex", is_flag=True, help="Print the equations of motion in LaTeX instead.")
@click.option("--sympy", is_flag=True, help="Print them as Python code for SymPy matrices.")
@shaping
def command(model: Path, latex: bool, sympy: bool, **shape: Any) -> None:
    """Show the states, blocks and operation counts of MODEL, and which terms its code leaves out and why."""
    if latex and sympy:
        raise click.UsageError("--latex and --sympy: choose one")
    with clock():
        request = Shape(**shape).request(model)
        _log.info("deriving %s", request.model.name)
        text = _text(request, latex, sympy)
    click.echo(text.rstrip("\n"))


def _text(request: Request, latex: bool, sympy: bool) -> str:
    if latex:
        return request.model.equations().latex()
    return (
        request.model.equations().source()
        if sympy
        else f"{request.explanation().rstrip()}\n\nThis machine\n  {_width()}"
    )


def _width() -> str:
    """Return a text about the number of lanes."""
    try:
        lanes = toolchain().lanes
    except BuildError as error:
        return f"its vectors are not known: {str(error).splitlines()[0]}"
    return f"{lanes} numbers in a vector" if lanes > 1 else "no vectors: lanes are taken one by one"
