"""What takes long says so while it does, on standard error and only where somebody is watching."""

import logging
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Event, Thread
from typing import TextIO

import click

from eigenmotion.pages.words import Progress

_STEPS = 1000
_PATIENCE = 1.0  # [s] what is quicker is not spoken of
_TICK = 0.2  # [s]
_CLEAR = "\r\x1b[K"


class _Clock(logging.Handler):
    """Takes each message of the log as the name of what begins now; writes it with its seconds, on one line."""

    def __init__(self, stream: TextIO, patience: float) -> None:
        super().__init__(logging.INFO)
        self._stream, self._patience, self._over = stream, patience, Event()
        self._stage: tuple[str, float] | None = None
        self._thread = Thread(target=self._tick, daemon=True)
        self._thread.start()

    def emit(self, record: logging.LogRecord) -> None:
        self._stage = record.getMessage(), time.monotonic()

    def stop(self) -> None:
        """Wipe the line."""
        self._over.set()
        self._thread.join()

    def _tick(self) -> None:
        written = False
        while not self._over.wait(min(_TICK, self._patience or _TICK)):
            if self._stage and (seconds := time.monotonic() - self._stage[1]) >= self._patience:
                self._stream.write(f"{_CLEAR}{self._stage[0]} ... {seconds:.0f} s")
                self._stream.flush()
                written = True
        if written:
            self._stream.write(_CLEAR)
            self._stream.flush()


@contextmanager
def clock(patience: float = _PATIENCE) -> Iterator[None]:
    """Show how long the stage that the log names last has taken, once it takes longer than `patience` [s]."""
    if not sys.stderr.isatty():
        yield
        return
    log, handler = logging.getLogger("eigenmotion"), _Clock(sys.stderr, patience)
    level = log.level
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        yield
    finally:
        log.setLevel(level)
        log.removeHandler(handler)
        handler.stop()


@contextmanager
def bar(name: str) -> Iterator[Progress]:
    """Show a bar; give what moves it: (share done so far, 0 ... 1, and what comes next)."""
    if not sys.stderr.isatty():
        yield lambda _done, _what: None
        return
    with click.progressbar(length=_STEPS, label=name, file=sys.stderr, item_show_func=str) as shown:

        def progress(done: float, what: str) -> None:
            shown.update(max(0, round(_STEPS * done) - shown.pos), what)

        yield progress
        progress(1.0, "done")
