"""Numbers in words, and what says how far a long task is."""

from collections.abc import Callable

Progress = Callable[[float, str], None]
"""Is told how much of the whole is done, 0 ... 1, and what comes next or was done last."""


def number(value: float | None) -> str:
    """Three digits, or a dash where there is none."""
    return "-" if value is None else f"{value:.3g}"


def seconds(value: float | None) -> str:
    """A time with the unit that suits it."""
    if value is None:
        return "-"
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if value >= size:
            return f"{value / size:.3g} {unit}"
    return f"{value / 1e-9:.3g} ns"


def part(progress: Progress, start: float, end: float) -> Progress:
    """Return the progress of a task that takes the whole from `start` to `end`."""
    return lambda done, what: progress(start + (end - start) * done, what)
