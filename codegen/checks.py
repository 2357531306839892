"""Every check of a model that needs no derivation. Each failure is a ModelError with name, symbol and remedy."""

from __future__ import annotations

import keyword
from typing import TYPE_CHECKING, Any

import sympy
from sympy.core.function import AppliedUndef

from .degree import has_degree
from .normalise import MULTIPLIER, ModelError, name_of, nearest, t

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .model import Model

SAME_OBJECT = "Create it once and use that same object everywhere."


def check_name(name: Any) -> None:
    """Raise unless the name serves as file, module and symbol prefix, in C and in Python."""
    if not isinstance(name, str) or not name.isidentifier() or not name.isascii() or keyword.iskeyword(name):
        raise ModelError(
            f"Model {name!r}: its name becomes that of a file, a Python module and a prefix in C. "
            "Use letters, digits and underscores, not starting with a digit, and no keyword of Python."
        )


def check(model: Model) -> None:
    """Raise ModelError at the first mistake found."""
    _check_functions_of_time(model)
    _check_parameters(model)
    _check_names(model)
    _check_initial(model)
    _check_scales(model)
    for what, expression, allowed in _expressions(model):
        _check_symbols(model, what, expression, allowed)
    _check_quasi_velocities(model)
    _check_degrees(model)
    _check_masses(model)
    _check_rows(model)


def solve_rates(model: Model, x: Iterable[float], y: Iterable[float]) -> tuple[float, ...]:
    """Return xdot = P(x)^-1 y (3) at the default parameters and t = 0, to rounding.

    Raises
    ------
    ModelError
        P is singular at x.
    """
    at = {x_i: sympy.Float(value, 30) for x_i, value in zip(model.coordinates, x, strict=True)}
    P, y_column = _transformation(model, at), sympy.Matrix([sympy.Float(entry, 30) for entry in y])
    if abs(P.det()) < 1e-14:
        raise ModelError(
            f"Model {model.name!r}: initial gives quasi-velocities, but P of y = P(x) xdot is singular at the initial "
            "coordinates. Start elsewhere, or choose other coordinates."
        )
    return tuple(map(float, P.LUsolve(y_column)))


def _transformation(model: Model, at: dict[sympy.Expr, sympy.Float]) -> sympy.Matrix:
    """P(x) in numbers of 30 digits."""
    values = {symbol: sympy.Float(value, 30) for symbol, value in [*model.parameters, (t, 0.0)]}
    rows = [[expression.coeff(v) for v in model.rates] for _, expression in _expanded(model)]
    return sympy.Matrix(rows).xreplace(at | values).evalf(30)


def _expanded(model: Model) -> list[tuple[sympy.Expr, sympy.Expr]]:
    return [(y, sympy.expand(expression)) for y, expression in model.quasi_velocities]


def _check_functions_of_time(model: Model) -> None:
    kinds = (
        ("coordinates", model.coordinates),
        ("inputs", [u for u, _ in model.inputs]),
        ("quasi_velocities", [y for y, _ in model.quasi_velocities]),
    )
    for kind, symbols in kinds:
        for symbol in symbols:
            if not isinstance(symbol, AppliedUndef) or symbol.args != (t,):
                raise ModelError(
                    f"{kind} contains {symbol!r}, which is not a function of time. "
                    f"Make it with dynamicsymbols({str(name_of(symbol))!r})."
                )
    if not model.coordinates:
        raise ModelError("coordinates is empty. A mechanism has at least one.")


def _check_parameters(model: Model) -> None:
    for symbol, _ in model.parameters:
        if not isinstance(symbol, sympy.Symbol):
            raise ModelError(f"parameters contains {symbol!r}, which is not a Symbol. Make it with sympy.symbols.")


