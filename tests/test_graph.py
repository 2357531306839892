"""The graph: canonical forms, derivatives, identities of sines, what is zero, rebuilding."""

from fractions import Fraction

import mpmath
import pytest
import sympy
from eigenmotion.codegen.graph.convert import FromSympy, ToSympy
from eigenmotion.codegen.graph.derivatives import Tangent, gradient
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.graph.rewrite import Rewriter, Substitution
from eigenmotion.codegen.graph.schedule import schedule
from eigenmotion.codegen.graph.store import Kind
from eigenmotion.codegen.graph.trigonometry import expansion
from eigenmotion.codegen.graph.zeros import Zeros
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational, cos, exp, log, sin, sqrt, symbols, tan

from .tree_checks import unclean
from .trees import Meaning

SYMBOLS = x, y, z, p, q = symbols("x y z p q", positive=True)
u, w = symbols("u w")
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


@pytest.fixture
def bench():
    return Bench()


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


# --- what is zero -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "zero",
    [
        sympy.Add(sin(2 * x), -2 * sin(x) * cos(x)),
        sympy.Add(cos(x + y), -cos(x) * cos(y), sin(x) * sin(y)),
        (x + y) ** 2 - x**2 - 2 * x * y - y**2,
        sqrt(x**2 + 2 * x * y + y**2) ** 3 - (x + y) ** 2 * sqrt(x**2 + 2 * x * y + y**2),
        p * (x * y + x * z) / x - p * y - p * z,
    ],
)
def test_what_vanishes_is_seen(bench, zero):
    assert Zeros(bench.graph)(bench.node(zero))


@pytest.mark.parametrize(
    "alive",
    [
        sympy.Float(1e-30) * x,
        1 + sympy.Float(1e-9) * sin(x) - cos(y) ** 2 - sin(y) ** 2,
        sqrt(x**2 + 2 * x * y + y**2) - x - y,
        sympy.Max(0, x - 3),
        sympy.Piecewise((x, x > 5), (0, True)),
        sympy.Heaviside(x - 2),
        exp(-1000 * x),
        1 - sympy.tanh(50 * (x - 5)) ** 2,
        sin(x) - x + x**3 / 6,
    ],
)
def test_what_only_seems_to_vanish_is_kept(bench, alive):
    """Also what is zero, or below rounding, in one part of space only."""
    assert not Zeros(bench.graph)(bench.node(alive))


def test_undefined_is_not_zero(bench):
    assert not Zeros(bench.graph)(bench.node(sympy.acosh(x - 9)))


@pytest.mark.parametrize(
    "alive",
    [
        sqrt(u**2) - u,
        sqrt(u**2) / u - 1,
        1 + sqrt((u - 3) ** 2) / (u - 3),
        sqrt((u - 1000) ** 2) + u - 1000,
        (u**3) ** Rational(1, 3) - u,
        sqrt(u * w) - sqrt(u) * sqrt(w),
        sqrt(u**2 * w**2) - u * w,
        sqrt(2 + 2 * cos(u)) - 2 * cos(u / 2),
        (sqrt(u**2) + u) * (sqrt(w**2) - w),
        sympy.asin(sin(u)) - u,
        sympy.atan(tan(u)) - u,
        sympy.atan(u) + sympy.atan(1 / u) - sympy.pi.evalf() / 2,
        log(u**2) - 2 * log(u),
    ],
)
def test_what_vanishes_for_some_signs_only_is_kept(bench, alive):
    assert not Zeros(bench.graph)(bench.node(alive))


def test_parameters_declared_positive_count_as_such(bench):
    root = bench.node(sqrt(u * w**2) - sqrt(u) * w)
    assert not Zeros(bench.graph)(root)
    assert not Zeros(bench.graph, {"u": 1})(root)
    assert Zeros(bench.graph, {"u": 1, "w": 1})(root)


# --- sums of angles ---------------------------------------------------------------------------------------------------


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


# --- rebuilding -------------------------------------------------------------------------------------------------------


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
    with pytest.raises(NotImplementedError):
        Rewriter(bench.graph)(root)


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
