"""SymPy's assumptions on symbols, as bits that describe the values allowed at run time.

SymPy simplifies by assumptions: with l declared positive, sqrt(l**2) becomes l. A negative value of l would then give
the motion of a different mechanism.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import sympy

from ..normalise import ModelError, name_of

if TYPE_CHECKING:
    from ..statement.mechanism import Mechanism

NEGATIVE, ZERO, POSITIVE, EVEN, ODD, BROKEN = 1, 2, 4, 8, 16, 32
"""The bits of em_assumptions.h; BROKEN: not an integer."""
ANY = 63
_SIGNS = {1: "negative", 2: "zero", 3: "nonpositive", 4: "positive", 5: "nonzero", 6: "nonnegative"}
_KINDS = {EVEN: "even", ODD: "odd", EVEN | ODD: "integer", BROKEN: "not an integer", BROKEN | ODD: "not even",
          BROKEN | EVEN: "not odd"}  # fmt: skip


def allowed(symbol: sympy.Basic) -> int:
    """Return the bits of the values that a symbol may take."""
    excluded = (
        (NEGATIVE, symbol.is_extended_negative is False), (ZERO, symbol.is_zero is False),
        (POSITIVE, symbol.is_extended_positive is False), (BROKEN, bool(symbol.is_integer)),
        (EVEN, symbol.is_even is False or symbol.is_integer is False),
        (ODD, symbol.is_odd is False or symbol.is_integer is False),
    )  # fmt: skip
    return ANY - sum(bit for bit, out in excluded if out)


def declared(bits: int) -> str:
    """Describe the allowed values by SymPy's names of assumptions; "" if any value is allowed."""
    return " and ".join(filter(None, (_SIGNS.get(bits & 7), _KINDS.get(bits & 56))))


def holds(bits: int, value: float) -> bool:
    """Whether a value is allowed by these bits."""
    sign = NEGATIVE if value < 0 else POSITIVE if value > 0 else ZERO
    kind = BROKEN if value != math.floor(value) else EVEN if math.fmod(value, 2.0) == 0.0 else ODD
    return bool(bits & sign) and bool(bits & kind)


def check_assumptions(model: Mechanism) -> None:
    """Raise ModelError where a symbol cannot have a real value, or its value contradicts its assumptions."""
    kinds = (("parameters", model.parameters), ("inputs", model.inputs), ("initial", model.initial))
    for kind, pairs in kinds:
        for symbol, value in pairs:
            _check_real(kind, symbol)
            if not holds(bits := allowed(symbol), value):
                raise ModelError(
                    f"{kind}[{name_of(symbol)}] is {value:g}, but {name_of(symbol)!r} was declared {declared(bits)}, "
                    "by which SymPy simplified what it stands in. Give it such a value, or declare it otherwise."
                )
    for z, _ in model.states:
        if allowed(z) != ANY:
            raise ModelError(
                f"states contains {name_of(z)!r}, declared {declared(allowed(z))}. A state may come to any number, and "
                "nothing keeps it there: declare it without."
            )
    for x in model.coordinates:
        if not holds(bits := allowed(x), dict(model.initial).get(x, 0.0)):
            raise ModelError(
                f"{name_of(x)!r} was declared {declared(bits)}, and without a value in initial it begins at 0. Give it "
                "one, or declare it otherwise."
            )


def _check_real(kind: str, symbol: sympy.Basic) -> None:
    if symbol.is_real is False:
        which = "infinite" if symbol.is_infinite else "imaginary, or not real"
        raise ModelError(
            f"{kind} contains {name_of(symbol)!r}, declared {which}. Its values are real and finite: declare it so."
        )
    if symbol.is_prime or symbol.is_composite:
        which = "prime" if symbol.is_prime else "composite"
        raise ModelError(
            f"{kind} contains {name_of(symbol)!r}, declared {which}, which is not looked at when it is given values. "
            "Declare it integer."
        )
