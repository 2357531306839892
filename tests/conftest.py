"""Fixtures that files share."""

import gc
import os
import signal
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from zlib import crc32

import pytest
from eigenmotion.codegen.choices import FORMULATIONS

from eigenmotion import System
from eigenmotion.building.toolchain import FLAGS

from .graph.expressions import Bench
from .support import generation
from .support.generation import COMPILERS
from .support.models_table import DAILY, HEAVY, Scenario

SCENE = """\
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model

angle = dynamicsymbols("angle")
m, g = symbols("m", positive=True), symbols("g", nonnegative=True)

def model(n: int = 1, tag: str = ""):
    return Model(name=f"swing{n}{tag}", coordinates=[angle], kinetic_energy=m * angle.diff() ** 2 / 2,
                 potential_energy=-n * m * g * cos(angle), parameters={m: 1.0, g: 9.81}, initial={angle: 0.5})
"""


LONGEST = ("test_build", "test_default_flags", "test_docs", "test_generated_c", "test_page", "test_proof",
           "test_random_mechanisms", "test_report", "test_right_hand_side_on_lanes", "test_stability")  # fmt: skip
"""Files that take a process half a minute: first, so that none of them is what all wait for at the end."""

BY_ALL = ("test_paper_scene", "test_signs")
"""Files that go by every formulation by day, too."""


def pytest_configure() -> None:
    """By day compile in a hurry, with Clang, a fifth of the time; where CC or flags are given, as at night, optimise.

    `test_default_flags`, `test_compiler_warnings` and `test_kernels_*` look at users' flags, with each compiler.
    """
    if not {"CC", FLAGS} & os.environ.keys() and "clang" in COMPILERS:
        os.environ["CC"], os.environ[FLAGS] = "clang", "-O0"
    os.environ.setdefault(FLAGS, "-O1")


def pytest_collection_finish() -> None:
    """What has been imported and collected stays: to look it over for garbage, again and again, took a tenth of all."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 20)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Longest files first, where `--no-loadscope-reorder` leaves it at that; what is not for every day, at night."""
    items.sort(key=lambda item: item.path.stem not in LONGEST)
    for item in (*(one for one in items if not _daily(one)), *_not_in_turn(items)):
        item.add_marker(pytest.mark.nightly)


def _daily(item: pytest.Item) -> bool:
    """Whether no heavy model takes part, and no formulation or compiler that is not the case's own by day."""
    given = list(_given(item))
    words = {one for one in given if isinstance(one, str)}
    if not all(_is_its_compiler(item.nodeid, compiler) for compiler in words.intersection(COMPILERS)):
        return False
    models, formulations = {_model_of(one) for one in given}, words.intersection(FORMULATIONS)
    if models & HEAVY:
        return item.path.stem == "test_heavy_models"
    return all(formulations <= DAILY[name] for name in models & DAILY.keys())


def _not_in_turn(items: list[pytest.Item]) -> Iterable[pytest.Item]:
    """Give what is left of a case that goes by more formulations: by day the eigenfactor one, and another in turn.

    Models of the table have their own (`DAILY`); what a file asks of others is asked of one model by the same two.
    """
    cases = defaultdict[tuple[str, str], dict[str, pytest.Item]](dict)
    for item in items:
        words = [one for one in _given(item) if isinstance(one, str) and one in FORMULATIONS]
        if len(words) == 1 and not (item.path.stem in BY_ALL or item.get_closest_marker("nightly") or _known(item)):
            case = item.callspec.id.replace(words[0], "", 1)
            cases[f"{item.path.stem} {case}", item.originalname][words[0]] = item
    for (case, _), by in cases.items():
        others = [one for one in FORMULATIONS[1:] if one in by]
        turn = crc32(case.encode()) % max(1, len(others))
        yield from (by[one] for one in others[:turn] + others[turn + 1 :])


def _known(item: pytest.Item) -> bool:
    """Whether a model of the table takes part."""
    return any(_model_of(one) in DAILY for one in _given(item))


def _is_its_compiler(case: str, compiler: str) -> bool:
    """Whether it is the one by which a case that goes by all at night goes by day, too."""
    return compiler == COMPILERS[crc32(case.replace(compiler, "").encode()) % len(COMPILERS)]


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


@pytest.fixture(scope="module")
def hurried() -> Iterator[None]:
    """What is compiled is compiled in a hurry, as by whom its speed does not concern."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(FLAGS, "-O0")
        if "clang" in COMPILERS and "CC" not in os.environ:
            patch.setenv("CC", "clang")
        yield


@pytest.fixture(scope="session")
def systems() -> Callable[..., System]:
    """(name of a file in models/, formulation) -> its System; each is generated and compiled once."""
    return generation.system_of


@pytest.fixture(scope="session")
def shared_cache(tmp_path_factory) -> str:
    """One cache for commands, pages and builds of all processes of a run, none of the user's."""
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "shared-cache"
    folder.mkdir(mode=0o700, exist_ok=True)
    return str(folder)


@pytest.fixture
def scene(tmp_path, shared_cache, monkeypatch) -> Path:
    """A file of a model in a folder of its own; what commands build is kept in the shared cache."""
    monkeypatch.setenv("EIGENMOTION_CACHE", shared_cache)
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "scene.py"
    path.write_text(SCENE)
    return path


@pytest.fixture
def bench() -> Bench:
    """An empty graph."""
    return Bench()
