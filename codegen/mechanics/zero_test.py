"""Zero test of expressions of coordinates, rates and speeds, wherever they are defined."""

from __future__ import annotations

from collections.abc import Iterable

import sympy
from sympy.core.function import AppliedUndef

from ..calculus.identity_test import Zeros
from ..graph.convert import FromSympy
from ..graph.graph import Graph
from ..model import ModelError


def vanish(expressions: Iterable[sympy.Expr]) -> bool:
    """Whether all are zero, judged as the compiler judges it; what it cannot tell counts as not."""
    given = sympy.Tuple(*expressions)
    moving = sorted(given.atoms(AppliedUndef, sympy.Derivative), key=sympy.default_sort_key)
    plain = given.xreplace({function: sympy.Symbol(f"moving {k}") for k, function in enumerate(moving)})
    symbols = plain.free_symbols
    graph = Graph(symbol.name for symbol in symbols)
    convert = FromSympy(graph)
    zeros = Zeros(graph, {symbol.name: 1 for symbol in symbols if symbol.is_positive})
    try:
        return all(zeros(convert(expression)) for expression in plain)
    except ModelError:  # a function of the user's
        return False
