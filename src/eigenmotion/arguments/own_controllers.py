"""Controllers of the members of an ensemble, one for each member: made by `make`, or copied."""

from copy import deepcopy
from dataclasses import replace
from types import FunctionType
from typing import Any

from ..codegen.model.normalise import ModelError, shown
from .sampled import Controlled, Controller
from .shared_state import REMEDY, names, owner, shared
from .tasks import Column


class OwnControllers:
    """Controllers of `count` members; `reasons` receives a message if `make` fails for a member."""

    def __init__(self, count: int, reasons: dict[int, str]) -> None:
        self._count, self._reasons = count, reasons
        self._of_member: dict[tuple[Controlled, int], Controlled] = {}
        self._from_make: dict[Any, list[Controller]] = {}
        self._owners = set[int]()

    def column(self, argument: Column) -> Column:
        """Return an input, where a controller is replaced by a list with one controller for each member.

        Raises
        ------
        ModelError
            A controller cannot be copied, or `make` returns the same object twice.
        """
        if isinstance(argument, Controlled):
            argument = [argument] * self._count
        if not isinstance(argument, list):
            return argument
        return [self._of(one, k) if isinstance(one, Controlled) else one for k, one in enumerate(argument)]

    def _of(self, one: Controlled, k: int) -> Controlled:
        """Return the controller of member k, the same object for each of its inputs."""
        if (one, k) not in self._of_member:
            self._of_member[one, k] = self._copied(one) if one.sampled.make is None else self._by_make(one, k)
        return self._of_member[one, k]

    def _by_make(self, one: Controlled, k: int) -> Controlled:
        try:
            controller = one.sampled.controller()
        except Exception as error:  # whatever a function of the user's raises
            self._reasons.setdefault(k, f"make of {one} raised {type(error).__name__}: {error}")
            return one
        if id(owner(controller)) in self._owners:
            raise ModelError(
                f"make of {one} returned {shown(controller)} for run {k}, and for another before, which would share "
                "what it keeps: return a new one each time. What keeps nothing is given as the function"
            )
        others = self._from_make.setdefault(one.sampled.make, [])
        others.append(controller)
        self._owners.add(id(owner(controller)))
        return _with(one, controller, shared(others[0], controller) if len(others) > 1 else ())

    def _copied(self, one: Controlled) -> Controlled:
        function: Any = one.sampled.function
        if isinstance(function, FunctionType):
            return self._of_member.setdefault((one, -1), _with(one, function, names(function)))
        try:
            return _with(one, deepcopy(function), ())
        except Exception as error:  # whatever copying an object of the user's raises
            raise ModelError(
                f"{one}: the controller {shown(function)} cannot be copied for each run ({error}): {REMEDY}"
            ) from error


def _with(one: Controlled, function: Controller, common: tuple[str, ...]) -> Controlled:
    return replace(one, sampled=replace(one.sampled, function=function, make=None), shared=common)
