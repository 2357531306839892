"""Room for expressions that are nested deeply: SymPy walks them by calls of itself; Python allows a thousand."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar

import sympy

Result = TypeVar("Result")
ORDINARY = 60
"""Levels that fit into Python's own limit, whatever SymPy does with them."""
CALLS, BYTES = 40, 12_000
"""A level takes at most so many calls, and so many bytes of a stack."""


def with_room(given: Any, action: Callable[[], Result]) -> Result:
    """Return what an action on expressions returns; with a stack of their depth where they are deep.

    Parameters
    ----------
    given
        Expressions, in tuples, lists, mappings or records.
    """
    depth = _depth(given)
    return action() if depth <= ORDINARY else _on_a_stack(depth, action)


def _on_a_stack(depth: int, action: Callable[[], Result]) -> Result:
    """Call an action in a thread of its own: the stack of this one is as large as it is."""
    outcome: list[Result] = []
    errors: list[BaseException] = []

    def run() -> None:
        try:
            outcome.append(action())
        except BaseException as error:
            errors.append(error)

    limit, size = sys.getrecursionlimit(), threading.stack_size(_rounded(BYTES * CALLS * depth))
    sys.setrecursionlimit(max(limit, CALLS * depth))
    try:
        thread = threading.Thread(target=run, daemon=True)
        thread.start()
        thread.join()
    finally:
        threading.stack_size(size)
        sys.setrecursionlimit(limit)
    if errors:
        raise errors[0]
    return outcome[0]


def _rounded(size: int) -> int:
    """Whole mebibytes, up to a gibibyte: of what a thread may use only what it uses is taken."""
    return min(max(64, size >> 20), 1024) << 20


def _depth(given: Any) -> int:
    """Return how many levels expressions have, each looked at once; of other things those of what is in them."""
    levels: dict[int, int] = {}
    waiting = list(expressions_in(given))
    kept = list(waiting)
    while waiting:
        part = waiting[-1]
        new = [inner for inner in part.args if id(inner) not in levels]
        if new:
            waiting += new
        else:
            waiting.pop()
            levels[id(part)] = 1 + max((levels[id(inner)] for inner in part.args), default=0)
    return max((levels[id(part)] for part in kept), default=0)


def expressions_in(given: Any) -> Iterable[sympy.Basic]:
    """Return the expressions in tuples, lists, mappings or records."""
    if isinstance(given, sympy.Basic):
        yield given
    elif isinstance(given, Mapping):
        yield from expressions_in((*given.keys(), *given.values()))
    elif isinstance(given, tuple | list):
        for one in given:
            yield from expressions_in(one)
    elif is_dataclass(given) and not isinstance(given, type):
        yield from expressions_in([getattr(given, field.name) for field in fields(given)])
