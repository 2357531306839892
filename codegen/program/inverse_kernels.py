"""Kernels of inverse dynamics: the forces for given accelerations, and where inputs act."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from ..equations.terms import Terms
from ..equations.tree.tree_terms import TreeTerms
from ..graph.store import Node
from ..kernel.kernel import Array, Entry, Kernel

Column = Callable[..., list[Entry]]
One = Callable[..., Kernel]


def is_recursive(terms: Terms) -> bool:
    """Return whether recursions give the forces for given accelerations, and so the bias, too."""
    return isinstance(terms, TreeTerms) and not terms.mechanics.augmented


def inverse_kernels(terms: Terms, one: One, column: Column) -> dict[str, Any]:
    """Write `required`, `input_columns` and `mixed_inputs` of `Kernels`.

    Parameters
    ----------
    one : writes a function with a fixed signature
    column : returns the entries of an array
    """
    return {
        "required": _required(terms, one, column),
        "input_columns": _input_columns(terms, one),
        "mixed_inputs": _mixed_inputs(terms),
    }


def _required(terms: Terms, one: One, column: Column) -> Kernel | None:
    """Write M a - loads and A a + gamma; None if C computes them from M and bias."""
    if not (isinstance(terms, TreeTerms) or terms.mechanics.augmented):
        return None
    entries = [*column("r", terms.required), *column("s", terms.row_accelerations, "N_ROWS")]
    name = "own_required_forces" if terms.scene.in_loops else "required_forces"
    return one(name, entries, "t", "x", "v", "a", "c", "u", "r", "s")


def _input_columns(terms: Terms, one: One) -> Kernel | None:
    """Write the entries of B = d forces / d inputs (n, n_inputs) that are not 0; None if there are no inputs."""
    flat = [node for row in terms.input_columns for node in row]
    entries = [Entry(Array("B", ""), (f"[{k}]",), node) for k, node in enumerate(flat)]
    nonzero = [entry for entry in entries if entry.node != terms.graph.zero]
    return one("input_columns", nonzero, "t", "x", "v", "a", "c", "u", "B") if flat else None


def _mixed_inputs(terms: Terms) -> tuple[int, ...]:
    inputs = [symbol.name for symbol in terms.mechanics.inputs]

    def depends(column: Iterable[Node], u: str) -> bool:
        return any(terms.graph.depends(entry, u) for entry in column)

    return tuple(int(depends(column, u)) for column in zip(*terms.input_columns, strict=True) for u in inputs)
