"""Units and descriptions of a unit's variables, as its user gives them."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from ..arguments.named_values import spelled, unknown
from ..codegen.model import ModelError
from ..codegen.model.normalise import shown
from .physical_units import rate_of, units_of
from .unit import Content, Variable


def labelled(
    content: Content,
    units: Mapping[Any, str] | None,
    descriptions: Mapping[Any, str] | None,
    of_model: Mapping[str, str],
) -> Content:
    """Return the content with units and descriptions; those of rates follow from those of coordinates.

    Variables without a unit in `units` have that of the model, which may be any word, if its time is in seconds: that
    of a unit always is.

    Raises
    ------
    ModelError
        A name is that of no variable; a unit is no product of known units, or a description is no line of text.
    """
    names = tuple(one.name for one in content.variables)
    in_seconds = of_model.get("time", "s") == "s"
    words = {name: unit for name, unit in of_model.items() if name in names and name != "time" and in_seconds}
    own = dict(_of_rates(words, names))
    given = dict(_of_rates(_texts(units, "units", names), names))
    measured = own | given
    described = _texts(descriptions, "descriptions", names)
    variables = tuple(_labelled(one, measured, described) for one in content.variables)
    seconds = ("s",) if measured else ()
    known = units_of((*seconds, *measured.values()), {*own.values()} - {*given.values()})
    return replace(content, variables=variables, physical_units=known)


def _texts(given: Mapping[Any, str] | None, keyword: str, names: tuple[str, ...]) -> dict[str, str]:
    """Return name -> text."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise ModelError(f"{keyword}= is {shown(given)}, but must be a mapping name -> text")
    texts = {spelled(name): text for name, text in given.items()}
    if wrong := set(texts) - set(names):
        raise ModelError(f"{keyword}=: {unknown('variable', wrong, names)}")
    for name, text in texts.items():
        if not isinstance(text, str) or not text.strip() or not text.isprintable():
            raise ModelError(f"{keyword}=: that of {name} is {shown(text)}, but must be a line of text")
    return texts


def _of_rates(units: Mapping[str, str], names: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """Yield the names and units given, and those of derivatives and integrals."""
    for name, unit in units.items():
        for order, rate in ((1, f"der({name})"), (2, f"der(der({name}))")):
            if rate in names:
                yield rate, rate_of(unit, order)
        if f"integral({name})" in names:
            yield f"integral({name})", f"{unit}*s"
    yield from units.items()


def _labelled(one: Variable, units: Mapping[str, str], descriptions: Mapping[str, str]) -> Variable:
    return one._replace(unit=units.get(one.name, ""), description=descriptions.get(one.name, one.description))
