"""Deadline of an examination: runs end by their number of steps, from the time that the first of these take."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from math import inf

from ..results.solution import Solution
from ..runtime import StopReason
from .interrupts import uninterrupted

_TRIAL = 20  # the part of a run's steps that is tried first, to see what a step takes
_LEAST = 100  # steps


class TooLateError(Exception):
    """A run could not end in time."""


@dataclass(frozen=True)
class Deadline:
    """A reading of the clock, which is the same in all processes, after which no run goes on."""

    until: float = inf
    now: Callable[[], float] = time.monotonic

    @property
    def left(self) -> float:
        """The time [s] that is left; negative if it is over."""
        return self.until - self.now()

    def sooner(self, seconds: float) -> "Deadline":
        """Return the deadline in some seconds from now, if that is before this one."""
        return Deadline(min(self.until, self.now() + seconds), self.now)

    def run(self, run: Callable[[int], Solution], most: int) -> Solution:
        """Return run(most steps), or the part of it that there is time for.

        Raises
        ------
        TooLateError
            There is no time for a run at all.
        """
        if self.left <= 0:
            raise TooLateError
        trial, begin = min(most, max(_LEAST, most // _TRIAL)), self.now()
        done = uninterrupted(run(trial))
        if trial == most or done.stop is not StopReason.TOO_MANY_STEPS:
            return done
        each = max((self.now() - begin) / trial, 1e-9)
        allowed = int(min(most, self.left / each))
        return uninterrupted(run(allowed)) if allowed > trial else done

    def complete(self, run: Callable[[int], Solution], most: int) -> Solution:
        """Return run(most steps).

        Raises
        ------
        TooLateError
            There is no time for so many steps, and fewer do not reach the end.
        """
        steps: list[int] = []

        def counted(count: int) -> Solution:
            steps.append(count)
            return run(count)

        done = self.run(counted, most)
        if steps[-1] < most and done.stop is StopReason.TOO_MANY_STEPS:
            raise TooLateError
        return done


NONE = Deadline()
"""No deadline: runs take as long as they take."""
