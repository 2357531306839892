"""`eigenmotion export`."""

from pathlib import Path
from typing import Any

import click

from eigenmotion.arguments.methods import STEPPED
from eigenmotion.building.request import request
from eigenmotion.casadi.export import export_casadi
from eigenmotion.codegen.model import Model
from eigenmotion.fmu.export import export_fmu
from eigenmotion.progress import clock

from ..options import ABOVE_ZERO, assignments, check_file, check_targets, distinct_assignments, listed, model, shaping
from ..starts import LABEL, assembled_model, assembling

_OF_CASADI = ("parameters", "prefix")
_SPELLED = {"motion": "path", "units": "unit", "descriptions": "describe", "closes": "assemble"}
_OF_BOTH = ("model", "fmu", "casadi", "define", "formulation")


@click.command("export")
@model
@click.option("--fmu", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE.fmu",
              help="The Functional Mock-up Unit to write.")  # fmt: skip
@click.option("--casadi", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE.so|FILE.c",
              help="The external functions of CasADi to write: compiled, or one C file.")  # fmt: skip
@click.option("--fmi", type=click.Choice(["2", "3"]), default="2", show_default=True,
              help="Version of the Functional Mock-up Interface: 2.0 or 3.0.")  # fmt: skip
@click.option("--unit", "units", multiple=True, metavar="NAME=UNIT",
              help="The physical unit of a variable: theta=rad, m=kg, u=N*m; those of rates follow.")  # fmt: skip
@click.option("--describe", "descriptions", multiple=True, metavar="NAME=TEXT",
              help="The description of a variable.")  # fmt: skip
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
@click.option("--parameters", metavar="NAMES",
              help="With --casadi: the parameters that are an input, separated by commas, or 'none'. Default: "
              "all.")  # fmt: skip
@click.option("--prefix", default="", metavar="TEXT",
              help="With --casadi: what the names of the functions begin with.")  # fmt: skip
@assembling
@shaping
def command(model: Path, fmu: Path | None, casadi: Path | None, **options: Any) -> None:
    """Export MODEL for other tools: as a Functional Mock-up Unit, or as functions for CasADi.

    A unit, with its C sources and a binary, is for co-simulation and, without contacts and frictions, for model
    exchange. It moves by forces; with --inverse it gives the forces of a motion, in co-simulation only. Functions for
    CasADi are accelerations, rates of the state, inverse dynamics and outputs, with exact sparse Jacobians.
    """
    if (fmu is None) == (casadi is None):
        raise click.UsageError("give --fmu FILE.fmu or --casadi FILE.so")
    given = assignments(options.pop("define"), "-D")
    if fmu is not None:
        _refuse("--fmu", [name for name in options if name in _OF_CASADI])
        _unit(model, fmu, {name: value for name, value in options.items() if name not in _OF_CASADI}, given)
    elif casadi is not None:
        _refuse("--casadi", [name for name in options if name not in (*_OF_CASADI, *_OF_BOTH)])
        _functions(model, casadi, {name: options[name] for name in (*_OF_CASADI, "formulation")}, given)


def _refuse(kind: str, names: list[str]) -> None:
    """Raise UsageError for an option that was given, but has no use for this kind of export."""
    context = click.get_current_context()
    for name in names:
        if context.get_parameter_source(name) is not click.core.ParameterSource.DEFAULT:
            option = _SPELLED.get(name, name.replace("_", "-"))
            raise click.UsageError(f"--{option} has no use with {kind}")


def _unit(model: Path, fmu: Path, options: dict[str, Any], given: dict[str, str]) -> None:
    check_file(fmu, "--fmu")
    inverse, motion = (listed(options.pop(name)) for name in ("inverse", "motion"))
    fmi = options.pop("fmi")
    for name in ("units", "descriptions"):
        options[name] = distinct_assignments(options[name], f"--{_SPELLED[name]}")
    closes = options.pop("closes")
    with clock():
        source, keywords = _closed(model, options, given) if closes else (model, given)
        export_fmu(source, fmu, fmi=int(fmi), inverse_dynamics=inverse, motion=motion, **options | keywords)
    click.echo(f"wrote {fmu} ({fmu.stat().st_size / 1e3:.0f} kB); import it in any tool that speaks FMI {fmi}.0")


def _closed(model: Path, options: dict[str, Any], given: dict[str, str]) -> tuple[Model, dict[str, str]]:
    """Return the model of a file with a consistent start, and no more arguments of -D."""
    choices = {name: options[name] for name in ("formulation", "close_eigenvalues", "schur")}
    closed, moved = assembled_model(request(model, given, **choices))
    click.echo(f"{LABEL}: {moved}")
    return closed, {}


def _functions(model: Path, casadi: Path, options: dict[str, Any], given: dict[str, str]) -> None:
    check_targets(("--casadi", casadi, (".so", ".c")))
    names = options.pop("parameters")
    with clock():
        export_casadi(model, casadi, parameters=() if names == "none" else listed(names), **options | given)
    prefix = options["prefix"]
    click.echo(f"wrote {casadi} ({casadi.stat().st_size / 1e3:.0f} kB); use casadi.external('{prefix}acceleration', "
               f"'{casadi.with_suffix('.so')}')")  # fmt: skip
