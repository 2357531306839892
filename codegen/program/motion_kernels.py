"""Kernels of accelerations and their derivatives in one piece, for callers that ask for both at one state.

`K` are the entries of M and A in the system M a + A^T lambda = bias, A a = -gamma, and `b` its right side. The kernels
of derivatives follow in the same function, where a and lambda are known, and share values with those of K and b.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..equations.partial_derivatives import Partials
from ..equations.terms import Terms
from ..graph.store import Node
from ..kernel.kernel import Array, Draft, Entry, Kernel, Symbols, written
from .memory_layout import places_of


@dataclass(frozen=True, slots=True)
class Columns:
    """Derivatives of r and s (see `Partials`) by a group of arguments, dense: (n + m, width) without columns of zeros.

    arguments : the numbers of the columns among x, v, inputs, parameters, time
    width : their number, or more, for whole vectors
    nonzero : places (row, column) that are not structurally zero
    """

    arguments: tuple[int, ...]
    width: int
    nonzero: frozenset[tuple[int, int]]


@dataclass(frozen=True, slots=True)
class MotionKernels:
    """The kernels.

    entries : the places (i, j), i >= j, of K in the lower triangle of the whole system; rows behind coordinates
    values : K and b alone; terms : the same, for `slopes` that follow; groups : what each of `slopes` assigns
    """

    entries: tuple[tuple[int, int], ...]
    values: Kernel
    terms: Kernel
    slopes: tuple[Kernel, ...]
    groups: tuple[Columns, ...]


def motion_kernels(terms: Terms, groups: Sequence[Sequence[int]]) -> MotionKernels:
    """Return the kernels, with derivatives by groups of arguments, given by numbers."""
    writing = _Writing(terms)
    columns = [writing.columns(k, group) for k, group in enumerate(groups)]
    drafts = [draft for draft, _ in columns]
    values = writing.written(Draft("motion_values", writing.system))[0]
    of_terms, *slopes = writing.written(Draft("motion_terms", writing.system), *drafts)
    return MotionKernels(tuple(writing.places), values, of_terms, tuple(slopes), tuple(group for _, group in columns))


class _Writing:
    def __init__(self, terms: Terms) -> None:
        self.terms, self.partials = terms, Partials(terms)
        n, m, zero = terms.scene.n, terms.scene.m, terms.graph.zero
        lower = {(i, j): terms.M[i][j] for i in range(n) for j in range(i + 1)}
        lower |= {(n + row, j): terms.A[row][j] for row in range(m) for j in range(n)}
        self.places = {place: node for place, node in lower.items() if node != zero}
        right = [*terms.bias, *map(terms.graph.negative, terms.gamma)]
        K, b = Array("K", f"[{len(self.places)}]"), Array("b", f"[{n + m}]")
        self.system = [
            *(self._entry(K, k, node) for k, node in enumerate(self.places.values())),
            *(self._entry(b, k, node) for k, node in enumerate(right)),
        ]

    def _entry(self, array: Array, place: int, node: Node) -> Entry:
        return Entry(array, (f"[{place}]",), self.terms.expanded(node))

    def columns(self, number: int, group: Sequence[int]) -> tuple[Draft, Columns]:
        """Return the draft of a group of columns."""
        zero = self.terms.graph.zero
        names = (*self.partials.state, *self.partials.forcing)
        rows = self.partials.of(self.partials.residual, [names[k] for k in group])
        kept = [k for k in range(len(group)) if any(row[k] != zero for row in rows)]
        width = len(kept) if len(kept) < 4 else -(-len(kept) // 4) * 4
        nonzero = {(i, k): row[j] for i, row in enumerate(rows) for k, j in enumerate(kept) if row[j] != zero}
        name = f"W{number}"
        array = Array(name, f"[{max(1, len(rows) * width)}]")
        entries = [self._entry(array, i * width + k, node) for (i, k), node in nonzero.items()]
        draft = Draft(f"motion_slopes_{number}", entries, actual={name: name})
        return draft, Columns(tuple(group[k] for k in kept), width, frozenset(nonzero))

    def written(self, *drafts: Draft) -> list[Kernel]:
        """Write kernels that share values; one without entries has no statements."""
        return written(self.terms.graph, drafts, Symbols(places_of(self.terms.mechanics), 0), None)
