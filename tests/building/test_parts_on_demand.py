"""Parts of a model are compiled as something first asks for them: once, proved, and with words if that fails."""

import os
import pickle
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion.building import lazy_units, shared_library
from eigenmotion.building.build import all_of, cached_sources, load_part, make
from eigenmotion.building.request import request
from eigenmotion.building.shared_library import load
from eigenmotion.building.toolchain import UNITS, Toolchain, toolchain
from eigenmotion.building.verification import verdict

from ..support.generation import model_of

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="there a module has all from the start")
FIRST = ["aside", "lanes", "model", "rhs"]


@pytest.fixture(autouse=True)
def shared_cache(tmp_path_factory, monkeypatch, hurried):
    """One cache for this file's tests, none of the user's."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path_factory.getbasetemp() / "later-cache"))


@pytest.fixture
def own_cache(shared_cache, tmp_path, monkeypatch):
    """An empty one, of which this process has loaded nothing."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / "cache"))
    forget(monkeypatch)
    return tmp_path / "cache"


@pytest.fixture
def units(monkeypatch):
    """Names of units, as they are compiled."""
    units, compile_unit = [], Toolchain.compile_unit

    def noted(tools, folder, stem, unit):
        units.append(unit)
        return compile_unit(tools, folder, stem, unit)

    monkeypatch.setattr(Toolchain, "compile_unit", noted)
    return units


def forget(monkeypatch):
    """As in a new process: what is loaded next has no part but the first."""
    monkeypatch.setattr(shared_library, "_loaded", {})


def test_each_part_is_compiled_once_and_nothing_changes(own_cache, units, monkeypatch):
    """What was there stays as it was, to the last bit; what is there is found again."""
    system = em.build(model_of("pendulum"))
    before = system.simulate((0.0, 1.0), method="dop853"), system.simulate((0.0, 1.0), method="ra15")
    stepper = system.stepper()
    stepper.advance(0.5)
    assert sorted(units) == FIRST
    assert system.simulate((0.0, 1.0), method="radau5").success
    assert sorted(units) == sorted([*FIRST, "derivatives"])
    assert system.simulate((0.0, 1.0), method="rk34").success
    assert system.linearize().A.shape == (2, 2)
    assert len(units) == len(FIRST) + 1
    assert system.jacobian(0.0, system.state()).shape == (system.n_state,) * 2
    assert em.simulate_ensemble(system, (0.0, 1.0), x0={"theta": [0.1, 0.2]}, method="dop853").success.all()
    assert sorted(units) == sorted(UNITS)
    for one in before:
        np.testing.assert_array_equal(system.simulate((0.0, 1.0), method=one.method).y, one.y)
    stepper.advance(1.0)
    forget(monkeypatch)
    again = em.build(model_of("pendulum"))
    other = again.stepper()
    other.advance(0.5)
    other.advance(1.0)
    np.testing.assert_array_equal(stepper.x, other.x)
    assert again.simulate((0.0, 1.0), method="radau9").success
    assert len(units) == len(UNITS)


ASKING = {
    "an explicit method": ("", lambda system: system.simulate((0.0, 1.0), method="dopri5")),
    "an implicit one": ("derivatives", lambda system: system.simulate((0.0, 1.0), method="radau9")),
    "a stepper": ("", lambda system: system.stepper(method="rk4", step=0.1)),
    "steppers": ("members", lambda system: system.steppers(2, method="midpoint", step=0.1)),
    "an ensemble": (
        "members",
        lambda system: em.simulate_ensemble(system, (0.0, 1.0), x0={"theta": [0.1, 0.2]}, method="dop853"),
    ),
    "a linearization": ("derivatives", lambda system: system.linearize()),
    "sensitivities": ("derivatives", lambda system: system.simulate((0.0, 1.0), sensitivities=["l"])),
    "a Jacobian": (None, lambda system: system.jacobian(0.0, system.state())),
    "what every run needs": (
        "",
        lambda system: [system.simulate((0.0, 1.0), method=m, dense_output=True) for m in ("auto", "dop853", "ra15")],
    ),
}


