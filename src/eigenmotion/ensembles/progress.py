"""How far many runs are, how fast, and how long the rest takes."""

import sys
import time
from types import TracebackType
from typing import TextIO

_EVERY, _SELDOM = 0.2, 30.0  # [s] between two lines; where they go to a file
_CLEAR = "\r\x1b[K"


class Progress:
    """A line on standard error, written over where somebody is watching; `add` may be called by any thread."""

    def __init__(self, total: int, done: int = 0, stream: TextIO | None = None) -> None:
        self._total, self._done, self._before = total, done, done
        self._stream = sys.stderr if stream is None else stream
        self._watched = self._stream.isatty()
        self._start = self._said = time.monotonic()

    def __enter__(self) -> "Progress":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._write("\n")

    def add(self, count: int) -> None:
        """Count runs that are done."""
        self._done += count
        if time.monotonic() - self._said < (_EVERY if self._watched else _SELDOM):
            return
        self._said = time.monotonic()
        self._write("" if self._watched else "\n")

    def _write(self, ending: str) -> None:
        self._stream.write(f"{_CLEAR if self._watched else ''}{self.words}{ending}")
        self._stream.flush()

    @property
    def words(self) -> str:
        """Done, of how many, at what rate, and the time left."""
        seconds = max(time.monotonic() - self._start, 1e-9)
        rate = (self._done - self._before) / seconds
        left = f", {duration((self._total - self._done) / rate)} left" if 0 < self._done < self._total and rate else ""
        return f"{self._done} of {self._total} runs, {rate:.3g} a second{left}"


def duration(seconds: float) -> str:
    """Return seconds as people say them."""
    whole = round(seconds)
    if whole < 60:
        return f"{seconds:.1f} s" if seconds < 10 else f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"
