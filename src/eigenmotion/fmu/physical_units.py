"""Physical units of variables, as exponents of SI's base units."""

import re
from collections.abc import Collection, Iterable, Mapping
from math import pi
from typing import NamedTuple

from ..codegen.model import ModelError

BASE = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")
"""The base units of FMI; an angle is one of them."""

_DERIVED: Mapping[str, tuple[float, Mapping[str, int]]] = {
    "1": (1.0, {}),
    "g": (1e-3, {"kg": 1}),
    "N": (1.0, {"kg": 1, "m": 1, "s": -2}),
    "J": (1.0, {"kg": 1, "m": 2, "s": -2}),
    "W": (1.0, {"kg": 1, "m": 2, "s": -3}),
    "Pa": (1.0, {"kg": 1, "m": -1, "s": -2}),
    "Hz": (1.0, {"s": -1}),
    "C": (1.0, {"A": 1, "s": 1}),
    "V": (1.0, {"kg": 1, "m": 2, "s": -3, "A": -1}),
    "Ohm": (1.0, {"kg": 1, "m": 2, "s": -3, "A": -2}),
    "F": (1.0, {"kg": -1, "m": -2, "s": 4, "A": 2}),
    "H": (1.0, {"kg": 1, "m": 2, "s": -2, "A": -2}),
    "T": (1.0, {"kg": 1, "s": -2, "A": -1}),
    "Wb": (1.0, {"kg": 1, "m": 2, "s": -2, "A": -1}),
    "deg": (pi / 180, {"rad": 1}),
    "rev": (2 * pi, {"rad": 1}),
    "min": (60.0, {"s": 1}),
    "h": (3600.0, {"s": 1}),
}
_PREFIXES: Mapping[str, float] = {"": 1.0, "k": 1e3, "M": 1e6, "G": 1e9, "c": 1e-2, "m": 1e-3, "u": 1e-6, "n": 1e-9}
_FACTOR = re.compile(r"\s*([*/]?)\s*([A-Za-z1]+)(?:\^(-?\d+))?\s*")


class PhysicalUnit(NamedTuple):
    """A unit by its name: `factor` of the product of SI's base units with these exponents.

    is_known : False for a word of the user of which nothing else is known
    """

    name: str
    factor: float
    exponents: tuple[tuple[str, int], ...]
    is_known: bool = True


def physical_unit(text: str) -> PhysicalUnit:
    """Return the unit that a text such as N*m, kg*m^2 or rad/s names.

    Raises
    ------
    ModelError
        It is no product of known units.

    Examples
    --------
    >>> physical_unit("N*m/rad").exponents
    (('kg', 1), ('m', 2), ('s', -2), ('rad', -1))
    """
    factor, powers, at = 1.0, dict.fromkeys(BASE, 0), 0
    while at < len(text) or at == 0:
        found = _FACTOR.match(text, at)
        if found is None or (at == 0) == bool(found[1]):
            raise ModelError(f"{text!r} is no physical unit: give a product such as N*m, kg*m^2 or rad/s")
        power = int(found[3] or 1) * (-1 if found[1] == "/" else 1)
        size, exponents = _one(found[2], text)
        factor *= size**power
        for base, exponent in exponents.items():
            powers[base] += exponent * power
        at = found.end()
    return PhysicalUnit(text, factor, tuple((base, power) for base, power in powers.items() if power))


def _one(name: str, text: str) -> tuple[float, Mapping[str, int]]:
    """Return factor and exponents of a unit without powers, which may have a prefix."""
    for prefix, size in _PREFIXES.items():
        rest = name.removeprefix(prefix) if name.startswith(prefix) else ""
        if rest in _DERIVED:
            factor, exponents = _DERIVED[rest]
            return size * factor, exponents
        if rest in BASE:
            return size, {rest: 1}
    known = ", ".join((*BASE, *_DERIVED))
    raise ModelError(f"{text!r}: {name} is no unit; known are {known}, and these with k, M, G, c, m, u, n before them")


def units_of(names: Iterable[str], words: Collection[str] = ()) -> tuple[PhysicalUnit, ...]:
    """Return each unit that is named, once; those of `words` may be any text, as FMI allows.

    Raises
    ------
    ModelError
        A name that is no word is no product of known units.
    """
    return tuple(_unit(name, name in words) for name in sorted({name for name in names if name}))


def _unit(name: str, is_word: bool) -> PhysicalUnit:
    try:
        return physical_unit(name)
    except ModelError:
        if not is_word:
            raise
        return PhysicalUnit(name, 1.0, (), is_known=False)


def rate_of(name: str, order: int = 1) -> str:
    """Return the name of a unit per second, or per second squared; "" stays "".

    Examples
    --------
    >>> rate_of("rad"), rate_of("rad", 2), rate_of("")
    ('rad/s', 'rad/s^2', '')
    """
    return name and f"{name}/s" + (f"^{order}" if order > 1 else "")
