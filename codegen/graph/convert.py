"""Conversion between SymPy expressions and the expression graph."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import sympy
from sympy.functions.elementary.piecewise import ExprCondPair, Piecewise
from sympy.logic.boolalg import ITE, And, Boolean, BooleanFalse, BooleanTrue, Not, Or

from ..model.model import ModelError
from ..model.table import TableCall
from ..model.tree.functions import BodyFunction
from .coefficients import Number, exact
from .graph import Graph
from .node_reference import NodeReference, from_number
from .store import Kind, Node
from .table_calls import name_of_call, orders_of, table_of

FUNCTIONS: dict[type[sympy.Basic], str] = {
    sympy.sin: "sin", sympy.cos: "cos", sympy.tan: "tan", sympy.asin: "asin", sympy.acos: "acos", sympy.atan: "atan",
    sympy.atan2: "atan2", sympy.sinh: "sinh", sympy.cosh: "cosh", sympy.tanh: "tanh", sympy.asinh: "asinh",
    sympy.acosh: "acosh", sympy.atanh: "atanh", sympy.exp: "exp", sympy.log: "log", sympy.Abs: "abs",
    sympy.sign: "sign", sympy.Min: "min", sympy.Max: "max", sympy.erf: "erf", sympy.floor: "floor",
    sympy.ceiling: "ceil", sympy.Heaviside: "step",
}  # fmt: skip
RELATIONS: dict[type[sympy.Basic], str] = {
    sympy.StrictLessThan: "<", sympy.LessThan: "<=", sympy.StrictGreaterThan: ">", sympy.GreaterThan: ">=",
    sympy.Equality: "==", sympy.Unequality: "!=", And: "and", Or: "or", Not: "not",
}  # fmt: skip
BACK: Mapping[str, type[sympy.Basic]] = {name: function for function, name in (FUNCTIONS | RELATIONS).items()}
SPLIT_IN_TWO = {"min", "max"}


class FromSympy:
    """Converts SymPy expressions in plain symbols to nodes of a graph; references to nodes must be to its own.

    Parameters
    ----------
    bodies
        Writes a function of bodies as a node, from the nodes of its arguments.
    """

    def __init__(self, graph: Graph, bodies: Callable[[BodyFunction, Sequence[Node]], Node] | None = None) -> None:
        self.graph, self._bodies = graph, bodies
        self._known: dict[sympy.Basic, Node] = {}

    def __call__(self, expression: sympy.Basic) -> Node:
        """Return the node of an expression.

        Raises
        ------
        ModelError
            A function has no counterpart in C; names it.
        """
        waiting = [expression]
        while waiting:  # an explicit stack: expressions may be nested deeper than the recursion limit
            part = waiting[-1]
            missing = [] if part in self._known else [inner for inner in _operands(part) if inner not in self._known]
            waiting += reversed(missing)
            if not missing:
                waiting.pop()
                if part not in self._known:
                    self._known[part] = self._convert(part)
        return self._known[expression]

    def _convert(self, expression: sympy.Basic) -> Node:
        graph = self.graph
        if isinstance(expression, sympy.Symbol):
            return graph.symbol(expression.name)
        if isinstance(expression, sympy.Number | sympy.NumberSymbol):
            return graph.number(_number(expression))
        if isinstance(expression, sympy.Add):
            return graph.add(*map(self, expression.args))
        if isinstance(expression, sympy.Mul):
            return graph.mul(*map(self, expression.args))
        if isinstance(expression, sympy.Pow):
            return self._power(*expression.args)
        return self._given(expression)

    def _power(self, base: sympy.Basic, exponent: sympy.Basic) -> Node:
        if base == sympy.E:
            return self.graph.call("exp", self(exponent))
        if isinstance(exponent, sympy.Number):
            return self.graph.power(self(base), _number(exponent))
        return self.graph.call("pow", self(base), self(exponent))

    def _given(self, expression: sympy.Basic) -> Node:
        """Convert a function that something else than SymPy defines: a table, bodies, a node."""
        if isinstance(expression, TableCall):
            return self._table(expression)
        if isinstance(expression, NodeReference):
            return expression.node
        if isinstance(expression, BodyFunction) and self._bodies:
            return self._bodies(expression, [self(argument) for argument in expression.args])
        return self._function(expression)

    def _function(self, expression: sympy.Basic) -> Node:
        graph = self.graph
        if isinstance(expression, Piecewise):
            return self._piecewise(expression.args)
        if isinstance(expression, BooleanTrue | BooleanFalse):
            return graph.number(int(bool(expression)))
        if isinstance(expression, ITE):
            condition, yes, no = expression.args
            ways = And(condition, yes, evaluate=False), And(Not(condition), no, evaluate=False)
            return self(Or(*ways, evaluate=False))
        name = {**FUNCTIONS, **RELATIONS}.get(type(expression))
        if name is None:
            raise ModelError(
                f"the function {expression.func} in {expression} has no counterpart in C; "
                f"use one of {', '.join(sorted(FUNCTIONS.values()))} or a Piecewise of them"
            )
        operands = [self(argument) for argument in expression.args]
        if name in SPLIT_IN_TWO or name in ("and", "or"):
            return self._fold(name, operands)
        if name == "step":
            return self._step(*expression.args)
        if name in ("sin", "cos", "tan"):
            return self._odd_or_even(name, operands[0])
        return graph.call(name, *operands)

    def _table(self, call: TableCall) -> Node:
        name = call.table.name
        self.graph.tables[name] = call.table
        operands = map(self, call.args)
        return self.graph.call(name_of_call(name, call.orders), self.graph.symbol(name), *operands)

    def _step(self, argument: sympy.Basic, at_zero: sympy.Basic = sympy.S.Half) -> Node:
        step = self.graph.call("step", self(argument))
        if at_zero == sympy.S.Half:
            return step
        return self.graph.call("select", self.graph.call("==", self(argument), self.graph.zero), self(at_zero), step)

    def _odd_or_even(self, name: str, angle: Node) -> Node:
        """Express sin(-a) by sin(a), so that they share a node; the sign is that of the graph's canonical form."""
        kind, operands = self.graph.records[angle]
        if kind is Kind.SUM and len(operands) == 1 and operands[0][1] < 0:
            positive = self.graph.call(name, self.graph.negative(angle))
            return positive if name == "cos" else self.graph.negative(positive)
        return self.graph.call(name, angle)

    def _fold(self, name: str, operands: list[Node]) -> Node:
        node = operands[0]
        for operand in operands[1:]:
            node = self.graph.call(name, node, operand)
        return node

    def _piecewise(self, pairs: tuple[sympy.Basic, ...]) -> Node:
        """Convert (value, condition) pairs to nested selects; without a final `True` the last alternative is NaN."""
        assert all(isinstance(pair, ExprCondPair) for pair in pairs)
        node = None
        for value, condition in reversed([pair.args for pair in pairs]):
            if condition == True or node is None:  # noqa: E712  (SymPy's true is not Python's)
                rest = self(value) if condition == True else self.graph.number(float("nan"))  # noqa: E712
                node = rest
            if condition != True:  # noqa: E712
                node = self.graph.call("select", self(condition), self(value), node)
        assert node is not None
        return node


