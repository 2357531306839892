"""Turns on the processor's cores, of which one may be kept for a unit that is not known yet; and on the interpreter."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Condition, Lock

from ..cores import cores


class Turns:
    """As many turns as there are cores.

    One lock for both kinds: whoever waits for a turn goes on when one is kept for it meanwhile.
    """

    def __init__(self, free: int | None = None) -> None:
        self._free, self._kept, self._changed = cores() if free is None else free, 0, Condition()

    @contextmanager
    def taken(self, kept: bool) -> Iterator[None]:
        """Wait for a turn; one that is kept will do where that is said."""
        with self._changed:
            self._changed.wait_for(lambda: self._free or (kept and self._kept))
            if kept and self._kept:
                self._kept -= 1
            else:
                self._free -= 1
        try:
            yield
        finally:
            self._give_back()

    @contextmanager
    def keeping(self) -> Iterator[None]:
        """Keep a turn for whoever takes it, and give it back at the end if nobody has."""
        with self._changed:
            self._changed.wait_for(lambda: self._free)
            self._free -= 1
            self._kept += 1
            self._changed.notify_all()
        try:
            yield
        finally:
            with self._changed:
                unused = bool(self._kept)
                self._kept -= unused
            if unused:
                self._give_back()

    def _give_back(self) -> None:
        with self._changed:
            self._free += 1
            self._changed.notify_all()


class Briefly:
    """Short turns on the interpreter while any thread is within this: others need not wait long for one that computes.

    A thread that starts compilers waits for each file and each process, and every time would get the interpreter back
    from one that derives equations only after the 5 ms that are Python's default.
    """

    SECONDS = 2e-4

    def __init__(self) -> None:
        self._lock, self._within, self._before = Lock(), 0, 0.0

    def __enter__(self) -> None:
        with self._lock:
            if not self._within:
                self._before = sys.getswitchinterval()
                sys.setswitchinterval(min(self.SECONDS, self._before))
            self._within += 1

    def __exit__(self, *_: object) -> None:
        with self._lock:
            self._within -= 1
            if not self._within:
                sys.setswitchinterval(self._before)


briefly = Briefly()
