"""The graph: canonical forms, sums of angles, rebuilding."""

from fractions import Fraction

import pytest
import sympy
from eigenmotion.codegen.calculus.identity_test import Zeros
from eigenmotion.codegen.calculus.trigonometry import expansion
from eigenmotion.codegen.graph.rewrite import Rewriter, Substitution
from eigenmotion.codegen.graph.store import Kind
from eigenmotion.codegen.schedule.schedule import schedule
from hypothesis import given
from sympy import Rational, cos, exp, sin, sqrt, tan

from .expression_trees import Meaning
from .expressions import EXPRESSIONS, SETTINGS, SYMBOLS, Bench, p, q, same, value, x, y, z
from .tree_checks import unclean


@given(EXPRESSIONS)
@SETTINGS
def test_the_graph_keeps_values(expression):
    bench = Bench()
    right = value(expression)
    assert same(value(bench.back(bench.node(expression))), right)


@given(EXPRESSIONS)
@SETTINGS
def test_coming_back_in_gives_the_same_node(expression):
    bench = Bench()
    first = bench.node(expression)
    again = bench.node(bench.back(first))
    assert Zeros(bench.graph).equal(first, again)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (x + y + z, z + (y + x)),
        (2 * x + 2 * y, 2 * (y + x)),
        (x * y / z, y / z * x),
        (x**2 * x**-1, x),
        (sqrt(x) * sqrt(x), x),
        (x - y, -(y - x)),
        (Rational(1, 2) * x + Rational(1, 2) * y, (x + y) / 2),
        (p * sin(x) + q * sin(x), (p + q) * sin(x)),
        (sympy.Float(2.0) * x, 2 * x),
        (sin(x - y), -sin(y - x)),
        (cos(x - y), cos(y - x)),
        (p * sin(x) ** 2 + p * cos(x) ** 2, p),
        (z * sin(x + y) ** 2 + y + z * cos(x + y) ** 2, z + y),
        (3 * sin(x) ** 2 * cos(y) ** 2 + 3 * cos(x) ** 2 * cos(y) ** 2 + 3 * sin(y) ** 2, sympy.Integer(3)),
    ],
)
def test_equal_expressions_are_one_node(bench, first, second):
    built = [bench.node(sympy.sympify(e)) for e in (first, second)]
    assert built[0] == built[1], list(map(bench.back, built))


@pytest.mark.parametrize("coefficient", [2, -1, p, sympy.Float(0.5)])
def test_sines_and_cosines_of_unequal_weight_stay(bench, coefficient):
    kept = bench.node(sin(x) ** 2 + coefficient * cos(x) ** 2)
    assert bench.graph.depends(kept, "x")
    assert same(value(bench.back(kept)), value(sin(x) ** 2 + coefficient * cos(x) ** 2))


@pytest.mark.parametrize(
    "expression", [sqrt(x**2 - 2 * x * y + y**2), sqrt((y - x) ** 2), ((x - y) ** 2) ** Rational(3, 2)]
)
def test_roots_of_squares_keep_their_sign(bench, expression):
    """(a^2)^(1/2) is |a|, not a."""
    real = {symbol: sympy.Symbol(symbol.name, real=True) for symbol in SYMBOLS}
    assert same(value(bench.back(bench.node(expression.xreplace(real))).xreplace({v: k for k, v in real.items()})),
                value(expression))  # fmt: skip


@pytest.mark.parametrize(
    "merged",
    [
        lambda g, S, r: g.mul(g.power(S, Fraction(1, 2)), g.power(S, Fraction(1, 2)), r),
        lambda g, S, r: g.power(g.mul(g.power(S, Fraction(1, 2)), r), 2),
        lambda g, S, r: g.mul(g.power(S, Fraction(3, 2)), g.power(S, Fraction(-1, 2)), r),
        lambda g, S, r: g.add(g.mul(g.power(g.mul(g.power(S, Fraction(1, 2)), g.symbol("p")), 2), r), r),
    ],
)
@pytest.mark.parametrize("inner", [4 + x**2, 2 * x * y, x**2, 2 + 2 * cos(x), sympy.Integer(3), -3 * p])
def test_a_merged_power_opens_what_it_closed(bench, merged, inner):
    """sqrt(S) sqrt(S) is S, with a coefficient and factors of its own."""
    graph = bench.graph
    merged(graph, bench.node(inner / 4), graph.symbol("z"))
    assert list(unclean(graph)) == []


@pytest.mark.parametrize(
    ("base", "inner", "outer"),
    [
        ("x", 2, Fraction(1, 2)),
        ("x", 3, Fraction(1, 3)),
        ("x", Fraction(3, 2), Fraction(2, 3)),
        ("x", -1, Fraction(1, 2)),
    ],
)
def test_powers_of_powers_that_depend_on_the_sign_stay(bench, base, inner, outer):
    graph = bench.graph
    symbol = graph.symbol(base)
    assert graph.power(graph.power(symbol, inner), outer) != graph.power(symbol, inner * outer)


def test_powers_of_numbers(bench):
    power, number = bench.graph.power, bench.graph.number
    assert power(number(2), Fraction(3, 2)) == bench.graph.scale(power(number(2), Fraction(1, 2)), 2)
    assert power(power(number(2), Fraction(1, 2)), 2) == number(2)
    assert power(number(0), Fraction(1, 2)) == number(0)
    for exponent in (-1, Fraction(-1, 2)):
        with pytest.raises(ZeroDivisionError):
            power(number(0), exponent)


