"""Expressions that users state of cycles: sections, conditions and periods, with their derivatives."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ...arguments.differentiation import variable_name
from ...arguments.named_values import unknown
from ...codegen.model.normalise import ModelError, shown

PERIOD, TIME = "period", "t"
_CONSTANTS = ("pi", "E")
_WORD = re.compile(r"(?<![\w.])([^\W\d]\w*'?)(\s*\(|)")
"""A name, perhaps of a rate, and the bracket after that of a function."""


@dataclass(frozen=True)
class Quantity:
    """An expression of numbers that have names: text : as users state it; expression : of symbols with these names."""

    text: str
    expression: Any
    names: tuple[str, ...]

    def value(self, values: Mapping[str, Any]) -> Any:
        """Return the value; it is an array if values are."""
        return self._functions[0](*(values[name] for name in self.names))

    def slopes(self, values: Mapping[str, float]) -> dict[str, float]:
        """Return the derivative by each name."""
        found = self._functions[1](*(values[name] for name in self.names))
        return dict(zip(self.names, map(float, found), strict=True))

    def doubled(self) -> "Quantity":
        """Return the expression of twice the value."""
        return Quantity(f"2*({self.text})", 2 * self.expression, self.names)

    def of_half(self) -> "Quantity":
        """Return the expression of half the period."""
        symbol = _symbol(PERIOD)
        return Quantity(self.text, self.expression.subs(symbol, symbol / 2), self.names)

    @cached_property
    def _functions(self) -> tuple[Callable[..., Any], Callable[..., Any]]:
        import sympy  # noqa: PLC0415, not needed for numbers

        symbols = [_symbol(name) for name in self.names]
        partials = [self.expression.diff(one) for one in symbols]
        value: Callable[..., Any] = sympy.lambdify(symbols, self.expression, modules="numpy")
        slopes: Callable[..., Any] = sympy.lambdify(symbols, partials, modules="numpy")
        return value, slopes


def quantity_of(model: str, what: str, argument: Any, known: Sequence[str]) -> Quantity:
    """Return an expression that users state, in SymPy or as text: "theta' - w*l".

    Raises
    ------
    ModelError
        It is no expression, or has a name that is not known.
    """
    found = _of_text(argument, known) if isinstance(argument, str) else _of_sympy(argument)
    if found is None:
        example = f"'{known[0]} - 0.1'" if known else "'2*pi'"
        raise ModelError(f"{model}: {what} is {shown(argument)}. Give an expression, such as {example}")
    names = tuple(sorted(one.name for one in found.free_symbols))
    if wrong := set(names) - set(known):
        bare = len(found.free_symbols) == 1 and found.is_Symbol
        raise ModelError(f"{model}: {unknown(what if bare else f'name in {what}', wrong, known)}")
    return Quantity(str(argument).replace("(t)", ""), found, names)


def stated_period(model: str, argument: Any, known: Sequence[str]) -> Quantity | None:
    """Return the period that users state as an expression of parameters, or None if it is a number."""
    if argument is None or isinstance(argument, int | float):
        return None
    try:
        return quantity_of(model, PERIOD, argument, known)
    except ModelError as error:
        raise ModelError(
            f"{model}: period is {shown(argument)}. Give a number, or an expression of parameters such as '2*pi/w'"
        ) from error


def _of_text(text: str, known: Sequence[str]) -> Any:
    """Return the expression of symbols with the names of a text, where a prime is a rate."""
    import sympy  # noqa: PLC0415, not needed for numbers

    places: dict[str, str] = {}

    def place(found: re.Match[str]) -> str:
        name, calls = found[1], bool(found[2])
        if name not in known and (calls or name in _CONSTANTS):
            return found[0]
        return places.setdefault(name, f"name_{len(places)}_") + found[2]

    spelt = _WORD.sub(place, text.replace("(t)", ""))
    try:
        found = sympy.sympify(spelt, locals={place: _symbol(name) for name, place in places.items()})
    except (sympy.SympifyError, TypeError, AttributeError, SyntaxError, ValueError):
        return None
    return found if isinstance(found, sympy.Expr) else None


def _of_sympy(argument: Any) -> Any:
    """Return the expression with functions of time and their rates as symbols."""
    import sympy  # noqa: PLC0415, not needed for numbers
    from sympy.core.function import AppliedUndef  # noqa: PLC0415

    if not isinstance(argument, sympy.Expr):
        return None
    rates = {one: _symbol(variable_name(one)) for one in argument.atoms(sympy.Derivative)}
    found = argument.xreplace(rates)
    found = found.xreplace({one: _symbol(variable_name(one)) for one in found.atoms(AppliedUndef)})
    return found.xreplace({one: _symbol(one.name) for one in found.free_symbols})


def _symbol(name: str) -> Any:
    import sympy  # noqa: PLC0415, not needed for numbers

    return sympy.Symbol(name, real=True)
