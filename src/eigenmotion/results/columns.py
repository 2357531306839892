"""Unique names of the columns of a table: ours and the user's."""

from collections import Counter
from collections.abc import Collection, Sequence

from ..runtime import CompiledModel


def columns(ours: Collection[str], users: Sequence[tuple[str, str]]) -> list[str]:
    """Return a column name for each (kind, name) of the user's.

    It is the name itself. If the name is one of ours, or occurs twice, the kind is put before it, as in `swept_run`;
    again if that name is taken too.
    """
    counts = Counter(name for _, name in users)
    used, named = {*ours, *counts}, []
    for kind, name in users:
        column = name
        if name in ours or counts[name] > 1:
            column = f"{kind}_{name}"
            while column in used:
                column = f"{kind}_{column}"
        used.add(column)
        named.append(column)
    return named


def moving(ours: Collection[str], coordinates: Sequence[str]) -> list[str]:
    """Return the columns of n coordinates, then of their rates, which are marked with '."""
    return columns(
        ours, [*(("coordinate", name) for name in coordinates), *(("rate", f"{name}'") for name in coordinates)]
    )


def names_of_rows(model: CompiledModel) -> dict[int, str]:
    """Return the number of a constraint row -> its name, for those that have one, or that a contact or friction has."""
    names = {k: name for k, name in enumerate(model.row_names) if name != f"row {k}"}
    for event, _, _, row, _, shift, _ in model.switches:
        cone = shift >= 0
        names |= {row + k: f"{model.events[event]}{f'[{k}]' * cone}" for k in range(1 + cone)}
    return dict(sorted(names.items()))


def reactions(model: CompiledModel) -> tuple[str, ...]:
    """Return the columns of multipliers: lambda_NAME of rows with names, contacts and frictions, else lambda0, ..."""
    names = names_of_rows(model)
    return tuple(f"lambda_{names[k]}" if k in names else f"lambda{k}" for k in range(model.m))
