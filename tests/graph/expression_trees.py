"""Random expression trees, what they are in SymPy and in the graph, and what numbers a graph stands for."""

from __future__ import annotations

import random
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import mpmath
import sympy
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.graph.store import Kind, Node

from ..oracles.principal import Tree, number

VARYING, PARAMETERS = ("x", "y", "z"), ("p", "q")
EXPONENTS = (2, 2, 3, 4, -1, -1, -2, *(Fraction(k, 2) for k in (1, 1, 1, 1, -1, 3, -3)),
             *(Fraction(*e) for e in ((1, 3), (2, 3), (-1, 3), (1, 4), (3, 4))), 0.375, 0.625)  # fmt: skip
# all exact: SymPy rounds roots of doubles, and the sine of a large argument magnifies that beyond any tolerance
NUMBERS = (
    2,
    3,
    -1,
    -2,
    4,
    Fraction(3, 8),
    Fraction(-5, 4),
    Fraction(1, 2),
    Fraction(1, 3),
    Fraction(-2, 3),
    Fraction(9, 4),
    12,
    0,
)
SMOOTH = ("sin", "cos", "tan", "atan", "tanh", "asinh", "log", "exp")
BROKEN = ("abs", "abs", "sign", "floor", "step")


class Grower:
    """Grows trees; a subtree that stands already is used again now and then, as squares and shared terms ask for."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self._grown: list[Tree] = []

    def tree(self, depth: int) -> Tree:
        """Return a tree of at most this depth."""
        if self._grown and self.random.random() < 0.3:
            return self.random.choice(self._grown)
        grown = self._leaf() if depth == 0 or self.random.random() < 0.08 else self._inner(depth - 1)
        self._grown.append(grown)
        return grown

    def _leaf(self) -> Tree:
        if self.random.random() < 0.25:
            return "number", self.random.choice(NUMBERS)
        return "symbol", self.random.choice(VARYING + PARAMETERS)

    def _inner(self, depth: int) -> Tree:
        kind = self.random.choices(
            ("add", "mul", "power", "root", "smooth", "broken", "choice", "piecewise", "pow", "atan2"),
            (22, 22, 16, 16, 8, 8, 4, 4, 1, 1),
        )[0]
        if kind in ("add", "mul"):
            return kind, *(self.tree(depth) for _ in range(self.random.choice((2, 2, 3))))
        if kind == "power":
            return kind, self.tree(depth), self.random.choice(EXPONENTS)
        if kind == "root":  # of a square, of a sum of squares, or what takes it back
            return self._root(depth)
        if kind == "piecewise":
            otherwise = self.tree(depth) if self.random.random() < 0.8 else None
            relation = self.random.choice(("<", "<=", ">", ">="))
            return kind, relation, self.tree(depth), self.tree(0), self.tree(depth), otherwise
        if kind == "pow":
            return kind, self.tree(depth), ("sin", self.tree(0))
        if kind == "atan2":
            return kind, self.tree(depth), self.tree(depth)
        return self._function(kind, depth)

    def _root(self, depth: int) -> Tree:
        a, b = self.tree(depth), self.tree(depth)
        square, half = ("power", a, 2), Fraction(1, 2)
        return self.random.choice((
            ("power", square, half),
            ("power", ("add", square, ("power", b, 2)), half),
            ("mul", ("power", ("add", ("number", 2), ("mul", ("number", 2), a)), half), b),
            ("mul", ("power", a, half), ("power", a, half), b),
            ("power", ("mul", ("power", a, half), b), 2),
            ("mul", ("power", ("mul", ("number", 4), a), half), ("power", ("mul", ("number", 4), a), half)),
        ))  # fmt: skip

    def _function(self, kind: str, depth: int) -> Tree:
        if kind == "choice":
            return self.random.choice(("min", "max")), self.tree(depth), self.tree(depth)
        name = self.random.choice(SMOOTH if kind == "smooth" else BROKEN)
        argument = self.tree(depth)
        return name, ("sin", argument) if name == "exp" else argument

    def point(self) -> dict[str, float]:
        """Return values of both signs, about 1 or from 1e-3 to 1e3; p is positive."""
        far = self.random.random() < 0.5
        sizes = (10 ** self.random.uniform(-3, 3) if far else self.random.uniform(0.4, 1.9) for _ in range(5))
        signed = [size * self.random.choice((-1, 1)) for size in sizes]
        return dict(zip((*VARYING, *PARAMETERS), signed, strict=True)) | {"p": abs(signed[3])}


def symbols_of(real: bool) -> dict[str, sympy.Symbol]:
    """Name -> symbol: p is declared positive, the others are real or nothing."""
    given = {"real": True} if real else {}
    return {name: sympy.Symbol(name, **given) for name in (*VARYING, "q")} | {"p": sympy.Symbol("p", positive=True)}


SYMPY: Mapping[str, Any] = {
    "add": sympy.Add, "mul": sympy.Mul, "atan2": sympy.atan2, "abs": sympy.Abs, "log": sympy.log, "pow": sympy.Pow,
    "min": sympy.Min, "max": sympy.Max, "sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "atan": sympy.atan,
    "tanh": sympy.tanh, "exp": sympy.exp, "asinh": sympy.asinh, "sign": sympy.sign, "floor": sympy.floor,
    "step": sympy.Heaviside,
}  # fmt: skip
RELATIONS = {"<": sympy.Lt, "<=": sympy.Le, ">": sympy.Gt, ">=": sympy.Ge}


def sympy_of(tree: Tree, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
    """Return what a user gets who writes the tree in SymPy, which rewrites it as it likes."""
    name, *operands = tree
    if name == "number":
        return _sympy_number(operands[0])
    if name == "symbol":
        return symbols[operands[0]]
    if name == "power":
        return sympy.Pow(sympy_of(operands[0], symbols), _sympy_number(operands[1]))
    if name == "piecewise":
        relation, left, right, then, otherwise = operands
        condition = RELATIONS[relation](sympy_of(left, symbols), sympy_of(right, symbols))
        last = [] if otherwise is None else [(sympy_of(otherwise, symbols), True)]
        return sympy.Piecewise((sympy_of(then, symbols), condition), *last)
    return SYMPY[name](*(sympy_of(operand, symbols) for operand in operands))


def _sympy_number(value: Any) -> sympy.Number:
    return sympy.Float(value) if isinstance(value, float) else sympy.Rational(value.numerator, value.denominator)


def node_of(tree: Tree, graph: Graph) -> Node:
    """Return the tree put into the graph directly: no rewriting of SymPy's stands between."""
    name, *operands = tree
    if name == "number":
        return graph.number(operands[0])
    if name == "symbol":
        return graph.symbol(operands[0])
    if name == "power":
        return graph.power(node_of(operands[0], graph), operands[1])
    if name == "piecewise":
        relation, left, right, then, otherwise = operands
        condition = graph.call(relation, node_of(left, graph), node_of(right, graph))
        rest = graph.number(float("nan")) if otherwise is None else node_of(otherwise, graph)
        return graph.call("select", condition, node_of(then, graph), rest)
    nodes = [node_of(operand, graph) for operand in operands]
    return {"add": graph.add, "mul": graph.mul}[name](*nodes) if name in ("add", "mul") else graph.call(name, *nodes)


