"""Counts of things, as text."""


def count_of(count: int, thing: str) -> str:
    """Return a number of things, as a native writer would.

    Examples
    --------
    >>> from eigenmotion.presentation.counts import count_of
    >>> count_of(1, "run"), count_of(6, "run")
    ('1 run', '6 runs')
    """
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"