@pytest.mark.parametrize(("given", "right"), [((), 0.5), ((1,), 1), ((0,), 0)])
def test_the_step_at_zero(bench, given, right):
    node = bench.node(sympy.Heaviside(x - y, *given, evaluate=False))
    assert Meaning(bench.graph, {"x": 2.0, "y": 2.0})(node) == right


@pytest.mark.parametrize("left", [0, 2])
def test_conditions_on_numbers_come_back(bench, left):
    graph = bench.graph
    choice = graph.call("select", graph.call("<", graph.number(left), graph.one), graph.symbol("x"), graph.symbol("y"))
    assert bench.back(choice) == (x if left < 1 else y)


def test_operands_come_before_what_is_made_of_them(bench):
    bench.node(sin(x + y) * exp(x * y) / sqrt(z + p))
    graph = bench.graph
    assert all(child < node for node in range(len(graph.records)) for child in graph.children(node))


def test_constants_are_split_off(bench):
    constant, varying = bench.graph.split(bench.node(p * q**2 * x * y))
    assert (bench.back(constant), bench.back(varying)) == (p * q**2, x * y)
    assert not bench.graph.varies(bench.node(p + q))
    assert bench.graph.varies(bench.node(p + x))


def sines(graph, roots):
    return sum(1 for node in graph.reachable(roots) if graph.records[node].operands[:1] in (("sin",), ("cos",)))


def test_differences_of_many_angles_are_written_out(bench):
    angles = [x, y, z, x * y, y * z]
    wanted = [f(a) for f in (sin, cos) for a in angles]
    wanted += [f(a - b) for f in (sin, cos) for k, a in enumerate(angles) for b in angles[:k]]
    roots = list(map(bench.node, wanted))
    expanded = list(map(expansion(bench.graph, roots), roots))
    assert sines(bench.graph, expanded) == 2 * len(angles)
    for expression, node in zip(wanted, expanded, strict=True):
        assert same(value(bench.back(node)), value(expression))


def test_a_lone_difference_stays(bench):
    roots = [bench.node(sin(x - y)), bench.node(cos(x - y))]
    assert list(map(expansion(bench.graph, roots), roots)) == roots


def test_sums_of_three_with_factors_and_constants(bench):
    wanted = [
        f(a) for f in (sin, cos) for a in (x, 2 * y, z, x + 2 * y, x + 2 * y - z, x - z, 2 * y - z, x + 2 * y + z)
    ]
    roots = list(map(bench.node, wanted))
    expand = expansion(bench.graph, roots)
    assert all(same(value(bench.back(expand(root))), value(e)) for root, e in zip(roots, wanted, strict=True))
    assert sines(bench.graph, list(map(expand, roots))) == 6


class Doubling(Rewriter):
    def replacement(self, node):
        kind, _ = self.graph.records[node]
        return self.graph.scale(node, Fraction(2)) if kind is Kind.SYMBOL else None


@given(EXPRESSIONS)
@SETTINGS
def test_rebuilding_with_replacements(expression):
    bench = Bench()
    doubled = Doubling(bench.graph)(bench.node(expression))
    right = expression.subs({symbol: 2 * symbol for symbol in SYMBOLS}, simultaneous=True)
    assert same(value(bench.back(doubled)), value(right), 1e-12)


def test_what_nothing_replaces_comes_back_as_it_was(bench):
    root = bench.node(sin(x + y) * exp(x) + tan(y))
    assert Substitution(bench.graph, {"z": bench.graph.zero})(root) == root
    assert Rewriter(bench.graph)(root) == root


def test_any_node_can_be_replaced(bench):
    inner, root = bench.node(sin(x + y)), bench.node(sin(x + y) * exp(x) + tan(y))
    assert bench.back(Rewriter(bench.graph, {inner: bench.node(y)})(root)) == y * exp(x) + tan(y)


@pytest.mark.parametrize("expression", [sin(x) + cos(x) * y, exp(x) * y + tan(x), sympy.cosh(x) * sympy.atan(x) + y])
def test_functions_of_zero_are_folded(bench, expression):
    at_zero = Substitution(bench.graph, {"x": bench.graph.zero})(bench.node(expression))
    assert bench.back(at_zero) == expression.subs(x, 0)


def test_many_shared_terms_stay_small():
    """Thirty doublings make 2^30 terms when written out, 30 nodes when shared."""
    bench = Bench()
    node = bench.node(x)
    for _ in range(30):
        node = bench.graph.add(bench.graph.call("sin", node), bench.graph.call("cos", node))
    assert len(bench.graph.reachable([node])) < 100
    assert len(schedule(bench.graph, [node]).operations) < 100


@pytest.mark.parametrize("nested", [sympy.Piecewise((x, sympy.Piecewise((y, x < z), (p, True)) < q), (z, True))])
def test_choices_within_conditions(bench, nested):
    """SymPy writes such conditions as if-then-else."""
    assert nested.atoms(sympy.ITE)
    assert same(value(bench.back(bench.node(nested))), value(nested))
