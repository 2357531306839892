"""Export of a model as a Functional Mock-up Unit (FMI 2.0, co-simulation).

The file contains the generated C with all headers, so that it can be compiled again, the description of its variables,
and a binary for this platform. Its numbers are set by name. It is a stepper (em_control.h), or inverse dynamics.
"""

import platform
import re
import sys
from collections.abc import Iterable, Mapping
from functools import cache
from io import BytesIO
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from xml.sax.saxutils import quoteattr
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from jinja2 import Environment, PackageLoader, StrictUndefined

from ..building.build import cached_sources, system_of
from ..building.cache import key
from ..building.request import Request, request
from ..building.toolchain import INCLUDE, LINK, SHARED, STANDARD, run, toolchain
from ..codegen.model import Model, ModelError
from ..codegen.model.normalise import shown
from ..files import write
from .inverse_unit import inverse_unit
from .motion_unit import motion_unit, stepping_of
from .unit import Content, Unit

_HERE = Path(__file__).parent
_HEADERS = ("em_fmi2.h", "em_unit_words.h", "em_fmu.h")
_STEPPING = {"method": "dop853", "rtol": 1e-6, "atol": 1e-9, "step": None}
_WHEN = (1980, 1, 1, 0, 0, 0)  # date of all files in the zip, so that the same model gives the same bytes


def export_fmu(
    model: Model | str | PathLike[str],
    path: str | PathLike[str],
    *,
    formulation: str | None = None,
    close_eigenvalues: str = "bounded",
    schur: str = "auto",
    method: str = "dop853",
    rtol: float = 1e-6,
    atol: float = 1e-9,
    step: float | None = None,
    inverse_dynamics: Mapping[Any, float] | Iterable[Any] | None = None,
    motion: Iterable[Any] | None = None,
    **keywords: Any,
) -> Path:
    """Write a model as a Functional Mock-up Unit (FMI 2.0, co-simulation), with its C inside; return the path.

    Parameters of the model, and coordinates and rates (`der(theta)`) at the start, can be set. Inputs are constant
    during a communication step. Coordinates, rates and the model's outputs are outputs.

    Parameters
    ----------
    model
        A Model, or the file that defines one; `keywords` are arguments of the file's function.
    path
        FILE.fmu
    method, step
        A compiled method of `simulate`, or one of fixed step of `System.stepper`, and its step [s].
    rtol, atol
        If the importing tool sets a tolerance, it replaces rtol, and atol is scaled by the same factor.
    inverse_dynamics
        Names of actuators, as in `System.inverse_dynamics`, for a unit that gives their forces for a motion: positions,
        rates and accelerations of coordinates are inputs. Nothing is integrated.
    motion
        The coordinates of that motion, as many as there are degrees of freedom, or all. Default: all or, with
        constraints, those of the actuators. The others follow from the constraints.

    Raises
    ------
    ModelError
        A mistake in the model or the options, or two variables of the unit would have the same name.
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
    if inverse_dynamics is None:
        if motion is not None:
            raise ModelError("motion= is for units of inverse dynamics: give inverse_dynamics=, their actuators, too")
        stepping = stepping_of(method, rtol, atol, step)
        content = motion_unit(system_of(requested), stepping)
    else:
        _check_steps_by_default(method=method, rtol=rtol, atol=atol, step=step)
        content = inverse_unit(system_of(requested), inverse_dynamics, motion)
    unit = packed(requested, content)
    try:
        write(target, unit)
    except OSError as error:
        raise ModelError(f"{target}: nothing can be written there ({error.strerror})") from error
    return target


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


def packed(requested: Request, content: Content) -> bytes:
    """Return the unit's bytes: the same for the same model, options and compiler."""
    texts = {file.name: file.text for file in cached_sources(requested).files if not file.name.endswith(".pyx")}
    texts |= {path.name: path.read_text(encoding="utf-8") for path in sorted(INCLUDE.rglob("*.h"))}
    texts |= {name: (_HERE / name).read_text(encoding="utf-8") for name in (*_HEADERS, *content.headers)}
    texts = {name: _side_by_side(text) for name, text in texts.items()}
    unit = _unit(system_of(requested).name, texts, content)
    texts[f"{unit.name}_fmu.c"] = _template("unit.c.jinja", unit)
    files = {"modelDescription.xml": _template("modelDescription.xml.jinja", unit).encode()}
    files |= {f"sources/{name}": text.encode() for name, text in sorted(texts.items())}
    files[f"binaries/{_platform()}/{unit.name}{_suffix()}"] = _binary(unit, texts)
    archived = BytesIO()
    with ZipFile(archived, "w") as archive:
        for name, data in files.items():
            archive.writestr(ZipInfo(name, _WHEN), data, ZIP_DEFLATED)
    return archived.getvalue()


