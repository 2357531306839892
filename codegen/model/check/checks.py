"""Checks of a model before its equations are derived. Each failure is a ModelError with name, symbol and remedy."""

from __future__ import annotations

import keyword
from typing import TYPE_CHECKING, Any

import sympy
from sympy.core.function import AppliedUndef

from ..normalise import ModelError, name_of, nearest_symbol, shown, t
from ..statement.contacts import Contact, Friction
from ..statement.states import check_states
from .allowed_symbols import check_symbols, declared
from .assumptions import check_assumptions
from .degree import has_degree
from .elimination import is_singular

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..statement.mechanism import Mechanism


LONGEST_NAME = 200
"""File systems allow 255 bytes; the suffixes of extension modules and of temporary files need some of them."""
_LARGEST_SCALE = 1e50  # the product of two scales and a mass, squared, stays within the range of a double


def check_name(name: Any) -> None:
    """Raise unless the name is valid for files, as a Python module and as a prefix of C symbols."""
    if not isinstance(name, str) or not name.isidentifier() or not name.isascii() or keyword.iskeyword(name):
        raise ModelError(
            f"Model {shown(name)}: its name becomes that of a file, a Python module and a prefix in C. "
            "Use letters, digits and underscores, not starting with a digit, and no keyword of Python."
        )
    if len(name) > LONGEST_NAME:
        raise ModelError(
            f"Model {name!r}: its name has {len(name)} characters, and those of its files are longer. "
            f"Use at most {LONGEST_NAME}."
        )
    if name.startswith("__"):
        raise ModelError(f"Model {name!r}: names with two underscores in front belong to C and Python. Choose another.")
    if name in ("cython", "em", "eigenmotion") or name.startswith("em_"):
        raise ModelError(f"Model {name!r}: what it is built with has that name. Choose another.")


def check(model: Mechanism) -> None:
    """Raise ModelError at the first mistake found."""
    check_functions_of_time("inputs", [u for u, _ in model.inputs])
    check_functions_of_time("quasi_velocities", [y for y, _ in model.quasi_velocities])
    check_states(model)
    _check_parameters(model)
    _check_names(model)
    _check_initial(model)
    check_assumptions(model)
    _check_scales(model)
    check_symbols(model)
    _check_quasi_velocities(model)
    _check_degrees(model)
    _check_masses(model)
    _check_contacts(model)
    _check_rows(model)
    _check_events(model)


def solve_rates(model: Mechanism, x: Iterable[float], y: Iterable[float]) -> tuple[float, ...]:
    """Return xdot = P(x)^-1 y (3) at the default parameters and t = 0, to rounding.

    Raises
    ------
    ModelError
        P is singular at x.
    """
    at = {x_i: sympy.Float(value, 30) for x_i, value in zip(model.coordinates, x, strict=True)}
    P, y_column = _transformation(model, at), sympy.Matrix([sympy.Float(entry, 30) for entry in y])
    if is_singular(P.tolist(), _terms(model, at).tolist(), 1e-14):
        raise ModelError(
            f"Model {model.name!r}: initial gives quasi-velocities, but P of y = P(x) xdot is singular at the initial "
            "coordinates. Start elsewhere, or choose other coordinates."
        )
    return tuple(map(float, P.LUsolve(y_column)))


def _transformation(model: Mechanism, at: dict[sympy.Expr, sympy.Float]) -> sympy.Matrix:
    """Return P(x) as numbers of 30 digits."""
    return _in_numbers(model, _symbolic_transformation(model), at)


def _terms(model: Mechanism, at: dict[sympy.Expr, sympy.Float]) -> sympy.Matrix:
    """Return (n, n) |P_ij| + sum_k |x_k dP_ij / dx_k|, to which the rounding errors of P and x are proportional."""
    P = _symbolic_transformation(model)
    parts = [P, *(x * P.diff(x) for x in model.coordinates)]
    sizes = [_in_numbers(model, part, at).applyfunc(abs) for part in parts]
    return sum(sizes[1:], sizes[0])


def _symbolic_transformation(model: Mechanism) -> sympy.Matrix:
    return sympy.Matrix([[expression.coeff(v) for v in model.rates] for _, expression in _expanded(model)])


def _in_numbers(model: Mechanism, matrix: sympy.Matrix, at: dict[sympy.Expr, sympy.Float]) -> sympy.Matrix:
    values = {symbol: sympy.Float(value, 30) for symbol, value in [*model.parameters, (t, 0.0)]}
    return matrix.xreplace(at | values).evalf(30)


def _expanded(model: Mechanism) -> list[tuple[sympy.Expr, sympy.Expr]]:
    return [(y, sympy.expand(expression)) for y, expression in model.quasi_velocities]


