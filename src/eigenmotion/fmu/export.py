"""Export of a model as a Functional Mock-up Unit (FMI 2.0, co-simulation).

The file contains the generated C with all headers, so that it can be compiled again, the description of its variables,
and a binary for this platform. A unit is a stepper (em_control.h) whose parameters and start are set by name.
"""

import platform
import re
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from jinja2 import Environment, PackageLoader, StrictUndefined

from ..arguments.methods import FIXED, STEPPED, Method, method_of
from ..building.build import cached_sources, system_of
from ..building.cache import key
from ..building.request import Request, request
from ..building.toolchain import INCLUDE, LINK, SHARED, STANDARD, run, toolchain
from ..codegen.model import Model, ModelError
from ..codegen.model.normalise import real, shown
from ..files import write

if TYPE_CHECKING:
    from ..system.system import System

_HERE = Path(__file__).parent
_HEADERS = ("em_fmi2.h", "em_unit_words.h", "em_unit.h", "em_fmu.h")
_WHEN = (1980, 1, 1, 0, 0, 0)  # date of all files in the zip, so that the same model gives the same bytes


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable of a unit, with its FMI attributes; the value reference is its index.

    initial, start : "" and None if the attribute is omitted
    """

    name: str
    causality: str
    variability: str
    initial: str
    start: str | None


@dataclass(frozen=True, slots=True)
class Unit:
    """The data of a unit for the templates.

    outputs, calculated : indices of variables, counted from 1
    """

    name: str
    guid: str
    sources: tuple[str, ...]
    variables: tuple[Variable, ...]
    outputs: tuple[int, ...]
    calculated: tuple[int, ...]
    velocities: tuple[str, ...]
    method: int
    rtol: str
    atol: str
    step: str


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
    chosen: Method = method_of(method, STEPPED)
    target = _target(path)
    options = tuple(_positive(value, name) for value, name in ((rtol, "rtol"), (atol, "atol")))
    unit = packed(requested, chosen, options, _step(chosen, step))
    try:
        write(target, unit)
    except OSError as error:
        raise ModelError(f"{target}: nothing can be written there ({error.strerror})") from error
    return target


def _target(path: object) -> Path:
    if not isinstance(path, (str, PathLike)):
        raise ModelError(f"path is {shown(path)}: give the name of a file, as {'unit.fmu'!r}")
    target = Path(path)
    if target.suffix != ".fmu":
        raise ModelError(f"{target}: the name of a Functional Mock-up Unit ends in .fmu")
    if target.is_dir():
        raise ModelError(f"{target} is a folder: give the name of a file")
    return target


def _positive(value: float, name: str) -> float:
    number = real(value, name)
    if not 0 < number < 1:
        raise ModelError(f"{name} is {number}, but must be above 0 and less than 1")
    return number


def _step(method: Method, step: float | None) -> float:
    if (step is not None) != (method.name in FIXED):
        raise ModelError(
            f"step= is for methods of fixed step ({', '.join(FIXED)}), which need it; method is {method.name}"
        )
    return 0.0 if step is None else _positive(step, "step")


def packed(requested: Request, method: Method, tolerances: tuple[float, ...], step: float) -> bytes:
    """Return the unit's bytes: the same for the same model, options and compiler."""
    texts = {file.name: file.text for file in cached_sources(requested).files if not file.name.endswith(".pyx")}
    texts |= {path.name: path.read_text(encoding="utf-8") for path in sorted(INCLUDE.rglob("*.h"))}
    texts |= {name: (_HERE / name).read_text(encoding="utf-8") for name in _HEADERS}
    texts = {name: _side_by_side(text) for name, text in texts.items()}
    unit = _unit(system_of(requested), texts, method, tolerances, step)
    texts[f"{unit.name}_fmu.c"] = _template("unit.c.jinja", unit)
    files = {"modelDescription.xml": _template("modelDescription.xml.jinja", unit).encode()}
    files |= {f"sources/{name}": text.encode() for name, text in sorted(texts.items())}
    files[f"binaries/{_platform()}/{unit.name}{_suffix()}"] = _binary(unit, texts)
    content = BytesIO()
    with ZipFile(content, "w") as archive:
        for name, data in files.items():
            archive.writestr(ZipInfo(name, _WHEN), data, ZIP_DEFLATED)
    return content.getvalue()


def _side_by_side(text: str) -> str:
    """Return C with includes from its own folder, where importing tools expect headers."""
    return re.sub(r'^#include "\w+/(\w+\.h)"', r'#include "\1"', text, flags=re.MULTILINE)


def _unit(
    system: "System", texts: Mapping[str, str], method: Method, tolerances: tuple[float, ...], step: float
) -> Unit:
    variables = tuple(_variables(system))
    for variable in variables:
        _check_xml(system.name, variable.name)
    places = {v.name: k for k, v in enumerate(variables, 1)}
    if len(places) < len(variables):
        raise ModelError(f"{system.name}: two of its numbers have one name, which FMI cannot tell apart: give each its "
                         "own, outputs too")  # fmt: skip
    parts = (*(text for _, text in sorted(texts.items())), method.name, *map(repr, tolerances), repr(step))
    digest = key(*parts)
    rtol, atol = map(repr, tolerances)
    return Unit(
        name=system.name,
        guid="{" + "-".join(digest[a:b] for a, b in ((0, 8), (8, 12), (12, 16), (16, 20), (20, 32))) + "}",
        sources=(f"{system.name}.c", f"{system.name}_fmu.c"),
        variables=variables,
        outputs=tuple(places[v.name] for v in variables if v.causality == "output"),
        calculated=tuple(places[v.name] for v in variables if v.initial == "calculated"),
        velocities=tuple(map(repr, system.begin()[1].tolist())),
        method=method.number,
        rtol=rtol,
        atol=atol,
        step=repr(step),
    )


def _check_xml(model: str, name: str) -> None:
    """Raise ModelError for a name that XML cannot represent: with control characters, tabs or line ends."""
    if any(ord(one) < 32 or 127 <= ord(one) < 160 or one in "\ufffe\uffff" for one in name):
        raise ModelError(
            f"{model}: {name!r} has a character that the description of a unit, which is XML, cannot hold. Rename it."
        )


def _variables(system: "System") -> Iterator[Variable]:
    """Yield all variables in the order of em_unit.h."""
    x, v = (values.tolist() for values in system.begin())
    places = (*system.coordinates, *(f"integral({name})" for name in system.states))
    rates = (*(f"der({name})" for name in system.coordinates), *system.states)
    for name, value in system.parameters.items():
        yield Variable(name, "parameter", "fixed", "exact", repr(value))
    for name, value in zip(places, x, strict=True):
        yield Variable(name, "output", "continuous", "exact", repr(value))
    for name, value in zip(rates, v, strict=True):
        yield Variable(name, "output", "continuous", "exact", repr(value))
    for name, value in system.inputs.items():
        yield Variable(name, "input", "continuous", "", repr(value))
    for name in system.outputs:
        yield Variable(name, "output", "continuous", "calculated", None)


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
