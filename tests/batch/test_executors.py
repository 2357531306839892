"""Ensembles in other processes: the same bits, and a worker that is killed costs its chunk only."""

import os
import pickle
import signal
import threading
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion import simulate_ensemble
from eigenmotion.batch import executors

from ..support.generation import system_of
from .test_ensemble import bits

SPEEDS = np.linspace(0.0, 9.0, 200)
GIVEN = {"rtol": 1e-9, "atol": 1e-9, "t_eval": [0.0, 5.0, 10.0]}
SPAN = (0.0, 10.0)


@pytest.fixture(scope="module")
def pendulum(tmp_path_factory):
    """A System whose workers find it in a cache of this file's own."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("EIGENMOTION_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield em.build(Path(__file__).parents[2] / "models" / "pendulum.py", formulation="lagrange")


@pytest.fixture
def small(monkeypatch):
    """Chunks as small as they can be."""
    monkeypatch.setattr(executors, "_PILOT", 8)
    monkeypatch.setattr(executors, "_SECONDS", 1e-4)


def runs_of(system: em.System, **how: object) -> em.Ensemble:
    return simulate_ensemble(system, SPAN, v0={system.coordinates[0]: SPEEDS}, **GIVEN, **how)


@pytest.fixture(scope="module")
def pool():
    """Another process, which takes seconds to start: one for all tests, of which the last kills it."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as started:
        yield started


def test_processes_give_the_same_bits(pendulum, small, pool):
    found = runs_of(pendulum, executor=pool)
    assert bits(found) == bits(runs_of(pendulum, workers=1))
    assert found[3].nfev == runs_of(pendulum)[3].nfev


def test_ensembles_travel(pendulum):
    runs = runs_of(pendulum)
    other = pickle.loads(pickle.dumps(runs))
    assert bits(other) == bits(runs)
    assert (other.summary, other.swept.keys()) == (runs.summary, runs.swept.keys())


class Dying(Executor):
    """Processes, one of which is killed once its chunk is on its way; the pool cannot go on then."""

    def __init__(self, pool: ProcessPoolExecutor, at: int) -> None:
        self.pool, self.left = pool, at

    def submit(self, function, /, *arguments) -> Future:
        future = self.pool.submit(function, *arguments)
        self.left -= 1
        if self.left == 0:
            os.kill(next(iter(self.pool._processes)), signal.SIGKILL)
        return future


def test_a_killed_process_costs_no_member(pendulum, small, pool, caplog):
    found = runs_of(pendulum, executor=Dying(pool, 4))
    assert bits(found) == bits(runs_of(pendulum, workers=1))
    assert "run here" in caplog.text


class Fragile(Executor):
    """Runs what it gets at once; every third chunk is lost with its worker, once, and after some it takes none."""

    def __init__(self, most: int) -> None:
        self.taken, self.most, self.lost = 0, most, set[bytes]()

    def submit(self, function, /, *arguments):
        self.taken += 1
        if self.taken > self.most:
            raise RuntimeError("cannot schedule new futures after shutdown")
        future: Future = Future()
        chunk = arguments[1].v.tobytes()
        if self.taken % 3 == 0 and chunk not in self.lost:
            self.lost.add(chunk)
            future.set_exception(RuntimeError("worker died"))
        else:
            future.set_result(function(*arguments))
        return future


@pytest.mark.parametrize("most", [100, 4])
def test_a_lost_chunk_is_run_again_and_the_bits_stay(pendulum, small, most):
    lost = Fragile(most)
    assert bits(runs_of(pendulum, executor=lost)) == bits(runs_of(pendulum))
    assert lost.taken > 4


def test_what_cannot_travel_says_so():
    with pytest.raises(em.ModelError, match=r"cannot travel to an executor's workers: .*capsule alone"):
        runs_of(system_of("pendulum", "lagrange"), executor=Fragile(1))


@pytest.mark.nightly
@pytest.mark.filterwarnings("ignore")
def test_a_dask_cluster_gives_the_same_bits_though_a_worker_is_killed(pendulum, small):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        found = runs_of(pendulum, executor=client.get_executor(retries=3))
        assert bits(found) == bits(runs_of(pendulum, workers=1))
        victims = client.run(os.getpid)

        def strike() -> None:
            time.sleep(0.2)
            os.kill(next(iter(victims.values())), signal.SIGKILL)

        threading.Thread(target=strike).start()
        found = runs_of(pendulum, executor=client.get_executor(retries=3))
    assert bits(found) == bits(runs_of(pendulum, workers=1))


@pytest.mark.nightly
def test_a_hundred_thousand_members_one_in_a_hundred_of_which_fails(pendulum):
    count = 100_000
    speeds = np.linspace(0.0, 9.0, count)
    parameters = {name: np.full(count, value) for name, value in pendulum.parameters.items()}
    ways = [(name, value) for name in parameters for value in (np.nan, -1.0)][:4]
    spoilt = np.random.default_rng(7).choice(count, count // 100, replace=False)
    for k, member in enumerate(spoilt):
        name, value = ways[k % len(ways)]
        parameters[name][member] = value
    runs = simulate_ensemble(pendulum, (0.0, 1.0), parameters=parameters, v0={pendulum.coordinates[0]: speeds})
    failed = set(runs.failed.tolist())
    for member in failed:
        assert member in set(spoilt.tolist())
    for k, member in enumerate(spoilt):
        if np.isnan(ways[k % len(ways)][1]):
            assert member in failed
            assert ways[k % len(ways)][0] in runs.message(member)
    assert np.isfinite(runs.x[runs.success]).all()
    assert np.isnan(runs.x[runs.failed]).all()
