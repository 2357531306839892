"""Derivatives of the graph, forward and reverse, and of pieces that are not chosen."""

import mpmath
import pytest
import sympy
from eigenmotion.codegen.calculus.derivatives import Tangent, gradient
from hypothesis import given
from hypothesis import strategies as st
from sympy import cos, log, sin, sqrt

from .expression_trees import Meaning
from .expressions import EXPRESSIONS, POINT, SETTINGS, SYMBOLS, Bench, evaluated, p, same, value, x, y, z


@given(EXPRESSIONS, st.sampled_from([x, y, z, p]))
@SETTINGS
def test_forward_and_reverse_derivatives(expression, symbol):
    bench = Bench()
    root = bench.node(expression)
    forward = Tangent(bench.graph, {symbol.name: bench.graph.one})(root)
    (reverse,) = gradient(bench.graph, root, [symbol.name])
    right = mpmath.diff(lambda at: evaluated(expression, {**POINT, symbol: at}), POINT[symbol])
    assert same(value(bench.back(forward)), right, 1e-10)
    assert same(value(bench.back(reverse)), right, 1e-10)


@given(EXPRESSIONS)
@SETTINGS
def test_all_entries_of_a_gradient_agree_with_sympy(expression):
    bench = Bench()
    entries = gradient(bench.graph, bench.node(expression), [symbol.name for symbol in SYMBOLS])
    for symbol, entry in zip(SYMBOLS, entries, strict=True):
        assert same(value(bench.back(entry)), value(expression.diff(symbol)), 1e-12)


def test_a_direction_mixes_rates(bench):
    along = Tangent(bench.graph, {"x": bench.node(y), "z": bench.graph.one})
    found = bench.back(along(bench.node(x**2 * sin(z))))
    assert sympy.expand(found - (2 * x * y * sin(z) + x**2 * cos(z))) == 0


PIECES = [
    sympy.Piecewise((sqrt(x - 3) ** 5, x > 3), (x**2, True)),
    sympy.Piecewise((log(x - 3), x > 3), (y, x > 2), (x * y, True)),
    z * sympy.Piecewise((sympy.Piecewise((log(x - 3), x > 4), (sqrt(x - 2), True)), x > 3), (x**3, True)) ** 2,
]


@pytest.mark.parametrize("pieces", PIECES)
def test_a_piece_that_is_not_chosen_may_be_undefined(bench, pieces):
    root = bench.node(pieces)
    found = [Tangent(bench.graph, {"x": bench.graph.one})(root), *gradient(bench.graph, root, ["x"])]
    meaning = Meaning(bench.graph, {symbol.name: float(at) for symbol, at in POINT.items()})
    assert all(same(meaning(node), value(pieces.diff(x))) for node in found)


def test_where_no_piece_holds_the_derivative_is_undefined_too(bench):
    root = bench.node(sympy.Piecewise((x**2, x > 3)))
    meaning = Meaning(bench.graph, {"x": 0.7})
    assert mpmath.isnan(meaning(Tangent(bench.graph, {"x": bench.graph.one})(root)))
    assert mpmath.isnan(meaning(gradient(bench.graph, root, ["x"])[0]))
