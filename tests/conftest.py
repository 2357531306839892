"""Fixtures that files share."""

import signal
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import pytest

from eigenmotion import System

from . import generation
from .expressions import Bench
from .models_table import HEAVY, Scenario

SCENE = """\
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model

angle = dynamicsymbols("angle")
m, g = symbols("m g", positive=True)

def model(n: int = 1, tag: str = ""):
    return Model(name=f"swing{n}{tag}", coordinates=[angle], kinetic_energy=m * angle.diff() ** 2 / 2,
                 potential_energy=-n * m * g * cos(angle), parameters={m: 1.0, g: 9.81}, initial={angle: 0.5})
"""


LONGEST = ("test_stability", "test_generated", "test_random_mechanisms", "test_lanes", "test_page", "test_build")
"""Files that take a process a minute: first, so that none of them is what all wait for at the end."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Longest files first, where `--no-loadscope-reorder` leaves it at that; what takes a heavy model, at night."""
    items.sort(key=lambda item: item.path.stem not in LONGEST)
    for item in items:
        if item.path.stem != "test_gallery" and HEAVY & {_model_of(given) for given in _given(item)}:
            item.add_marker(pytest.mark.nightly)


def _given(item: pytest.Item) -> Iterable[object]:
    """Return what a test is parametrised with."""
    return item.callspec.params.values() if hasattr(item, "callspec") else ()


def _model_of(given: object) -> str | None:
    """Return the file that a scenario, a path or a name stands for."""
    if isinstance(given, Scenario):
        return given.file
    return given.stem if isinstance(given, Path) else given if isinstance(given, str) else None


@pytest.fixture(scope="session", autouse=True)
def interruptible() -> Iterator[None]:
    """Ctrl-C interrupts also where the tests were started with it ignored, as in the background of a shell."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def systems() -> Callable[..., System]:
    """(name of a file in models/, formulation) -> its System; each is generated and compiled once."""
    return generation.system_of


@pytest.fixture
def scene(tmp_path, tmp_path_factory, monkeypatch) -> Path:
    """A file of a model in a folder of its own; and one cache for all tests of commands, none of the user's."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path_factory.getbasetemp() / "cli-cache"))
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "scene.py"
    path.write_text(SCENE)
    return path


@pytest.fixture
def bench() -> Bench:
    """An empty graph."""
    return Bench()
