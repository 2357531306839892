"""Execution of an ensemble by threads of this process, each of which takes the next chunk of members."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait

from ..arguments.members import Asked, Members
from ..results.batch_arrays import BatchArrays, Collection
from ..runtime.ensemble import Stop
from .chunk import run_chunk

Report = Callable[[int], None]
_PART = 3  # the next chunk is this part of a thread's share of what is left: the last are short, so all end together
_LEAST, _MOST = 64, 4096  # members of a chunk: enough to fill lanes, and to report
_TICK = 0.05  # [s] between two looks at signals


def pieces(count: int, size: int) -> list[tuple[int, int]]:
    """Return (start, stop) of chunks of at most `size`."""
    return [(start, min(start + size, count)) for start in range(0, count, size)]


def shares(count: int, workers: int) -> list[tuple[int, int]]:
    """Return (start, stop) of chunks of decreasing length for so many threads; each costs some time in Python."""
    if workers == 1:
        return pieces(count, _MOST)
    least, found, start = min(_LEAST, -(-count // workers)), list[tuple[int, int]](), 0
    while start < count:
        size = min(_MOST, max(least, (count - start) // (_PART * workers)), count - start)
        found.append((start, start + size))
        start += size
    return found


def in_threads(asked: Asked, members: Members, workers: int, report: Report) -> BatchArrays:
    """Run all members; Ctrl-C ends the runs, and the results so far are returned."""
    stop, parts = Stop(), shares(members.count, workers)
    if len(parts) == 1 or members.controllers:  # which Python asks, so that threads are of use between questions alone
        only = run_chunk(asked, members, stop, workers)
        report(members.count)
        return only
    found = Collection(asked, members.count)

    def work(start: int, end: int) -> None:
        found.put(start, run_chunk(asked, members.part(start, end), stop))
        report(end - start)

    if workers == 1:
        for part in parts:
            work(*part)
        return found.whole
    with ThreadPoolExecutor(min(workers, len(parts))) as pool:
        try:
            _await([pool.submit(work, *part) for part in parts], stop)
        except BaseException as error:
            stop.set()
            if not isinstance(error, KeyboardInterrupt):
                raise
    return found.whole


def _await(futures: list[Future[None]], stop: Stop) -> None:
    """Wait for all threads; the main thread handles signals here, and ends the runs."""
    waiting = set(futures)
    while waiting:
        try:
            done, waiting = wait(waiting, _TICK)
            for future in done:
                future.result()
        except KeyboardInterrupt:
            stop.set()
