"""Recursion limit and stack size for deeply nested expressions, on which SymPy recurses beyond Python's default."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar

import sympy

Result = TypeVar("Result")
ORDINARY = 60
"""Nesting depth that fits into Python's default limit, whatever SymPy does with the expression."""
CALLS, BYTES = 40, 12_000
"""Upper bounds: Python calls for each level of nesting, and bytes of stack for each call."""


def with_room(source: Any, action: Callable[[], Result]) -> Result:
    """Return the result of an action on expressions, run with a larger stack where they are deeply nested.

    Parameters
    ----------
    source
        Expressions, in tuples, lists, mappings or records.
    """
    depth = _depth(source)
    return action() if depth <= ORDINARY else _on_a_stack(depth, action)


def _on_a_stack(depth: int, action: Callable[[], Result]) -> Result:
    """Call an action in a new thread: the stack of the current thread cannot grow."""
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
    """Return whole mebibytes, from 64 to 1024: the system commits only the pages that a thread uses."""
    return min(max(64, size >> 20), 1024) << 20


def _depth(source: Any) -> int:
    """Return the largest nesting depth of the expressions in an object; shared subexpressions are visited once."""
    levels: dict[int, int] = {}
    waiting = list(expressions_in(source))
    roots = list(waiting)
    while waiting:
        part = waiting[-1]
        new = [inner for inner in part.args if id(inner) not in levels]
        if new:
            waiting += new
        else:
            waiting.pop()
            levels[id(part)] = 1 + max((levels[id(inner)] for inner in part.args), default=0)
    return max((levels[id(part)] for part in roots), default=0)


def expressions_in(source: Any) -> Iterable[sympy.Basic]:
    """Return the expressions in tuples, lists, mappings or records."""
    if isinstance(source, sympy.Basic):
        yield source
    elif isinstance(source, Mapping):
        yield from expressions_in((*source.keys(), *source.values()))
    elif isinstance(source, tuple | list):
        for one in source:
            yield from expressions_in(one)
    elif is_dataclass(source) and not isinstance(source, type):
        yield from expressions_in([getattr(source, field.name) for field in fields(source)])
