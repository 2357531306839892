"""C text for scheduled expressions: one statement a shared value, under the user's names."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from ..graph.graph import Graph, Kind, Node, Number, magnitude
from ..graph.schedule import Constants, Cost, Operation, Schedule, operands_of, schedule
from .names import is_reserved

SUM, PRODUCT, ATOM = 0, 1, 2
"""How tightly a text binds."""
WIDTH = 110
CALLS: Mapping[str, str] = {
    "sin": "em_sin", "cos": "em_cos", "abs": "fabs", "min": "em_least", "max": "em_greatest", "sign": "em_sign",
    "step": "em_heaviside",
}  # fmt: skip
INFIX: Mapping[str, str] = {"and": "&&", "or": "||"}


def c_identifier(name: str) -> str:
    """Return a name as C takes it: what is no identifier, a word of C or one of our own gets underscores."""
    identifier = re.sub(r"\W", "_", name, flags=re.ASCII)
    if not identifier or identifier[0].isdigit():
        identifier = f"_{identifier}"
    return identifier + "_" if is_reserved(identifier) else identifier


def c_identifiers(names: Iterable[str]) -> dict[str, str]:
    """Return name -> identifier, all of them different."""
    identifiers: dict[str, str] = {}
    for name in names:
        identifier = c_identifier(name)
        while identifier in identifiers.values():
            identifier += "_"
        identifiers[name] = identifier
    return identifiers


@dataclass(frozen=True, slots=True)
class Section:
    """Lines of C: what is loaded, what is computed, what is assigned."""

    loads: tuple[str, ...]
    temporaries: tuple[str, ...]
    outputs: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Body:
    """The model-specific part of one function.

    unused : those of the function's arguments that no line reads (C warns of them).
    """

    sections: tuple[Section, ...]
    unused: tuple[str, ...]
    cost: Cost


@dataclass(frozen=True, slots=True)
class Naming:
    """Where symbols and constants live.

    identifiers : symbol -> C identifier
    places : symbol -> C expression to load it from; a symbol whose place is its own identifier is not loaded
    first_constant : the place of the first constant in the prepared parameters
    """

    identifiers: Mapping[str, str]
    places: Mapping[str, str]
    first_constant: int


Assignments = Sequence[tuple[str, Node]]


def body(
    graph: Graph,
    sections: Sequence[Assignments],
    naming: Naming,
    constants: Constants | None,
    arguments: Sequence[str] = (),
) -> Body:
    """Write the sections of one function; each is a sequence of (target, expression).

    Without `constants` what is made of parameters only is computed in place.
    """
    roots = [node for assignments in sections for _, node in assignments]
    plan = schedule(graph, roots, hoist=constants is not None)
    writer = _Writer(graph, plan, naming, constants)
    written = tuple(writer.section(assignments) for assignments in sections)
    text = "\n".join(line for section in written for part in (section.loads, section.outputs) for line in part)
    unused = tuple(name for name in arguments if not re.search(rf"\b{name}\b", text + writer.text))
    return Body(written, unused, plan.cost)


class _Writer:
    """Remembers across the sections of a function what has a name already."""

    def __init__(self, graph: Graph, plan: Schedule, naming: Naming, constants: Constants | None) -> None:
        self.graph, self.plan, self.naming, self.constants = graph, plan, naming, constants
        self.names: dict[int, str] = {}
        self.text = ""
        self._taken = set(naming.identifiers.values())
        self._loads: list[str] = []
        self._temporaries: list[str] = []

    def section(self, assignments: Assignments) -> Section:
        """Write one section."""
        self._loads, self._temporaries = [], []
        for _, node in assignments:
            self._need(self.plan.roots[node])
        outputs = tuple(_wrap(f"{target} = {self._bare(self.plan.roots[node])};") for target, node in assignments)
        self.text += "\n".join(self._temporaries)
        return Section(tuple(sorted(self._loads, key=_place)), tuple(self._temporaries), outputs)

    def _need(self, root: int) -> None:
        """Name every value behind root that wants a name, operands first."""
        stack = [(root, False)]
        seen: set[int] = set()
        while stack:
            value, ready = stack.pop()
            if value in self.names or value in seen and not ready:
                continue
            if ready:
                self._name(value)
                continue
            seen.add(value)
            stack.append((value, True))
            stack.extend((operand, False) for operand in reversed(list(operands_of(self.plan.operations[value]))))

    def _name(self, value: int) -> None:
        kind, operands = self.plan.operations[value]
        if kind == "leaf":
            self._load(value, operands[0])
        elif kind == "constant":
            self._load_constant(value, operands[0])
        elif kind != "number" and (self.plan.uses[value] > 1 or self._is_sine(value)):
            name = self._fresh(value)
            self._temporaries.append(_wrap(f"const double {name} = {self._bare(value)};"))
            self.names[value] = name

    def _load(self, value: int, symbol: str) -> None:
        identifier = self.naming.identifiers[symbol]
        place = self.naming.places[symbol]
        if place != identifier:
            self._loads.append(f"const double {identifier} = {place};")
        self.names[value] = identifier

    def _load_constant(self, value: int, node: Node) -> None:
        kind, operands = self.graph.records[node]
        if kind is Kind.SYMBOL:
            self._load(value, operands[0])
            return
        assert self.constants is not None
        index = self.constants.index(node)
        self._loads.append(f"const double c_{index} = c[{self.naming.first_constant + index}];")
        self.names[value] = f"c_{index}"

    def _is_sine(self, value: int) -> bool:
        kind, operands = self.plan.operations[value]
        return kind == "call" and operands[0] in ("sin", "cos")

    def _fresh(self, value: int) -> str:
        name = f"z_{len(self.names)}"
        if self._is_sine(value):
            function, angle = self.plan.operations[value].operands
            name = f"{function}_{self.names[angle]}" if angle in self.names else f"{function}_{len(self.names)}"
        while name in self._taken:
            name += "_"
        self._taken.add(name)
        return name

    # -- expressions ---------------------------------------------------------------------------------------------

    def _bare(self, value: int) -> str:
        """Return the text of a value without parentheses around it."""
        return self.names[value] if value in self.names else self._write(self.plan.operations[value])[0]

    def _bound(self, value: int, tightness: int) -> str:
        """Return the text of a value, in parentheses where it binds less tightly than asked for."""
        if value in self.names:
            return self.names[value]
        text, binding = self._write(self.plan.operations[value])
        return text if binding >= tightness else f"({text})"

    def _write(self, operation: Operation) -> tuple[str, int]:
        kind, operands = operation
        if kind == "number":
            return c_number(operands[0]), ATOM if operands[0] >= 0 else SUM
        if kind == "add":
            return self._sum(operands)
        if kind == "mul":
            return self._product(operands), PRODUCT
        if kind == "inverse":
            return f"1.0/{self._bound(operands[0], ATOM)}", PRODUCT
        if kind == "sqrt":
            return f"sqrt({self._bare(operands[0])})", ATOM
        return self._call(operands[0], operands[1:])

    def _sum(self, terms: Sequence[tuple[int, Number]]) -> tuple[str, int]:
        ordered = sorted(terms, key=lambda term: term[1] < 0)
        first, *rest = (self._term(*term) for term in ordered)
        sign, text = first
        written = ("-" if sign < 0 else "") + text
        for sign, text in rest:
            written += f" {'-' if sign < 0 else '+'} {text}"
        return written, SUM

    def _term(self, value: int, factor: Number) -> tuple[int, str]:
        sign = -1 if factor < 0 else 1
        text = self._bound(value, PRODUCT)
        return sign, text if abs(factor) == 1 else f"{c_number(magnitude(factor))}*{text}"

    def _product(self, values: Sequence[int]) -> str:
        above = [value for value in values if not self._is_inverse(value)]
        below = [self.plan.operations[value].operands[0] for value in values if self._is_inverse(value)]
        text = "*".join(self._bound(value, ATOM if place else PRODUCT) for place, value in enumerate(above)) or "1.0"
        if not below:
            return text
        under = "*".join(self._bound(value, ATOM) for value in below)
        return f"{text}/{under}" if len(below) == 1 else f"{text}/({under})"

    def _is_inverse(self, value: int) -> bool:
        return value not in self.names and self.plan.operations[value].kind == "inverse"

    def _call(self, name: str, operands: Sequence[int]) -> tuple[str, int]:
        texts = [self._bare(operand) for operand in operands]
        if name == "select":
            condition, yes, no = (f"({text})" for text in texts)
            return f"({condition} ? {yes} : {no})", ATOM
        if name == "not":
            return f"!({texts[0]})", ATOM
        if name in ("<", "<=", ">", ">=", "==", "!=", "and", "or"):
            return f"(({texts[0]}) {INFIX.get(name, name)} ({texts[1]}))", ATOM
        return f"{CALLS.get(name, name)}({', '.join(texts)})", ATOM


def _place(load: str) -> tuple[str, int]:
    """Return what to sort loads by: the array, then the index."""
    array, index = re.findall(r"(\w+)\[(\d+)\]", load)[-1]
    return array, int(index)


def c_number(value: Number) -> str:
    """Return a number as C writes it, exactly where that is possible."""
    if isinstance(value, Fraction) and value.denominator > 1 and Fraction(float(value)) != value:
        return f"({value.numerator}.0/{value.denominator}.0)"
    if value != value:
        return "NAN"
    return repr(float(value))


def _wrap(statement: str) -> str:
    """Break a long statement into lines."""
    return "\n".join(textwrap.wrap(statement, WIDTH, subsequent_indent="    ", break_long_words=False) or [""])
