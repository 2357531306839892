"""Choice of the form of a model's sums: as SymPy writes them, or nested."""

from __future__ import annotations

from ..graph.convert import FromSympy
from ..graph.graph import Graph
from ..graph.nested_sums import NestedSums
from ..model.statement.mechanism import Mechanism
from ..model.tree.functions import BodyFunction
from ..schedule.schedule import weight
from .plain_symbols import Names

MOST = 0.9
"""Nested sums are taken if T costs at most this part of what it costs as written: its derivatives then cost less, too.

Otherwise entries of M that are written out can be simplified one by one, which is worth more."""
MANY = 8
"""With more coordinates than this, nested sums are taken if T costs any less: entries one by one take too long."""


def saves_by_nesting(model: Mechanism) -> bool:
    """Whether the equations are derived from nested sums; False for trees of bodies, which have recursions."""
    if model.kinetic_energy.has(BodyFunction) or model.potential_energy.has(BodyFunction):
        return False
    names = Names(model)
    graph = Graph(symbol.name for symbol in names.parameters)
    T = FromSympy(graph)(names.plain(model.kinetic_energy))
    nested = NestedSums(graph, [T])
    if not nested.are_shared:
        return False
    before, after = weight(graph, [T]), weight(graph, [nested(T)])
    return after <= MOST * before or model.n > MANY and after < before
