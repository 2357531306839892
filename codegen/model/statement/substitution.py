"""Substitution in the fields of a model: expressions in tuples and records."""

from __future__ import annotations

from copy import copy
from dataclasses import fields, is_dataclass
from typing import Any

import sympy


def substituted(given: Any, replacements: dict[sympy.Expr, sympy.Expr]) -> Any:
    """Return expressions, in tuples and records, with replacements made."""
    if isinstance(given, sympy.Basic):
        return given.xreplace(replacements)
    if isinstance(given, tuple):
        return tuple(substituted(part, replacements) for part in given)
    if not is_dataclass(given):
        return given
    made = copy(given)
    for field in fields(given):
        object.__setattr__(made, field.name, substituted(getattr(given, field.name), replacements))
    return made