def check_functions_of_time(kind: str, symbols: Iterable[Any]) -> None:
    """Check that each coordinate, input or quasi-velocity is a function of time.

    Raises
    ------
    ModelError
        One is not, which is shown with the remedy; or there are no coordinates.
    """
    for symbol in symbols:
        if not isinstance(symbol, AppliedUndef) or symbol.args != (t,):
            name = name_of(symbol) if isinstance(symbol, sympy.Symbol) else symbol if isinstance(symbol, str) else "q"
            raise ModelError(
                f"{kind} contains {shown(symbol)}, which is not a function of time. "
                f"Make it with dynamicsymbols({name!r})."
            )
    if kind == "coordinates" and not symbols:
        raise ModelError("coordinates is empty. A mechanism has at least one.")


def _check_parameters(model: Mechanism) -> None:
    for symbol, _ in model.parameters:
        if not isinstance(symbol, sympy.Symbol):
            raise ModelError(f"parameters contains {shown(symbol)}, which is not a Symbol. Make it with sympy.symbols.")


def _check_names(model: Mechanism) -> None:
    """Check that names are unique, and that none is the name of the time symbol."""
    seen: dict[str, tuple[str, sympy.Expr]] = {t.name: ("the time", t)}
    for kind, symbol in declared(model):
        name = name_of(symbol)
        if name in seen:
            other, first = seen[name]
            raise ModelError(_clash(kind, name, other, same=symbol == first))
        seen[name] = (kind, symbol)
        _check_text(kind, name)
    for what, entries in (("outputs", model.outputs), ("events", model.events)):
        for name in (entry[0] for entry in entries):
            if not isinstance(name, str) or not name:
                raise ModelError(f"{what} has an entry named {shown(name)}. Name it by a text.")
            _check_text(what, name)
    for what, names in _keys(model):
        for name in sorted({name for name in names if names.count(name) > 1}):
            raise ModelError(f"{what} has two entries for {name!r}. Keep one.")


def _check_text(what: str, name: str) -> None:
    """Raise where a name has characters that a file or a C string cannot hold."""
    if "\0" in name or any("\ud800" <= char <= "\udfff" for char in name):
        raise ModelError(f"{what} has an entry named {name!r}, with a character that no text of C holds. Rename it.")


def _clash(kind: str, name: str, other: str, same: bool) -> str:
    if other == "the time":
        return f"{kind} {name!r} is named like the time, eigenmotion.t. Rename it."
    if same:
        return f"{name!r} is named twice: as {other} and as {kind}. Keep one of them."
    return f"two different symbols have the name {name!r}: {other} and {kind}. Rename one of them."


def _keys(model: Mechanism) -> tuple[tuple[str, list[str]], ...]:
    return (
        ("initial", [name_of(key) for key, _ in model.initial]),
        ("outputs", [name for name, _ in model.outputs]),
        ("events", [name for name, _ in model.events]),
    )


def _check_initial(model: Mechanism) -> None:
    quasi = [y for y, _ in model.quasi_velocities]
    allowed = {*model.coordinates, *model.rates, *quasi, *(z for z, _ in model.states)}
    for key, _ in model.initial:
        if not isinstance(key, sympy.Basic) or key not in allowed:
            hint = nearest_symbol(key, allowed)
            raise ModelError(
                f"initial has a value for {shown(key)}, which is neither a coordinate nor a rate, nor a state.{hint}"
            )
    given = {key for key, _ in model.initial}
    if given & set(model.rates) and given & set(quasi):
        raise ModelError("initial gives both rates and quasi-velocities. Give the velocities in one of the two.")


def _check_scales(model: Mechanism) -> None:
    for x, scale in zip(model.coordinates, model.scales, strict=True):
        if scale <= 0:
            raise ModelError(f"scales[{name_of(x)}] is {scale}. A scale is the positive unit of a coordinate.")
        if not 1 / _LARGEST_SCALE <= scale <= _LARGEST_SCALE:
            raise ModelError(
                f"scales[{name_of(x)}] is {scale}. The equations multiply scales: keep them between "
                f"{1 / _LARGEST_SCALE:g} and {_LARGEST_SCALE:g}, or choose other units of the coordinate."
            )


