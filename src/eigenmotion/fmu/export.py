"""Export of a model as a Functional Mock-up Unit (FMI 2.0 or 3.0; co-simulation and model exchange).

Its numbers are set by name. It is a stepper (em_control.h), a motion that the importing tool integrates, or inverse
dynamics.
"""

from collections.abc import Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from ..building.build import system_of
from ..building.request import Request, request
from ..codegen.model import Model, ModelError
from ..codegen.model.normalise import shown
from ..files import write
from .inverse_unit import inverse_unit
from .labels import labelled
from .motion_unit import motion_unit, stepping_of
from .packing import VERSIONS, packed
from .unit import Content

_STEPPING = {"method": "dop853", "rtol": 1e-6, "atol": 1e-9, "step": None}


def export_fmu(
    model: Model | str | PathLike[str],
    path: str | PathLike[str],
    *,
    fmi: int = 2,
    formulation: str | None = None,
    close_eigenvalues: str = "bounded",
    schur: str = "auto",
    method: str = "dop853",
    rtol: float = 1e-6,
    atol: float = 1e-9,
    step: float | None = None,
    inverse_dynamics: Mapping[Any, float] | Iterable[Any] | None = None,
    motion: Iterable[Any] | None = None,
    units: Mapping[Any, str] | None = None,
    descriptions: Mapping[Any, str] | None = None,
    **keywords: Any,
) -> Path:
    """Write a model as a Functional Mock-up Unit, with its C inside; return the path.

    Parameters of the model, and coordinates and rates (`der(theta)`) at the start, can be set. Coordinates, rates and
    the model's outputs are outputs. The unit is for co-simulation, in which it steps by itself and inputs are constant
    during a communication step, and for model exchange, in which the importing tool integrates its states. Models with
    contacts, frictions or changes at certain times are for co-simulation only.

    Parameters
    ----------
    model
        A Model, or the file that defines one; `keywords` are arguments of the file's function.
    path
        FILE.fmu
    fmi
        The version of FMI, 2 or 3.
    method, step
        A compiled method of `simulate`, or one of fixed step of `System.stepper`, and its step [s].
    rtol, atol
        If the importing tool sets a tolerance, it replaces rtol, and atol is scaled by the same factor. In model
        exchange, constraints are restored where they have drifted by a tenth of these.
    inverse_dynamics
        Names of actuators, as in `System.inverse_dynamics`, for a unit that gives their forces for a motion: positions,
        rates and accelerations of coordinates are inputs. Nothing is integrated.
    motion
        The coordinates of that motion, as many as there are degrees of freedom, or all. Default: all or, with
        constraints, those of the actuators. The others follow from the constraints.
    units
        Physical units of variables, name -> unit: a product such as N*m, kg*m^2 or rad/s. Those of rates follow from
        those of coordinates. Default: the units of the model, if its time is in s.
    descriptions
        Descriptions of variables, name -> text.

    Raises
    ------
    ModelError
        A mistake in the model or the options; a unit or a description of no variable; or two variables of the unit
        would have the same name.
    BuildError
        There is no compiler, or it failed.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> em.export_fmu(model, "pendulum.fmu").name
    'pendulum.fmu'
    """
    requested = request(model, keywords, formulation=formulation, close_eigenvalues=close_eigenvalues, schur=schur)
    target = _target(path)
    if fmi not in VERSIONS:
        raise ModelError(f"fmi is {shown(fmi)}: give the version of FMI, 2 or 3")
    stepping = {"method": method, "rtol": rtol, "atol": atol, "step": step}
    content = _content(requested, stepping, inverse_dynamics, motion)
    unit = packed(requested, labelled(content, units, descriptions, dict(requested.model.units)), fmi)
    try:
        write(target, unit)
    except OSError as error:
        raise ModelError(f"{target}: nothing can be written there ({error.strerror})") from error
    return target


def _content(requested: Request, stepping: dict[str, Any], inverse_dynamics: Any, motion: Any) -> Content:
    """Return the content of a unit that moves, or of one of inverse dynamics."""
    if inverse_dynamics is not None:
        _check_steps_by_default(**stepping)
        return inverse_unit(system_of(requested), inverse_dynamics, motion)
    if motion is not None:
        raise ModelError("motion= is for units of inverse dynamics: give inverse_dynamics=, their actuators, too")
    checked = stepping_of(**stepping)
    return motion_unit(system_of(requested), checked)


def _check_steps_by_default(**stepping: Any) -> None:
    """Raise ModelError for an option that a unit of inverse dynamics has no use for."""
    if given := [name for name, value in stepping.items() if value != _STEPPING[name]]:
        raise ModelError(f"{given[0]}= is for units that move. One of inverse dynamics integrates nothing.")


def _target(path: object) -> Path:
    if not isinstance(path, (str, PathLike)):
        raise ModelError(f"path is {shown(path)}: give the name of a file, as {'unit.fmu'!r}")
    target = Path(path)
    if target.suffix != ".fmu":
        raise ModelError(f"{target}: the name of a Functional Mock-up Unit ends in .fmu")
    if target.is_dir():
        raise ModelError(f"{target} is a folder: give the name of a file")
    return target
