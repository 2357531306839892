"""Hanging chain: n point masses on n massless links, in a plane.

::

    -----o-----
         |\\  l_1
         | \\
     theta_1 O m_1
             |\\  l_2
             | \\
         theta_2 O m_2
                  .
                   .
                    O m_n       | g
                                v

Coordinates: theta_1 ... theta_n [rad], each from the downward vertical.

Oracles: Lagrange equations; high-precision integration; n = 2 against `double_pendulum`.
"""

from sympy import Integer, Rational, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t


def model(n: int = 5) -> Model:
    """Return the chain of n links."""
    theta = dynamicsymbols(f"theta_1:{n + 1}")
    masses, lengths = symbols(f"m_1:{n + 1}", positive=True), symbols(f"l_1:{n + 1}", nonnegative=True)
    g = symbols("g", real=True)

    x = y = T = V = Integer(0)
    drawing: list[object] = [draw.Ground((0, 0))]
    for m, l, angle in zip(masses, lengths, theta, strict=True):
        joint = x, y
        x, y = x + l * sin(angle), y - l * cos(angle)
        drawing += [draw.Line(joint, (x, y)), draw.Disk((x, y), l / 12)]
        T += Rational(1, 2) * m * (x.diff(t) ** 2 + y.diff(t) ** 2)
        V += m * g * y

    return Model(
        name=f"chain_{n}",
        coordinates=theta,
        kinetic_energy=T,
        potential_energy=V,
        parameters=dict.fromkeys(masses, 1.0) | dict.fromkeys(lengths, 1.0) | {g: 9.81},
        initial=dict.fromkeys(theta, pi / 4),
        drawing=[*drawing, draw.Trace((x, y))],
    )
