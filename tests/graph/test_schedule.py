"""The operations chosen for expressions: same values, nothing twice, parameters taken out, honest counts."""

import math
from collections.abc import Mapping
from fractions import Fraction

import pytest
from eigenmotion.codegen.equations.derive import derive
from eigenmotion.codegen.equations.specialise import specialise
from eigenmotion.codegen.equations.terms import Terms
from eigenmotion.codegen.equations.tree.tree_terms import terms_of
from eigenmotion.codegen.graph.convert import FromSympy
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.graph.store import Kind
from eigenmotion.codegen.model.statement.states import as_mechanism
from eigenmotion.codegen.schedule.operations import Cost, operands_of
from eigenmotion.codegen.schedule.schedule import schedule
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Integer, Max, Piecewise, Rational, cos, exp, sin, sqrt, symbols

from eigenmotion import load_model

from ..support.generation import MODELS, NAMES, model_of

SYMBOLS = x, y, z, p, q = symbols("x y z p q", positive=True)
VALUES = {"x": 0.71, "y": 1.13, "z": 1.62, "p": 0.87, "q": 1.41}
CALLS = {"sin": math.sin, "cos": math.cos, "exp": math.exp, "pow": math.pow, "max": max, "<": float.__lt__,
         "select": lambda condition, yes, no: yes if condition else no, "log": math.log, "tan": math.tan,
         "min": min, "abs": abs, "tanh": math.tanh}  # fmt: skip


def run(plan, values: Mapping[str, float], constants: Mapping[int, float], calls=CALLS) -> dict[int, float]:
    """Carry out operations in their order; an operand that is not there yet is a KeyError."""
    done: dict[int, float] = {}
    for value, (kind, operands) in plan.operations.items():
        if kind == "number":
            done[value] = float(operands[0])
        elif kind == "leaf":
            done[value] = values[operands[0]]
        elif kind == "constant":
            done[value] = constants[operands[0]]
        elif kind == "add":
            done[value] = math.fsum(float(factor) * done[term] for term, factor in operands)
        elif kind == "mul":
            done[value] = math.prod(done[operand] for operand in operands)
        elif kind in ("inverse", "sqrt"):
            done[value] = 1 / done[operands[0]] if kind == "inverse" else math.sqrt(done[operands[0]])
        else:
            done[value] = calls[operands[0]](*(done[operand] for operand in operands[1:]))
    return done


class Bench:
    def __init__(self, parameters="pq"):
        self.graph = Graph(parameters)
        self.node = FromSympy(self.graph)

    def values(self, expressions, hoist=True):
        """Return the schedule and the numbers of some expressions by way of it."""
        roots = [self.node(Integer(1) * expression) for expression in expressions]
        plan = schedule(self.graph, roots, hoist=hoist)
        constants = {}
        if hoist:
            wanted = [op.operands[0] for op in plan.operations.values() if op.kind == "constant"]
            inner = schedule(self.graph, wanted, hoist=False)
            found = run(inner, VALUES, {})
            constants = {node: found[inner.roots[node]] for node in wanted}
        found = run(plan, VALUES, constants)
        return plan, [found[plan.roots[root]] for root in roots]


def combined(inner):
    one = st.sampled_from([sin, cos, lambda a: exp(-a * a / 50), lambda a: sqrt(a * a + 1), lambda a: 1 / (a * a + 2)])
    two = st.sampled_from([
        lambda a, b: a + b, lambda a, b: a * b, lambda a, b: a - 3 * b, lambda a, b: a**3 * b,
        lambda a, b: a * (b * b + 1) ** Rational(-3, 2), lambda a, b: Piecewise((a, x < y), (b, True)),
    ])  # fmt: skip
    return st.one_of(st.builds(lambda f, a: f(a), one, inner), st.builds(lambda f, a, b: f(a, b), two, inner, inner))


LEAVES = st.sampled_from([*SYMBOLS, Max(x, y), p * x, p + q, Integer(2), Rational(-1, 3), x - y])
EXPRESSIONS = st.recursive(LEAVES, combined, max_leaves=8)


@given(st.lists(EXPRESSIONS, min_size=1, max_size=5), st.booleans())
@settings(max_examples=120, deadline=None, derandomize=True)
def test_operations_give_the_values_of_the_expressions(expressions, hoist):
    _, found = Bench().values(expressions, hoist)
    for value, expression in zip(found, expressions, strict=True):
        right = float((Integer(1) * expression).subs({symbol: VALUES[symbol.name] for symbol in SYMBOLS}).evalf(30))
        assert math.isclose(value, right, rel_tol=1e-11, abs_tol=1e-11), expression


