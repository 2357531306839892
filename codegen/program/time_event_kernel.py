"""Kernel of time events: the times at which conditions on time alone change."""

from __future__ import annotations

import sympy

from ..equations.terms import Terms
from ..graph.convert import ToSympy
from ..kernel.kernel import Array, Draft, Entry, Symbols, written
from .kernel_roles import TimeEventKernel


class _AnySymbol(dict[str, sympy.Symbol]):
    """Symbols by name, created on first use."""

    def __missing__(self, name: str) -> sympy.Symbol:
        return sympy.Symbol(name)


def time_event_kernel(terms: Terms, symbols: Symbols) -> TimeEventKernel:
    """Return the kernel. It does not use the prepared constants, since no step calls it."""
    graph, events = terms.graph, terms.time_events
    nodes = [node for one in events.times for node in (one.at, one.period, one.terms)]
    entries = [Entry(Array("at", ""), (f"[{k}]",), node) for k, node in enumerate(nodes)]
    kernel = written(graph, [Draft("model_time_events", entries, ("c", "at"))], symbols, None)[0] if nodes else None
    text = ToSympy(graph, _AnySymbol())
    named = (
        str(text(one.at)) + (f" + k*({text(one.period)})" if one.period != graph.zero else "") for one in events.times
    )
    return TimeEventKernel(kernel, len(events.times), tuple(named), tuple(str(text(node)) for node in events.unsolved))
