"""Rules of dependency (docs/architecture.md), read off the sources."""

import ast
import importlib.util
import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
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
        for file in [*folder.rglob("*.py"), *folder.rglob("*.pyi")]:
            parts = file.relative_to(folder).with_suffix("").parts
            found.setdefault(".".join([package, *(part for part in parts if part != "__init__")]), file)
    return found


def imports(module: str, file: Path) -> Iterator[str]:
    """Absolute names of what a file imports, anywhere in it."""
    package = module if file.stem == "__init__" else module.rpartition(".")[0]
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            source = importlib.util.resolve_name("." * node.level + (node.module or ""), package)
            yield source
            yield from (f"{source}.{alias.name}" for alias in node.names)


MODULES = modules()


def within(name: str, package: str) -> bool:
    return name == package or name.startswith(f"{package}.")


def test_every_package_is_installed():
    """A folder that pyproject.toml does not list is there in a checkout, and missing from a wheel."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    home = ROOT / "src" / "eigenmotion"
    found = {"eigenmotion", *(f"eigenmotion.{file.parent.relative_to(home)}".replace("/", ".")
                              for file in home.rglob("__init__.py") if file.parent != home)}  # fmt: skip
    others = {name for name in PACKAGES if name != "eigenmotion"}
    assert set(project["tool"]["setuptools"]["packages"]) == found | others


def test_the_sources_are_found():
    assert {"eigenmotion", "eigenmotion.build", "eigenmotion.codegen.model", "eigenmotion.runtime.core"} <= set(MODULES)


@pytest.mark.parametrize("module", [name for name in MODULES if within(name, "eigenmotion.codegen")])
def test_codegen_imports_sympy_jinja_and_the_standard_library(module):
    for name in imports(module, MODULES[module]):
        top = name.partition(".")[0]
        ours = within(name, "eigenmotion.codegen") or within(name, "eigenmotion.templates")
        assert ours or top in {"sympy", "jinja2"} or top in sys.stdlib_module_names, f"{module} imports {name}"


@pytest.mark.parametrize("module", [name for name in MODULES if within(name, "eigenmotion.runtime")])
def test_runtime_imports_nothing_of_ours(module):
    for name in imports(module, MODULES[module]):
        assert not within(name, "eigenmotion") or within(name, "eigenmotion.runtime"), f"{module} imports {name}"


def test_runtime_extension_imports_nothing_of_ours():
    text = (PACKAGES["eigenmotion"] / "runtime" / "core.pyx").read_text(encoding="utf-8")
    named = [line.split()[1] for line in text.splitlines() if line.startswith(("from ", "import ", "cimport "))]
    assert named
    assert not [name for name in named if name.startswith(("..", "eigenmotion"))]


def included(header: str, folder: Path) -> set[str]:
    """A header, and those of ours that it includes, directly or not."""
    text = (folder / header).read_text(encoding="utf-8")
    return {header}.union(*(included(name, folder) for name in re.findall(r'^#include "(\w+\.h)"', text, re.MULTILINE)))


def test_the_runtime_is_built_anew_when_a_header_of_it_changes():
    """The lists of pyproject.toml and of the Makefile hold each header that core.pyx includes, and no other."""
    runtime = PACKAGES["eigenmotion"] / "runtime"
    first = re.findall(r'extern from "(\w+\.h)"', (runtime / "core.pxd").read_text(encoding="utf-8"))
    needed = set().union(*(included(name, runtime / "include") for name in first))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    (extension,) = project["tool"]["setuptools"]["ext-modules"]
    assert {Path(path).name for path in extension["depends"]} == needed
    rule = (ROOT / "Makefile").read_text(encoding="utf-8").partition("include/%.h,")[2].partition(")")[0]
    assert {f"{name}.h" for name in rule.split()} == needed


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
