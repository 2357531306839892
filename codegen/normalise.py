"""What the user wrote, as SymPy expressions, floats and tuples."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping, Sequence, Set
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

t: sympy.Symbol = dynamicsymbols._t
"""The time, as SymPy's mechanics knows it: `(L * r).diff(t)`."""

MULTIPLIER = sympy.Function("multiplier", real=True)
INFINITE = (sympy.nan, sympy.zoo, sympy.oo, -sympy.oo)


class ModelError(ValueError):
    """A mistake in a model. The message names the model, the symbol and the remedy."""


def name_of(symbol: sympy.Basic) -> str:
    """Return the user's name of a symbol or function of time; of a rate, the name of what it is the rate of and '."""
    if isinstance(symbol, sympy.Derivative):
        return name_of(symbol.expr) + "'" * int(symbol.derivative_count)
    if isinstance(symbol, AppliedUndef):
        return str(symbol.func.__name__)
    return str(getattr(symbol, "name", symbol))


def nearest(name: str, known: Iterable[str]) -> str:
    """Return " Did you mean 'x'?" with the known name most like this one, or nothing."""
    matches = difflib.get_close_matches(name, sorted(known), n=1, cutoff=0.6)
    return f" Did you mean {matches[0]!r}?" if matches else ""


def pairs_of(given: Any, what: str) -> tuple[tuple[Any, Any], ...]:
    """Return a mapping, or a sequence of pairs, as a tuple of pairs in the order given."""
    if isinstance(given, Mapping):
        return tuple(given.items())
    if isinstance(given, Set) or not isinstance(given, Sequence) or any(not _is_pair(entry) for entry in given):
        raise ModelError(f"{what} must be a mapping or a sequence of pairs, not {given!r}.")
    return tuple((key, value) for key, value in given)


def sequence_of(given: Any, what: str) -> tuple[Any, ...]:
    """Return a sequence as a tuple; sets and mappings have no order a model could rely on and are refused."""
    if isinstance(given, sympy.MatrixBase):
        return tuple(given)
    if isinstance(given, (str, Mapping, Set)) or not isinstance(given, Iterable):
        raise ModelError(f"{what} must be a list or tuple, not {given!r}: their order is that of the state.")
    return tuple(given)


def expression(given: Any, what: str) -> sympy.Expr:
    """Return a scalar SymPy expression with derivatives carried out and exponents exact.

    Raises
    ------
    ModelError
        It is no expression (a string, a matrix, a truth value), not real, or not finite.
    """
    try:
        value = sympy.sympify(given, strict=True)
    except (sympy.SympifyError, TypeError) as error:
        raise ModelError(f"{what} is {given!r}, which is not a SymPy expression. Build it from symbols.") from error
    if not isinstance(value, sympy.Expr) or isinstance(value, sympy.MatrixBase) or value.is_Matrix:
        raise ModelError(f"{what} is {value!r}, which is not a scalar expression.")
    if value.has(sympy.I):
        raise ModelError(f"{what} contains the imaginary unit. Energies, forces and constraints are real.")
    if value.has(*INFINITE):
        raise ModelError(f"{what} contains an infinite or undefined term. Look for a division by zero in it.")
    return _exact_exponents(_carried_out(_real(value)))


def number(given: Any, what: str) -> float:
    """Return a finite float; SymPy numbers such as pi/6 are rounded once.

    Raises
    ------
    ModelError
        It is no real number, or it is infinite or not a number.
    """
    try:
        value = float(given.evalf(30) if isinstance(given, sympy.Expr) else given)
    except OverflowError as error:
        raise ModelError(f"{what} is beyond the largest number a double holds, 1.8e308.") from error
    except (TypeError, ValueError) as error:
        raise ModelError(f"{what} is {given!r}. Give a real number: it may be changed at run time.") from error
    if not math.isfinite(value):
        raise ModelError(f"{what} is {value}. Give a finite number.")
    return value


def _is_pair(entry: Any) -> bool:
    return isinstance(entry, Sequence) and not isinstance(entry, str) and len(entry) == 2


def _real(value: sympy.Expr) -> sympy.Expr:
    """Take all quantities as real: |z|.diff(t), with z(t) that SymPy takes for complex, becomes sign(z) z.diff(t).

    A sign has the rate 0, but where it jumps.
    """
    if not value.has(sympy.re, sympy.im, sympy.conjugate, sympy.sign):
        return value
    for part in (sympy.re, sympy.conjugate):
        value = value.replace(part, lambda inside: inside)
    value = value.replace(sympy.im, lambda _: sympy.S.Zero)
    signs = {rate: sympy.S.Zero for rate in value.atoms(sympy.Derivative) if isinstance(rate.expr, sympy.sign)}
    return value.xreplace(signs)


def _carried_out(value: sympy.Expr) -> sympy.Expr:
    """Carry out derivatives left standing, such as Derivative(L*r, t) and Derivative(r, r); rates in time stay."""
    rates = value.atoms(sympy.Derivative)
    standing = any(not isinstance(rate.expr, AppliedUndef) or {*rate.variables} != {t} for rate in rates)
    return value.doit() if standing else value


def _exact_exponents(value: sympy.Expr) -> sympy.Expr:
    """Write the exponents 2.0 and 0.5 as 2 and 1/2: they are meant exactly, and only then does v**2.0 derive to 2 v."""
    if not any(_is_rounded(power) for power in value.atoms(sympy.Pow)):
        return value
    return value.replace(_is_rounded, lambda power: sympy.Pow(power.base, sympy.Rational(int(2 * power.exp), 2)))


def _is_rounded(value: sympy.Basic) -> bool:
    """Say whether this is a power whose exponent is a floating-point multiple of 1/2."""
    return bool(value.is_Pow and value.exp.is_Float and (2 * float(value.exp)).is_integer())