def _check_names(model: Model) -> None:
    """One name, one symbol; none named like the time."""
    seen: dict[str, tuple[str, sympy.Expr]] = {t.name: ("the time", t)}
    for kind, symbol in _declared(model):
        name = name_of(symbol)
        if name in seen:
            other, first = seen[name]
            raise ModelError(_clash(kind, name, other, same=symbol == first))
        seen[name] = (kind, symbol)
    for what, entries in (("outputs", model.outputs), ("events", model.events)):
        for name in (entry[0] for entry in entries):
            if not isinstance(name, str) or not name:
                raise ModelError(f"{what} has an entry named {name!r}. Name it by a text.")
    for what, names in _keys(model):
        for name in sorted({name for name in names if names.count(name) > 1}):
            raise ModelError(f"{what} has two entries for {name!r}. Keep one.")


def _clash(kind: str, name: str, other: str, same: bool) -> str:
    if other == "the time":
        return f"{kind} {name!r} is named like the time, eigenmotion.t. Rename it."
    if same:
        return f"{name!r} is named twice: as {other} and as {kind}. Keep one of them."
    return f"two different symbols have the name {name!r}: {other} and {kind}. Rename one of them."


def _declared(model: Model) -> list[tuple[str, sympy.Expr]]:
    return [
        *(("coordinate", x) for x in model.coordinates),
        *(("quasi-velocity", y) for y, _ in model.quasi_velocities),
        *(("input", u) for u, _ in model.inputs),
        *(("parameter", p) for p, _ in model.parameters),
    ]


def _keys(model: Model) -> tuple[tuple[str, list[str]], ...]:
    return (
        ("initial", [name_of(key) for key, _ in model.initial]),
        ("outputs", [name for name, _ in model.outputs]),
        ("events", [name for name, _ in model.events]),
    )


def _check_initial(model: Model) -> None:
    quasi = [y for y, _ in model.quasi_velocities]
    allowed = {*model.coordinates, *model.rates, *quasi}
    for key, _ in model.initial:
        if key not in allowed:
            hint = nearest(name_of(key), map(name_of, allowed))
            raise ModelError(f"initial has a value for {key!r}, which is neither a coordinate nor a rate.{hint}")
    given = {key for key, _ in model.initial}
    if given & set(model.rates) and given & set(quasi):
        raise ModelError("initial gives both rates and quasi-velocities. Give the velocities in one of the two.")


def _check_scales(model: Model) -> None:
    for x, scale in zip(model.coordinates, model.scales, strict=True):
        if scale <= 0:
            raise ModelError(f"scales[{name_of(x)}] is {scale}. A scale is the positive unit of a coordinate.")


def _expressions(model: Model) -> list[tuple[str, sympy.Expr, frozenset[str]]]:
    """Every expression of the model: what it is called, and what beside x, t and parameters it may contain."""
    moving = frozenset({"rates", "quasi"})
    anything = moving | {"inputs"}
    return [
        ("kinetic_energy", model.kinetic_energy, moving),
        ("potential_energy", model.potential_energy, frozenset()),
        *((f"forces[{name_of(x)}]", Q, anything) for x, Q in zip(model.coordinates, model.forces, strict=True)),
        *((f"holonomic_constraints[{k}]", phi, frozenset()) for k, phi in enumerate(model.holonomic_constraints)),
        *((f"nonholonomic_constraints[{k}]", row, moving) for k, row in enumerate(model.nonholonomic_constraints)),
        *((f"quasi_velocities[{name_of(y)}]", row, frozenset({"rates"})) for y, row in model.quasi_velocities),
        *((f"outputs[{name}]", out, anything | {"accelerations", "multipliers"}) for name, out in model.outputs),
        *((f"events[{name}]", event.expression, anything) for name, event in model.events),
    ]


def _check_symbols(model: Model, what: str, expression: sympy.Expr, allowed: frozenset[str]) -> None:
    known = {symbol: kind for kind, symbol in _declared(model)}
    rates = expression.atoms(sympy.Derivative)
    for rate in sorted(rates, key=name_of):
        _check_rate(what, rate, known.get(rate.expr), allowed)
    for function in sorted(expression.atoms(AppliedUndef), key=name_of):
        _check_function(model, what, function, known, allowed)
    for symbol in sorted(expression.atoms(sympy.Symbol), key=name_of):
        if symbol != t and known.get(symbol) != "parameter":
            raise ModelError(_unknown(model, what, symbol))


