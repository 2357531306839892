"""Chunks of members for other processes, on this machine or others: any `concurrent.futures.Executor`.

A chunk takes about a second, so that what travels costs little; one that is lost with its worker is run again.
"""

import logging
import os
import pickle
import time
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, wait
from functools import lru_cache

from ..arguments.members import Asked, Members
from ..codegen.model.normalise import ModelError
from ..results.batch_arrays import BatchArrays, Collection
from ..runtime.ensemble import Stop
from .chunk import run_chunk
from .threads import Report, pieces

_log = logging.getLogger("eigenmotion")
_PILOT = 16  # members that tell how long others may take
_SECONDS = 1.0  # a chunk
_AHEAD = 4  # chunks at least for each core here, where there are members enough: then no worker waits for one
_TRIES = 3
_TICK = 0.5  # [s] between two looks at signals


def _packed(asked: Asked) -> bytes:
    try:
        return pickle.dumps(asked)
    except (TypeError, AttributeError, pickle.PicklingError) as error:
        raise ModelError(f"{asked.model.name} cannot travel to an executor's workers: {error}") from error


@lru_cache(maxsize=8)
def _asked(packed: bytes) -> Asked:
    """Make what is asked of all, its model with it: once a process, not once a chunk."""
    asked: Asked = pickle.loads(packed)
    return asked


def timed_chunk(packed: bytes, members: Members) -> tuple[BatchArrays, float]:
    """Run members in a worker, in one thread; return what came of them, and the seconds it took."""
    asked = _asked(packed)
    start = time.perf_counter()
    found = run_chunk(asked, members, Stop())
    return found, time.perf_counter() - start


def in_executor(asked: Asked, members: Members, executor: Executor, report: Report) -> BatchArrays:
    """Run all members in the executor's workers; Ctrl-C gives up what is not done."""
    work = _Work(asked, members, executor, report)
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
    return work.found.whole


class _Work:
    """Chunks on their way."""

    def __init__(self, asked: Asked, members: Members, executor: Executor, report: Report) -> None:
        self.packed, self.members, self.executor, self.report = _packed(asked), members, executor, report
        self.found, self.seconds = Collection(asked, members.count), 0.0
        self.waiting: dict[Future[tuple[BatchArrays, float]], tuple[int, int]] = {}
        self.tries: dict[tuple[int, int], int] = {}

    def submit(self, parts: list[tuple[int, int]]) -> None:
        """Hand chunks (start, stop) out; where the executor takes none any more, run them here."""
        for part in parts:
            members = self.members.part(*part)
            try:
                self.waiting[self.executor.submit(timed_chunk, self.packed, members)] = part
            except (BrokenExecutor, RuntimeError) as error:
                _log.warning("the executor is lost (%s): members %d to %d run here", error, part[0], part[1] - 1)
                self._put(part, timed_chunk(self.packed, members))

    def finish(self) -> None:
        """Wait for all that is on its way."""
        while self.waiting:
            done, _ = wait(self.waiting, _TICK, return_when="FIRST_COMPLETED")
            for future in done:
                self._take(future, self.waiting.pop(future))

    def _take(self, future: Future[tuple[BatchArrays, float]], part: tuple[int, int]) -> None:
        """Take over a chunk, or hand it out again where it was lost with its worker."""
        try:
            self._put(part, future.result())
        except (Exception, CancelledError) as error:
            self.tries[part] = self.tries.get(part, 0) + 1
            if self.tries[part] >= _TRIES:
                raise
            _log.warning("members %d to %d are run again: %s", part[0], part[1] - 1, error)
            self.submit([part])

    def _put(self, part: tuple[int, int], done: tuple[BatchArrays, float]) -> None:
        found, seconds = done
        self.found.put(part[0], found)
        self.seconds += seconds
        self.report(part[1] - part[0])

    def cancel(self) -> None:
        """Give up what has not begun."""
        for future in self.waiting:
            future.cancel()
