"""Values given by name: overlaid on defaults, with unknown names refused in words that help."""

from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .codegen.model import ModelError

Vector = NDArray[np.float64]


def spelled(key: object) -> str:
    """Return the name of a key: a string, or a SymPy symbol or function of time."""
    return str(key).removesuffix("(t)")


def unknown(what: str, names: Iterable[str], known: Sequence[str]) -> str:
    """Say which names are not known, which are, and which is nearest."""
    wrong = sorted(names)
    near = [match for name in wrong for match in get_close_matches(name, known, n=1)]
    listed = ", ".join(known) if known else "there are none"
    hint = f" Did you mean {', '.join(repr(name) for name in near)}?" if near else ""
    return f"unknown {what} {', '.join(repr(name) for name in wrong)}; known: {listed}.{hint}"


def by_name(given: Mapping[Any, Any], known: Sequence[str], what: str) -> dict[str, Any]:
    """Return the mapping with its keys as strings.

    Raises
    ------
    ModelError
        A key is not among `known`; names it, the known ones and the nearest.
    """
    named = {spelled(key): value for key, value in given.items()}
    if wrong := named.keys() - set(known):
        raise ModelError(unknown(what, wrong, known))
    return named


def overlay(given: Mapping[Any, Any] | ArrayLike | None, names: Sequence[str], defaults: Vector, what: str) -> Vector:
    """Return one number for each name: from an array in their order, or from a mapping over the defaults.

    Raises
    ------
    ModelError
        An unknown name, a wrong shape, or something that is not a finite number; names it.
    """
    values = defaults.copy()
    if given is None:
        return values
    if isinstance(given, Mapping):
        for name, value in by_name(given, names, what).items():
            values[list(names).index(name)] = _number(value, what, name)
    else:
        values = _array(given, what)
    if values.shape != (len(names),):
        raise ModelError(f"{what}: an array of shape {values.shape}, but {len(names)} are needed: {', '.join(names)}")
    if not all(map(isfinite, values.tolist())):  # quicker than NumPy for as many numbers as a mechanism has
        raise ModelError(f"{what} {names[int(np.argmin(np.isfinite(values)))]!r} is not a finite number")
    return values


def _number(value: object, what: str, name: str) -> float:
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError) as error:
        raise ModelError(f"{what} {name!r} is {value!r}, not a number") from error


def reals(given: ArrayLike, what: str) -> Vector:
    """Return a copy as float64.

    Raises
    ------
    ModelError
        The numbers are complex: NumPy would drop their imaginary parts.
    """
    if np.iscomplexobj(given):
        raise ModelError(f"{what} is complex; give real numbers")
    return np.array(given, dtype=np.float64)


def _array(given: ArrayLike, what: str) -> Vector:
    try:
        return reals(given, what)
    except ModelError:
        raise
    except (TypeError, ValueError) as error:
        raise ModelError(f"{what}: {given!r} is neither a mapping of names nor an array of numbers") from error
