"""Double inverted pendulum on a cart, which a servo drives by a toothed belt and a controller keeps upright.

::

                      / 2
               l2    /  q2: from the upright, to the right
                    o
             l1    /
                  /  q1                             | g
                 /                                  v
             [  o  ]  m0      x
        o====[=====]===========o   toothed belt
      motor, pulley r          pulley

Coordinates: x [m] of the cart, q1, q2 [rad] of the rods. Rods are slender, of masses m1 and m2.
States: i [A], current of the motor; e [A s], integral of the current controller. Input: target [m] of the cart.

    motor           L i' = u - R i - K x' / r,    force on the cart K i / r
    current loop    u = max(-most, min(most, w)),  w = kp (wanted - i) + ki e,  e' = wanted - i + (u - w) / kp
    balance         wanted = -(k1 (x - target) + k2 q1 + k3 q2 + k4 x' + k5 q1' + k6 q2')   [A]

The last term of e' stops the integral while the voltage is at its limit (back-calculation, a form of anti-windup).

Gains of the current loop: a bandwidth of 500 rad/s, kp = 500 L, ki = 500 R. Gains of the balance: the linear quadratic
regulator of the linearised mechanism with the current as input, for the weights diag(40, 10, 10, 1, 1, 1) of the
coordinates and rates and 0.05 of the current, rounded to four digits; `tests/states/test_servo_pendulums.py` computes
them again.

Oracles: Newton's and Kirchhoff's equations by hand, integrated by SciPy; the energy that the amplifier delivers is
that of the motion and of the coil, and the heat; eigenvalues of the closed loop.
"""

from sympy import Max, Min, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, q1, q2, i, e, target = dynamicsymbols("x q1 q2 i e target")
m0, m1, m2, l1, l2, J, r = symbols("m0 m1 m2 l1 l2 J r", positive=True)
K, R, L, kp, ki, most = symbols("K R L kp ki most", positive=True)
d0, d1, d2 = symbols("d0 d1 d2", nonnegative=True)
g = symbols("g", real=True)
gains = symbols("k1:7", real=True)

joint = x + l1 * sin(q1), l1 * cos(q1)
tip = joint[0] + l2 * sin(q2), joint[1] + l2 * cos(q2)
middles = ((x + joint[0]) / 2, joint[1] / 2), ((joint[0] + tip[0]) / 2, (joint[1] + tip[1]) / 2)
rods = ((m1, l1, q1), (m2, l2, q2))
rods_energy = sum(
    mass * (px.diff(t) ** 2 + py.diff(t) ** 2 + length**2 / 12 * angle.diff() ** 2) / 2
    for (mass, length, angle), (px, py) in zip(rods, middles, strict=True)
)

errors = (x - target, q1, q2, x.diff(), q1.diff(), q2.diff())
wanted = -sum(gain * error for gain, error in zip(gains, errors, strict=True))
command = kp * (wanted - i) + ki * e
voltage = Max(-most, Min(most, command))
bending = q2.diff() - q1.diff()
size, end = l1 / 6, 2 * l1
belt = -size - r

model = Model(
    name="servo_pendulums",
    coordinates=[x, q1, q2],
    kinetic_energy=Rational(1, 2) * (m0 + J / r**2) * x.diff() ** 2 + rods_energy,
    potential_energy=g * sum(mass * py for (mass, _, _), (_, py) in zip(rods, middles, strict=True)),
    forces={x: K * i / r - d0 * x.diff(), q1: -d1 * q1.diff() + d2 * bending, q2: -d2 * bending},
    states={
        i: (voltage - R * i - K * x.diff() / r) / L,
        e: wanted - i + (voltage - command) / kp,
    },
    inputs={target: 0.0},
    outputs={
        "voltage": voltage,
        "wanted": wanted,
        "force": K * i / r,
        "electric_power": voltage * i,
        "heat": R * i**2 + d0 * x.diff() ** 2 + d1 * q1.diff() ** 2 + d2 * bending**2,
    },
    parameters={
        m0: 0.6, m1: 0.1, m2: 0.08, l1: 0.3, l2: 0.4, J: 8e-5, r: 0.02, d0: 2.0, d1: 2e-4, d2: 2e-4, g: 9.81,
        K: 0.1, R: 0.5, L: 1e-3, kp: 0.5, ki: 250.0, most: 8.0,
        **dict(zip(gains, (28.28, -84.28, 198.9, 25.91, 7.476, 26.91), strict=True)),
    },
    initial={q1: 0.15, q2: -0.1},
    drawing=[
        *(draw.Disk((side * end, belt), r, angle=x / r) for side in (-1, 1)),
        *(draw.Line((-end, belt + side * r), (end, belt + side * r)) for side in (-1, 1)),
        draw.Body([(x + a * size, b * size) for a, b in ((-1, -1), (1, -1), (1, 0), (-1, 0))]),
        draw.Line((x, 0), joint),
        draw.Line(joint, tip),
        draw.Trace(tip),
    ],
)  # fmt: skip