def _operands(expression: sympy.Basic) -> list[sympy.Basic]:
    """Return the parts to convert before an expression; none for a function without counterpart, which then fails."""
    if isinstance(expression, Piecewise):
        return [part for pair in reversed(expression.args) for part in reversed(pair.args) if part != True]  # noqa: E712
    if isinstance(expression, sympy.Add | sympy.Mul):
        return list(expression.args)
    if isinstance(expression, sympy.Pow):
        base, exponent = expression.args
        return [part for part in (base, exponent) if part != sympy.E and not isinstance(part, sympy.Number)]
    if isinstance(expression, TableCall | BodyFunction):
        return list(expression.args)
    return list(expression.args) if type(expression) in (FUNCTIONS | RELATIONS) else []


def _number(expression: sympy.Basic) -> Number:
    if isinstance(expression, sympy.Rational):
        return exact(int(expression.p), int(expression.q))
    value = float(expression)
    if math.isinf(value):
        raise ModelError(f"the number {expression} is beyond what C's double holds; choose other units")
    return value


class ToSympy:
    """Converts nodes back to SymPy expressions in plain symbols; a chain of selects becomes one Piecewise."""

    def __init__(self, graph: Graph, symbols: Mapping[str, sympy.Symbol]) -> None:
        self.graph = graph
        self._symbols = symbols
        self._known: dict[Node, sympy.Expr] = {}

    def __call__(self, root: Node) -> sympy.Expr:
        """Return the expression of a node."""
        for node in self.graph.reachable([root], self._known):
            if not self._is_select(node):
                self._known[node] = self._convert(node)
        return self._value(root)

    def _is_select(self, node: Node) -> bool:
        return self.graph.records[node].operands[0] == "select" and self.graph.records[node].kind is Kind.CALL

    def _value(self, node: Node) -> sympy.Expr:
        if node not in self._known:
            self._known[node] = self._piecewise(node)
        return self._known[node]

    def _piecewise(self, node: Node) -> sympy.Expr:
        """Return a chain of selects as one Piecewise."""
        chain = []
        while self._is_select(node) and node not in self._known:
            chain.append(self.graph.records[node].operands[1:])
            node = chain[-1][2]
        pairs = [(self._value(yes), _condition(self._value(condition))) for condition, yes, _ in chain]
        return Piecewise(*pairs, (self._value(node), True), evaluate=False)

    def _convert(self, node: Node) -> sympy.Expr:
        kind, operands = self.graph.records[node]
        if kind is Kind.NUMBER:
            return from_number(operands[0])
        if kind is Kind.SYMBOL:
            return self._symbols[operands[0]]
        if kind is Kind.SUM:
            return sympy.Add(*(from_number(factor) * self._value(child) for child, factor in operands))
        if kind is Kind.PRODUCT:
            return sympy.Mul(*(self._value(child) ** from_number(power) for child, power in operands))
        if orders := orders_of(operands[0]):
            return self.graph.tables[table_of(operands[0])].function(orders)(*map(self._value, operands[2:]))
        name, *values = operands[0], *map(self._value, operands[1:])
        return values[0] ** values[1] if name == "pow" else BACK[name](*values)


def _condition(value: sympy.Basic) -> Boolean:
    return value if isinstance(value, Boolean) else sympy.Ne(value, 0)
