"""Execution of an ensemble by a `concurrent.futures.Executor`: other processes, on this machine or others.

Work is sent in chunks of about one second, so that the transfer costs little. A chunk that is lost with its worker is
run again.
"""

import logging
import os
import pickle
import time
from collections.abc import Mapping
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, wait
from dataclasses import replace
from functools import lru_cache

from ..arguments.named_values import Vector
from ..arguments.tasks import EnsembleTask, Members
from ..codegen.model.normalise import ModelError, shown
from ..results.batch_arrays import BatchArrays, Collection
from ..runtime.ensemble import Stop
from ..runtime.tables import packed, unpacked
from .chunk import run_chunk
from .threads import Report, pieces

_log = logging.getLogger("eigenmotion")
_PILOT = 16  # members whose run time predicts that of the others
_SECONDS = 1.0  # run time of a chunk
_AHEAD = 4  # least number of chunks for each core, if there are enough members, so that no worker is idle
_TRIES = 3
_POLL = 0.5  # [s] between two checks for signals


def _packed(common: EnsembleTask) -> bytes:
    try:
        return pickle.dumps(common)
    except (TypeError, AttributeError, pickle.PicklingError) as error:
        raise ModelError(f"{common.model.name} cannot travel to an executor's workers: {error}") from error


def _check_travels(members: Members) -> None:
    """Refuse controllers that cannot be pickled."""
    for one in members.controllers:
        try:
            pickle.dumps(one)
        except Exception as error:  # whatever pickling an object of the user's raises
            raise ModelError(
                f"{one}: the controller {shown(one.sampled.function)} cannot travel to an executor's workers: {error}. "
                "Define its function or class at the top of a module, or use threads of this process: workers="
            ) from error


@lru_cache(maxsize=8)
def _common(packed: bytes) -> EnsembleTask:
    """Unpickle the task that all members share, with the model: once per process, not once per chunk."""
    common: EnsembleTask = pickle.loads(packed)
    return common


def timed_chunk(packed: bytes, members: Members, tables: Mapping[float, Vector]) -> tuple[BatchArrays, float]:
    """Run members in one thread of a worker; return their results and the seconds it took."""
    common = _common(packed)
    places = [place for place, _ in common.model.tables.values()]
    members = replace(members, parameters=unpacked(members.parameters, places, tables)) if tables else members
    start = time.perf_counter()
    results = run_chunk(common, members, Stop())
    return results, time.perf_counter() - start


def in_executor(common: EnsembleTask, members: Members, executor: Executor, report: Report) -> BatchArrays:
    """Run all members in the workers of the executor; Ctrl-C cancels the chunks that have not finished."""
    _check_travels(members)
    work = _Work(common, members, executor, report)
    try:
        pilot = min(_PILOT, members.count)
        work.submit([(0, pilot)])
        work.finish()
        rest = members.count - pilot
        size = max(
            1, min(int(_SECONDS / max(work.seconds / pilot, 1e-9)), -(-rest // (_AHEAD * (os.cpu_count() or 1))))
        )
        work.submit([(pilot + start, pilot + end) for start, end in pieces(rest, size)])
        work.finish()
    except KeyboardInterrupt:
        work.cancel()
    return work.results.whole


class _Work:
    """Chunks submitted to an executor."""

    def __init__(self, common: EnsembleTask, members: Members, executor: Executor, report: Report) -> None:
        self.packed, self.members, self.executor, self.report = _packed(common), members, executor, report
        self.results, self.seconds = Collection(common, members.count), 0.0
        self.tables = tuple(common.model.tables.values())
        self.waiting: dict[Future[tuple[BatchArrays, float]], tuple[int, int]] = {}
        self.tries: dict[tuple[int, int], int] = {}

    def submit(self, parts: list[tuple[int, int]]) -> None:
        """Submit chunks (start, stop); if the executor accepts no more, run them in this process."""
        for part in parts:
            members = self.members.part(*part)
            tables = self._tables(members)
            try:
                self.waiting[self.executor.submit(timed_chunk, self.packed, members, tables)] = part
            except (BrokenExecutor, RuntimeError) as error:
                _log.warning("the executor is lost (%s): members %d to %d run here", error, part[0], part[1] - 1)
                self._put(part, timed_chunk(self.packed, members, tables))

    def _tables(self, members: Members) -> dict[float, Vector]:
        """Return address -> data of the tables among the parameters, to be sent to the worker."""
        places = [place for place, _ in self.tables]
        return packed(members.parameters[:, places].ravel().tolist()) if places else {}

    def finish(self) -> None:
        """Wait for all submitted chunks."""
        while self.waiting:
            done, _ = wait(self.waiting, _POLL, return_when="FIRST_COMPLETED")
            for future in done:
                self._take(future, self.waiting.pop(future))

    def _take(self, future: Future[tuple[BatchArrays, float]], part: tuple[int, int]) -> None:
        """Store the results of a chunk, or submit it again if its worker was lost."""
        try:
            self._put(part, future.result())
        except (Exception, CancelledError) as error:
            self.tries[part] = self.tries.get(part, 0) + 1
            if isinstance(error, ModelError) or self.tries[part] >= _TRIES:
                raise
            _log.warning("members %d to %d are run again: %s", part[0], part[1] - 1, error)
            self.submit([part])

    def _put(self, part: tuple[int, int], done: tuple[BatchArrays, float]) -> None:
        results, seconds = done
        self.results.put(part[0], results)
        self.seconds += seconds
        self.report(part[1] - part[0])

    def cancel(self) -> None:
        """Cancel the chunks that have not begun."""
        for future in self.waiting:
            future.cancel()
