"""Canonical text of a model, for hashing: independent of the process, its hash seed and the model's file."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

LATER = ("constraint_names", "states")
"""Fields added in later versions. They are omitted where empty, so that hashes of older models do not change."""
UNWRITTEN = ("notes", "units")
"""Fields that change nothing of the generated files."""


def canonical_text(record: Any) -> str:
    """Return one line `field = value` for each field, in the order of the class; empty fields of LATER are omitted."""
    writer = _Writer()
    names = [field.name for field in fields(record) if field.name not in LATER or getattr(record, field.name)]
    return "".join(f"{name} = {writer(getattr(record, name))}\n" for name in names if name not in UNWRITTEN)


class _Writer:
    """Writes nested tuples, records, numbers and expressions; the text of a shared subexpression is computed once."""

    def __init__(self) -> None:
        self._known: dict[sympy.Basic, str] = {}

    def __call__(self, value: Any) -> str:
        if isinstance(value, sympy.Basic):
            return self._expression(value)
        if isinstance(value, tuple):
            return f"({', '.join(map(self, value))})"
        if is_dataclass(value):
            return self([getattr(value, field.name) for field in fields(value) if field.compare])
        if isinstance(value, list):
            return f"[{', '.join(map(self, value))}]"
        return repr(value)

    def _expression(self, value: sympy.Basic) -> str:
        text = self._known.get(value)
        if text is None:
            text = self._known[value] = self._spell(value)
        return text

    def _spell(self, value: sympy.Basic) -> str:
        if isinstance(value, sympy.Symbol):
            return f"{value.name!r}{_assumptions(value._assumptions_orig)}"
        if not value.args:
            return str(sympy.srepr(value))
        parts = [self._expression(argument) for argument in value.args]
        if isinstance(value, sympy.Add | sympy.Mul) and value.is_commutative:
            parts.sort()
        return f"{self._head(value)}({', '.join(parts)})"

    @staticmethod
    def _head(value: sympy.Basic) -> str:
        if isinstance(value, AppliedUndef):
            return f"{value.func.__name__!r}{_assumptions(value.func._kwargs)}"
        return str(value.func.__name__)


def _assumptions(assumptions: dict[str, Any]) -> str:
    listed = ", ".join(f"{name}={assumptions[name]}" for name in sorted(assumptions) if assumptions[name] is not None)
    return f"[{listed}]" if listed else ""
