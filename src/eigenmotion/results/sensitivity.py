"""Sensitivities of runs."""

from typing import NamedTuple

from ..arguments.named_values import Vector
from ..runtime import CompiledModel


class _Rows(NamedTuple):
    dx: Vector
    dv: Vector


class Sensitivity(_Rows):
    """How a run changes with one number p; an ensemble has these with the K runs first, and no dt_events.

    dx, dv : (n, k), d x / d p and d xdot / d p at its rows, at fixed time: of rows at an event that acts, those of the
        motion before it and of the motion after it; at a terminal event, of the motion up to there
    dz : (p, k) of first-order states
    dt_events : for each event of the model (e,), d t_events / d p; None where it has none. With it, dx + v dt is how
        the place of an event changes
    """

    dt_events: list[Vector] | None = None
    dz: Vector

    @classmethod
    def of(cls, dx: Vector, dv: Vector, dz: Vector, dt_events: list[Vector] | None) -> "Sensitivity":
        """Return one; unpacked, it is dx and dv."""
        made = cls(dx, dv)
        made.dz, made.dt_events = dz, dt_events
        return made


def parts_of(model: CompiledModel, S: Vector) -> tuple[Vector, Vector, Vector]:
    """Return dx, dv, dz of derivatives (2 n, ...) of x, v of compiled functions, of which states are the last v."""
    n, every = model.n_coordinates, model.n
    return S[:n], S[every : every + n], S[every + n :]
