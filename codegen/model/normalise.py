"""Normalisation of user input to SymPy expressions, floats and tuples."""

from __future__ import annotations

import difflib
import math
import numbers
import reprlib
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from functools import lru_cache
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

t: sympy.Symbol = dynamicsymbols._t
"""The time symbol of sympy.physics.mechanics: `(L * r).diff(t)`."""


@lru_cache(maxsize=4096)
def rate_of(x: sympy.Expr) -> sympy.Expr:
    """Return dx/dt of a coordinate or state; SymPy takes a millisecond to form it."""
    return x.diff(t)


MULTIPLIER = sympy.Function("multiplier", real=True)
INFINITE = (sympy.nan, sympy.zoo, sympy.oo, -sympy.oo)
_UNEVALUATED = (sympy.Integral, sympy.Sum, sympy.Product, sympy.Limit)
_REWRITTEN: Mapping[type[sympy.Basic], Callable[..., sympy.Expr]] = {
    sympy.Mod: lambda a, b: a - b * sympy.floor(a / b), sympy.frac: lambda a: a - sympy.floor(a),
    sympy.cot: lambda a: 1 / sympy.tan(a), sympy.sec: lambda a: 1 / sympy.cos(a), sympy.csc: lambda a: 1 / sympy.sin(a),
    sympy.coth: lambda a: 1 / sympy.tanh(a), sympy.sech: lambda a: 1 / sympy.cosh(a),
    sympy.csch: lambda a: 1 / sympy.sinh(a), sympy.erfc: lambda a: 1 - sympy.erf(a),
}  # fmt: skip
"""Functions that C lacks, written with functions that it has."""
_SHORT = reprlib.Repr()
_SHORT.maxstring = _SHORT.maxother = _SHORT.maxlong = 60


class ModelError(ValueError):
    """A mistake in a model. The message names the model, the symbol and the remedy.

    Examples
    --------
    >>> import eigenmotion as em
    >>> em.Model(name="nothing", coordinates=[], kinetic_energy=0)
    Traceback (most recent call last):
        ...
    eigenmotion.codegen.model.normalise.ModelError: Model 'nothing': coordinates is empty. A mechanism has at least one.
    """


def shown(value: object) -> str:
    """Return the repr of an object on one line, shortened to fit into an error message."""
    try:
        return " ".join(_SHORT.repr(value).split())
    except Exception:  # a user's __repr__ may raise anything; so does an int of a million digits
        return f"of type {type(value).__name__}"


def name_of(symbol: sympy.Basic) -> str:
    """Return the name of a symbol or function of time; a derivative has a ' for each order, such as theta''."""
    if isinstance(symbol, sympy.Derivative):
        return name_of(symbol.expr) + "'" * int(symbol.derivative_count)
    if isinstance(symbol, AppliedUndef):
        return str(symbol.func.__name__)
    return str(getattr(symbol, "name", symbol))


def nearest(name: str, known: Iterable[str]) -> str:
    """Return " Did you mean 'x'?" with the closest known name, or "" if none is close."""
    matches = difflib.get_close_matches(name, sorted(known), n=1, cutoff=0.6)
    return f" Did you mean {matches[0]!r}?" if matches else ""


def nearest_symbol(key: Any, known: Iterable[Any]) -> str:
    """Return a hint for a key that is none of the known symbols: to give the symbol itself, or the closest name."""
    names = set(map(name_of, known))
    if name_of(key) in names:
        return " Give the model's own symbol, not its name or another symbol of that name."
    return nearest(name_of(key), names)


def pairs_of(given: Any, what: str) -> tuple[tuple[Any, Any], ...]:
    """Return a mapping, or a sequence of pairs, as a tuple of pairs in the same order."""
    if isinstance(given, Mapping):
        return tuple(given.items())
    if isinstance(given, Set) or not isinstance(given, Sequence) or any(not _is_pair(entry) for entry in given):
        raise ModelError(f"{what} must be a mapping or a sequence of pairs, not {shown(given)}.")
    return tuple((key, value) for key, value in given)


def sequence_of(given: Any, what: str) -> tuple[Any, ...]:
    """Return a sequence as a tuple; sets and mappings are refused, since a model relies on the order."""
    if isinstance(given, sympy.MatrixBase):
        return tuple(given)
    if isinstance(given, (str, bytes, Mapping, Set)) or not isinstance(given, Iterable):
        raise ModelError(f"{what} must be a list or tuple, not {shown(given)}: the order counts.")
    try:
        return tuple(given)
    except TypeError as error:  # objects that only look iterable, such as a class or an array of dimension 0
        raise ModelError(f"{what} must be a list or tuple, not {shown(given)}.") from error


def expression(given: Any, what: str) -> sympy.Expr:
    """Return a scalar SymPy expression with derivatives evaluated and exponents exact.

    Raises
    ------
    ModelError
        It is no expression (a string, a matrix, a truth value), not real, or not finite.
    """
    try:
        value = sympy.sympify(given, strict=True)
    except Exception as error:  # SympifyError, or whatever SymPy raises on the elements of containers
        raise ModelError(
            f"{what} is {shown(given)}, which is not a SymPy expression. Build it from symbols."
        ) from error
    if not isinstance(value, sympy.Expr) or isinstance(value, sympy.MatrixBase) or value.is_Matrix:
        raise ModelError(f"{what} is {shown(given)}, which is not a scalar expression.")
    if value.has(sympy.I) or isinstance(given, complex):
        raise ModelError(f"{what} contains the imaginary unit. Energies, forces and constraints are real.")
    if value.has(*INFINITE):
        raise ModelError(f"{what} contains an infinite or undefined term. Look for a division by zero in it.")
    if value.has(*_UNEVALUATED):
        unevaluated = next(part for part in sympy.preorder_traversal(value) if isinstance(part, _UNEVALUATED))
        raise ModelError(
            f"{what} contains {shown(unevaluated)}, which is not carried out. Write what .doit() makes of it."
        )
    for constant in value.atoms(sympy.Number):
        if _is_lost(constant):
            raise ModelError(f"{what} contains {shown(constant)}, beyond the range of a double. Choose other units.")
    return _exact_exponents(_evaluated(_rewritten(_real(value))))


