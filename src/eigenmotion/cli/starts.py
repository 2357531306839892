"""The option --assemble: a start that satisfies the constraints, from a rough guess."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import click

from eigenmotion.analysis.equilibrium.assemble import assemble
from eigenmotion.building.build import system_of
from eigenmotion.building.request import Request
from eigenmotion.codegen.model import Model
from eigenmotion.system.system import System

from .options import Command

LABEL = "assembled"


def assembling(command: Command) -> Command:
    """Add --assemble."""
    option = click.option("--assemble", "closes", is_flag=True,
                          help="Close the loops and contacts at the start, from the model's values as a guess; values "
                          "of --set are kept.")  # fmt: skip
    return option(command)


def assembled(system: System, arguments: Mapping[str, Any]) -> tuple[dict[str, Any], str]:
    """Return the arguments of a run with a consistent x0 and v0, by name, and what moved.

    Values of coordinates and rates in `arguments` are kept.

    Raises
    ------
    ModelError
        Nothing near the guess closes.
    """
    x0, v0, parameters = (arguments.get(kind) for kind in ("x0", "v0", "parameters"))
    kept = tuple(name for name in x0 or () if name in system.coordinates)
    found = assemble(system, x0, v0, parameters=parameters, keep=kept)
    states = {name: value for name, value in (x0 or {}).items() if name in system.states}
    x, v = (dict(zip(system.coordinates, values.tolist(), strict=True)) for values in found)
    return {**arguments, "x0": x | states, "v0": v}, found.message


def assembled_model(requested: Request) -> tuple[Model, str]:
    """Return the model of a request with a consistent start, and what moved."""
    model = requested.model
    arguments, message = assembled(system_of(requested), {})
    states = {z: value for z, value in model.initial if any(z == one for one, _ in model.states)}
    x, v = (
        dict(zip(names, arguments[kind].values(), strict=True))
        for names, kind in ((model.coordinates, "x0"), (model.rates, "v0"))
    )
    return replace(model, initial=tuple((states | x | v).items())), message