@st.composite
def nested_sums(draw):
    """Return a graph of sums of earlier nodes, of which one may be an operand beside its own operands; and the sums."""
    graph = Graph()
    nodes = leaves = [graph.symbol(name) for name in "xyz"]
    for _ in range(draw(st.integers(3, 6))):
        terms = draw(
            st.lists(st.tuples(st.sampled_from(nodes), st.sampled_from([1, 1, 1, -1, 2])), min_size=2, max_size=5)
        )
        nodes = [*nodes, graph.sum(terms)]
    return graph, [node for node in nodes if node not in leaves]


@given(nested_sums())
@settings(max_examples=400, deadline=None, derandomize=True)
def test_sums_that_contain_the_sum_of_their_own_operands_keep_their_values(made):
    """A pair of operands was replaced by a value that the sum had already, and one of the two was lost."""
    graph, roots = made
    plan = schedule(graph, roots)
    found, direct = run(plan, VALUES, {}), node_by_node(graph, roots, VALUES, CALLS)
    for root in roots:
        assert math.isclose(found[plan.roots[root]], direct[root][0], rel_tol=1e-11, abs_tol=1e-13 * direct[root][1])


@given(st.lists(EXPRESSIONS, min_size=1, max_size=5))
@settings(max_examples=60, deadline=None, derandomize=True)
def test_no_operation_stands_twice_and_none_is_idle(expressions):
    plan, _ = Bench().values(expressions)
    operations = [op for op in plan.operations.values() if op.kind in ("mul", "add", "call")]
    assert len(set(operations)) == len(operations)
    used = {operand for op in plan.operations.values() for operand in operands_of(op)} | set(plan.roots.values())
    assert used == set(plan.operations)
    assert all(plan.uses[value] > 0 for value in plan.operations)


def test_what_is_made_of_parameters_is_computed_once():
    plan, _ = Bench().values([(p**2 + sqrt(q)) * x + sin(p) / q])
    counts = dict(zip(("add", "multiply", "divide", "root", "call"), plan.cost.counts(), strict=True))
    assert counts == {"add": 1, "multiply": 1, "divide": 0, "root": 0, "call": 0}
    assert sorted(op.kind for op in plan.operations.values()) == ["add", "constant", "constant", "leaf", "mul"]


def test_without_hoisting_everything_is_computed():
    plan, _ = Bench().values([(p**2 + sqrt(q)) * x], hoist=False)
    assert not any(op.kind == "constant" for op in plan.operations.values())
    assert plan.cost.counts() == (1, 2, 0, 1, 0)


@pytest.mark.parametrize(
    ("expression", "counts"),
    [
        (x**2, (0, 1, 0, 0, 0)),
        (x**8, (0, 3, 0, 0, 0)),
        (x**7, (0, 4, 0, 0, 0)),
        (1 / x, (0, 0, 1, 0, 0)),
        (x ** Rational(-3, 2), (0, 1, 1, 1, 0)),
        (x ** Rational(1, 3), (0, 0, 0, 0, 1)),
        (p * x + p * y, (1, 1, 0, 0, 0)),
        (x * y * z + x * y, (1, 2, 0, 0, 0)),
        (sin(x + y) + (x + y) ** 2, (2, 1, 0, 0, 1)),
        (3 * p * x, (0, 1, 0, 0, 0)),
        (p * x - p * x, (0, 0, 0, 0, 0)),
    ],
)
def test_costs(expression, counts):
    plan, _ = Bench().values([expression])
    assert plan.cost.counts() == counts


def test_costs_add_up():
    total = Cost(1, 2, 3, 4, 5) + Cost(1, 1, 1, 1, 1)
    assert total.counts() == (2, 3, 4, 5, 6)
    assert total.weight == 2 + 3 + 4 * 4 + 5 * 5 + 15 * 6


def test_pairs_shared_by_many_products_are_taken_out():
    plan, _ = Bench().values([x * y * z, x * y * sin(z), x * y * cos(z)])
    assert plan.cost.multiply == 4


def test_pairs_shared_by_sums_up_to_a_factor_are_taken_out():
    plan, _ = Bench().values([sin(x + 2 * y), z + x + 2 * y, cos(z - x - 2 * y)])
    assert plan.cost.add == 3


