"""Progress of a long task, on one line of standard error."""

import logging
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Event, Thread

Progress = Callable[[float, str], None]
"""Called with the finished part of the task, 0 ... 1, and the name of the current or last stage."""

_PATIENCE = 1.0  # [s] shorter tasks show nothing
_POLL, _SELDOM = 0.2, 30.0  # [s] between two readings of the clock; between two lines if not on a terminal
_CLEAR = "\r\x1b[K"


class _Line:
    """A line on standard error that is overwritten on a terminal."""

    def __init__(self) -> None:
        self._stream, self._written = sys.stderr, False
        self.is_terminal = self._stream.isatty()

    def write(self, words: str) -> None:
        self._stream.write(f"{_CLEAR}{words}" if self.is_terminal else f"{words}\n")
        self._stream.flush()
        self._written = True

    def wipe(self) -> None:
        if self._written and self.is_terminal:
            self.write("")


@contextmanager
def bar(name: str = "", every: float = 0.0) -> Iterator[Progress]:
    """Show the progress of a task and the remaining time; yield a function to report it. `every` [s]: between lines."""
    line, start = _Line(), time.monotonic()
    written_at, pause = start, every if line.is_terminal else _SELDOM

    def progress(done: float, what: str) -> None:
        nonlocal written_at
        if (now := time.monotonic()) - written_at >= pause:
            written_at = now
            line.write(" ".join([*name.split(), words(done, what, now - start)]))

    try:
        yield progress
    finally:
        line.wipe()


def words(done: float, what: str, seconds: float) -> str:
    """Return the finished part of a task, its stage, and the remaining time, as text."""
    left = f", {duration(seconds * (1 - done) / done)} left" if 0 < done < 1 else ""
    return f"{100 * done:.0f} %, {what}{left}"


def part(progress: Progress, start: float, end: float) -> Progress:
    """Return the progress of a subtask that is the part from `start` to `end` of a task."""
    return lambda done, what: progress(start + (end - start) * done, what)


@contextmanager
def counted(total: int, before: int = 0) -> Iterator[Callable[[int], None]]:
    """Show the number of finished runs, `before` of them earlier; yield the counter, which any thread may call."""
    done, start = before, time.monotonic()
    with bar(every=_PATIENCE) as progress:

        def add(count: int) -> None:
            nonlocal done
            done += count
            rate = (done - before) / max(time.monotonic() - start, 1e-9)
            progress((done - before) / max(total - before, 1), f"{done} of {total} runs, {rate:.3g} a second")

        yield add


def duration(seconds: float) -> str:
    """Return a duration in readable form."""
    whole = round(seconds)
    if whole < 60:
        return f"{seconds:.1f} s" if seconds < 10 else f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"


class _Clock(logging.Handler):
    """Log handler that shows each message as the current stage, with its seconds so far."""

    def __init__(self, line: _Line, patience: float) -> None:
        super().__init__(logging.INFO)
        self._line, self._patience, self._over = line, patience, Event()
        self._stage: tuple[str, float] | None = None
        self._thread = Thread(target=self._tick, daemon=True)
        self._thread.start()

    def emit(self, record: logging.LogRecord) -> None:
        self._stage = record.getMessage(), time.monotonic()

    def stop(self) -> None:
        self._over.set()
        self._thread.join()
        self._line.wipe()

    def _tick(self) -> None:
        while not self._over.wait(min(_POLL, self._patience or _POLL)):
            if self._stage and (seconds := time.monotonic() - self._stage[1]) >= self._patience:
                self._line.write(f"{self._stage[0]} ... {seconds:.0f} s")


@contextmanager
def clock(patience: float = _PATIENCE) -> Iterator[None]:
    """Show the last log message and its duration, if it lasts longer than `patience` [s]."""
    line = _Line()
    if not line.is_terminal:
        yield
        return
    log, handler = logging.getLogger("eigenmotion"), _Clock(line, patience)
    level = log.level
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        yield
    finally:
        log.setLevel(level)
        log.removeHandler(handler)
        handler.stop()
