"""Groups of formulations that fare alike, so that a picture has a row for each group and not for each formulation."""

from collections.abc import Callable, Iterable, Sequence

from ..evaluation.outcome import Cell

Row = tuple[str, tuple[str, ...]]
"""A method or a case, and the variants of the row."""
Look = Callable[[Cell], object]


def alike(cells: Iterable[Cell], look: Look) -> list[tuple[str, ...]]:
    """Return the variants of some cells in groups; those of one group look alike in every cell.

    Examples
    --------
    >>> cells = [Cell("a", "1", name, "dop853", 1e-8) for name in ("lagrange", "inverse")]
    >>> alike(cells, lambda cell: cell.variant)
    [('lagrange',), ('inverse',)]
    >>> alike(cells, lambda cell: cell.outcome)
    [('lagrange', 'inverse')]
    """
    seen: dict[str, list[object]] = {}
    for cell in cells:
        seen.setdefault(cell.variant, []).append((cell.point, cell.method, look(cell)))
    groups: dict[tuple[object, ...], list[str]] = {}
    for variant, looks in seen.items():
        groups.setdefault(tuple(looks), []).append(variant)
    return [tuple(group) for group in groups.values()]


def named(group: Sequence[str], every: Sequence[str]) -> str:
    """Return a name for a group of the variants that a case has: "" for all of them, or who is in it.

    Examples
    --------
    >>> named(("lagrange", "inverse"), ("lagrange", "inverse")), named(("a", "b"), ("a", "b", "inverse"))
    ('', 'all but inverse')
    """
    others = [variant for variant in every if variant not in group]
    if not others:
        return ""
    return f"all but {others[0]}" if len(others) == 1 and len(every) > 2 else ", ".join(group)
