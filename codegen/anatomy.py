"""Structure of a scene: which entries of M and A, and which other terms, are zero, constant or varying."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum

import sympy

from .equations.specialise import Block, Scene


class Variation(Enum):
    """On what a term depends; `value` is the text for users."""

    ABSENT = "zero"
    CONSTANT = "constant"
    OF_TIME = "varies with time alone"
    VARYING = "varies"


@dataclass(frozen=True, slots=True)
class Anatomy:
    """The structure of M (n, n) and A (m, n), entry by entry, and of the other terms.

    names : (n) coordinates; blocks : those of M
    terms : (name, variation) of M, A, b, G, T0, V, Q as wholes
    """

    names: tuple[str, ...]
    M: tuple[tuple[Variation, ...], ...]
    A: tuple[tuple[Variation, ...], ...]
    blocks: tuple[Block, ...]
    terms: tuple[tuple[str, Variation], ...]


def anatomy_of(scene: Scene) -> Anatomy:
    """Return the structure of a scene whose M contains the trees of bodies."""
    mechanics = scene.mechanics
    varying = frozenset((*mechanics.x, *mechanics.v, *mechanics.inputs, *mechanics.multipliers))

    def matrix(entries: sympy.ImmutableDenseMatrix) -> tuple[tuple[Variation, ...], ...]:
        return tuple(
            tuple(_variation([entries[i, j]], varying, mechanics.time) for j in range(entries.cols))
            for i in range(entries.rows)
        )

    M, A = matrix(mechanics.factored), matrix(mechanics.A)
    terms = {"b": mechanics.b, "G": mechanics.G, "T0": [mechanics.T0], "V": [mechanics.V], "Q": mechanics.Q}
    others = [(name, _variation(term, varying, mechanics.time)) for name, term in terms.items()]
    return Anatomy(
        mechanics.coordinate_names, M, A, scene.blocks, (("M", _strongest(M)), ("A", _strongest(A)), *others)
    )


def _strongest(rows: Iterable[Iterable[Variation]]) -> Variation:
    order = list(Variation)
    return max((one for row in rows for one in row), key=order.index, default=Variation.ABSENT)


def _variation(entries: Sequence[sympy.Expr], varying: frozenset[sympy.Symbol], time: sympy.Symbol) -> Variation:
    """Return on what entries depend together; references to nodes of a graph have the symbols of these."""
    if all(entry == 0 for entry in entries):
        return Variation.ABSENT
    symbols = set().union(*(entry.free_symbols for entry in entries))
    if symbols & varying:
        return Variation.VARYING
    return Variation.OF_TIME if time in symbols else Variation.CONSTANT
