"""Ctrl-C during many runs: a run that it ended ends all, and other processes end at once and say nothing."""

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any
from weakref import WeakSet

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
    """A pool of new processes that end where its block is left by an exception.

    Where a process dies, calls end with BrokenProcessPool, those included that are submitted at the same moment: Python
    3.11 can lose them, and then waits for their results for ever.
    """

    def __init__(self, workers: int, initializer: Callable[..., object] | None = None, initargs: Any = ()) -> None:
        super().__init__(workers, mp_context=SPAWN, initializer=_begin, initargs=(initializer, initargs))
        self._others = set(multiprocessing.active_children())
        self._calls: WeakSet[Future[Any]] = WeakSet()

    def submit(self, *arguments: Any, **named: Any) -> "Future[Any]":
        """Submit a call; a process that starts for it ignores Ctrl-C until it is ready."""
        with starting():
            call = super().submit(*arguments, **named)
        self._calls.add(call)
        if self._broken:
            self._end_calls()
        return call

    def _end_calls(self) -> None:
        """End all calls, when the thread that ends them has done what it does where a process dies."""
        manager: threading.Thread | None = getattr(self, "_executor_manager_thread", None)
        if manager is not None:
            manager.join()
        for call in list(self._calls):
            if not call.done():
                call.set_exception(BrokenProcessPool("A process in the process pool was terminated abruptly"))

    def __exit__(self, *raised: Any) -> None:
        """Wait for the calls; after an exception, end the processes instead."""
        if raised[0] is not None:
            self.shutdown(wait=False, cancel_futures=True)
            for process in set(multiprocessing.active_children()) - self._others:
                process.terminate()
                process.join(_MOMENT)
        super().__exit__(*raised)