def real(given: Any, what: str) -> float:
    """Return a number as a float, infinity and NaN included; SymPy numbers such as pi/6 are rounded once.

    Raises
    ------
    ModelError
        It is a text, a truth value, a complex number, an array, or too large for a float; shows it.
    """
    if isinstance(given, float):  # numpy.float64 included
        return float(given)
    if not _is_real(given):
        raise ModelError(f"{what} is {shown(given)}, not a real number.")
    try:
        value = float(given.evalf(30) if isinstance(given, sympy.Expr) else given)
    except OverflowError as error:
        raise ModelError(f"{what} is {shown(given)}, beyond the range of a double.") from error
    except (TypeError, ValueError, ArithmeticError) as error:
        raise ModelError(f"{what} is {shown(given)}, not a real number.") from error
    if math.isinf(value) and given != value:
        raise ModelError(f"{what} is {shown(given)}, beyond the range of a double.")
    return value


def number(given: Any, what: str) -> float:
    """Return a number as a finite float; like `real`, but infinity and NaN are refused too."""
    value = real(given, what)
    if not math.isfinite(value):
        raise ModelError(f"{what} is {value}, not a finite number.")
    return value


def truth(given: Any, what: str) -> bool:
    """Return True or False; 1 and 0 are accepted too."""
    if given is True or given is False:
        return given
    is_numpy = getattr(getattr(given, "dtype", None), "kind", "") == "b" and not getattr(given, "ndim", 0)
    if not ((isinstance(given, int) and given in (0, 1)) or is_numpy):
        raise ModelError(f"{what} is {shown(given)}; give True or False.")
    return bool(given)


def _is_real(given: Any) -> bool:
    """Whether `float` may convert this; it would also parse texts, accept truth values and drop imaginary parts."""
    if isinstance(given, (bool, str, bytes, bytearray)) or getattr(given, "ndim", 0) != 0:
        return False
    if isinstance(given, numbers.Complex) and not isinstance(given, (numbers.Real, sympy.Expr)):
        return False
    return getattr(getattr(given, "dtype", None), "kind", "f") in "fiuO"


def _is_lost(constant: sympy.Number) -> bool:
    """Whether a finite nonzero constant overflows or underflows as a double."""
    try:
        value = float(constant)
    except OverflowError:
        return True
    return math.isinf(value) or (value == 0.0 and not constant.is_zero)


def _is_pair(entry: Any) -> bool:
    return isinstance(entry, Sequence) and not isinstance(entry, str) and len(entry) == 2


def _real(value: sympy.Expr) -> sympy.Expr:
    """Treat all quantities as real: |z|.diff(t), with a z(t) that SymPy takes for complex, becomes sign(z) z.diff(t).

    The derivative of a sign is 0, except where it jumps.
    """
    if not value.has(sympy.re, sympy.im, sympy.conjugate, sympy.sign):
        return value
    for part in (sympy.re, sympy.conjugate):
        value = value.replace(part, lambda inside: inside)
    value = value.replace(sympy.im, lambda _: sympy.S.Zero)
    signs = {rate: sympy.S.Zero for rate in value.atoms(sympy.Derivative) if isinstance(rate.expr, sympy.sign)}
    return value.xreplace(signs)


def _rewritten(value: sympy.Expr) -> sympy.Expr:
    """Rewrite functions that C lacks: Mod(a, b) as a - b floor(a / b), sec(a) as 1 / cos(a)."""
    if not value.has(*_REWRITTEN):
        return value
    return value.replace(lambda part: type(part) in _REWRITTEN, lambda part: _REWRITTEN[type(part)](*part.args))


def _evaluated(value: sympy.Expr) -> sympy.Expr:
    """Evaluate derivatives such as Derivative(L*r, t) and Derivative(r, r); time derivatives of functions remain."""
    rates = value.atoms(sympy.Derivative)
    unevaluated = any(not isinstance(rate.expr, AppliedUndef) or {*rate.variables} != {t} for rate in rates)
    return value.doit() if unevaluated else value


def _exact_exponents(value: sympy.Expr) -> sympy.Expr:
    """Replace exponents such as 2.0 and 0.5 by 2 and 1/2: only then is the derivative of v**2.0 simply 2 v."""
    if not any(_is_rounded(power) for power in value.atoms(sympy.Pow)):
        return value
    return value.replace(_is_rounded, lambda power: sympy.Pow(power.base, sympy.Rational(int(2 * power.exp), 2)))


def _is_rounded(value: sympy.Basic) -> bool:
    """Whether this is a power whose exponent is a floating-point multiple of 1/2."""
    return bool(value.is_Pow and value.exp.is_Float and (2 * float(value.exp)).is_integer())
