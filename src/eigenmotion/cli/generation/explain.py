"""`eigenmotion explain`."""

import logging
from pathlib import Path
from typing import Any

import click

from eigenmotion.building.errors import BuildError
from eigenmotion.building.request import Request
from eigenmotion.building.toolchain import toolchain
from eigenmotion.explanation import figure, savings_of, table
from eigenmotion.presentation.figures import FORMATS, require_matplotlib, save
from eigenmotion.progress import clock

from ..options import Shape, check_targets, model, shaping

_log = logging.getLogger("eigenmotion")


@click.command("explain")
@model
@click.option("--latex", is_flag=True, help="Print the equations of motion in LaTeX instead.")
@click.option("--sympy", is_flag=True, help="Print them as Python code for SymPy matrices.")
@click.option("--plot", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help=f"Draw M with its blocks, A, and what each saving saves ({', '.join(FORMATS)}).")  # fmt: skip
@shaping
def command(model: Path, latex: bool, sympy: bool, plot: Path | None, **shape: Any) -> None:
    """Show the states, blocks and operation counts of MODEL, and which terms its code leaves out and why.

    --plot also draws the structure of M and A, and prints the states and operations without each saving.
    """
    if latex + sympy + bool(plot) > 1:
        raise click.UsageError("--latex, --sympy and --plot: choose one")
    if plot:
        require_matplotlib()
        check_targets(("--plot", plot, FORMATS))
    with clock():
        request = Shape(**shape).request(model)
        _log.info("deriving %s", request.model.name)
        text = _text(request, latex, sympy)
        found = savings_of(request) if plot else None
    click.echo(text.rstrip("\n"))
    if plot and found:
        click.echo(f"\n{table(found)}\n\ndrawn to {save(figure(found), plot)}")


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
