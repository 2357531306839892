"""Systems, their parameters and solutions travel: copied, pickled, to other processes."""

import copy
import os
import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em

from ..support.hand_written import bead


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    """A cache of this file's own, also for the processes that it starts."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("EIGENMOTION_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield Path(os.environ["EIGENMOTION_CACHE"])


@pytest.fixture(scope="module")
def system(cache) -> em.System:
    return em.build(Path(__file__).parents[2] / "models" / "chain.py", n=2, flags="-O0")


def test_systems_travel_to_other_processes(system, cache):
    prepared = system.prepare({"g": 1.62})
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        found = pool.submit(em.simulate, system, (0.0, 0.1), parameters=prepared).result()
    assert (found.y == system.simulate((0.0, 0.1), parameters=prepared).y).all()
    assert len(pickle.dumps((system, prepared))) < 10_000
    assert len(list(cache.glob("binaries/*"))) == 1


def test_copies_of_a_system_are_the_system(system):
    prepared = system.prepare({"g": 1.62})
    same, too = copy.deepcopy((system, prepared))
    assert same is system
    assert copy.copy(system) is system
    assert too.parameters == prepared.parameters
    assert same.simulate((0.0, 0.1), parameters=too).success


@pytest.mark.parametrize("method", ["dop853", "rk34", "radau5"])
def test_dense_output_travels(system, method):
    t = np.linspace(0.0, 1.0, 7)
    found = system.simulate((0.0, 1.0), method=method, dense_output=True)
    for twin in (pickle.loads(pickle.dumps(found.sol)), copy.deepcopy(found).sol):
        assert (twin(t) == found.sol(t)).all()
        assert (twin.ts == found.sol.ts).all()


def test_a_run_of_a_method_that_is_no_more_is_refused(system):
    """Steps of SciPy's were number 8, and their interpolants are polynomials of another kind."""
    found = system.simulate((0.0, 1.0), dense_output=True)
    made, (prepared, _, *others) = found.sol._rows_at.__self__.__reduce__()
    with pytest.raises(ValueError, match="chain_2: a run of another version"):
        made(prepared, 8, *others)


def test_a_system_without_a_way_to_it_says_so():
    with pytest.raises(TypeError, match=r"bead was made from a capsule.*eigenmotion\.build"):
        pickle.dumps(bead())