@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
@pytest.mark.parametrize("what", ASKING)
def test_who_needs_a_part_asks_for_it(formulation, what, monkeypatch):
    """Each on a System that has the first part alone; what has not been asked for stays where it is."""
    forget(monkeypatch)
    system = em.build(model_of("pendulum"), formulation=formulation)
    part, ask = ASKING[what]
    part = {"eigenfactor": "duals", "lagrange": "derivatives"}[formulation] if part is None else part
    given, asked = system.compiled.load_part, []
    system.compiled.load_part = lambda part: asked.append(part) or given(part)
    assert ask(system) is not None
    assert not part or part in asked  # by each of the threads that find it missing at once
    assert set(asked) <= {part}


def test_impacts_need_no_derivatives_but_their_sensitivities_do(own_cache, units, monkeypatch):
    """A run through impacts compiles none; sensitivities load the maps across impacts, and the run stays the same."""
    system = em.build(model_of("bouncing_ball"))
    before = system.simulate((0.0, 1.0))
    assert before.t_events[0].size > 0
    assert "derivatives" not in units
    after = system.simulate((0.0, 1.0), sensitivities=["z"])
    assert units.count("derivatives") == 1
    np.testing.assert_array_equal(after.x[:, -1], before.x[:, -1])


def test_a_run_that_carries_interpolants_elsewhere(monkeypatch):
    """A solution by an implicit method is unpickled where its derivatives are not compiled in yet."""
    system = em.build(model_of("pendulum"))
    found = system.simulate((0.0, 1.0), method="radau5", dense_output=True)
    text, expected = pickle.dumps(found), found.sol(0.3)
    forget(monkeypatch)
    np.testing.assert_array_equal(pickle.loads(text).sol(0.3), expected)


def test_threads_that_ask_at_once_take_the_same(own_cache, units):
    system = em.build(model_of("pendulum"))
    with ThreadPoolExecutor(4) as pool:
        runs = list(pool.map(lambda _: system.simulate((0.0, 1.0), method="radau5").y, range(4)))
    assert all((run == runs[0]).all() for run in runs)
    assert units.count("derivatives") == 1


RUN = """
import eigenmotion as em
from eigenmotion.models.pendulum import model
print(em.build(model).simulate((0.0, 1.0), method="radau5").x[0, -1])
"""


def test_processes_that_ask_at_once_take_the_same(own_cache):
    """One of them compiles, and all others wait for that."""
    command = [sys.executable, "-c", RUN]
    both = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    ends = [float(one.communicate()[0]) for one in both]
    assert ends == [em.build(model_of("pendulum")).simulate((0.0, 1.0), method="radau5").x[0, -1]] * 2
    assert [one.name for one in (own_cache / "steppers").glob("*/*.o")] == ["em_stepper.o"]


def test_a_process_after_a_fork_asks_for_itself(monkeypatch):
    forget(monkeypatch)
    system = em.build(model_of("pendulum"))
    child = os.fork()
    if child == 0:
        os._exit(0 if system.simulate((0.0, 1.0), method="radau5").success else 1)
    assert os.waitpid(child, 0)[1] == 0


def test_a_compiler_that_has_gone(own_cache, tmp_path):
    """An error that says what is missing, every time; what needs none goes on, and one that is back is asked again."""
    there, gone = tmp_path / "cc", tmp_path / "gone"
    there.symlink_to(shutil.which(toolchain().command[0]))
    system = em.build(model_of("pendulum"), compiler=str(there))
    there.rename(gone)
    words = r"cannot start .*/cc(.|\n)*derivatives of pendulum(.|\n)*`eigenmotion build`"
    for _ in range(2):
        with pytest.raises(em.BuildError, match=words):
            system.simulate((0.0, 1.0), method="radau9")
    with pytest.raises(em.BuildError, match="derivatives of pendulum"):
        system.stepper(method="radau5")
    assert system.simulate((0.0, 1.0), method="ra15").success
    gone.rename(there)
    assert system.simulate((0.0, 1.0), method="radau9").success


