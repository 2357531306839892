"""Names of columns: ours, and the user's beside them, no two alike."""

from collections import Counter
from collections.abc import Collection, Sequence


def columns(ours: Collection[str], users: Sequence[tuple[str, str]]) -> list[str]:
    """Return the name of a column for each (kind, name) of the user's.

    It is the name itself, but where that is one of ours, or two things have it: those are written with what they are,
    as `swept_run`, and once more where that is taken.
    """
    counts = Counter(name for _, name in users)
    taken, found = {*ours, *counts}, []
    for kind, name in users:
        column = name
        if name in ours or counts[name] > 1:
            column = f"{kind}_{name}"
            while column in taken:
                column = f"{kind}_{column}"
        taken.add(column)
        found.append(column)
    return found


def moving(ours: Collection[str], coordinates: Sequence[str]) -> list[str]:
    """Return the columns of n coordinates, and then of their rates, each the coordinate's with a mark."""
    return columns(
        ours, [*(("coordinate", name) for name in coordinates), *(("rate", f"{name}'") for name in coordinates)]
    )
