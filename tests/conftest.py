"""Fixtures that files share."""

import gc
import os
import signal
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from eigenmotion import System
from eigenmotion.building.toolchain import FLAGS

from .graph.expressions import Bench
from .support import generation
from .support.browser import Browser, chromium
from .support.by_day import mark_nightly, rule_of
from .support.generation import COMPILERS
from .support.night_slice import out_of_turn, outside_slice, slice_of

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


LONGEST = ("test_build", "test_compiler_warnings", "test_default_flags", "test_docs", "test_generated_c", "test_models",
           "test_page", "test_parts_on_demand", "test_proof", "test_proof_rounding", "test_quick_return_shaper",
           "test_random_contacts", "test_random_mechanisms", "test_reaction_rates", "test_report",
           "test_right_hand_side_on_lanes", "test_stability", "test_stability_contacts",
           "test_stability_limits", "test_sweep_stores")  # fmt: skip
"""Files that take a process 15 seconds or more: first, so that none of them is what all wait for at the end."""

LEFT_OUT = pytest.StashKey[Counter[str]]()
"""How many cases each rule left for the night."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add what `make nightly`, `make docs` and `make screenshots` use."""
    parser.addoption(
        "--slice", metavar="K/N", help="one of N parts, with one in ten of the night's random cases (default: all)"
    )
    parser.addoption("--site", type=Path, metavar="FOLDER", help="the site whose looks are tested")
    parser.addoption("--screenshots", type=_folder, metavar="FOLDER", help="where photographs of pages are kept")


def _folder(name: str) -> Path:
    """Return a folder, which is made."""
    Path(name).mkdir(parents=True, exist_ok=True)
    return Path(name).resolve()


def pytest_configure(config: pytest.Config) -> None:
    """By day compile in a hurry, with Clang, a fifth of the time; where CC or flags are given, as at night, optimise.

    `test_default_flags`, `test_compiler_warnings` and `test_kernels_*` look at users' flags, with each compiler.
    """
    if not {"CC", FLAGS} & os.environ.keys() and "clang" in COMPILERS:
        os.environ["CC"], os.environ[FLAGS] = "clang", "-O0"
    os.environ.setdefault(FLAGS, "-O1")
    config.stash[LEFT_OUT] = Counter()
    named = config.option.keyword or any("::" in one for one in config.args)
    if named and not any(one.startswith("-m") for one in config.invocation_params.args):
        config.option.markexpr = ""  # who names cases gets them, also those of the night


def pytest_collection_finish() -> None:
    """What has been imported and collected stays: to look it over for garbage, again and again, took a tenth of all."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 20)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Longest files first, where `--no-loadscope-reorder` leaves it at that; what is not for every day, at night."""
    items.sort(key=lambda item: item.path.stem not in LONGEST)
    mark_nightly(items)
    if text := config.option.slice:
        part = slice_of(text)
        others = set(out_of_turn(items, part.turn))
        items[:] = [item for item in items if item not in others]
        others = outside_slice(items, part.part, part.parts)
        items[:] = [item for item in items if item not in others]


def pytest_deselected(items: list[pytest.Item]) -> None:
    """Count what waits for the night, by the rule that says so."""
    option = items[0].config.option
    if option.markexpr == "not nightly" and not option.keyword:
        items[0].config.stash[LEFT_OUT].update(filter(None, map(rule_of, items)))


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Tell the process that reports: with pytest-xdist it has collected nothing itself."""
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["left_out"] = dict(session.config.stash[LEFT_OUT])


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node) -> None:
    """Take what one worker tells: each has collected all cases."""
    node.config.stash[LEFT_OUT] |= Counter(getattr(node, "workeroutput", {}).get("left_out", {}))


def pytest_terminal_summary(terminalreporter, config: pytest.Config) -> None:
    """Say what was left out, and how it is run."""
    if left_out := config.stash[LEFT_OUT]:
        terminalreporter.section("left for the night")
        for rule, count in left_out.most_common():
            terminalreporter.line(f"{count:5} {rule}")
        terminalreporter.line('-k NAME or FILE::TEST runs what it names, -m "" all, `make nightly` what was left out')


@pytest.fixture(scope="session", autouse=True)
def interruptible() -> Iterator[None]:
    """Ctrl-C interrupts also where the tests were started with it ignored, as in the background of a shell."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Return a headless Chromium, for the tests of one file."""
    if chromium() is None:
        pytest.skip("Chromium is not here (apt-get install chromium)")
    with Browser() as opened:
        yield opened


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
