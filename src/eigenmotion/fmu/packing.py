"""The files of a unit: generated C with all headers, descriptions, and a binary for this platform."""

import json
import platform
import re
import sys
from collections.abc import Mapping
from functools import cache
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.sax.saxutils import quoteattr
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from jinja2 import Environment, PackageLoader, StrictUndefined

from ..building.build import cached_sources, system_of
from ..building.cache import key
from ..building.processes import run
from ..building.request import Request
from ..building.toolchain import INCLUDE, SHARED, STANDARD, link_flags, toolchain
from ..codegen.model import ModelError
from .unit import Content, Unit

VERSIONS = (2, 3)
"""Versions of FMI."""

_INCLUDE = Path(__file__).parent / "include"
_HEADERS = ("em_unit_words.h", "em_face.h", "em_both.h")
_OF_VERSION = {2: ("em_fmi2.h", "em_fmu2.h"), 3: ("em_fmi3.h", "em_fmu3.h", "em_no_fmi3.h")}
_WHEN = (1980, 1, 1, 0, 0, 0)  # date of all files in the zip, so that the same model gives the same bytes


def packed(requested: Request, content: Content, version: int) -> bytes:
    """Return the unit's bytes: the same for the same model, options and compiler.

    Raises
    ------
    ModelError
        Two variables have one name, or one has a name that XML cannot represent.
    BuildError
        There is no compiler, or it failed.
    """
    texts = {file.name: file.text for file in cached_sources(requested).files if not file.name.endswith(".pyx")}
    texts |= {path.name: path.read_text(encoding="utf-8") for path in sorted(INCLUDE.rglob("*.h"))}
    ours = (*_HEADERS, *_OF_VERSION[version], *content.headers)
    paths = {path.name: path for path in _INCLUDE.rglob("*.h")}
    texts |= {name: paths[name].read_text(encoding="utf-8") for name in ours}
    texts = {name: _side_by_side(text) for name, text in texts.items()}
    unit = _unit(system_of(requested).name, texts, content, version)
    texts[f"{unit.name}_fmu.c"] = _template("unit.c.jinja", unit)
    files = {"modelDescription.xml": _template(f"modelDescription{version}.xml.jinja", unit).encode()}
    files |= {f"sources/{name}": text.encode() for name, text in sorted(texts.items())}
    if version == 3:
        files["sources/buildDescription.xml"] = _template("buildDescription.xml.jinja", unit).encode()
    files[f"binaries/{_platform(version)}/{unit.name}{_suffix()}"] = _binary(unit, texts)
    return _zipped(files)


def _zipped(files: Mapping[str, bytes]) -> bytes:
    archived = BytesIO()
    with ZipFile(archived, "w") as archive:
        for name, data in files.items():
            archive.writestr(ZipInfo(name, _WHEN), data, ZIP_DEFLATED)
    return archived.getvalue()


def _side_by_side(text: str) -> str:
    """Return C with includes from its own folder, where importing tools expect headers."""
    return re.sub(r'^#include "\w+/(\w+\.h)"', r'#include "\1"', text, flags=re.MULTILINE)


def _unit(name: str, texts: Mapping[str, str], content: Content, version: int) -> Unit:
    for variable in content.variables:
        _check_xml(name, variable.name)
    names = [*(variable.name for variable in content.variables), *(("time",) if version == 3 else ())]
    if len({*names}) < len(names):
        twice = ", ".join(sorted({one for one in names if names.count(one) > 1}))
        raise ModelError(f"{name}: two numbers of the unit have one name, {twice}, and FMI cannot tell them apart: "
                         "give each its own, outputs too. In FMI 3.0 the time is a number, time.")  # fmt: skip
    described = map(repr, (version, *content.constants, *content.variables))
    digest = key(*(text for _, text in sorted(texts.items())), content.options, *described)
    return Unit(
        name=name,
        guid="{" + "-".join(digest[a:b] for a, b in ((0, 8), (8, 12), (12, 16), (16, 20), (20, 32))) + "}",
        version=version,
        sources=(f"{name}.c", f"{name}_fmu.c"),
        content=content,
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
        loader=PackageLoader(__package__), undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
        keep_trailing_newline=True, autoescape=False,
    )  # fmt: skip
    environment.filters["attribute"] = quoteattr
    environment.filters["quoted"] = json.dumps  # as C writes a string, too, with its escapes
    return environment


def _template(name: str, unit: Unit) -> str:
    return _templates().get_template(name).render(unit=unit)


def _binary(unit: Unit, texts: Mapping[str, str]) -> bytes:
    """Return the compiled unit, for any processor of this architecture, since it may run on other machines."""
    tools = toolchain()
    ours = tuple(flag for flag in tools.optimised if flag != "-march=native")
    flags = (*STANDARD, *ours, *SHARED, *link_flags(tools.command), "-w", *tools.flags)
    with TemporaryDirectory() as place:
        work = Path(place)
        for name, text in texts.items():
            (work / name).write_text(text, encoding="utf-8")
        target = f"{unit.name}{_suffix()}"
        run((*tools.command, *flags, "-I.", *unit.sources, "-lm", "-o", target), work)
        return (work / target).read_bytes()


def _platform(version: int) -> str:
    """Return the folder of the binary, as the version of FMI names platforms."""
    bits = "64" if platform.architecture()[0] == "64bit" else "32"
    if version == 2:
        return {"darwin": "darwin", "win32": "win"}.get(sys.platform, "linux") + bits
    system = {"darwin": "darwin", "win32": "windows"}.get(sys.platform, "linux")
    machine = "aarch64" if platform.machine().lower() in ("arm64", "aarch64") else {"64": "x86_64", "32": "x86"}[bits]
    return f"{machine}-{system}"


def _suffix() -> str:
    return ".dylib" if sys.platform == "darwin" else ".so"
