"""Ctrl-C during many runs: a run that it ended ends all, and other processes end at once and say nothing."""

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from typing import Any

from ..results.solution import Solution
from ..runtime import StopReason

SPAWN = multiprocessing.get_context("spawn")
"""New processes, since forks of a process with threads may hang."""
_MOMENT = 5.0  # [s] for a process to end


def uninterrupted(done: Solution) -> Solution:
    """Return a solution.

    Raises
    ------
    KeyboardInterrupt
        Ctrl-C ended the run, which returns the motion so far.
    """
    if done.stop is StopReason.INTERRUPTED:
        raise KeyboardInterrupt
    return done


@contextmanager
def starting() -> Iterator[None]:
    """Ignore Ctrl-C for a moment: processes that start meanwhile ignore it until `ends_silently`."""
    if threading.current_thread() is not threading.main_thread():  # only the main thread may set handlers
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def ends_silently() -> None:
    """Let Ctrl-C end this process, which another one started, without a traceback."""
    signal.signal(signal.SIGINT, lambda *_: os._exit(130))


def _begin(more: Callable[..., object] | None, arguments: tuple[Any, ...]) -> None:
    ends_silently()
    if more is not None:
        more(*arguments)


class Pool(ProcessPoolExecutor):
    """A pool of new processes that end where its block is left by an exception."""

    def __init__(self, workers: int, initializer: Callable[..., object] | None = None, initargs: Any = ()) -> None:
        super().__init__(workers, mp_context=SPAWN, initializer=_begin, initargs=(initializer, initargs))
        self._others = set(multiprocessing.active_children())

    def submit(self, *arguments: Any, **named: Any) -> "Future[Any]":
        """Submit a call; a process that starts for it ignores Ctrl-C until it is ready."""
        with starting():
            return super().submit(*arguments, **named)

    def __exit__(self, *raised: Any) -> None:
        """Wait for the calls; after an exception, end the processes instead."""
        if raised[0] is not None:
            self.shutdown(wait=False, cancel_futures=True)
            for process in set(multiprocessing.active_children()) - self._others:
                process.terminate()
                process.join(_MOMENT)
        super().__exit__(*raised)