def _check_quasi_velocities(model: Mechanism) -> None:
    if not model.quasi_velocities:
        return
    if len(model.quasi_velocities) != model.n:
        count = len(model.quasi_velocities)
        raise ModelError(
            f"quasi_velocities has {count} entries for {model.n} coordinates. P in y = P(x) xdot is square."
        )
    at_rest = dict.fromkeys(model.rates, sympy.Integer(0))
    for y, expression in model.quasi_velocities:
        if not has_degree(expression, model.rates, 1) or sympy.expand(expression.xreplace(at_rest)) != 0:
            raise ModelError(f"quasi_velocities[{name_of(y)}] is not linear in the rates: y = P(x) xdot (3).")
    # a generic point: a P that is singular there is, barring coincidence, singular everywhere
    generic = {x: sympy.Float(0.37 + 0.61 * k) for k, x in enumerate(model.coordinates)}
    P = _transformation(model, generic)
    if is_singular(P.tolist(), P.applyfunc(abs).tolist(), 1e-20):
        raise ModelError("quasi_velocities are not independent: P in (3) is singular. Change one of them.")


def _check_degrees(model: Mechanism) -> None:
    velocities = (*model.rates, *(y for y, _ in model.quasi_velocities))
    T = model.kinetic_energy
    if not has_degree(T, velocities, 2):
        worst = [v for v in velocities if not has_degree(T, [v], 2)] or [v for v in velocities if T.has(v)]
        raise ModelError(
            "kinetic_energy is not a polynomial of at most second degree in the velocities (4): "
            f"look at {', '.join(map(name_of, worst))}."
        )
    for k, row in enumerate(model.nonholonomic_constraints):
        if not has_degree(row, velocities, 1):
            raise ModelError(f"nonholonomic_constraints[{k}] is not linear in the velocities (8): {row}.")


def _check_masses(model: Mechanism) -> None:
    """Check that each coordinate has mass, or occurs in a constraint, which then determines its acceleration."""
    T = model.in_rates(model.kinetic_energy)
    rows = [phi.diff(t) for phi in model.holonomic_constraints]
    rows += [model.in_rates(row) for row in model.nonholonomic_constraints]
    for x, v in zip(model.coordinates, model.rates, strict=True):
        if not (T.has(v) or any(row.has(v) for row in rows)):
            raise ModelError(
                f"kinetic_energy does not contain the rate of {name_of(x)!r}: the mass matrix is singular. Give what "
                "moves with this coordinate a mass, hold it by a constraint, or, if it has a rate of its own, put it "
                "under states."
            )


def _check_events(model: Mechanism) -> None:
    """Check that events can occur; resets name coordinates, and either rates or quasi-velocities; impacts have one."""
    parameters = {symbol for symbol, _ in model.parameters}
    quasi = [y for y, _ in model.quasi_velocities]
    allowed = {*model.coordinates, *model.rates, *quasi, *(z for z, _ in model.states)}
    for name, event in model.events:
        keys = [key for key, _ in event.reset]
        for key in keys:
            if not isinstance(key, sympy.Basic) or key not in allowed:
                hint = nearest_symbol(key, allowed)
                raise ModelError(
                    f"reset of events[{name}] has an entry for {shown(key)}, which is neither a coordinate nor a "
                    f"velocity of the model.{hint}"
                )
            if keys.count(key) > 1:
                raise ModelError(f"reset of events[{name}] has two entries for {name_of(key)!r}. Keep one.")
        if set(keys) & set(model.rates) and set(keys) & set(quasi):
            raise ModelError(
                f"reset of events[{name}] gives both rates and quasi-velocities. Give the velocities in one of the two."
            )
        if event.expression.free_symbols <= parameters:
            raise ModelError(
                f"events[{name}] contains neither the time nor anything that moves: {event.expression}. It never "
                "occurs."
            )
        if event.impact and not event.impact[0].has(*model.coordinates):
            raise ModelError(f"phi of the impact of events[{name}] contains no coordinate: {event.impact[0]}.")


def _check_contacts(model: Mechanism) -> None:
    velocities = (*model.rates, *(y for y, _ in model.quasi_velocities))
    for name, entry in model.contacts:
        if isinstance(entry, Contact) and not entry.gap.has(*model.coordinates):
            raise ModelError(f"gap of contacts[{name}] contains no coordinate: {entry.gap}. Nothing can close it.")
        for slip in entry.slips if isinstance(entry, Friction) else ():
            if not (slip.has(*velocities) and has_degree(slip, velocities, 1)):
                raise ModelError(f"slip of contacts[{name}] is not linear in the velocities (8): {slip}.")


def _check_rows(model: Mechanism) -> None:
    velocities = {*model.rates, *(y for y, _ in model.quasi_velocities)}
    for k, phi in enumerate(model.holonomic_constraints):
        if not phi.has(*model.coordinates):
            raise ModelError(f"holonomic_constraints[{k}] contains no coordinate: {phi}. It constrains nothing.")
    for k, row in enumerate(model.nonholonomic_constraints):
        if not row.has(*velocities):
            raise ModelError(
                f"nonholonomic_constraints[{k}] contains no velocity: {row}. A constraint on the coordinates alone is "
                "stated under holonomic_constraints."
            )
