"""The paper's constrained dual-link manipulator: Figure 1, (56)-(61).

::

    (0, 4) o
           :  K2
           :. . . . . . . .o m2   hand (x, y), at constant height: ydot = 0
           :              /
           :             / l2, theta2
           :            /
           :           o m1
           :          /  ` K3, relaxed at theta4 - theta1 = pi/2
           :         /    `
           : K1 -> z        o m3        l3, theta4: direction of the rod m1 - m3
           :      z   l1 + theta3
           :     /  theta1
    -------o--------------------> x

Coordinates: theta1, theta2, theta4 [rad], angles from the horizontal; theta3 [m], stretch of the first link.
The constraint is on the velocities, as in the paper (61).

Oracles: the certified state and multiplier at t = 10 s; Lagrange equations; high-precision integration.
"""

from sympy import Rational, cos, pi, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

theta1, theta2, theta3, theta4 = dynamicsymbols("theta1:5")
m1, m2, m3, l1, l2, l3 = symbols("m1:4 l1:4", positive=True)
K1, K2, K3 = symbols("K1:4", nonnegative=True)

half = Rational(1, 2)
reach = l1 + theta3
omega1, omega2, stretch_rate, omega4 = (angle.diff() for angle in (theta1, theta2, theta3, theta4))

x = reach * cos(theta1) + l2 * cos(theta2)  # (56)
y = reach * sin(theta1) + l2 * sin(theta2)  # (57)

elbow = reach * cos(theta1), reach * sin(theta1)
tip = elbow[0] + l3 * cos(theta4), elbow[1] + l3 * sin(theta4)

kinetic_energy = (  # (59)
    half * m1 * (reach**2 * omega1**2 + stretch_rate**2)
    + half * m3 * l3**2 * omega4**2
    + half
    * m2
    * (
        reach**2 * omega1**2
        + l2**2 * omega2**2
        + stretch_rate**2
        + 2 * reach * l2 * cos(theta1 - theta2) * omega1 * omega2
        + 2 * l2 * sin(theta1 - theta2) * omega2 * stretch_rate
    )
)
potential_energy = (  # (58)
    half * K1 * theta3**2 + half * K2 * (x**2 + (4 - y) ** 2) + half * K3 * (theta4 - theta1 - pi / 2) ** 2
)

model = Model(
    name="dual_link",
    coordinates=[theta1, theta2, theta3, theta4],
    kinetic_energy=kinetic_energy,
    potential_energy=potential_energy,
    nonholonomic_constraints=[y.diff(t)],  # (61)
    parameters={m1: 1.0, m2: 1.0, m3: 1.0, l1: 0.5, l2: 1 / sqrt(2), l3: 0.5, K1: 1.0, K2: 1.0, K3: 0.5},
    initial={theta1: pi / 6, theta2: pi / 3, theta3: 0, theta4: 3 * pi / 4},
    drawing=[
        draw.Trace((x, y)),
        draw.Ground((0, 0)),
        draw.Ground((0, 4)),
        draw.Spring((0, 4), (x, y)),
        draw.Spring((0, 0), elbow),
        draw.Line(elbow, (x, y)),
        draw.Line(elbow, tip),
        draw.Disk(elbow, l1 / 10),
        draw.Disk((x, y), l1 / 10),
        draw.Disk(tip, l1 / 10),
    ],
)
