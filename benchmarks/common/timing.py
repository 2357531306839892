"""Interleaved timing: what is compared runs in turns, so that whatever else the machine does hits all alike."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

import numpy as np


def interleaved(
    actions: Mapping[str, Callable[[], object]], rounds: int, clock: Callable[[], float] = time.perf_counter
) -> dict[str, np.ndarray]:
    """Return the seconds of each action in each round (rounds,), after one round that does not count.

    Where others use the machine, time.thread_time for a clock leaves out what they take.
    """
    for action in actions.values():
        action()
    seconds = {name: np.empty(rounds) for name in actions}
    for k in range(rounds):
        for name, action in actions.items():
            start = clock()
            action()
            seconds[name][k] = clock() - start
    return seconds


def ratio(numerator: np.ndarray, denominator: np.ndarray) -> str:
    """Return the median of the ratios round by round, and their quartiles."""
    low, median, high = np.percentile(numerator / denominator, [25, 50, 75])
    return f"{median:.3g} [{low:.3g}, {high:.3g}]"


def spread(seconds: np.ndarray, unit: float, digits: int = 3) -> str:
    """Return the median and the quartiles, in a unit of so many seconds."""
    low, median, high = np.percentile(seconds / unit, [25, 50, 75])
    return f"{median:.{digits}g} [{low:.{digits}g}, {high:.{digits}g}]"
