"""Checks of one random tree: values and derivatives kept on every way, canonical nodes, zeros that are zero.

Right is the tree itself in complex numbers (`oracles.principal`), which neither SymPy nor the graph has rewritten.
Where everything on the way is real, the graph must give that number. Where it is not, C may give no number, or the one
that comes out in the end; never another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction

import mpmath
import sympy
from eigenmotion.codegen.calculus.derivatives import Tangent, gradient
from eigenmotion.codegen.calculus.identity_test import Zeros
from eigenmotion.codegen.graph.convert import FromSympy, ToSympy
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.graph.store import Kind, Node
from eigenmotion.codegen.model import ModelError
from eigenmotion.codegen.model.normalise import expression

from ..oracles.principal import Dual, Tree, Undefined, dual
from .expression_trees import PARAMETERS, VARYING, Grower, Meaning, node_of, symbols_of, sympy_of

DIGITS, NOISE = 50, 1e-11
"""pi and the like are doubles in the graph, so that numbers agree to NOISE of the largest on the way only."""
POINTS = 6
PLAIN = symbols_of(real=False) | {"p": sympy.Symbol("p", positive=True)}


@dataclass
class Counts:
    """What came of some trees."""

    trees: int = 0
    refused: int = 0
    values: int = 0
    unreal: int = 0
    zeros: int = 0
    wrong: list[str] = field(default_factory=list)


class Case:
    """One tree, its nodes by every way into a graph, and points."""

    def __init__(self, seed: int, depth: int = 4) -> None:
        self.seed, self.grower = seed, Grower(seed)
        self.tree = self.grower.tree(depth)
        self.points = [self.grower.point() for _ in range(POINTS)]
        self.direction = self.grower.random.choice(VARYING)
        self.graph = Graph(PARAMETERS)
        symbols = symbols_of(real=seed % 2 == 0)
        self.nodes = {"direct": node_of(self.tree, self.graph)}
        self.nodes["sympy"] = FromSympy(self.graph)(expression(sympy_of(self.tree, symbols), f"tree {seed}"))
        self.nodes |= {f"{way} and back": self._again(node) for way, node in list(self.nodes.items())}

    def _again(self, node: Node) -> Node:
        return FromSympy(self.graph)(ToSympy(self.graph, PLAIN)(node))

    def slopes(self) -> Iterator[tuple[str, Node]]:
        """Give the derivative of each node, forward and reverse."""
        for way, node in self.nodes.items():
            yield f"{way}, forward", Tangent(self.graph, {self.direction: self.graph.one})(node)
            yield f"{way}, reverse", gradient(self.graph, node, [self.direction])[0]


def check(seed: int, counts: Counts) -> Case | None:
    """Judge the tree of one seed; return its case unless SymPy or the model refuses the tree."""
    try:
        case = Case(seed)
    except (ModelError, TypeError, ZeroDivisionError, OverflowError, ValueError, NotImplementedError):
        counts.refused += 1  # infinite or not real whatever the symbols are, which SymPy or the model says
        return None
    counts.trees += 1
    with mpmath.workdps(DIGITS):
        slopes = list(case.slopes())
        for point in case.points:
            _compare(case, point, slopes, counts)
        counts.wrong.extend(f"tree {seed}: {fault}" for fault in unclean(case.graph))
    return case


def _compare(case: Case, point: dict[str, float], slopes: list[tuple[str, Node]], counts: Counts) -> None:
    try:
        right = dual(case.tree, point, case.direction)
    except Undefined:
        return
    meaning = Meaning(case.graph, point)
    pairs = [(way, node, right.value) for way, node in case.nodes.items()]
    pairs += [(way, node, right.slope) for way, node in slopes]
    for way, node, wanted in pairs:
        counts.values += 1
        counts.unreal += not right.real
        found = meaning(node)
        if not agrees(found, wanted, right.real):
            counts.wrong.append(f"tree {case.seed}, {way} at {point}: {found} for {wanted}: {case.tree}")
            return


def agrees(found: object, wanted: mpmath.mpc, real: bool) -> bool:
    """Whether a number is the right one, or none where real arithmetic can not follow."""
    if mpmath.isnan(found):
        return not real
    return bool(abs(found - wanted) <= NOISE * abs(wanted) + mpmath.mpf(10) ** -25)


# --- canonical form ---------------------------------------------------------------------------------------------------


def unclean(graph: Graph) -> Iterator[str]:
    """Give what is not as the graph's docstring promises."""
    for node, (kind, operands) in enumerate(list(graph.records)):
        if kind in (Kind.SUM, Kind.PRODUCT):
            nodes = [child for child, _ in operands]
            faults = _sum_faults if kind is Kind.SUM else _product_faults
            made_anew = graph.sum(operands) if kind is Kind.SUM else graph.product(operands)
            conditions = {"operands are sorted, none twice": nodes == sorted(set(nodes)),
                          "operands come first": max(nodes) < node, "made anew it is itself": made_anew == node,
                          "no number is zero": all(value != 0 for _, value in operands)}  # fmt: skip
            conditions |= faults(graph, operands)
            yield from (f"{kind.value} {operands}: not so: {what}" for what, holds in conditions.items() if not holds)


