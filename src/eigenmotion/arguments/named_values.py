"""Values by name: values over defaults, and errors that suggest the nearest known name."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from difflib import get_close_matches
from math import isfinite
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..codegen.model.normalise import ModelError, real, shown

Vector = NDArray[np.float64]


def spelled(key: object) -> str:
    """Return the name of a key: a string, or a SymPy symbol or function of time."""
    return str(key).removesuffix("(t)")


def rate_name(key: object) -> str:
    """Return the name of a key; for the rate of a coordinate, as in `initial`, the name of the coordinate."""
    text = spelled(key)
    rate = re.fullmatch(r"Derivative\((.+)\(t\), t\)", text)
    return rate[1] if rate else text


def unknown(what: str, names: Iterable[str], known: Sequence[str], elsewhere: Mapping[str, str] | None = None) -> str:
    """Return a message with the unknown, known and nearest names, or with our name for another tool's option."""
    wrong, places = sorted(names), elsewhere or {}
    if foreign := [f"in place of {name!r} of SciPy: {places[name]}" for name in wrong if name in places]:
        return f"unknown {what} {', '.join(map(repr, wrong))}; {'; '.join(foreign)}."
    near = [match for name in wrong for match in get_close_matches(name, known, n=1)]
    listed = ", ".join(known) if known else "there are none"
    hint = f" Did you mean {', '.join(repr(name) for name in near)}?" if near else ""
    return f"unknown {what} {', '.join(repr(name) for name in wrong)}; known: {listed}.{hint}"


def is_named(argument: object) -> TypeGuard[Mapping[Any, Any]]:
    """Return whether values have names: a mapping, or a pandas Series or DataFrame with labels that are strings."""
    if isinstance(argument, Mapping):
        return True
    if not (hasattr(argument, "keys") and hasattr(argument, "items")):
        return False
    return any(isinstance(key, str) for key in argument.keys())  # noqa: SIM118  (iterating a Series gives its values)


def by_spelling(argument: Mapping[Any, Any], what: str, spelling: Callable[[object], str] = spelled) -> dict[str, Any]:
    """Return the mapping with its keys as strings. A key given twice, as a string and as a symbol, is an error."""
    spelt = {spelling(key): value for key, value in argument.items()}
    if len(spelt) < len(argument.keys()):
        raise ModelError(f"{what}: one of {', '.join(map(repr, spelt))} is given twice, by name and as a symbol")
    return spelt


def by_name(argument: Mapping[Any, Any], known: Sequence[str], what: str) -> dict[str, Any]:
    """Return the mapping with its keys as strings.

    Raises
    ------
    ModelError
        A key is not among `known` (names it, the known ones and the nearest), or given twice.
    """
    spelt = by_spelling(argument, what)
    if wrong := spelt.keys() - set(known):
        raise ModelError(unknown(what, wrong, known) + _rates_go_elsewhere(wrong, known))
    return spelt


def _rates_go_elsewhere(wrong: Iterable[str], known: Sequence[str]) -> str:
    """Return a hint that rates (named as in `initial` and --set) belong in v0."""
    rates = {name: rate_name(name.removesuffix("'")) for name in sorted(wrong)}
    found = [(name, rate) for name, rate in rates.items() if rate != name and rate in known]
    return "".join(f" {name!r} is a rate: give it as v0={{{rate!r}: ...}}." for name, rate in found)


def overlay(
    argument: Mapping[Any, Any] | ArrayLike | None, names: Sequence[str], defaults: Vector, what: str
) -> Vector:
    """Return one number for each name: from an array in that order, or the defaults updated by a mapping.

    Raises
    ------
    ModelError
        An unknown name, a wrong shape, or something that is not a finite number; names it.
    """
    values = defaults.copy()
    if argument is None:
        return values
    if is_named(argument):
        for name, value in by_name(argument, names, what).items():
            values[list(names).index(name)] = real(value, f"{what} {name!r}")
    else:
        values = vector(argument, what)
    if values.shape != (len(names),):
        raise ModelError(f"{what}: an array of shape {values.shape}, but {len(names)} are needed: {', '.join(names)}")
    if not all(map(isfinite, values.tolist())):  # faster than NumPy for the few numbers of a mechanism
        raise ModelError(f"{what} {names[int(np.argmin(np.isfinite(values)))]!r} is not a finite number")
    return values


def vector(argument: object, what: str) -> Vector:
    """Return real numbers as a new float64 array of the same shape; infinity and NaN are allowed.

    Raises
    ------
    ModelError
        The array is ragged or masked, or contains strings, booleans, complex numbers, objects or too large numbers.
    """
    if type(argument) is np.ndarray and argument.dtype == np.float64:
        return argument.copy()
    try:
        array = np.asarray(argument)
    except Exception as error:  # a ragged array, or an exception of the user's object
        raise ModelError(f"{what} is {shown(argument)}, not an array of real numbers") from error
    if array.dtype.kind == "O" and array.ndim:  # SymPy's numbers, fractions
        numbers = [real(value, f"{what}[{k}]") for k, value in enumerate(array.flat)]
        return np.array(numbers, dtype=np.float64).reshape(array.shape)
    if array.dtype.kind not in "fiu" or _has_truths(argument) or np.ma.isMaskedArray(argument):
        raise ModelError(f"{what} is {shown(argument)}, not an array of real numbers")
    with np.errstate(over="ignore"):  # of long doubles: infinite ones are refused where they are read
        return np.array(array, dtype=np.float64)


def _has_truths(argument: object) -> bool:
    """Return whether a list contains True or False, which NumPy converts to 1 and 0 in a list with numbers."""
    return isinstance(argument, list | tuple) and any(isinstance(value, bool | np.bool_) for value in argument)