def _check_rate(what: str, rate: sympy.Derivative, kind: str | None, allowed: frozenset[str]) -> None:
    order = int(rate.derivative_count)
    if kind is None or rate.variables != (t,) * order:
        return  # an unknown function is named by _check_function
    if kind == "input":
        raise ModelError(f"{what} contains the rate of the input {name_of(rate.expr)!r}. Make the rate its own input.")
    order += kind == "quasi-velocity"
    if order == 1 and "rates" not in allowed:
        raise ModelError(f"{what} contains the velocity {name_of(rate)}. {_remedy_for_velocity(what)}")
    if order > 2 or (order == 2 and "accelerations" not in allowed):
        raise ModelError(
            f"{what} contains {name_of(rate)}, a derivative of higher order. "
            "Only outputs may use accelerations, and nothing beyond them."
        )


def _remedy_for_velocity(what: str) -> str:
    if what.startswith("holonomic"):
        return "State it under nonholonomic_constraints."
    if what.startswith("potential"):
        return "What depends on velocities belongs to kinetic_energy or forces."
    return "State it in the rates of the coordinates where those are allowed."


def _check_function(
    model: Model, what: str, function: sympy.Expr, known: dict[sympy.Expr, str], allowed: frozenset[str]
) -> None:
    if function.func == MULTIPLIER:
        _check_multiplier(model, what, function, allowed)
        return
    kind = known.get(function)
    if kind is None:
        raise ModelError(_unknown(model, what, function))
    if kind == "input" and "inputs" not in allowed:
        raise ModelError(f"{what} contains the input {name_of(function)!r}. Let it act through forces.")
    if kind == "quasi-velocity" and "quasi" not in allowed:
        raise ModelError(f"{what} contains the quasi-velocity {name_of(function)!r}. {_remedy_for_velocity(what)}")


def _check_multiplier(model: Model, what: str, function: sympy.Expr, allowed: frozenset[str]) -> None:
    if "multipliers" not in allowed:
        raise ModelError(f"{what} contains a multiplier. Only outputs may use them.")
    if not 0 <= function.args[0] < model.m:
        raise ModelError(f"{what} contains {function}, but the model has {model.m} constraint rows, counted from 0.")


def _unknown(model: Model, what: str, symbol: sympy.Expr) -> str:
    """Return what to say of a symbol that nothing declares."""
    name = name_of(symbol)
    if name == t.name:
        return f"{what} contains a symbol named {name!r} that is not the time. Use eigenmotion.t."
    declared = {name_of(known): kind for kind, known in _declared(model)}
    if name in declared:
        return (
            f"{what} contains {name!r}, a different symbol from the {declared[name]} of that name: two symbols of one "
            f"name differ by their assumptions or by being a function of time. {SAME_OBJECT}"
        )
    where = "coordinates, quasi_velocities or inputs" if isinstance(symbol, AppliedUndef) else "parameters"
    return f"{what} contains {name!r}, which is not declared. Add it to {where}.{nearest(name, declared)}"


def _check_quasi_velocities(model: Model) -> None:
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
    # a place without symmetry: a P singular there is singular everywhere, up to coincidence
    somewhere = {x: sympy.Float(0.37 + 0.61 * k) for k, x in enumerate(model.coordinates)}
    if abs(_transformation(model, somewhere).det()) < 1e-20:
        raise ModelError("quasi_velocities are not independent: P in (3) is singular. Change one of them.")


def _check_degrees(model: Model) -> None:
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


def _check_masses(model: Model) -> None:
    T = model.in_rates(model.kinetic_energy)
    for x, v in zip(model.coordinates, model.rates, strict=True):
        if not T.has(v):
            raise ModelError(
                f"kinetic_energy does not contain the rate of {name_of(x)!r}: the mass matrix is singular. Give what "
                "moves with this coordinate a mass, or take it out of coordinates."
            )


def _check_rows(model: Model) -> None:
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
