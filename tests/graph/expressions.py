"""Expressions in five symbols, drawn by hypothesis, with their numbers at one point; and a graph to take them into."""

import mpmath
import sympy
from eigenmotion.codegen.graph.convert import FromSympy, ToSympy
from eigenmotion.codegen.graph.graph import Graph
from hypothesis import settings
from hypothesis import strategies as st
from sympy import Rational, cos, exp, log, sin, sqrt, symbols

SYMBOLS = x, y, z, p, q = symbols("x y z p q", positive=True)
BY_NAME = {symbol.name: symbol for symbol in SYMBOLS}
POINT = dict(zip(SYMBOLS, map(mpmath.mpf, ("0.71", "1.13", "1.62", "0.87", "1.41")), strict=True))
mpmath.mp.dps = 30
SETTINGS = settings(max_examples=60, deadline=None, derandomize=True)


class Bench:
    """A graph with both ways in and out; p and q are parameters."""

    def __init__(self):
        self.graph = Graph(["p", "q"])
        self.node = FromSympy(self.graph)
        self.back = ToSympy(self.graph, BY_NAME)


def value(expression):
    """Return an expression's number at POINT."""
    return evaluated(sympy.sympify(expression), POINT)


def evaluated(expression, point):
    """Return an expression's number in the digits mpmath works with just now."""
    exact = {symbol: sympy.Float(at, mpmath.mp.dps) for symbol, at in point.items()}
    return mpmath.mpf(sympy.N(expression.xreplace(exact), mpmath.mp.dps))


def same(first, second, tolerance=1e-13):
    """Compare two numbers; those of functions carry constants of double precision."""
    return abs(first - second) <= tolerance * max(1, abs(first), abs(second))


def of_one(argument):
    functions = [sin, cos, sympy.atan, sympy.tanh, lambda a: exp(-a * a / 50), lambda a: log(a * a + 1)]
    functions += [lambda a: sqrt(a * a + 1), lambda a: (a * a + 2) ** Rational(-3, 2), sympy.Abs, sympy.asinh]
    return st.builds(lambda f, a: f(a), st.sampled_from(functions), argument)


def of_two(argument):
    operations = [lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b, lambda a, b: a / (b * b + 3)]
    operations += [sympy.Max, sympy.Min, lambda a, b: sympy.atan2(a, b * b + 1), lambda a, b: (a * a + 1) ** b]
    operations += [lambda a, b: sympy.Piecewise((a, x < y * z), (a * b, True))]
    return st.builds(lambda f, a, b: f(a, b), st.sampled_from(operations), argument, argument)


LEAVES = st.one_of(
    st.sampled_from(SYMBOLS),
    st.fractions(-3, 3, max_denominator=5).map(lambda f: Rational(f.numerator, f.denominator)),
    st.sampled_from([x + y, x - y, p * x - y, sympy.Float(0.3), sympy.pi]),
)


EXPRESSIONS = st.recursive(LEAVES, lambda inner: st.one_of(of_one(inner), of_two(inner)), max_leaves=10)
