"""Events: zero crossings of an expression along a motion, and their actions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy

from ..normalise import ModelError, expression, pairs_of, shown, truth


@dataclass(frozen=True, slots=True)
class Event:
    """A zero crossing, and what it does. The run goes on from the root with what it did.

    Parameters
    ----------
    expression
        In x, xdot, t and inputs: happens where it passes zero.
    direction
        1 upwards, -1 downwards, 0 both.
    terminal
        Whether it ends the run (after it acted).
    impact
        (phi, restitution): Newton's impact between what phi(x, t) keeps apart, in the mass metric,
        v+ = v - (1 + e) M^-1 N^T (N M^-1 N^T)^-1 (N v + dphi/dt), N = dphi/dx; other constraints are kept and take
        impulses. The restitution e, from 0 to 1, is an expression in what the event's may be.
    reset
        Mapping coordinate, rate or quasi-velocity -> expression of the state before; what it does not name stays. Where
        there is an impact too, the state before is that after the impact.

    Examples
    --------
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from eigenmotion import Event
    >>> theta = dynamicsymbols("theta")
    >>> events = {"limit": Event(theta - 1, direction=1, terminal=True), "bottom": theta}
    >>> strikes = {"wall": Event(1 - theta, direction=-1, impact=(1 - theta, 0.8))}
    """

    expression: Any
    direction: int = 0
    terminal: bool = False
    reset: Any = None
    impact: Any = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "expression", expression(self.expression, "The expression of an event"))
        given = self.direction
        if not isinstance(given, int) or isinstance(given, bool) or given not in (-1, 0, 1):
            raise ModelError(f"The direction of an event is 1 (upwards), -1 (downwards) or 0, not {shown(given)}.")
        object.__setattr__(self, "terminal", truth(self.terminal, "terminal of an event"))
        object.__setattr__(self, "reset", _reset(self.reset))
        object.__setattr__(self, "impact", _impact(self.impact))

    @property
    def acts(self) -> bool:
        """Whether it changes the state."""
        return self.impact is not None or bool(self.reset)

    @property
    def keeps_apart(self) -> bool:
        """Whether it happens wherever the motion is about to enter phi < 0, from rest at phi = 0 too."""
        if self.impact is None or self.direction == 0:
            return False
        return bool((self.expression + self.direction * self.impact[0]).expand() == 0)


def restitution_of(given: Any, what: str) -> sympy.Expr:
    """Return a restitution; one that is a number lies between 0 and 1.

    Raises
    ------
    ModelError
        It does not, or is no expression.
    """
    e = expression(given, what)
    if e.is_number and not 0 <= e <= 1:
        raise ModelError(f"{what} is {shown(given)}. Give one from 0 (plastic) to 1 (elastic).")
    return e


def _reset(given: Any) -> tuple[tuple[Any, sympy.Expr], ...]:
    if given is None:
        return ()
    pairs = pairs_of(given, "reset of an event")
    return tuple((key, expression(value, f"reset[{shown(key)}] of an event")) for key, value in pairs)


def _impact(given: Any) -> tuple[sympy.Expr, sympy.Expr] | None:
    if given is None:
        return None
    if not isinstance(given, (tuple, list)) or len(given) != len(("phi", "restitution")):
        raise ModelError(f"impact of an event is {shown(given)}. Give (phi, restitution).")
    return expression(given[0], "phi of an impact"), restitution_of(given[1], "The restitution of an impact")
