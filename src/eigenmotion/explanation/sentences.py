"""Lines below the matrices of a picture: blocks, terms, states and operations."""

from collections.abc import Sequence

from ..codegen.anatomy import Variation
from ..codegen.equations.specialise import Kind
from .savings import WORDS, Savings

_LONGEST = 24  # letters of a name
_LETTERS = 58  # of a line
_MOST = 8  # blocks that are listed one by one
_BLOCKS = {
    Kind.TURNING: "varies, C and s are states",
    Kind.SINGLE: "one coordinate, s in closed form",
    Kind.FIXED: "constant, factored once",
}


def sentences(found: Savings) -> list[tuple[str, str]]:
    """Return lines as (text, weight of the type)."""
    base, *others = found.prices
    own, full = dict(base.states), others[-1].states
    kept = [f"{name}: {own.get(name, 0)} of {length} kept" for name, length in full]
    more = [f"{one.words}, {one.n_state} states: {WORDS[one.name]}" for one in others]
    parts = {
        "Blocks of M": _blocks(found),
        "Terms": _terms(found),
        f"States ({found.formulation}): {base.n_state}, of {others[-1].n_state} without savings": _joined(kept),
        f"A right-hand side: {base.words}; without a saving:": more,
    }
    return [line for title, lines in parts.items() for line in [(title, "bold"), *((text, "normal") for text in lines)]]


def _blocks(found: Savings) -> list[str]:
    blocks, names = found.anatomy.blocks, found.anatomy.names
    if len(blocks) > _MOST:
        counts = {kind: sum(block.kind is kind for block in blocks) for kind in _BLOCKS}
        return [f"{count} blocks: {_BLOCKS[kind]}" for kind, count in counts.items() if count]
    return [f"{_span([names[k] for k in block.coordinates])}: {_BLOCKS[block.kind]}" for block in blocks]


def _span(names: Sequence[str]) -> str:
    """Return the names of a block, or the first of many with their number."""
    text, room = ", ".join(names), _LETTERS - 2 - max(map(len, _BLOCKS.values()))
    return (
        text
        if len(text) <= room
        else short(text, room)
        if len(names) == 1
        else f"{short(names[0], 14)} and {len(names) - 1} more"
    )


def _terms(found: Savings) -> list[str]:
    by_kind = {kind: [name for name, one in found.anatomy.terms if one is kind] for kind in Variation}
    return [f"{kind.value}: {', '.join(names)}" for kind, names in by_kind.items() if names]


def _joined(parts: Sequence[str]) -> list[str]:
    lines = [""]
    for part in parts:
        joined = f"{lines[-1]}; {part}" if lines[-1] else part
        lines = [*lines[:-1], joined] if len(joined) <= _LETTERS else [*lines, part]
    return lines


def short(name: str, most: int = _LONGEST) -> str:
    """Return a name of at most some letters.

    Examples
    --------
    >>> short("theta"), short("elongation", 6)
    ('theta', 'elong\N{HORIZONTAL ELLIPSIS}')
    """
    return name if len(name) <= most else f"{name[: most - 1]}\N{HORIZONTAL ELLIPSIS}"