def _sum_faults(graph: Graph, terms: tuple[tuple[Node, object], ...]) -> dict[str, bool]:
    numbers = [
        graph.records[child].kind is Kind.NUMBER and (child != graph.one or len(terms) == 1) for child, _ in terms
    ]
    return {"no term is a number but 1": not any(numbers),
            "no term is scaled": not any(scaled(graph, child) for child, _ in terms),
            "a coefficient other than 1": len(terms) > 1 or terms[0][1] != 1,
            "the first coefficient is positive": len(terms) == 1 or terms[0][1] > 0}  # fmt: skip


def _product_faults(graph: Graph, factors: tuple[tuple[Node, object], ...]) -> dict[str, bool]:
    whole = [graph.records[child].kind for child, power in factors if power == int(power)]
    opened = [child for child, power in factors if power == int(power) and scaled(graph, child)]
    return {"no factor comes apart": not opened and not {Kind.NUMBER, Kind.PRODUCT} & set(whole),
            "more than one factor, or a power": len(factors) > 1 or factors[0][1] != 1}  # fmt: skip


def scaled(graph: Graph, node: Node) -> bool:
    kind, operands = graph.records[node]
    return kind is Kind.SUM and len(operands) == 1


# --- zeros ------------------------------------------------------------------------------------------------------------


def _number(value: Fraction | int) -> Tree:
    return "number", value


def _times(*factors: Tree) -> Tree:
    return "mul", *factors


def _less(a: Tree, b: Tree) -> Tree:
    return "add", a, _times(_number(-1), b)


def _square(a: Tree) -> Tree:
    return "power", a, 2


def _root(a: Tree, degree: int = 2) -> Tree:
    return "power", a, Fraction(1, degree)


def _sine(a: Tree) -> Tree:
    return "sin", a


def _cosine(a: Tree) -> Tree:
    return "cos", a


PARTLY_ZERO: tuple[Callable[[Tree, Tree], Tree], ...] = (
    lambda a, b: _less(("abs", a), a),
    lambda a, b: _less(_root(_square(a)), a),
    lambda a, b: _less(_times(_root(_square(a)), ("power", a, -1)), _number(1)),
    lambda a, b: ("add", _root(_square(_less(a, _number(3)))), a, _number(-3)),
    lambda a, b: _less(_root(_square(_less(a, b))), _less(a, b)),
    lambda a, b: _less(("max", a, b), a),
    lambda a, b: _less(("max", a, b), b),
    lambda a, b: _less(_root(("power", a, 3), 3), a),
    lambda a, b: ("floor", _times(a, _number(Fraction(1, 7)))),
    lambda a, b: ("step", _less(a, _number(2))),
    lambda a, b: _less(("sign", a), _number(1)),
    lambda a, b: _less(_root(_times(_square(a), _square(b))), _times(a, b)),
    lambda a, b: _less(("sign", _times(a, b)), _times(("sign", a), ("sign", b))),
    lambda a, b: _times(("add", a, ("abs", a)), _less(("abs", b), b)),
    lambda a, b: _less(
        _root(("add", _number(2), _times(_number(2), _cosine(a)))),
        _times(_number(2), _cosine(_times(a, _number(Fraction(1, 2))))),
    ),
    lambda a, b: ("piecewise", "<", a, _number(5), _number(0), b),
)  # fmt: skip
"""Zero for some signs or sizes of a and b, not for others."""
WHOLLY_ZERO: tuple[Callable[[Tree, Tree], Tree], ...] = (
    lambda a, b: _less(_sine(_times(_number(2), a)), _times(_number(2), _sine(a), _cosine(a))),
    lambda a, b: _less(_square(("add", a, b)), ("add", _square(a), _times(_number(2), a, b), _square(b))),
    lambda a, b: _less(_square(("abs", a)), _square(a)),
    lambda a, b: _less(("power", _square(a), Fraction(3, 2)), _times(_square(a), _root(_square(a)))),
    lambda a, b: _less(_cosine(("add", a, b)), _less(_times(_cosine(a), _cosine(b)), _times(_sine(a), _sine(b)))),
    lambda a, b: _less(_times(("sign", a), ("abs", a)), a),
)


def check_zeros(seed: int, counts: Counts) -> None:
    """What counts as zero is zero at points of every sign and size; what is zero of itself is seen."""
    grower = Grower(seed)
    a, b, c = (grower.tree(depth) for depth in (1, 1, 2))
    a, b = (("symbol", name) if tree[0] == "number" else tree for name, tree in (("x", a), ("y", b)))
    for k, form in enumerate((*PARTLY_ZERO, *WHOLLY_ZERO)):
        graph, tree = Graph(PARAMETERS), _times(form(a, b), c)
        try:
            zero = Zeros(graph, {"p": 1})(node_of(tree, graph))
        except (ZeroDivisionError, OverflowError):
            continue
        counts.zeros += 1
        if zero:
            with mpmath.workdps(4 * DIGITS):
                values = [_value(tree, grower.point()) for _ in range(30)]
            if any(abs(value) > mpmath.mpf(10) ** -DIGITS for value in values if value is not None):
                counts.wrong.append(f"zero {seed}: called zero, but takes {values}: {tree}")
        simple = a[0] == b[0] == "symbol" and k >= len(PARTLY_ZERO) and c[0] == "symbol"
        if simple and not zero:
            counts.wrong.append(f"zero {seed}: not seen to be zero: {tree}")


def _value(tree: Tree, point: dict[str, float]) -> mpmath.mpc | None:
    """Return the value of a tree where it is real all the way, else nothing."""
    try:
        found: Dual = dual(tree, point)
    except Undefined:
        return None
    return found.value if found.real else None
