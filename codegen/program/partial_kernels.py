"""Kernels of partial derivatives: dense matrices, of which they assign the nonzero entries."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..equations.partial_derivatives import Partials
from ..equations.terms import Rows, Terms
from ..graph.store import Node
from ..kernel.kernel import Array, Draft, Entry, Kernel, Symbols, both_triangles, written
from .kernel_roles import PartialKernels
from .structure import structure_of

MOTION = ("t", "x", "v", "a", "lambda", "c", "u")


def partial_kernels(terms: Terms, symbols: Symbols) -> PartialKernels:
    """Return the kernels. They do not use the prepared constants, since they are called rarely."""
    return _Writing(terms, symbols).kernels()


class _Writing:
    def __init__(self, terms: Terms, symbols: Symbols) -> None:
        self.terms, self.symbols, self.partials = terms, symbols, Partials(terms)
        self.own = "own_" if terms.scene.in_loops else ""

    def kernels(self) -> PartialKernels:
        mechanics, partials = self.terms.mechanics, self.partials
        arguments = (*partials.state, *partials.forcing)
        outputs, events, quasi = (
            [self.terms.node(expression) for _, expression in named]
            for named in (mechanics.outputs, mechanics.events, mechanics.quasi_velocities)
        )
        times = [node for one in self.terms.time_events.times for node in (one.at, one.period)]
        return PartialKernels(
            in_loops=self.terms.scene.in_loops,
            structure=structure_of(self.terms),
            state=self.dense(f"{self.own}state_partials", partials.residual, partials.state, *MOTION),
            forcing=self.dense("forcing_partials", partials.residual, partials.forcing, *MOTION),
            equations=self.equations() if mechanics.augmented else None,
            constraints=self.if_any("constraint_partials", partials.constraints, arguments, "t", "x", "v", "c"),
            outputs=self.if_any("output_partials", outputs, (*partials.solved, *arguments), *MOTION),
            events=self.if_any("event_partials", events, arguments, "t", "x", "v", "c", "u"),
            time_events=self.if_any("time_event_partials", times, arguments, "c"),
            quasi=self.if_any("quasi_partials", quasi, arguments, "t", "x", "v", "c"),
            mass_matrix=self.gradient(f"{self.own}mass_matrix_gradient", self.terms.dM),
            factored=self.gradient("factored_gradient", self.terms.factored_gradient) if mechanics.augmented else None,
            **self.event_actions(),
        )

    def equations(self) -> Kernel:
        """Return the kernel of the equations with M itself, where M + A^T W A is factored."""
        arguments = (*self.partials.state, *self.partials.forcing)
        return self.dense(f"{self.own}equation_partials", self.partials.equations, arguments, *MOTION)

    def event_actions(self) -> dict[str, Kernel | None]:
        """Return the kernels of the event actions; None for each if no event acts."""
        mechanics, partials = self.terms.mechanics, self.partials
        rows = {
            "impacts": [(*one.N, one.rate, one.restitution) for one in mechanics.impacts],
            "resets": [one.after for one in mechanics.resets],
            "levels": mechanics.levels,
        }
        arguments = (*partials.state, *partials.forcing)
        if not any(rows.values()):
            return dict.fromkeys((*rows, "blow"))
        nodes = {name: [self.terms.node(entry) for row in of_name for entry in row] for name, of_name in rows.items()}
        of_state = "t", "x", "v", "c", "u"
        name, of_blow = f"{self.own}impact_balance_partials", ("t", "x", "a", "lambda", "c")
        blow = self.dense(name, partials.impact_balance, arguments, *of_blow)
        of_each = {
            name: self.dense(f"{name[:-1]}_partials", roots, arguments, *of_state) for name, roots in nodes.items()
        }
        return {"blow": blow, **of_each}

    def if_any(self, name: str, roots: Sequence[Node], columns: Sequence[str], *arguments: str) -> Kernel | None:
        return self.dense(name, roots, columns, *arguments) if roots else None

    def dense(self, name: str, roots: Sequence[Node], columns: Sequence[str], *arguments: str) -> Kernel:
        """Return the kernel that assigns the nonzero entries of D (roots, columns)."""
        graph, D = self.terms.graph, Array("D", "")
        flat = [entry for row in self.partials.of(roots, columns) for entry in row]
        expanded = [(k, self.terms.expanded(entry)) for k, entry in enumerate(flat)]
        entries = [Entry(D, (f"[{k}]",), node) for k, node in expanded if node != graph.zero]
        return self.one(name, entries, *arguments, "D")

    def gradient(self, name: str, dM: Sequence[Rows]) -> Kernel:
        """Return the kernel that assigns the nonzero entries of a gradient; the caller clears the array first."""
        zero, expanded = self.terms.graph.zero, self.terms.expanded
        every = [entry for k, M in enumerate(dM) for entry in both_triangles("dM", k * len(M) ** 2, M)]
        entries = [replace(entry, node=expanded(entry.node)) for entry in every if entry.node != zero]
        return self.one(name, entries, "t", "x", "c", "dM")

    def one(self, name: str, entries: Sequence[Entry], *arguments: str) -> Kernel:
        return written(self.terms.graph, [Draft(name, entries, arguments)], self.symbols, None)[0]
