"""Order of a sweep: all that determines the bytes of its store, as JSON data."""

import json
from reprlib import Repr
from typing import Any

from ...runtime import CompiledModel
from .design import Design

_OPTIONS = {
    "model": "the model", "sources": "the model, its default values or how it is compiled", "grid": "--sweep",
    "samples": "--sample", "n": "-n", "t_end": "--t-end", "units": "the unit of",
}  # fmt: skip
_NOT_GIVEN = "not given"
_SHORT = Repr()
_SHORT.maxlist, _SHORT.maxstring = 4, 80


def order_of(model: CompiledModel, design: Design, arguments: dict[str, Any], **rest: Any) -> dict[str, Any]:
    """Return the order of a sweep."""
    drawn = {name: str(one) for name, one in design.samples.items()}
    grid = {name: list(numbers) for name, numbers in design.grid.items()}
    options = {name: arguments[name] for name in ("rtol", "atol", "method")}
    units = {} if model.units is None else {"units": dict(sorted(model.units.items()))}
    described = {"model": f"{model.name}, {model.formulation}"} | units
    return {"grid": grid, "samples": drawn, "n": design.n, "seed": design.seed} | options | described | rest


def differences(text: str, order: dict[str, Any]) -> str:
    """Return as words in what the order of another sweep, as JSON text, differs from this one.

    Examples
    --------
    >>> from eigenmotion.batch.sweep.order import differences
    >>> differences('{"grid": {"m": [1.0, 2.0]}, "t_end": 3.0}', {"grid": {"m": [1.0, 4.0]}, "t_end": 3.0})
    '--sweep m is [1.0, 2.0] there, and [1.0, 4.0] here'
    """
    try:
        there, here = _named(json.loads(text)), _named(order)
    except (ValueError, AttributeError):
        return "its description cannot be read"
    differing = [name for name in here | there if there.get(name) != here.get(name)]
    if len(differing) > 1 and _OPTIONS["sources"] in differing:
        differing.remove(_OPTIONS["sources"])  # it follows from the model, whose name differs, or goes with the others
        if _OPTIONS["model"] not in differing:
            differing.insert(0, _OPTIONS["sources"])
    return "; ".join(_words(name, there, here) for name in differing)


def _words(name: str, there: dict[str, Any], here: dict[str, Any]) -> str:
    if name == _OPTIONS["sources"]:
        return f"{name} differ"
    return f"{name} is {_value(name, there)} there, and {_value(name, here)} here"


def _value(name: str, named: dict[str, Any]) -> str:
    return _SHORT.repr(named[name]) if named.get(name) not in (None, []) else _NOT_GIVEN


def _named(order: dict[str, Any]) -> dict[str, Any]:
    """Return name as on the command line -> value; swept and sampled names one by one."""
    named: dict[str, Any] = {}
    for key, value in order.items():
        option = _OPTIONS.get(key, f"--{key}")
        named |= (
            {f"{option} {name}": one for name, one in value.items()} if isinstance(value, dict) else {option: value}
        )
    return named
