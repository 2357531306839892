"""Progress of a long task, on one line of standard error."""

import logging
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import inf
from threading import Event, Thread

Progress = Callable[[float, str], None]
"""Called with the finished part of the task, 0 ... 1, and the name of the current or last stage."""

PATIENCE = 1.0
"""[s] Shorter tasks show nothing."""
_POLL, _SELDOM = 0.2, 30.0  # [s] between two readings of the clock; between two lines if not on a terminal
_CLEAR = "\r\x1b[K"


class _Line:
    """A line on standard error that is overwritten on a terminal and in a notebook."""

    def __init__(self) -> None:
        self._stream, self._written = sys.stderr, False
        self.is_terminal = self._stream.isatty() or type(self._stream).__module__.startswith("ipykernel")

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
    with bar(every=PATIENCE) as progress:

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


def durations(spent: list[tuple[str, float]]) -> str:
    """Return the time of each kind of stage, its first word, in the order in which they began; "" if there are none."""
    sums: dict[str, float] = {}
    for what, seconds in spent:
        kind = what.split()[0]
        sums[kind] = sums.get(kind, 0.0) + seconds
    listed = ", ".join(f"{kind} {duration(seconds)}" for kind, seconds in sums.items())
    return f": {listed}" if listed else ""


class Stages(logging.Filter):
    """The stages of a task, which are the log messages: each with its duration.

    A filter, because it passes on only what the user's own levels let through. A message may have the seconds that its
    stage will take about, as the attribute `expected` of the record.

    Attributes
    ----------
    spent : (stage, seconds) of each finished stage, in order

    Examples
    --------
    >>> import logging
    >>> from eigenmotion.progress import clock
    >>> with clock() as stages:
    ...     logging.getLogger("eigenmotion").info("deriving %s", "pendulum")
    >>> [what for what, _ in stages.spent]
    ['deriving pendulum']
    """

    def __init__(self, level: int) -> None:
        super().__init__()
        self.spent: list[tuple[str, float]] = []
        self.current: tuple[str, float] | None = None
        self.begun, self.end = inf, -inf
        self.level = level

    def filter(self, record: logging.LogRecord) -> bool:
        """Take a message as the next stage. Return whether it would be logged without us."""
        self._enter((record.getMessage(), time.monotonic()))
        self.end = time.monotonic() + getattr(record, "expected", -inf)
        return record.levelno >= self.level

    def _enter(self, stage: tuple[str, float] | None) -> None:
        if self.current is not None:
            self.spent.append((self.current[0], time.monotonic() - self.current[1]))
        self.current = stage
        if stage is not None:
            self.begun = min(self.begun, stage[1])

    def close(self) -> None:
        """Finish the last stage."""
        self._enter(None)


def _show(stages: Stages, line: _Line, patience: float, over: Event) -> None:
    """Show the current stage, its seconds so far, and those left if they are known, until the task is over."""
    while not over.wait(min(_POLL, patience or _POLL)):
        stage, now = stages.current, time.monotonic()
        if stage is not None and now - stages.begun >= patience:
            left = f", about {duration(stages.end - now)} left" if stages.end - now > 0.05 else ""
            line.write(f"{stage[0]} ... {now - stage[1]:.0f} s{left}")
    line.wipe()


@contextmanager
def _shown(stages: Stages, patience: float) -> Iterator[None]:
    line, over = _Line(), Event()
    if not line.is_terminal:
        yield
        return
    thread = Thread(target=_show, args=(stages, line, patience, over), daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


@contextmanager
def clock(patience: float = PATIENCE) -> Iterator[Stages]:
    """Show the last log message on a terminal or in a notebook, `patience` [s] after the first.

    Yields the stages. Within another clock, which shows them already, it yields those of that one.
    """
    log = logging.getLogger("eigenmotion")
    outer = next((one for one in log.filters if isinstance(one, Stages)), None)
    if outer is not None:
        yield outer
        return
    level, stages = log.level, Stages(log.getEffectiveLevel())
    log.addFilter(stages)
    log.setLevel(min(logging.INFO, stages.level))
    try:
        with _shown(stages, patience):
            yield stages
    finally:
        log.setLevel(level)
        log.removeFilter(stages)
        stages.close()
