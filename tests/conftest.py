"""Fixtures that files share."""

import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from eigenmotion import System

from . import generation
from .expressions import Bench

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


LONGEST = ("test_stability", "test_lanes", "test_random_mechanisms", "test_options_accuracy", "test_report")
"""Files that take a process a minute: first, so that none of them is what all wait for at the end."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Longest files first; `--no-loadscope-reorder` leaves it at that."""
    items.sort(key=lambda item: item.path.stem not in LONGEST)


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