# --- what a graph stands for ------------------------------------------------------------------------------------------

NAN = mpmath.mpf("nan")


class Meaning:
    """Values of nodes in mpmath's real numbers as C computes them: what is not real is not a number."""

    def __init__(self, graph: Graph, point: Mapping[str, float]) -> None:
        self.graph, self._point = graph, point
        self._known: dict[Node, Any] = {}

    def __call__(self, root: Node) -> Any:
        for node in self.graph.reachable([root]):
            if node not in self._known:
                try:
                    self._known[node] = self._value(node)
                except (ZeroDivisionError, ValueError, OverflowError):
                    self._known[node] = NAN
        return self._known[root]

    def _value(self, node: Node) -> Any:
        kind, operands = self.graph.records[node]
        known = self._known
        if kind is Kind.NUMBER:
            return number(operands[0])
        if kind is Kind.SYMBOL:
            return mpmath.mpf(self._point[operands[0]])
        if kind is Kind.SUM:
            return mpmath.fsum(number(factor) * known[child] for child, factor in operands)
        if kind is Kind.PRODUCT:
            return mpmath.fprod(_real_power(known[child], number(power)) for child, power in operands)
        return CALLS[operands[0]](*(known[child] for child in operands[1:]))


def _real_power(base: Any, exponent: Any) -> Any:
    if exponent == int(exponent):
        return base ** int(exponent)
    return base**exponent if base > 0 else mpmath.mpf(0) if base == 0 and exponent > 0 else NAN


def _real(f: Any) -> Any:
    return lambda a: NAN if mpmath.isnan(a) else f(a)


CALLS: Mapping[str, Any] = {
    "select": lambda c, a, b: a if c else b, "<": lambda a, b: a < b, "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b, ">=": lambda a, b: a >= b, "==": lambda a, b: a == b, "!=": lambda a, b: a != b,
    "and": lambda a, b: bool(a) and bool(b), "or": lambda a, b: bool(a) or bool(b), "not": lambda a: not a,
    "min": lambda a, b: NAN if mpmath.isnan(a) or mpmath.isnan(b) else min(a, b),
    "max": lambda a, b: NAN if mpmath.isnan(a) or mpmath.isnan(b) else max(a, b),
    "log": lambda a: mpmath.log(a) if a > 0 else NAN, "pow": _real_power, "atan2": mpmath.atan2,
    "step": _real(lambda a: mpmath.mpf(a > 0) if a else mpmath.mpf(0.5)), "abs": abs,
    **{name: _real(getattr(mpmath, name)) for name in ("sin", "cos", "tan", "atan", "tanh", "exp", "asinh", "sign",
                                                       "floor", "sinh", "cosh")},
}  # fmt: skip
