"""Kernels: straight-line functions of arrays, with the user's names as local variables."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from ..graph.graph import Graph
from ..graph.store import Kind, Node
from ..schedule.operations import Cost, operands_of
from ..schedule.schedule import Constants, Schedule, cost_behind, schedule
from .identifiers import c_identifiers, free
from .line_breaks import folded, wrapped
from .parts import KEPT, Part, cut
from .printer import Printer

INPUTS = ("t", "x", "v", "eta", "a", "lambda", "c", "u", "parameters")
"""The possible inputs of a kernel, in the order of its arguments; all but the time are arrays."""
SHARED = "shared"
"""The array of values that one kernel computes and the next one also needs."""
LONG = 250
"""Kernels with at least this number of statements are not inlined: compile time grows faster than the length of the
text, and the code is no faster."""


@dataclass(frozen=True, slots=True)
class Array:
    """An output array of a kernel; shape is C text, such as [N1][N1]."""

    name: str
    shape: str


@dataclass(frozen=True, slots=True)
class Entry:
    """An assignment of the value of a node to elements of an array, such as [0][1]; `words` is an optional comment."""

    array: Array
    places: tuple[str, ...]
    node: Node
    words: str = ""


def both_triangles(name: str, first: int, M: Sequence[Sequence[Node]]) -> list[Entry]:
    """Return the assignments of both triangles of a symmetric matrix (n, n), from index `first` on."""
    n, array = len(M), Array(name, "")
    places = {(i, j): (first + i * n + j, first + j * n + i) for i in range(n) for j in range(i + 1)}
    return [Entry(array, tuple(f"[{at}]" for at in dict.fromkeys(both)), M[i][j]) for (i, j), both in places.items()]


@dataclass(frozen=True, slots=True)
class Draft:
    """A kernel before it is written.

    arguments : names of the arguments of a function with a fixed signature; if (), they follow from what it uses
    actual : the names of the arguments in the caller, if they differ
    on_lanes : whether it computes with `real` (em_real.h) instead of double
    exported : whether other units call it if it, or a kernel written together with it, is long
    """

    name: str
    entries: Sequence[Entry]
    arguments: tuple[str, ...] = ()
    actual: Mapping[str, str] | None = None
    on_lanes: bool = False
    exported: bool = False

    @property
    def number(self) -> str:
        """The C type of its inputs and outputs."""
        return "real" if self.on_lanes else "double"


@dataclass(frozen=True, slots=True)
class Kernel:
    """A straight-line function as C text.

    head : the head of the function
    declared, call : the declaration of its outputs in the caller (if needed), and the call
    statements : in an order that keeps few values alive at a time; calls of the parts, if it is cut
    parts : the functions that a long one is cut into
    called : names of the functions called by it and by the kernels written together with it
    reads : the INPUTS that it reads
    exported : whether other units call it
    assigned : the places that it assigns, such as [0], without the arrays
    """

    head: str
    declared: str
    call: str
    statements: tuple[str, ...]
    parts: tuple[Part, ...]
    cost: Cost
    called: frozenset[str]
    reads: frozenset[str]
    exported: bool
    assigned: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Symbols:
    """The arguments and indices of symbols and constants.

    places : symbol -> (argument, index in it); the index is None if the argument is not an array
    first_constant : the index of the first constant in the prepared parameters
    """

    places: Mapping[str, tuple[str, int | None]]
    first_constant: int


def written(graph: Graph, drafts: Sequence[Draft], symbols: Symbols, constants: Constants | None,
            passing_only: Draft | None = None) -> list[Kernel]:  # fmt: skip
    """Return kernels that are called one after the other: common values are computed once and passed on.

    The cost of the first one includes that of the others. If `constants` is None, functions of the parameters are
    computed in place. If kernels are long, `passing_only` is written in addition: it computes only the values that are
    passed on, replaces the first kernel for callers that need only the last one, and has the cost of these two.
    """
    plan = schedule(graph, [entry.node for draft in drafts for entry in draft.entries], hoist=constants is not None)
    arrays = {entry.array.name for draft in drafts for entry in draft.entries}
    taken = {*INPUTS, *arrays, SHARED, KEPT, *(name for draft in drafts for name in draft.arguments)}
    writer = _Writer(graph, plan, symbols, constants, taken)
    scopes = [writer.scope(draft) for draft in drafts]
    long = any(len(scope.statements) + len(scope.shares) >= LONG for scope in scopes)
    costs = [plan.cost, *[Cost()] * len(scopes)][: len(scopes)]
    if passing_only is not None and long:
        scopes.append(writer.passing_only(passing_only))
        costs.append(cost_behind(plan, [entry.node for entry in drafts[-1].entries]))
    return [_kernel(scope, len(writer.passed), cost, long) for scope, cost in zip(scopes, costs, strict=True)]


class _Scope:
    """The body of one kernel under construction."""

    def __init__(self, draft: Draft, plan: Schedule) -> None:
        self.draft = draft
        self.names: dict[int, str] = {}
        self.printer = Printer(plan, self.names, draft.on_lanes)
        self.read: set[str] = set()
        self.statements: list[str] = []
        self.shares: list[str] = []

    def load(self, array: str, place: int | None, identifier: str) -> None:
        """Declare a name for an element of an array."""
        self.read.add(array)
        if place is not None:
            self.statements.append(f"const {self.draft.number} {identifier} = {array}[{place}];")

    def assign(self, entry: Entry) -> None:
        """Write the assignment of an output, whose operands already have names."""
        text = self.printer.whole(self.printer.plan.roots[entry.node])
        words = f" /* {entry.words} */" if entry.words else ""
        self.statements.append(wrapped(f"{_targets(entry)} = {text};") + words)


class _Writer:
    """Writes kernels one after the other, and keeps track of the values that already have names."""

    def __init__(self, graph: Graph, plan: Schedule, symbols: Symbols, constants: Constants | None, taken: set[str]
                 ) -> None:  # fmt: skip
        self.graph, self.plan, self.symbols, self.constants = graph, plan, symbols, constants
        self.identifiers = c_identifiers(symbols.places, taken) | {"t": "t"}
        self.reserved = frozenset((*taken, *self.identifiers.values()))
        self.taken = set(self.reserved)
        self.known: dict[int, tuple[str, _Scope]] = {}
        self.passed: dict[int, int] = {}
        self.here: _Scope

    def scope(self, draft: Draft) -> _Scope:
        """Write one kernel."""
        self.here = _Scope(draft, self.plan)
        for entry in draft.entries:
            self._need(self.plan.roots[entry.node])
            self.here.assign(entry)
        return self.here

    def passing_only(self, draft: Draft) -> _Scope:
        """Write the kernel that computes only the values passed on."""
        self.known, self.taken, self.here = {}, set(self.reserved), _Scope(draft, self.plan)
        for value, place in self.passed.items():
            self._need(value)
            self.here.shares.append(f"{SHARED}[{place}] = {self.here.names[value]};")
        return self.here

    def _need(self, root: int) -> None:
        """Name the values that root depends on, operands first, where they need a name."""
        stack = [(root, False)]
        seen: set[int] = set()
        while stack:
            value, ready = stack.pop()
            if value in self.here.names or value in seen and not ready:
                continue
            if ready or value in self.known:
                self._name(value)
                continue
            seen.add(value)
            stack.append((value, True))
            stack.extend((operand, False) for operand in reversed(list(operands_of(self.plan.operations[value]))))

    def _name(self, value: int) -> None:
        kind, operands = self.plan.operations[value]
        if value in self.known:
            self._receive(value)
        elif kind == "leaf":
            self._load(value, operands[0])
        elif kind == "constant":
            self._load_constant(value, operands[0])
        elif kind != "number" and (
            self.plan.uses[value] > 1 or self._is_sine(value) or self.here.printer.is_deep(value)
        ):
            self._compute(value)

    def _receive(self, value: int) -> None:
        """Pass on a value from the kernel that computes it, and read it in this one."""
        name, before = self.known[value]
        if value not in self.passed:
            self.passed[value] = len(self.passed)
            before.shares.append(f"{SHARED}[{self.passed[value]}] = {name};")
        self.here.load(SHARED, self.passed[value], name)
        self.here.names[value] = name

    def _load(self, value: int, symbol: str) -> None:
        self.here.load(*self.symbols.places[symbol], self.identifiers[symbol])
        self.here.names[value] = self.identifiers[symbol]

    def _load_constant(self, value: int, node: Node) -> None:
        kind, operands = self.graph.records[node]
        if kind is Kind.SYMBOL:
            self._load(value, operands[0])
            return
        assert self.constants is not None
        index = self.constants.index(node)
        name = free(f"c_{index}", self.identifiers.values())
        self.here.load("c", self.symbols.first_constant + index, name)
        self.here.names[value] = name

    def _compute(self, value: int) -> None:
        name = free(self._named_after(value), self.taken)
        self.taken.add(name)
        number = self.here.draft.number
        self.here.statements.append(wrapped(f"const {number} {name} = {self.here.printer.bare(value)};"))
        self.here.names[value] = name
        self.known[value] = name, self.here

    def _named_after(self, value: int) -> str:
        if not self._is_sine(value):
            return f"z_{len(self.known)}"
        function, angle = self.plan.operations[value].operands
        return f"{function}_{self.here.names.get(angle, len(self.known))}"

    def _is_sine(self, value: int) -> bool:
        kind, operands = self.plan.operations[value]
        return kind == "call" and operands[0] in ("sin", "cos")


def _kernel(scope: _Scope, passed: int, cost: Cost, long: bool) -> Kernel:
    draft = scope.draft
    results = list(dict.fromkeys(entry.array for entry in draft.entries))
    if scope.shares:
        results.append(Array(SHARED, f"[{passed}]"))
    read = [name for name in (*INPUTS, SHARED) if name in scope.read]
    names = dict.fromkeys((*read, *(array.name for array in results)))  # one may read shared values, and add some
    actual, statements = draft.actual or {}, (*scope.statements, *scope.shares)
    declared = [one.name + one.shape for one in results if one.name not in (*actual, *read)]
    linkage = "EM_INLINE" if len(statements) < LONG else "EM_NOINLINE_KERNEL"
    exported = draft.exported and long
    if exported:
        linkage = "EM_NOINLINE_KERNEL_EXPORT"
    parameters = _parameters(draft, read, results, passed)
    parts, called = cut(draft.name, draft.number, statements, parameters)
    inner = folded(f"{linkage} void {draft.name}(", list(parameters.values()), ")")
    return Kernel(
        head=_head(draft) if draft.arguments else inner,
        declared=folded(f"{draft.number} ", declared, ";"),
        call=folded(f"{draft.name}(", [actual.get(name, name) for name in names], ");"),
        statements=called, parts=parts, cost=cost,
        called=frozenset(called for kind, (called, *_) in scope.printer.plan.operations.values() if kind == "call"),
        reads=frozenset(read), exported=exported,
        assigned=tuple(place for entry in draft.entries for place in entry.places),
    )  # fmt: skip


def _targets(entry: Entry) -> str:
    return " = ".join(entry.array.name + place for place in entry.places)


def _head(draft: Draft) -> str:
    """Return the head of a function with a fixed signature, whether it uses all arguments or not."""
    arguments = [_input(name, "double") if name in INPUTS else f"double *restrict {name}" for name in draft.arguments]
    return folded(f"EM_EXPORT void {draft.name}(", arguments, ")")


def _parameters(draft: Draft, read: Iterable[str], results: Iterable[Array], passed: int) -> dict[str, str]:
    """Return the declarations of inputs and outputs as parameters, by name."""
    number = draft.number
    inputs = {name: _input(name, number) if name != SHARED else f"const {number} {SHARED}[{passed}]" for name in read}
    return inputs | {a.name: f"{number} {a.name}{a.shape}" if a.shape else f"{number} *restrict {a.name}"
                     for a in results}  # fmt: skip


def _input(name: str, number: str) -> str:
    return f"{number} {name}" if name == "t" else f"const {number} *restrict {name}"
