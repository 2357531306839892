"""Check of the symbols in each expression of a model: which kinds (rates, inputs, states, ...) each may contain."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy
from sympy.core.function import AppliedUndef

from ..normalise import MULTIPLIER, ModelError, name_of, nearest, shown, t
from ..statement.contacts import expressions_of

if TYPE_CHECKING:
    from ..statement.mechanism import Mechanism

SAME_OBJECT = "Create it once and use that same object everywhere."


def check_symbols(model: Mechanism) -> None:
    """Raise ModelError at the first symbol that is undeclared, or not allowed in its expression."""
    for what, expression, allowed in _expressions(model):
        _check_expression(model, what, expression, allowed)


def declared(model: Mechanism) -> list[tuple[str, sympy.Expr]]:
    """Return every symbol that the model declares, with its kind."""
    return [
        *(("coordinate", x) for x in model.coordinates),
        *(("quasi-velocity", y) for y, _ in model.quasi_velocities),
        *(("state", z) for z, _ in model.states),
        *(("input", u) for u, _ in model.inputs),
        *(("parameter", p) for p, _ in model.parameters),
    ]


def _expressions(model: Mechanism) -> list[tuple[str, sympy.Expr, frozenset[str]]]:
    """Return every expression of the model: its name, and the kinds it may contain besides x, t and parameters."""
    velocities = frozenset({"rates", "quasi"})
    anything = velocities | {"inputs", "states"}
    in_forces = anything | {"multipliers"} if model.contacts else anything
    return [
        *((what, part, anything if free else frozenset[str]())
          for name, entry in model.contacts for what, part, free in expressions_of(name, entry)),
        ("kinetic_energy", model.kinetic_energy, velocities),
        ("potential_energy", model.potential_energy, frozenset({"states"})),
        *((f"forces[{name_of(x)}]", Q, in_forces) for x, Q in zip(model.coordinates, model.forces, strict=True)),
        *((f"states[{name_of(z)}]", rate, anything | {"multipliers"}) for z, rate in model.states),
        *((f"holonomic_constraints[{k}]", phi, frozenset()) for k, phi in enumerate(model.holonomic_constraints)),
        *((f"nonholonomic_constraints[{k}]", row, velocities) for k, row in enumerate(model.nonholonomic_constraints)),
        *((f"quasi_velocities[{name_of(y)}]", row, frozenset({"rates"})) for y, row in model.quasi_velocities),
        *((f"outputs[{name}]", out, anything | {"accelerations", "multipliers"}) for name, out in model.outputs),
        *((f"events[{name}]", event.expression, anything) for name, event in model.events),
        *((f"reset[{name_of(key)}] of events[{name}]", after, anything)
          for name, event in model.events for key, after in event.reset),
        *((f"phi of the impact of events[{name}]", event.impact[0], frozenset[str]())
          for name, event in model.events if event.impact),
        *((f"the restitution of events[{name}]", event.impact[1], anything)
          for name, event in model.events if event.impact),
        *((f"drawing[{k}] ({shape.kind})", number, frozenset({"states"}))
          for k, shape in enumerate(model.drawing) for number in shape.numbers),
    ]  # fmt: skip


def _check_expression(model: Mechanism, what: str, expression: sympy.Expr, allowed: frozenset[str]) -> None:
    known = {symbol: kind for kind, symbol in declared(model)}
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
        return  # _check_function reports unknown functions
    if kind == "input":
        raise ModelError(f"{what} contains the rate of the input {name_of(rate.expr)!r}. Make the rate its own input.")
    order += kind in ("quasi-velocity", "state")
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
    if what.startswith("drawing"):
        return "A drawing is made of positions."
    if what.startswith("potential"):
        return "What depends on velocities belongs to kinetic_energy or forces."
    return "State it in the rates of the coordinates where those are allowed."


def _remedy_for_state(what: str) -> str:
    if what.startswith("kinetic"):
        return (
            "Its effect on the motion belongs to forces. Make a mass that changes a coordinate, whose rate is a "
            "nonholonomic constraint."
        )
    return "Let it act through forces."


def _remedy_for_input(what: str) -> str:
    return "Draw it as a coordinate." if what.startswith("drawing") else "Let it act through forces."


def _check_function(
    model: Mechanism, what: str, function: sympy.Expr, known: dict[sympy.Expr, str], allowed: frozenset[str]
) -> None:
    if function.func == MULTIPLIER:
        _check_multiplier(model, what, function, allowed)
        return
    kind = known.get(function)
    if kind is None:
        raise ModelError(_unknown(model, what, function))
    if kind == "input" and "inputs" not in allowed:
        raise ModelError(f"{what} contains the input {name_of(function)!r}. {_remedy_for_input(what)}")
    if kind == "state" and "states" not in allowed:
        raise ModelError(f"{what} contains the state {name_of(function)!r}. {_remedy_for_state(what)}")
    if kind == "quasi-velocity" and "quasi" not in allowed:
        raise ModelError(f"{what} contains the quasi-velocity {name_of(function)!r}. {_remedy_for_velocity(what)}")


def _check_multiplier(model: Mechanism, what: str, function: sympy.Expr, allowed: frozenset[str]) -> None:
    if "multipliers" not in allowed:
        raise ModelError(f"{what} contains a multiplier. Only outputs may use them.")
    if len(function.args) != 1 or not 0 <= function.args[0] < model.m:
        raise ModelError(f"{what} contains {function}, but the model has {model.m} constraint rows, counted from 0.")


def _unknown(model: Mechanism, what: str, symbol: sympy.Expr) -> str:
    """Return the error message for an undeclared symbol."""
    name = name_of(symbol)
    if name == t.name:
        return f"{what} contains a symbol named {name!r} that is not the time. Use eigenmotion.t."
    kinds = {name_of(known): kind for kind, known in declared(model)}
    if name in kinds and isinstance(symbol, AppliedUndef) and len(symbol.args) == 1 and symbol.args != (t,):
        return (
            f"{what} contains {shown(symbol)}, the {kinds[name]} {name!r} at another time than now. Delays are "
            "not taken in expressions: use a controller, Sampled(delay=), or a filter, whose states are coordinates."
        )
    if name in kinds:
        return (
            f"{what} contains {name!r}, a different symbol from the {kinds[name]} of that name: two symbols of one "
            f"name differ by their assumptions or by being a function of time. {SAME_OBJECT}"
        )
    if isinstance(symbol, AppliedUndef) and symbol.args != (t,):
        return (
            f"{what} contains {shown(symbol)}, a function that is not declared: nothing says what it is. Write it "
            "out, or give it by numbers: eigenmotion.Table."
        )
    where = "coordinates, states, quasi_velocities or inputs" if isinstance(symbol, AppliedUndef) else "parameters"
    return f"{what} contains {name!r}, which is not declared. Add it to {where}.{nearest(name, kinds)}"
