"""Terms of a model's expressions that have no finite value at a state, as words for the message of a failed run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.piecewise import Piecewise

from ..codegen.model import Model
from ..codegen.model.normalise import name_of, rate_of, t

_NEAR = 1e-6  # distance from the end of a domain, relative to the terms, within which a term is suspected
_MOST = 3
_LOGARITHMS = (sympy.log,)
_ARCS = (sympy.asin, sympy.acos)


def undefined_terms(model: Model, values: Mapping[str, float]) -> str:
    """Return words on the terms that have no finite value or derivative at `values`; "" if there are none.

    Where all are finite, terms are named that are next to the end of their domain, such as a root of almost 0. What
    contains a symbol that has no value, or a function that is not SymPy's, is left out.

    Parameters
    ----------
    values
        Numbers by name, as a System has them: "t", coordinates, rates ("theta'"), states, parameters and inputs.

    Examples
    --------
    >>> from eigenmotion.building.undefined_terms import undefined_terms
    >>> from eigenmotion.models.elastic_pendulum import model
    >>> undefined_terms(model, {"t": 0.0, "r": 1.0})
    ''
    """
    search = _Search(_known(model, values))
    for where, expression in _stated(model):
        search.at(where, expression)
    found = search.undefined or search.near
    if not found:
        return ""
    words = "has no finite value or derivative" if search.undefined else "is next to the end of its domain"
    shown = [f"{term} in {where} {words}, where {given}" for term, (where, given) in list(found.items())[:_MOST]]
    return f" {'; '.join(shown)}."


def _known(model: Model, values: Mapping[str, float]) -> dict[sympy.Basic, float]:
    """Return symbol, function of time or derivative -> value."""
    pairs = [(symbol, name_of(symbol)) for symbol, _ in (*model.parameters, *model.inputs, *model.states)]
    pairs += [(x, name_of(x)) for x in model.coordinates]
    pairs += [(rate_of(x), f"{name_of(x)}'") for x in model.coordinates]
    return {t: values["t"]} | {symbol: values[name] for symbol, name in pairs if name in values}


def _stated(model: Model) -> Iterator[tuple[str, sympy.Expr]]:
    """Give each expression that the motion follows from, with the argument of Model where it stands."""
    yield "kinetic_energy", model.in_rates(model.kinetic_energy)
    yield "potential_energy", model.potential_energy
    for x, force in zip(model.coordinates, model.forces, strict=True):
        yield f"forces[{name_of(x)}]", model.in_rates(force)
    for kind in ("holonomic_constraints", "nonholonomic_constraints"):
        for k, row in enumerate(getattr(model, kind)):
            yield f"{kind}[{k}]", model.in_rates(row)
    for z, rate in model.states:
        yield f"states[{name_of(z)}]", model.in_rates(rate)


class _Search:
    """Values of subexpressions, each computed once, and what was found: text of a term -> (where, its arguments)."""

    def __init__(self, known: Mapping[sympy.Basic, float]) -> None:
        self._values: dict[sympy.Basic, float | None] = dict(known)
        self._where = ""
        self.undefined: dict[str, tuple[str, str]] = {}
        self.near: dict[str, tuple[str, str]] = {}

    def at(self, where: str, expression: sympy.Expr) -> None:
        """Search an expression."""
        self._where = where
        self._value(expression)

    def _value(self, part: sympy.Basic) -> float | None:
        """Return the value of a part; None if it is not known, or not finite."""
        if part not in self._values:
            self._values[part] = self._computed(part)
        return self._values[part]

    def _computed(self, part: sympy.Basic) -> float | None:
        if isinstance(part, AppliedUndef | sympy.Derivative | sympy.Symbol):
            return None
        if isinstance(part, Piecewise):
            return self._branch(part)
        arguments = [value for argument in part.args if (value := self._value(argument)) is not None]
        if len(arguments) < len(part.args):
            return None
        value = _finite(part.func(*map(sympy.Float, arguments)) if part.args else part)
        if value is None or _has_no_slope(part, arguments):
            self.undefined.setdefault(_text(part), (self._where, self._given(part)))
        elif self._is_near(part):
            self.near.setdefault(_text(part), (self._where, self._given(part)))
        return value

    def _branch(self, part: Piecewise) -> float | None:
        """Return the value of the branch that holds; the others may be undefined."""
        for expression, condition in part.args:
            symbols = {one: self._value(one) for one in condition.atoms(sympy.Symbol, AppliedUndef, sympy.Derivative)}
            if None in symbols.values():
                return None
            holds = condition.xreplace({one: sympy.Float(value) for one, value in symbols.items()})
            if holds == sympy.true:
                return self._value(expression)
            if holds != sympy.false:
                return None
        return None

    def _is_near(self, part: sympy.Basic) -> bool:
        """Return whether a root, quotient, logarithm or arc is next to the end of its domain."""
        if not part.args:
            return False
        first = part.args[0]
        if isinstance(part, _ARCS):
            return abs(abs(self._value(first) or 0.0) - 1.0) <= _NEAR
        if not (isinstance(part, _LOGARITHMS) or _is_root(part)) or first.is_number:
            return False
        sizes = [abs(self._value(term) or 0.0) for term in sympy.Add.make_args(first)]
        size = sum(sizes) if len(sizes) > 1 else 1.0
        return abs(self._value(first) or 0.0) <= _NEAR * size

    def _given(self, part: sympy.Basic) -> str:
        """Return the arguments of a term that are not numbers, with their values."""
        named = [argument for argument in part.args if not argument.is_number] or [part]
        return ", ".join(
            f"{_text(one)} = {self._values[one]:.6g}" for one in named if self._values.get(one) is not None
        )


def _is_root(part: sympy.Basic) -> bool:
    """Return whether part is a power that has no derivative, or no value, where its base is 0."""
    return isinstance(part, sympy.Pow) and not (part.exp.is_integer and part.exp.is_nonnegative)


def _has_no_slope(part: sympy.Basic, arguments: list[float]) -> bool:
    if isinstance(part, _ARCS):
        return abs(arguments[0]) == 1.0
    return _is_root(part) and arguments[0] == 0.0 and not part.base.is_number and arguments[1] < 1.0


def _finite(value: sympy.Basic) -> float | None:
    """Return a real, finite value as a number; else None."""
    try:
        number = complex(value.evalf())
    except (TypeError, ValueError, OverflowError, AttributeError):
        return None
    return number.real if number.imag == 0.0 and abs(number.real) < float("inf") else None


def _text(expression: sympy.Basic) -> str:
    """Return an expression in the user's words: functions of time without their argument, rates with a mark."""
    rates = {one: sympy.Symbol(f"{name_of(one.expr)}{one.derivative_count * chr(39)}")
             for one in expression.atoms(sympy.Derivative)}  # fmt: skip
    plain = expression.xreplace(rates)
    return str(plain.xreplace({one: sympy.Symbol(name_of(one)) for one in plain.atoms(AppliedUndef)}))
