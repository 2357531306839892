"""Period that users state as an expression of parameters, such as that of a forcing."""

from dataclasses import dataclass
from typing import Any

from ...codegen.model.normalise import ModelError, shown
from ...runtime import CompiledModel, Prepared


@dataclass(frozen=True)
class StatedPeriod:
    """A period as an expression of parameters."""

    expression: Any
    names: tuple[str, ...]

    def value(self, c: CompiledModel, prepared: Prepared) -> float:
        """Return the period [s]."""
        return float(self.expression.subs(self._values(c, prepared)))

    def slope(self, c: CompiledModel, prepared: Prepared, by: str) -> float:
        """Return the derivative by a parameter."""
        return float(self.expression.diff(_symbol(by)).subs(self._values(c, prepared)))

    def _values(self, c: CompiledModel, prepared: Prepared) -> dict[Any, float]:
        values = dict(zip(c.parameters, prepared.parameters, strict=True))
        return {_symbol(name): values[name] for name in self.names}


def stated_period(c: CompiledModel, argument: Any) -> StatedPeriod | None:
    """Return the period that users state as an expression, or None if it is a number.

    Raises
    ------
    ModelError
        It is no expression of parameters.
    """
    if argument is None or isinstance(argument, int | float):
        return None
    import sympy  # noqa: PLC0415, not needed for numbers

    try:
        found = sympy.sympify(str(argument), locals={name: _symbol(name) for name in c.parameters})
        names = tuple(sorted(one.name for one in found.free_symbols))
    except (sympy.SympifyError, TypeError, AttributeError, SyntaxError) as error:
        raise _no_period(c, argument) from error
    if set(names) - set(c.parameters):
        raise _no_period(c, argument)
    return StatedPeriod(found, names)


def _symbol(name: str) -> Any:
    import sympy  # noqa: PLC0415, not needed for numbers

    return sympy.Symbol(name)


def _no_period(c: CompiledModel, argument: Any) -> ModelError:
    return ModelError(
        f"{c.name}: period is {shown(argument)}. Give a number, or an expression of parameters such as '2*pi/w'"
    )
