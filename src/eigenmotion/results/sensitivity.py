"""Sensitivities of runs."""

from typing import NamedTuple

from ..arguments.named_values import Vector
from ..runtime import CompiledModel


class _Rows(NamedTuple):
    dx: Vector
    dv: Vector


class Sensitivity(_Rows):
    """Derivatives of a run with respect to one number p. In an ensemble, the K runs are the first axis.

    dx, dv : (n, k), dx/dp and dxdot/dp at the rows, at fixed time. The two rows at an event action have the derivatives
        of the motion before and after it; the row at a terminal event those of the motion before it
    dz : (p, k) of first-order states
    dt_events : for each event (e,), d t_events / dp; None for a model without events, and in an ensemble. The
        position of an event changes by dx + v dt
    """

    dt_events: list[Vector] | None = None
    dz: Vector

    @classmethod
    def of(cls, dx: Vector, dv: Vector, dz: Vector, dt_events: list[Vector] | None) -> "Sensitivity":
        """Return a Sensitivity, which unpacks as dx, dv."""
        sensitivity = cls(dx, dv)
        sensitivity.dz, sensitivity.dt_events = dz, dt_events
        return sensitivity


def parts_of(model: CompiledModel, S: Vector) -> tuple[Vector, Vector, Vector]:
    """Return dx, dv, dz from derivatives (2 n, ...) of x, v of compiled functions, where states are the last of v."""
    n, every = model.n_coordinates, model.n
    return S[:n], S[every : every + n], S[every + n :]
