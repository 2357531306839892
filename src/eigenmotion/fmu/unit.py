"""Units as data for the templates: one description, whatever the version of FMI."""

from dataclasses import dataclass
from typing import NamedTuple

from .physical_units import PhysicalUnit


class Variable(NamedTuple):
    """A variable of a unit, with its FMI attributes, and its value reference.

    initial, start : "" and None if the attribute is omitted
    derivative : the reference of the variable of which it is the derivative
    reinit : whether it may jump, as a continuous state
    indicates : whether it is an event function
    """

    reference: int
    name: str
    causality: str
    variability: str
    initial: str
    start: str | None
    description: str = ""
    derivative: int | None = None
    reinit: bool = False
    indicates: bool = False
    unit: str = ""


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
    co_simulation_only : why there is no model exchange; "": there is
    """

    headers: tuple[str, ...]
    variables: tuple[Variable, ...]
    constants: tuple[Constant, ...]
    options: str
    rtol: str | None
    co_simulation_only: str
    physical_units: tuple[PhysicalUnit, ...] = ()

    @property
    def time(self) -> int:
        """The reference of the time, after all others."""
        return max(one.reference for one in self.variables) + 1

    @property
    def outputs(self) -> tuple[int, ...]:
        """References of outputs."""
        return tuple(one.reference for one in self.variables if one.causality == "output")

    @property
    def rates(self) -> tuple[int, ...]:
        """References of the rates of continuous states, in the order of the states; () without model exchange."""
        rates = (one.reference for one in self.variables if one.derivative is not None)
        return () if self.co_simulation_only else tuple(rates)

    @property
    def indicators(self) -> tuple[int, ...]:
        """References of event indicators; () without model exchange."""
        found = (one.reference for one in self.variables if one.indicates)
        return () if self.co_simulation_only else tuple(found)

    @property
    def initial(self) -> tuple[int, ...]:
        """References of outputs and rates that are calculated at the start."""
        asked = {*self.outputs, *self.rates}
        unknown = (one for one in self.variables if one.initial in ("approx", "calculated"))
        return tuple(one.reference for one in unknown if one.reference in asked)

    @property
    def places(self) -> dict[int, int]:
        """Reference -> index of the variable, counted from 1, as FMI 2.0 refers to it."""
        return {one.reference: k for k, one in enumerate(self.variables, 1)}


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit of one version of FMI, 2 or 3."""

    name: str
    guid: str
    version: int
    sources: tuple[str, ...]
    content: Content
