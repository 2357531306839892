"""Mass on a spring, carried along by a moving belt with LuGre friction: a stick-slip limit cycle.

::

    |      k      _____
    |--/\\/\\/\\/\\--|  m  |  ----> x
    |         ____|_____|____________
             ( o   bristles z      o )  ---> vb
              -----------------------

Coordinate: x [m] of the mass, from where the spring is relaxed. State: z [m], mean deflection of the bristles between
mass and belt. With v = vb - x', the speed of the belt relative to the mass [m/s],

    z' = v - s0 abs(v) z / g(v),    g(v) = Fc + (Fs - Fc) exp(-(v / vs)^2),    F = s0 z + s1 z' + s2 v   [N]

The mass sticks until the spring pulls with about Fs, and then slips back. The bristles are stiff: use `radau9`.

Source: C. Canudas de Wit, H. Olsson, K. J. Astrom and P. Lischinsky, A new model for control of systems with friction,
IEEE Transactions on Automatic Control 40 (1995), whose numbers these are.
Oracles: the equations by hand, integrated by SciPy's Radau; work of the belt = energy + heat.
"""

from sympy import Abs, Rational, exp, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, z = dynamicsymbols("x z")
m, k, s0, Fc, Fs, vs = symbols("m k s0 Fc Fs vs", positive=True)
s1, s2 = symbols("s1 s2", nonnegative=True)
vb = symbols("vb", real=True)

v = vb - x.diff()
deflecting = v - s0 * Abs(v) * z / (Fc + (Fs - Fc) * exp(-((v / vs) ** 2)))
friction = s0 * z + s1 * deflecting + s2 * v

size, wall, radius = Rational(3, 20), -1, Rational(1, 10)
left, right, belt = Rational(-1, 2), Rational(3, 2), -size
block = [(x + a * size, b * size) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]

model = Model(
    name="lugre_oscillator",
    coordinates=[x],
    kinetic_energy=Rational(1, 2) * m * x.diff() ** 2,
    potential_energy=Rational(1, 2) * k * x**2,
    forces={x: friction},
    states={z: deflecting},
    outputs={"friction": friction, "relative_speed": v, "belt_power": friction * vb, "heat": friction * v},
    parameters={m: 1.0, k: 2.0, s0: 1e5, s1: 1e5**0.5, s2: 0.4, Fc: 1.0, Fs: 1.5, vs: 1e-3, vb: 0.1},
    drawing=[
        draw.Line((wall, belt), (wall, size)),
        draw.Spring((wall, 0), (x - size, 0)),
        draw.Body(block),
        draw.Line((left, belt), (right, belt)),
        draw.Line((left, belt - 2 * radius), (right, belt - 2 * radius)),
        *(draw.Disk((end, belt - radius), radius, angle=-vb * t / radius) for end in (left, right)),
    ],
)
