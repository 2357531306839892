"""`eigenmotion equilibrium`."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from eigenmotion import ModelError
from eigenmotion.analysis.equilibrium.equilibrium import Equilibrium, find_equilibrium
from eigenmotion.analysis.linear.text import description, state_rows
from eigenmotion.analysis.state.active_contacts import named_modes
from eigenmotion.building.build import system_of
from eigenmotion.progress import clock

from ..options import Shape, model, setting, shaping, values


@click.command("equilibrium")
@model
@setting
@click.option("--free", multiple=True, metavar="NAME",
              help="An unknown to solve for: a coordinate, theta' for a rate, an input or a parameter. Default: all "
              "coordinates.")  # fmt: skip
@shaping
def command(model: Path, settings: tuple[str, ...], free: tuple[str, ...], **shape: Any) -> int:
    """Find an equilibrium of MODEL, at rest unless rates are set; print the state and its modes.

    If there is none near the given state, the command prints the residuals and exits with code 2. Contacts and
    frictions hold as their forces allow. At the limit between two contact modes there are no eigenvalues unless a mode
    is set, for example floor_held=0.
    """
    request = Shape(**shape).request(model)
    arguments: dict[str, Any] = dict(values(request.model, settings))
    with clock():
        system = system_of(request)
        result = find_equilibrium(system, arguments.pop("x0", None), free=free or None, **arguments)
        text = _described(result, arguments.get("parameters", {})) if result.success else result.message
    click.echo("\n".join([text, *_solved(result, free)]))
    return 0 if result.success else 2


def _described(result: Equilibrium, arguments: Mapping[str, float]) -> str:
    """Return the state and its modes, or the reason why there are no modes."""
    system = result.system
    try:
        return description(result.linearize(mode=named_modes(system.compiled, arguments)))
    except ModelError as error:
        return "\n".join([f"{system.name}: {result.message}", "", *state_rows(system.coordinates, result.x, result.v,
                          result.acceleration), "", str(error)])  # fmt: skip


def _solved(result: Equilibrium, free: tuple[str, ...]) -> list[str]:
    """Return lines with the inputs and parameters that were solved for."""
    arguments = result.inputs | result.parameters
    return [f"{name} = {arguments[name] + 0.0:.9g}" for name in free if name in arguments]
