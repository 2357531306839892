"""Variables of differentiation: the option `sensitivities`."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from ..codegen.model.normalise import ModelError, shown
from ..runtime import CompiledModel
from .named_values import by_spelling, is_named, rate_name, spelled, unknown
from .options import OptionError
from .states import names_of_states
from .tables import refuse_tables


class Differentiated(NamedTuple):
    """The variables of differentiation: parameters, inputs, initial x and v.

    from_quasi : whether motions start from quasi-velocities
    """

    names: tuple[str, ...]
    from_quasi: bool


def names_of(c: CompiledModel) -> tuple[str, ...]:
    """Return all names to choose from: coordinates, states, rates, quasi-velocities, inputs, parameters."""
    return *c.coordinates, *rates_of(c.coordinates[: c.n_coordinates]), *c.quasi_velocities, *c.inputs, *c.parameters


@lru_cache(maxsize=16)
def rates_of(coordinates: tuple[str, ...]) -> tuple[str, ...]:
    """Return "theta'" of "theta"."""
    return tuple(f"{name}'" for name in coordinates)


def differentiated(c: CompiledModel, chosen: Sequence[Any], v0: Any, option: str = "sensitivities") -> Differentiated:
    """Return the variables that an option names, for runs that start with v0.

    Raises
    ------
    ModelError
        The model has no such name, or it is a quasi-velocity but the start is given in rates.
    """
    if isinstance(chosen, str) or not isinstance(chosen, Sequence):
        raise OptionError(f"{option} is {shown(chosen)}: give a list of names")
    known = dict.fromkeys(names_of(c))
    names = tuple(dict.fromkeys(one if isinstance(one, str) and one in known else variable_name(one) for one in chosen))
    if wrong := set(names) - known.keys():
        raise ModelError(unknown(f"name in {option}", wrong, tuple(known)))
    refuse_tables(c, names, option)
    quasi = [name for name in names if name in c.quasi_velocities and name not in names_of_states(c)]
    argument = set(by_spelling(v0, "v0", rate_name)) if is_named(v0) else set()
    from_quasi = bool(argument & set(c.quasi_velocities)) or (v0 is None and c.initial_y is not None)
    if quasi and not from_quasi:
        raise ModelError(f"{option}: the run does not start from quasi-velocities, as {quasi[0]!r} is; name rates")
    if is_named(v0) and (c.initial_y is not None) != from_quasi and len(argument) < c.n_coordinates:
        raise ModelError(f"{option}: the start mixes rates and quasi-velocities; give all of one kind in v0")
    return Differentiated(names, from_quasi)


def variable_name(key: object) -> str:
    """Return the name of a key: "theta'" for the rate of theta, as in `initial`."""
    return f"{rate_name(key)}'" if rate_name(key) != spelled(key) else spelled(key)
