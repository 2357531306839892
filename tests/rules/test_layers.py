"""Rules of dependency (docs/architecture.md), read off the sources."""

import ast
import importlib.util
import re
import sys
import tomllib
from collections import Counter
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

from .rooms import ROOMS

ROOT = Path(__file__).parents[2]
PACKAGES = {
    "eigenmotion.codegen": ROOT / "codegen",
    "eigenmotion.models": ROOT / "models",
    "eigenmotion.templates": ROOT / "templates",
    "eigenmotion": ROOT / "src" / "eigenmotion",
}


def modules() -> dict[str, Path]:
    """Name of each module of ours -> its file."""
    found: dict[str, Path] = {}
    for package, folder in PACKAGES.items():
        for file in (file for ending in ("py", "pyi", "pyx") for file in folder.rglob(f"*.{ending}")):
            parts = file.relative_to(folder).with_suffix("").parts
            found.setdefault(".".join([package, *(part for part in parts if part != "__init__")]), file)
    return found


def imports(module: str, file: Path) -> Iterator[str]:
    """Absolute names of what a file imports, anywhere in it, and for a type checker alone, too."""
    package = module if file.stem == "__init__" else module.rpartition(".")[0]
    text = file.read_text(encoding="utf-8") if file.suffix != ".pyx" else ""
    for node in ast.walk(ast.parse(text + compiled_imports(file))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            source = importlib.util.resolve_name("." * node.level + (node.module or ""), package)
            yield source
            yield from (f"{source}.{alias.name}" for alias in node.names)


def compiled_imports(file: Path) -> str:
    """The imports at the top of an extension module and its declarations, as Python."""
    texts = [one.read_text(encoding="utf-8") for one in map(file.with_suffix, (".pyx", ".pxd")) if one.exists()]
    lines = re.findall(r"^(?:from \.|import ).*", "\n".join(texts).replace(" cimport ", " import "), re.MULTILINE)
    return "\n".join(["", *lines, ""])


MODULES = modules()


def within(name: str, package: str) -> bool:
    return name == package or name.startswith(f"{package}.")


def test_every_package_is_installed():
    """A folder that pyproject.toml does not list is there in a checkout, and missing from a wheel."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert set(project["tool"]["setuptools"]["packages"]) == {
        name for name, file in MODULES.items() if file.stem == "__init__"
    }


def test_the_sources_are_found():
    assert {
        "eigenmotion",
        "eigenmotion.building.build",
        "eigenmotion.codegen.model.model",
        "eigenmotion.runtime.point",
    } <= set(MODULES)


@pytest.mark.parametrize("module", [name for name in MODULES if within(name, "eigenmotion.codegen")])
def test_codegen_imports_sympy_numpy_jinja_and_the_standard_library(module):
    for name in imports(module, MODULES[module]):
        top = name.partition(".")[0]
        ours = within(name, "eigenmotion.codegen") or within(name, "eigenmotion.templates")
        assert ours or top in {"sympy", "numpy", "jinja2"} or top in sys.stdlib_module_names, f"{module} imports {name}"


@pytest.mark.parametrize("module", [name for name in MODULES if within(name, "eigenmotion.runtime")])
def test_runtime_imports_nothing_of_ours(module):
    for name in imports(module, MODULES[module]):
        assert not within(name, "eigenmotion") or within(name, "eigenmotion.runtime"), f"{module} imports {name}"


RUNTIME = PACKAGES["eigenmotion"] / "runtime"


def imported(module: str) -> set[str]:
    """The modules of ours that one imports, packages only where no module of theirs is meant."""
    named = [name for name in imports(module, MODULES[module]) if name in MODULES]
    return {name for name in named if not any(other.startswith(f"{name}.") for other in named)} - {module}


def room_of(module: str) -> str:
    """Return the longest name of a room that holds a module; else its first folder."""
    inner = module.removeprefix("eigenmotion").removeprefix(".")
    rooms = [room for room in ROOMS if within(inner, room)]
    return max(rooms, key=len) if rooms else inner.partition(".")[0]


def test_modules_import_each_other_in_no_circle():
    try:
        list(TopologicalSorter({module: imported(module) for module in MODULES}).static_order())
    except CycleError as error:
        pytest.fail(" -> ".join(error.args[1]))


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_what_it_may(room):
    used = {room_of(name): f"{module} imports {name}" for module in MODULES if room_of(module) == room
            for name in imported(module)}  # fmt: skip
    assert not [words for other, words in used.items() if other not in (room, *ROOMS[room])]
    assert set(ROOMS[room]) <= set(used), "a room that may be imported is"


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_stands_below_what_it_imports(room):
    above = list(ROOMS)[: list(ROOMS).index(room)]
    assert set(ROOMS[room]) <= {"", "models", *above}


FULL = 12
COUNTED = (".py", ".pyx", ".jinja", ".js", ".css")


def crowded(root: Path) -> dict[str, int]:
    """Folders with more modules, templates or scripts than one can survey, and how many they have."""
    files = (path for path in root.rglob("*") if path.suffix in COUNTED and path.name != "__init__.py")
    counts = Counter(str(path.parent.relative_to(root)) for path in files if "__pycache__" not in path.parts)
    return {folder: count for folder, count in counts.items() if count > FULL}


@pytest.mark.parametrize("package", [name for name in PACKAGES if name != "eigenmotion.models"])
def test_no_folder_is_crowded(package):
    assert not crowded(PACKAGES[package])


def test_a_crowded_folder_is_found(tmp_path):
    (tmp_path / "room").mkdir()
    for number in range(FULL):
        (tmp_path / "room" / f"module_{number}.py").touch()
    (tmp_path / "room" / "__init__.py").touch()
    assert not crowded(tmp_path)
    (tmp_path / "room" / "one_more.pyx").touch()
    assert crowded(tmp_path) == {"room": FULL + 1}


def test_every_room_is_there_and_has_its_rules():
    rooms = {room_of(module) for module in MODULES}
    assert rooms - set(ROOMS) == {"", "__main__", "models", "templates"}
    assert set(ROOMS) <= rooms


def included(header: str, folder: Path) -> set[str]:
    """A header, and those of ours that it includes, directly or not."""
    text = (folder / header).read_text(encoding="utf-8")
    return {header}.union(
        *(included(name, folder) for name in re.findall(r'^#include "([\w/]+\.h)"', text, re.MULTILINE))
    )


STACK = ("", "kinematics", "numeric", "tables", "bodies", "mass", "constraints", "dynamics", "contact", "tableaux",
         "stepper", "gauss_radau", "radau_iia", "methods", "monitors", "events", "loop", "batch",
         "inverse_dynamics", "sensitivity")  # fmt: skip
"""Folders of headers, from the ground up; a header includes none of a folder above its own."""


def test_headers_include_none_of_a_room_above():
    folder = RUNTIME / "include"
    assert {file.parent.relative_to(folder).as_posix() for file in folder.rglob("*.h")} == {r or "." for r in STACK}
    for file in folder.rglob("*.h"):
        room = file.relative_to(folder).parts[-2:-1]
        for other in re.findall(r'^#include "([\w/]+\.h)"', file.read_text(encoding="utf-8"), re.MULTILINE):
            assert STACK.index(Path(other).parts[-2:-1][0] if "/" in other else "") <= STACK.index(*room or ("",)), (
                file.name
            )


def test_no_room_of_headers_holds_more_than_a_dozen():
    folder = RUNTIME / "include"
    assert all(len(list((folder / room).glob("*.h"))) <= 12 for room in STACK)


def test_every_header_says_first_what_it_is():
    for header in (RUNTIME / "include").rglob("*.h"):
        assert header.read_text(encoding="utf-8").startswith(f"/* {header.name}: ")


def named(file: Path) -> set[str]:
    """Headers of ours that an extension module names, itself or in the declarations it imports."""
    text = file.read_text(encoding="utf-8")
    declared = re.findall(r"^from (?:\.|\.\.runtime\.)(\w+) cimport", text, re.MULTILINE)
    beside = {file.with_suffix(".pxd"), *(RUNTIME / f"{name}.pxd" for name in declared)}
    first = re.findall(r'extern from "([\w/]+\.h)"', text)
    return set(first).union(*(named(other) for other in beside - {file} if other.exists()))


def headers(file: Path) -> set[str]:
    """Those of ours that it may include, directly or not."""
    return set().union(*(included(name, RUNTIME / "include") for name in named(file)))


def test_an_extension_is_built_anew_when_a_header_of_it_changes():
    """The compiler listed headers beside each extension (setup.py): ours, but for what an #ifdef leaves out."""
    for file in PACKAGES["eigenmotion"].rglob("*.pyx"):
        listed = file.with_suffix(".d").read_text(encoding="utf-8").partition("\n")[0].split()[1:]
        names = {str(Path(path).relative_to(RUNTIME.relative_to(ROOT) / "include")) for path in listed}
        assert named(file) <= names <= headers(file), file.name


def test_nothing_imports_the_command_line():
    users = {
        module
        for module, file in MODULES.items()
        if not within(module, "eigenmotion.cli") and module != "eigenmotion.__main__"
        for name in imports(module, file)
        if within(name, "eigenmotion.cli")
    }
    assert not users


def test_codegen_is_not_importable_a_second_time():
    """Run plain `pytest`: `python -m pytest` puts the checkout on sys.path, and `codegen` would be there twice."""
    assert str(ROOT) not in sys.path
    assert importlib.util.find_spec("codegen") is None
    assert importlib.util.find_spec("templates") is None
    assert "codegen" not in sys.modules


def test_oracles_share_no_code_with_the_package():
    """They read a model, and no more; what the generator or the references work out, they work out themselves."""
    for file in sorted((ROOT / "tests" / "oracles").glob("*.py")):
        ours = {name for name in imports(f"tests.oracles.{file.stem}", file) if within(name, "eigenmotion")}
        assert ours <= {"eigenmotion", *(f"eigenmotion.{name}" for name in ("Model", "load_model", "t"))}, file.name
