"""Small errors in what a model states: one subexpression, somewhere, times 1 + eps. What was compiled differs then."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from copy import copy

import sympy
from sympy.core.function import AppliedUndef, Derivative
from sympy.functions.elementary.piecewise import ExprCondPair

from eigenmotion import Model

Path = tuple[int, ...]
ROWS = ("forces", "holonomic_constraints", "nonholonomic_constraints")


def planted(model: Model, chance: random.Random) -> Callable[[float], Model]:
    """Return eps -> the model with one subexpression of an energy, a force or a row off by this part of itself."""
    where = [("kinetic_energy", None)] * 3 + [("potential_energy", None)] * 2 * (model.potential_energy != 0)
    where += [(name, row) for name in ROWS for row, given in enumerate(getattr(model, name)) if given != 0]
    field, row = chance.choice(where)
    given = getattr(model, field) if row is None else getattr(model, field)[row]
    whole = () if "constraints" in field else ((),)  # a row times a number is the same constraint
    path = chance.choice([*whole, *(path for path in paths(given) if path)])

    def make(eps: float) -> Model:
        other = copy(model)
        changed = times(given, path, 1 + sympy.Float(eps, 17))
        if row is not None:
            changed = tuple(changed if k == row else old for k, old in enumerate(getattr(model, field)))
        object.__setattr__(other, field, changed)
        return other

    return make


def paths(given: sympy.Expr, path: Path = ()) -> Iterator[Path]:
    """Give the ways down to each subexpression that may be scaled; exponents and conditions are none."""
    yield path
    if isinstance(given, Derivative | AppliedUndef):
        return
    parts = given.args[:1] if isinstance(given, sympy.Pow) else given.args
    for place, part in enumerate(parts):
        if isinstance(part, ExprCondPair):
            yield from paths(part.args[0], (*path, place, 0))
        elif isinstance(part, sympy.Expr):
            yield from paths(part, (*path, place))


def times(given: sympy.Basic, path: Path, factor: sympy.Expr) -> sympy.Basic:
    """Return the expression with the part at the end of a path multiplied."""
    if not path:
        return given * factor
    parts = list(given.args)
    parts[path[0]] = times(parts[path[0]], path[1:], factor)
    return given.func(*parts)
