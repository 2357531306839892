"""Units as data for the templates."""

from dataclasses import dataclass
from typing import NamedTuple


class Variable(NamedTuple):
    """A variable of a unit, with its FMI attributes, and its value reference.

    initial, start : "" and None if the attribute is omitted
    """

    reference: int
    name: str
    causality: str
    variability: str
    initial: str
    start: str | None


class Constant(NamedTuple):
    """An array in C, which is `given` in the options of a unit."""

    kind: str
    name: str
    values: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Content:
    """What one kind of unit adds to the model.

    headers : the last one defines em_unit
    options : the fields of em_unit_options
    rtol : relative tolerance that importing tools may replace; None: nothing is integrated
    """

    headers: tuple[str, ...]
    variables: tuple[Variable, ...]
    constants: tuple[Constant, ...]
    options: str
    rtol: str | None


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit.

    outputs, initial : indices of variables, counted from 1; those that are calculated at the start are `initial`
    """

    name: str
    guid: str
    sources: tuple[str, ...]
    content: Content
    outputs: tuple[int, ...]
    initial: tuple[int, ...]
