"""A quick-return shaper whose block has no mass, in any unit, and where it is at any time in closed form.

A crank of length r turns about O; its pin is a block that slides along a rocker, which turns about P, h below O:

    r cos(q1) = s cos(q2),   h + r sin(q1) = s sin(q2),   q1 = w t
"""

from dataclasses import dataclass

import numpy as np
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, t

Q1, Q2, S = dynamicsymbols("q1 q2 s")
r, h, J1, J2, w = symbols("r h J1 J2 w", positive=True)


@dataclass(frozen=True)
class Units:
    """How many units of the numbers here a metre, a kilogramme, a second are."""

    length: float = 1.0
    mass: float = 1.0
    time: float = 1.0

    @property
    def parameters(self) -> dict[str, float]:
        inertia = self.mass * self.length**2
        return {"r": 0.1 * self.length, "h": 0.3 * self.length, "J1": 1e-3 * inertia, "J2": 1e-2 * inertia,
                "w": 2 * np.pi / self.time}  # fmt: skip


def shaper(units: Units = Units(), q2: float = 1.25, s: float = 0.316) -> Model:
    """The model in some units, with a start written by eye."""
    given = units.parameters
    return Model(
        name="shaper", coordinates=[Q1, Q2, S], kinetic_energy=J1 * Q1.diff() ** 2 / 2 + J2 * Q2.diff() ** 2 / 2,
        holonomic_constraints=[r * cos(Q1) - S * cos(Q2), h + r * sin(Q1) - S * sin(Q2), Q1 - w * t],
        parameters={symbol: given[symbol.name] for symbol in (r, h, J1, J2, w)},
        initial={Q2: q2, S: s * units.length},
    )  # fmt: skip


def closed_form(at: np.ndarray, units: Units = Units()) -> tuple[np.ndarray, np.ndarray]:
    """x, v (3, nt) at times."""
    r, h, w = (units.parameters[name] for name in ("r", "h", "w"))
    q1, s = w * at, np.sqrt(r**2 + h**2 + 2 * r * h * np.sin(w * at))
    q2, along = np.arctan2(h + r * np.sin(q1), r * np.cos(q1)), r * h * w * np.cos(q1)
    rate = (r**2 * w + r * h * w * np.sin(q1)) / s**2
    return np.array([q1, q2, s]), np.array([np.full_like(q1, w), rate, along / s])
