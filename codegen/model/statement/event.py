"""Events: zero crossings of an expression along a motion, and their effects on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy

from ..normalise import ModelError, expression, pairs_of, shown, truth


@dataclass(frozen=True, slots=True)
class Event:
    """A zero crossing of an expression, and its action on the state. The run continues from the changed state.

    Parameters
    ----------
    expression
        A function of x, xdot, t and inputs; the event happens where it crosses zero.
    direction
        1 upwards, -1 downwards, 0 both.
    terminal
        Whether it ends the run, after its action.
    impact
        (phi, restitution): Newton's impact of two bodies with distance phi(x, t), in the mass metric,
        v+ = v - (1 + e) M^-1 N^T (N M^-1 N^T)^-1 (N v + dphi/dt), N = dphi/dx. Other constraints still hold, and take
        impulses. The restitution e, from 0 to 1, may contain the same symbols as `expression`.
    reset
        Mapping coordinate, rate or quasi-velocity -> expression of the state before the reset, which is the state
        after the impact if there is one. Other variables do not change.

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
        direction = self.direction
        if not isinstance(direction, int) or isinstance(direction, bool) or direction not in (-1, 0, 1):
            raise ModelError(f"The direction of an event is 1 (upwards), -1 (downwards) or 0, not {shown(direction)}.")
        object.__setattr__(self, "terminal", truth(self.terminal, "terminal of an event"))
        object.__setattr__(self, "reset", _reset(self.reset))
        object.__setattr__(self, "impact", _impact(self.impact))

    @property
    def acts(self) -> bool:
        """Whether it changes the state."""
        return self.impact is not None or bool(self.reset)

    @property
    def keeps_apart(self) -> bool:
        """Whether its expression is phi of its impact, so that it also happens where phi < 0 would follow phi = 0."""
        if self.impact is None or self.direction == 0:
            return False
        return bool((self.expression + self.direction * self.impact[0]).expand() == 0)


def restitution_of(restitution: Any, what: str) -> sympy.Expr:
    """Return a coefficient of restitution.

    Raises
    ------
    ModelError
        It is not an expression, or is a number outside 0 to 1.
    """
    e = expression(restitution, what)
    if e.is_number and not 0 <= e <= 1:
        raise ModelError(f"{what} is {shown(restitution)}. Give one from 0 (plastic) to 1 (elastic).")
    return e


def _reset(reset: Any) -> tuple[tuple[Any, sympy.Expr], ...]:
    if reset is None:
        return ()
    pairs = pairs_of(reset, "reset of an event")
    return tuple((key, expression(value, f"reset[{shown(key)}] of an event")) for key, value in pairs)


def _impact(impact: Any) -> tuple[sympy.Expr, sympy.Expr] | None:
    if impact is None:
        return None
    if not isinstance(impact, (tuple, list)) or len(impact) != len(("phi", "restitution")):
        raise ModelError(f"impact of an event is {shown(impact)}. Give (phi, restitution).")
    return expression(impact[0], "phi of an impact"), restitution_of(impact[1], "The restitution of an impact")
