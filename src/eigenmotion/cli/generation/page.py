"""`eigenmotion page`."""

import logging
from pathlib import Path
from typing import Any

import click

from eigenmotion.building.build import system_of
from eigenmotion.codegen.model import Model, ModelError
from eigenmotion.codegen.model.normalise import name_of
from eigenmotion.files import write
from eigenmotion.progress import clock
from eigenmotion.webpage.page import Place, Run, page
from eigenmotion.webpage.page_object import of_space, with_meshes

from ..options import Finite, Shape, check_file, ending, model, setting, shaping, values
from ..starts import LABEL, assembled, assembling

_log = logging.getLogger("eigenmotion")


@click.command("page")
@model
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help="The page; MODEL.html by default.")  # fmt: skip
@ending(Finite())
@click.option("--rtol", type=Finite(), default=1e-9, show_default=True, metavar="R", help="Relative tolerance.")
@click.option("--atol", type=Finite(), default=1e-9, show_default=True, metavar="A", help="Absolute tolerance.")
@click.option("--embed", is_flag=True, help="A compact page for a frame in a page of yours; it reports its height.")
@click.option("--home", default="", metavar="URL", help="The address of a link at the end of the page.")
@setting
@assembling
@shaping
def command(
    model: Path,
    output: Path | None,
    t_end: float,
    rtol: float,
    atol: float,
    embed: bool,
    home: str,
    settings: tuple[str, ...],
    closes: bool,
    **shape: Any,
) -> None:
    """Write an interactive page of MODEL: one HTML file with the model compiled to WebAssembly, for any browser.

    Needs a compiler for WebAssembly: pip install 'eigenmotion[page]'. Robots from URDF files show their meshes, unless
    -D meshes=no.
    """
    request = Shape(**shape).request(model, with_meshes)
    target = output or Path(f"{request.model.name}.html")
    _check(target, t_end, rtol, atol)
    given = _given(request.model, settings)
    with clock():
        if closes:
            given, moved = assembled(system_of(request), given)
            click.echo(f"{LABEL}: {moved}")
        _log.info("compiling %s to WebAssembly", request.model.name)
        library, missing = of_space(request.model)
        run = Run(t_end, rtol, atol, given)
        text = page(request, model.read_text(encoding="utf-8"), run, library, Place(embed, home))
    if missing:
        click.echo(missing, err=True)
    write(target, text.encode())
    click.echo(f"wrote {target} ({len(text.encode()) / 1e3:.0f} kB); open it in a browser")
    if not request.model.drawing:
        click.echo(f"{request.model.name} has no drawing, so the page shows its curves alone: Model(drawing=[...])")


def _given(model: Model, settings: tuple[str, ...]) -> dict[str, dict[str, float]]:
    """Return the initial values of sliders."""
    arguments = values(model, settings)
    if speeds := sorted({name_of(y) for y, _ in model.quasi_velocities} & arguments.get("v0", {}).keys()):
        raise click.UsageError(f"--set {speeds[0]}: a page has rates, not quasi-velocities")
    tables = {table.name for table in model.tables}
    if curves := sorted(tables & {name for kind in ("parameters", "inputs") for name in arguments.get(kind, {})}):
        what = "prescribes a motion" if curves[0] in model.prescribed else "is a table"
        raise click.UsageError(
            f"--set {curves[0]}: it {what}, and a page has that of its model. Change it in the model"
        )
    return arguments


def _check(target: Path, t_end: float, rtol: float, atol: float) -> None:
    """Check the options and the target before the work."""
    check_file(target, "-o")
    for name, value in (("--t-end", t_end), ("--rtol", rtol), ("--atol", atol)):
        if value <= 0:
            raise ModelError(f"{name} is {value:g}; a page needs a positive number")