@pytest.mark.parametrize("factor", [5.5, 3.5, -3.5])
def test_a_pair_that_is_an_operand_of_its_sum_too_is_added_to_it(factor):
    """3.5 a - 3.5 b + k (a - b) + z, beside a - b: humanoids had such a sum, with one factor for both."""
    bench = Bench()
    a, b, c = (bench.node(one) for one in (sin(x), sin(y), sin(z)))
    apart = bench.graph.sum([(a, 1.0), (b, -1.0)])
    roots = [bench.graph.sum([(a, 3.5), (b, -3.5), (apart, factor), (one, 1)]) for one in (c, bench.node(cos(x)))]
    plan = schedule(bench.graph, [*roots, bench.graph.call("cos", apart)])
    found = run(plan, VALUES, {})
    for root, other in zip(roots, (math.sin(VALUES["z"]), math.cos(VALUES["x"])), strict=True):
        right = (3.5 + factor) * (math.sin(VALUES["x"]) - math.sin(VALUES["y"])) + other
        assert math.isclose(found[plan.roots[root]], right, rel_tol=1e-14)


@pytest.mark.parametrize("name", NAMES)
def test_the_terms_of_every_model_keep_their_values(name):
    """The force, Mdot, M of a model: by way of the operations chosen, against the graph evaluated node by node."""
    model = as_mechanism(model_of(name))
    terms = terms_of(specialise(derive(model)))
    calls = CALLS | calls_of(model_of(name).tables)
    roots = [*terms.motion.force, *terms.bias, *(e for row in terms.motion.Mdot for e in row), *terms.gamma]
    roots += [e for row in terms.M for e in row]
    roots = list(map(terms.expanded, roots))
    m = terms.mechanics
    names = [s.name for s in (*m.x, *m.v, *m.parameters, *m.inputs)]
    values = {name: 0.4 + 0.13 * (k % 9) for k, name in enumerate([*names, "t"])}
    direct = node_by_node(terms.graph, roots, values, calls)
    plan = schedule(terms.graph, roots, hoist=False)
    found = run(plan, values, {}, calls)
    for root in roots:
        assert math.isclose(found[plan.roots[root]], direct[root][0], rel_tol=1e-11, abs_tol=1e-12 * direct[root][1])


def calls_of(tables):
    """Return the name of each table, and of its derivatives, -> their values; the first operand is the handle."""
    return {
        f"{table.name}[{order}]": lambda _, at, table=table, order=order: float(table.pieces.value((order,), [at]))
        for table in tables
        for order in range(4)
    }


def node_by_node(graph, roots, values, calls):
    """Return node -> (value, sum of the absolute terms behind it)."""
    known: dict[int, tuple[float, float]] = {}
    for node in graph.reachable(roots):
        kind, operands = graph.records[node]
        if kind in (Kind.NUMBER, Kind.SYMBOL):
            number = float(operands[0]) if kind is Kind.NUMBER else values[operands[0]]
            known[node] = number, abs(number)
        elif kind is Kind.SUM:
            terms = [
                (float(factor) * known[child][0], float(abs(factor)) * known[child][1]) for child, factor in operands
            ]
            known[node] = math.fsum(a for a, _ in terms), math.fsum(b for _, b in terms)
        elif kind is Kind.PRODUCT:
            powers = [(known[child], float(power)) for child, power in operands]
            number = math.prod(a**power for (a, _), power in powers)
            sizes = [b**power if power > 0 else abs(a) ** power * max(1, b / abs(a)) for (a, b), power in powers]
            known[node] = number, math.prod(sizes)
        else:
            number = calls[operands[0]](*(known[child][0] for child in operands[1:]))
            known[node] = number, abs(number)
    return known


@pytest.fixture(scope="module")
def work_per_pair():
    """Operations of M, Mdot and forces of the chain, by n (n + 1) / 2, for n = 5, 10, 20."""
    work = {}
    for n in (5, 10, 20):
        terms = Terms(specialise(derive(load_model(MODELS / "chain.py", n=n))))
        roots = [*terms.motion.force, *(e for k, row in enumerate(terms.motion.Mdot) for e in row[: k + 1])]
        roots += [e for k, row in enumerate(terms.M) for e in row[: k + 1]]
        cost = schedule(terms.graph, list(map(terms.expanded, roots))).cost
        work[n] = cost.weight / (n * (n + 1) / 2)
    return work


def test_work_per_pair_of_coordinates_does_not_grow(work_per_pair):
    assert work_per_pair[10] <= work_per_pair[5]
    assert work_per_pair[20] <= work_per_pair[10]


def test_numbers_of_one_value_are_one_constant():
    graph = Graph()
    assert graph.number(Fraction(1, 2)) != graph.number(0.1)
    assert graph.number(2.0) == graph.number(Fraction(2))