def _side_by_side(text: str) -> str:
    """Return C with includes from its own folder, where importing tools expect headers."""
    return re.sub(r'^#include "\w+/(\w+\.h)"', r'#include "\1"', text, flags=re.MULTILINE)


def _unit(name: str, texts: Mapping[str, str], content: Content) -> Unit:
    for variable in content.variables:
        _check_xml(name, variable.name)
    places = {v.name: k for k, v in enumerate(content.variables, 1)}
    if len(places) < len(content.variables):
        raise ModelError(f"{name}: two of its numbers have one name, which FMI cannot tell apart: give each its "
                         "own, outputs too")  # fmt: skip
    digest = key(*(text for _, text in sorted(texts.items())), content.options, *map(repr, content.constants))
    return Unit(
        name=name,
        guid="{" + "-".join(digest[a:b] for a, b in ((0, 8), (8, 12), (12, 16), (16, 20), (20, 32))) + "}",
        sources=(f"{name}.c", f"{name}_fmu.c"),
        content=content,
        outputs=tuple(places[v.name] for v in content.variables if v.causality == "output"),
        initial=tuple(places[v.name] for v in content.variables if v.initial in ("approx", "calculated")),
    )


def _check_xml(model: str, name: str) -> None:
    """Raise ModelError for a name that XML cannot represent: with control characters, tabs or line ends."""
    if any(ord(one) < 32 or 127 <= ord(one) < 160 or one in "\ufffe\uffff" for one in name):
        raise ModelError(
            f"{model}: {name!r} has a character that the description of a unit, which is XML, cannot hold. Rename it."
        )


@cache
def _templates() -> Environment:
    environment = Environment(
        loader=PackageLoader(__package__, "."), undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
        keep_trailing_newline=True, autoescape=False,
    )  # fmt: skip
    environment.filters["attribute"] = quoteattr
    return environment


def _template(name: str, unit: Unit) -> str:
    return _templates().get_template(name).render(unit=unit)


def _binary(unit: Unit, texts: Mapping[str, str]) -> bytes:
    """Return the compiled unit, for any processor of this architecture, since it may run on other machines."""
    tools = toolchain()
    ours = tuple(flag for flag in tools.optimised if flag != "-march=native")
    flags = (*STANDARD, *ours, *SHARED, *LINK, "-w", *tools.flags)
    with TemporaryDirectory() as place:
        work = Path(place)
        for name, text in texts.items():
            (work / name).write_text(text, encoding="utf-8")
        target = f"{unit.name}{_suffix()}"
        run((*tools.command, *flags, "-I.", *unit.sources, "-lm", "-o", target), work)
        return (work / target).read_bytes()


def _platform() -> str:
    """Return the folder of the binary, as FMI 2.0 names platforms."""
    system = {"darwin": "darwin", "win32": "win"}.get(sys.platform, "linux")
    return f"{system}{'64' if platform.architecture()[0] == '64bit' else '32'}"


def _suffix() -> str:
    return ".dylib" if sys.platform == "darwin" else ".so"
