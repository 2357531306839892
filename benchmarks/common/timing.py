"""Interleaved timing: the compared actions alternate, so that the other load of the machine affects all equally."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

import numpy as np


def interleaved(
    actions: Mapping[str, Callable[[], object]], rounds: int, clock: Callable[[], float] = time.perf_counter
) -> dict[str, np.ndarray]:
    """Return the seconds of each action in each round (rounds,), after a warm-up round.

    If the machine is shared with others, use time.thread_time as the clock: it counts only this thread's time.
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
    """Return the median and quartiles of the ratios of each round, as text."""
    low, median, high = np.percentile(numerator / denominator, [25, 50, 75])
    return f"{median:.3g} [{low:.3g}, {high:.3g}]"


def spread(seconds: np.ndarray, unit: float, digits: int = 3) -> str:
    """Return the median and quartiles as text, in a unit given in seconds."""
    low, median, high = np.percentile(seconds / unit, [25, 50, 75])
    return f"{median:.{digits}g} [{low:.{digits}g}, {high:.{digits}g}]"
