"""Identity test of expressions in coordinates, rates and speeds."""

from __future__ import annotations

from collections.abc import Iterable

import sympy
from sympy.core.function import AppliedUndef

from ..calculus.identity_test import Zeros
from ..graph.convert import FromSympy
from ..graph.graph import Graph
from ..model import ModelError


def vanish(expressions: Iterable[sympy.Expr]) -> bool:
    """Whether all expressions are identically zero, by the compiler's identity test; False where it cannot decide."""
    whole = sympy.Tuple(*expressions)
    moving = sorted(whole.atoms(AppliedUndef, sympy.Derivative), key=sympy.default_sort_key)
    plain = whole.xreplace({function: sympy.Symbol(f"moving {k}") for k, function in enumerate(moving)})
    symbols = plain.free_symbols
    graph = Graph(symbol.name for symbol in symbols)
    convert = FromSympy(graph)
    zeros = Zeros(graph, {symbol.name: 1 for symbol in symbols if symbol.is_positive})
    try:
        return all(zeros(convert(expression)) for expression in plain)
    except ModelError:  # a function that the graph cannot represent
        return False
