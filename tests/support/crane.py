"""A model with names, units and powers of each kind, an input, outputs and a named constraint, for tests of looks."""

from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import draw, multiplier


def measured_crane() -> em.Model:
    """A load on a rope from a trolley."""
    s, swing, rope = dynamicsymbols("s_trolley swing rope")
    m, load, g, drag = symbols("m_trolley m_load g drag", positive=True)
    push = dynamicsymbols("push")
    height, place = -rope * cos(swing), s + rope * sin(swing)
    speed = place.diff() ** 2 + height.diff() ** 2
    return em.Model(
        name="crane_with_units", coordinates=[s, swing, rope], inputs={push: 0.5},
        kinetic_energy=m * s.diff() ** 2 / 2 + load * speed / 2, potential_energy=load * g * height,
        forces={s: push - drag * s.diff()}, holonomic_constraints={"rope_length": [rope - 2]},
        parameters={m: 4.0, load: 1.5, g: 9.81, drag: 0.2}, initial={swing: 0.8, rope: 2.0},
        outputs={"tension": multiplier("rope_length"), "acceleration_of_gravity": g},
        drawing=[draw.Line((-3, 0), (3, 0)), draw.Disk((s, 0), 0.2), draw.Line((s, 0), (place, height))],
        units={s: "m", swing: "rad", rope: "m", m: "kg", load: "kg", g: "m/s^2", drag: "kg s^-1", push: "kg m/s^2",
               "tension": "N", "acceleration_of_gravity": "m/s^2", "energy": "kg m^2/s^2", "length": "m"},
    )  # fmt: skip
