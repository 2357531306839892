"""Execution of an ensemble by threads of this process; each takes the next chunk of members."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait

from ..arguments.tasks import EnsembleTask, Members
from ..results.batch_arrays import BatchArrays, Collection
from ..runtime.ensemble import Stop
from .chunk import run_chunk

Report = Callable[[int], None]
_PART = 3  # a chunk is 1/3 of a thread's share of the remaining members: late chunks are short, so threads end together
_LEAST, _MOST = 64, 4096  # members of a chunk: enough to fill lanes, few enough to report progress
_POLL = 0.05  # [s] between two checks for signals


def pieces(count: int, size: int) -> list[tuple[int, int]]:
    """Return (start, stop) of chunks of at most `size`."""
    return [(start, min(start + size, count)) for start in range(0, count, size)]


def shares(count: int, workers: int) -> list[tuple[int, int]]:
    """Return (start, stop) of chunks of decreasing length. Few, since each costs some time in Python."""
    if workers == 1:
        return pieces(count, _MOST)
    least, chunks, start = min(_LEAST, -(-count // workers)), list[tuple[int, int]](), 0
    while start < count:
        size = min(_MOST, max(least, (count - start) // (_PART * workers)), count - start)
        chunks.append((start, start + size))
        start += size
    return chunks


def in_threads(common: EnsembleTask, members: Members, workers: int, report: Report) -> BatchArrays:
    """Run all members. Ctrl-C ends the runs; the results so far are returned."""
    stop, parts = Stop(), shares(members.count, workers)
    if len(parts) == 1 or members.controllers:  # Python calls controllers, so threads help only between sample times
        only = run_chunk(common, members, stop, workers)
        report(members.count)
        return only
    results = Collection(common, members.count)

    def work(start: int, end: int) -> None:
        results.put(start, run_chunk(common, members.part(start, end), stop))
        report(end - start)

    if workers == 1:
        for part in parts:
            work(*part)
        return results.whole
    with ThreadPoolExecutor(min(workers, len(parts))) as pool:
        try:
            _await([pool.submit(work, *part) for part in parts], stop)
        except BaseException as error:
            stop.set()
            if not isinstance(error, KeyboardInterrupt):
                raise
    return results.whole


def _await(futures: list[Future[None]], stop: Stop) -> None:
    """Wait for all threads; the main thread handles signals here, and ends the runs."""
    waiting = set(futures)
    while waiting:
        try:
            done, waiting = wait(waiting, _POLL)
            for future in done:
                future.result()
        except KeyboardInterrupt:
            stop.set()