def test_what_has_all_needs_no_compiler(own_cache, tmp_path, units):
    """A module for a folder of the user's; there is nothing it asks for."""
    asked = request(model_of("pendulum"))
    system = load(all_of(cached_sources(asked), toolchain(), asked.model))
    assert sorted(units) == sorted(set(UNITS) - {"lanes", "duals"})
    assert system.compiled.load_part is None
    for method in ("rk34", "radau5", "ra15"):
        assert system.simulate((0.0, 1.0), method=method).success
    assert system.linearize().A.shape == (2, 2)
    assert em.simulate_ensemble(system, (0.0, 1.0), x0={"theta": [0.1, 0.2]}, method="dop853").success.all()


def test_an_interrupt_leaves_nothing_and_is_no_end(own_cache, monkeypatch):
    system = em.build(model_of("pendulum"))
    entries = sorted((own_cache / "binaries").iterdir())

    def interrupted(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(Toolchain, "link", interrupted)
        with pytest.raises(KeyboardInterrupt):
            system.simulate((0.0, 1.0), method="radau5")
    assert sorted((own_cache / "binaries").iterdir()) == entries
    assert system.simulate((0.0, 1.0), method="radau5").success


EXPLICIT = ("rk34", "dopri5", "dop853", "ra15")
PROVED = {"derivatives": ("radau5", "radau9"), "members": EXPLICIT, "duals": ()}


@pytest.mark.parametrize(("part", "methods"), PROVED.items())
def test_what_is_compiled_later_is_proved_then(part, methods, own_cache, monkeypatch):
    """Its methods' first steps are held against accelerations; what is off is kept by nobody, and says so."""
    asked, held = request(model_of("pendulum")), []

    def first_steps(system, methods):
        held.extend(methods)
        yield from ((name, "is made up") for name in methods if len(held) > len(EXPLICIT))

    monkeypatch.setattr(verdict, "first_steps", first_steps)
    em.build(asked.model)
    assert held == list(EXPLICIT)
    if methods:
        words = rf"a run by {methods[0]} is made up(.|\n)*{lazy_units.WORDS[part]} of pendulum"
        with pytest.raises(em.ProofError, match=words):
            load_part(asked, toolchain(), part)
    else:
        load_part(asked, toolchain(), part)
    assert tuple(held[len(EXPLICIT) :]) == methods
    assert len(list((own_cache / "binaries").iterdir())) == (1 if methods else 2)


def test_what_acts_is_there_at_first():
    """Events do what they do in a model's first run."""
    system = em.build(model_of("bouncing_ball"))
    asked = []
    system.compiled.load_part = asked.append
    assert system.simulate((0.0, 1.0)).success
    assert not asked


def test_what_extrapolates_has_its_derivatives_at_first():
    """dM/dx says whether axes turn where eigenvalues coincide at the start: the proof asks, with nothing to add."""
    system = em.build(model_of("drone"), close_eigenvalues="extrapolate", flags="-O0")
    system.compiled.load_part = None
    with pytest.raises(em.ModelError, match="coincide at x0"):
        system.simulate((0.0, 1.0))
    alone = shared_library.system_in(make(request(model_of("pendulum")), toolchain()))
    for ask in (
        lambda: alone.mass_matrix_gradient([0.3]),
        lambda: alone.simulate((0.0, 1.0), method="radau9"),
        lambda: alone.simulate((0.0, 1.0), sensitivities=["l"]),
        alone.linearize,
    ):
        with pytest.raises(RuntimeError, match="pendulum has been compiled without derivatives"):
            ask()


def test_a_cache_that_cannot_be_used_any_more(own_cache, monkeypatch):
    system = em.build(model_of("pendulum"))
    monkeypatch.setenv("EIGENMOTION_CACHE", str(own_cache / "locks" / next((own_cache / "locks").iterdir()).name))
    with pytest.raises(em.BuildError, match="EIGENMOTION_CACHE"):
        system.simulate((0.0, 1.0), method="radau5")


@pytest.mark.nightly
def test_a_command_that_needs_a_part(own_cache):
    """`run` by an implicit method has derivatives compiled."""
    model = "models/pendulum.py"
    command = [sys.executable, "-m", "eigenmotion", "run", model, "--t-end", "1", "--method", "radau5"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
