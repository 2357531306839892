"""Flyball governor: as the shaft turns, the balls rise and lift a sleeve by nearly rigid rods (a stiff system).

::

               | z
           ____o____  <- hinges on the shaft, b from its axis
        a1/    |    \\ a2
         /\\ c  |  c /\\           rods of length 2 l, a ball M at each end
        /  \\   |   /  \\          rods c: springs k with dampers c, from the middle of the arms to the sleeve
       O    [sleeve]    O                                    | g
      M      s, m        M                                   v

Coordinates: phi [rad] of the shaft, a1, a2 [rad] of the arms from the vertical, s [m] of the sleeve below the hinges.
Forces: the dampers. The springs are as stiff as steel rods, so explicit methods need steps of 1e-4 s.

Source: after the benchmark "flyball governor" of the IFToMM Technical Committee for Multibody Dynamics (M. Gonzalez,
D. Dopico, U. Lugris and J. Cuadrado, A benchmarking system for MBS simulation software, Multibody System Dynamics 16,
2006).
Oracles: Lagrange equations; high-precision integration; conservation of the angular momentum about the shaft.
"""

from sympy import Expr, Matrix, Rational, cos, pi, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

phi, a1, a2, s = coordinates = dynamicsymbols("phi a1 a2 s")
M, m, J, l, b, L = symbols("M m J l b L", positive=True)
k, c = symbols("k c", nonnegative=True)
g = symbols("g", real=True)


def arm(sign: int, angle: Expr, length: Expr) -> Matrix:
    """Return the point of an arm at a distance from its hinge, in axes that turn with the shaft."""
    return Matrix([sign * (b + length * sin(angle)), 0, -length * cos(angle)])


def turning(place: Matrix) -> Matrix:
    """Return a position in fixed axes."""
    return Matrix([[cos(phi), -sin(phi), 0], [sin(phi), cos(phi), 0], [0, 0, 1]]) * place


sides = ((1, a1), (-1, a2))
sleeve = Matrix([0, 0, -s])
balls = [turning(arm(sign, angle, 2 * l)) for sign, angle in sides]
rods = [arm(sign, angle, l) - Matrix([sign * b, 0, -s]) for sign, angle in sides]
lengths = [sqrt(rod.dot(rod)) for rod in rods]
stretching = [length.diff(t) for length in lengths]
kinetic_energy = sum(ball.diff(t).dot(ball.diff(t)) for ball in balls) * M + m * s.diff() ** 2 + J * phi.diff() ** 2

model = Model(
    name="governor",
    coordinates=coordinates,
    kinetic_energy=Rational(1, 2) * kinetic_energy,
    potential_energy=g * (M * sum(ball[2] for ball in balls) - m * s) + k * sum((n - L) ** 2 for n in lengths) / 2,
    forces={x: -c * sum(rate * rate.diff(x.diff()) for rate in stretching) for x in (a1, a2, s)},
    parameters={M: 5.0, m: 3.0, J: 1.0, l: 0.5, b: 0.05, k: 8e5, c: 4e4, L: 0.5, g: 9.81},
    initial={phi.diff(): 2 * pi, a1: pi / 6, a2: pi / 6, s: cos(pi / 6)},
    drawing=[
        draw.Line((0, 0, l / 2), (0, 0, -3 * l)),
        draw.Line(turning(Matrix([-b, 0, 0])), turning(Matrix([b, 0, 0]))),
        *(draw.Line(turning(arm(sign, angle, 0)), ball) for (sign, angle), ball in zip(sides, balls, strict=True)),
        *(
            draw.Spring(turning(arm(sign, angle, l)), turning(sleeve + Matrix([sign * b, 0, 0])))
            for sign, angle in sides
        ),
        *(draw.Disk(ball, l / 8) for ball in balls),
        draw.Disk(sleeve, 2 * b),
        draw.Trace(balls[0]),
    ],
)
