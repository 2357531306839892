"""Detection of shared state of controllers: the objects to which a function refers, and their changes."""

import dis
import pickle
from collections.abc import Iterable, Iterator
from functools import cache, partial
from types import BuiltinFunctionType, CodeType, FunctionType, MethodType, ModuleType
from typing import Any

from ..codegen.model.normalise import ModelError
from .sampled import Controlled

_CONSTANT = (type(None), int, float, complex, str, bytes, type, ModuleType, BuiltinFunctionType)
REMEDY = "give make=, which returns a controller of its own for each run"
Reference = tuple[str, int, Any]
"""A name, an identifier of the variable, and its value."""


def owner(function: Any) -> Any:
    """Return the object of a method, or the function itself."""
    return owner(function.__self__) if isinstance(function, MethodType) else function


def references(function: Any) -> Iterator[Reference]:
    """Yield the objects to which a function, and the functions that it refers to, refer."""
    seen, waiting = set[int](), [function]
    while waiting:
        for name, place, value in _of_one(owner(waiting.pop())):
            if place in seen:
                continue
            seen.add(place)
            yield name, place, value
            if isinstance(value, FunctionType | MethodType | partial):
                waiting.append(value)


def _of_one(argument: Any) -> Iterator[Reference]:
    if isinstance(argument, FunctionType):
        yield from _of_function(argument)
    elif isinstance(argument, partial):
        named = {"func": argument.func} | dict(enumerate(argument.args)) | argument.keywords
        yield from ((str(name), hash((id(argument), name)), value) for name, value in named.items())
    elif not isinstance(argument, _CONSTANT):
        yield from _in_table(getattr(argument, "__dict__", {}))


def _of_function(function: FunctionType) -> Iterator[Reference]:
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or (), strict=True):
        try:
            yield name, id(cell), cell.cell_contents
        except ValueError:  # nothing has been assigned yet
            continue
    for name in _globals_of(function.__code__):
        if name in function.__globals__:
            yield name, hash((id(function.__globals__), name)), function.__globals__[name]
    for k, value in enumerate(function.__defaults__ or ()):
        yield f"default {k}", hash((id(function), k)), value
    yield from _in_table(function.__kwdefaults__ or {})
    yield from _in_table(function.__dict__)


def _in_table(table: dict[str, Any]) -> Iterator[Reference]:
    for name, value in table.items():
        yield name, hash((id(table), name)), value


@cache
def _globals_of(code: CodeType) -> tuple[str, ...]:
    """Names of globals in a function's code, and in that of functions within it."""
    within = [name for one in code.co_consts if isinstance(one, CodeType) for name in _globals_of(one)]
    named = {step.argval for step in dis.get_instructions(code) if step.opname.endswith("_GLOBAL")}
    return tuple(dict.fromkeys([*sorted(named), *within]))


def names(function: Any) -> tuple[str, ...]:
    """Return the names of all objects to which a function refers."""
    return tuple(dict.fromkeys(name for name, _, _ in references(function)))


def shared(first: Any, second: Any) -> tuple[str, ...]:
    """Return the names of the variables, and of the mutable objects, to which both functions refer."""
    there = {mark for _, *marks in map(_marks, references(first)) for mark in marks}
    return tuple(name for name, *marks in map(_marks, references(second)) if there.intersection(marks))


def _marks(reference: Reference) -> tuple[Any, ...]:
    name, place, value = reference
    return (name, place) if isinstance(value, (*_CONSTANT, tuple, FunctionType)) else (name, place, id(value))


class Watch:
    """The state of objects that controllers share, recorded to detect changes."""

    def __init__(self, controllers: Iterable[Controlled]) -> None:
        each = {(one.shared, getattr(one.sampled.function, "__code__", None)): one for one in controllers if one.shared}
        self._before = [(one, _state(one)) for one in each.values()]

    def check(self) -> None:
        """Raise ModelError if a shared object has changed; names it."""
        for one, before in self._before:
            after = _state(one)
            for key in before.keys() | after.keys():
                if before.get(key) != after.get(key):
                    raise ModelError(f"{one}: its controller changes {key[0]!r}, which the runs of the ensemble share: "
                                     f"{REMEDY}")  # fmt: skip


def _state(controlled: Controlled) -> dict[tuple[str, int], bytes]:
    """Return name and identifier of each shared object -> its pickled state."""
    return {
        (name, place): _bytes(controlled, name, value)
        for name, place, value in references(controlled.sampled.function)
        if name in controlled.shared and not isinstance(value, FunctionType | ModuleType | type | BuiltinFunctionType)
    }


def _bytes(controlled: Controlled, name: str, value: Any) -> bytes:
    try:
        return pickle.dumps(value)
    except Exception as error:  # whatever pickling an object of the user's raises
        raise ModelError(
            f"{controlled}: its controller refers to {name!r}, of type {type(value).__name__}, which the runs of the "
            f"ensemble would share, and nothing shows whether it changes ({error}): {REMEDY}"
        ) from error
