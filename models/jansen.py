"""Jansen's linkage: a leg of Theo Jansen's beach animals, whose crank makes the foot step along the ground.

::

                C
             e /| \\ j
              / |b   \\
             D  |      P
           d  \\ |   k . ' \\ m, crank theta         BCD and EFG are triangles of bars;
             f |B- - - - - O                          B and O are fixed pins               | g
               |  \\ c .                                                                   v
               F---E
              h \\  | i
                 \\ |
                   G foot

Coordinates [rad]: theta of the crank; aj, ak, ac, af of bars j, k, c, f; ab of the upper triangle (B to C); ag of the
lower triangle (E to F). Bars: slender, of `density` [kg/m]. A motor turns the crank by a constant torque.
Holonomic constraints: closure of three loops, at C, E and F.

Source: T. Jansen, The great pretender (2007), for the lengths, his "holy numbers", here in metres.
Oracles: the joints by intersection of circles at every crank angle, and the energy; high-precision integration.
"""

from math import acos, atan2, hypot

from sympy import Expr, Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

NUMBERS = {
    "a": 0.38, "b": 0.415, "c": 0.393, "d": 0.401, "e": 0.558, "f": 0.394, "g": 0.367, "h": 0.657, "i": 0.49, "j": 0.5,
    "k": 0.619, "l": 0.078, "m": 0.15,
}  # fmt: skip
theta, aj, ab, ak, ac, af, ag = coordinates = dynamicsymbols("theta aj ab ak ac af ag")
lengths = dict(zip(NUMBERS, symbols("a b c d e f g h i j k l m", positive=True), strict=True))
density, J = symbols("density J", positive=True)
torque, gravity = symbols("torque gravity", real=True)


def bar(length: str, angle: Expr) -> Matrix:
    """Return the vector along a bar."""
    return lengths[length] * Matrix([cos(angle), sin(angle)])


def corner(near: str, opposite: str, far: str) -> Expr:
    """Return the cosine of the angle between two sides of a triangle, `near` and `far`, by the law of cosines."""
    p, q, r = lengths[near], lengths[far], lengths[opposite]
    return (p**2 + q**2 - r**2) / (2 * p * q)


def beside(near: str, angle: Expr, far: str, opposite: str) -> Matrix:
    """Return the third corner of a triangle, from the start of a bar and to the left of it."""
    cosine = corner(near, opposite, far)
    along, across = lengths[far] * cosine, lengths[far] * (1 - cosine**2) ** Rational(1, 2)
    return along * Matrix([cos(angle), sin(angle)]) + across * Matrix([-sin(angle), cos(angle)])


O, B = Matrix([0, 0]), -Matrix([lengths["a"], lengths["l"]])
P = bar("m", theta)
C, E = B + bar("b", ab), B + bar("c", ac)
D = B + beside("b", ab, "d", "e")
F = E + bar("g", ag)
G = E + beside("g", ag, "i", "h")
bars = [(P, C, "j"), (P, E, "k"), (B, C, "b"), (B, D, "d"), (C, D, "e"),
        (B, E, "c"), (D, F, "f"), (E, F, "g"), (E, G, "i"), (F, G, "h")]  # fmt: skip


def energy(p: Matrix, q: Matrix, length: str) -> Expr:
    """Return the kinetic energy of a slender bar."""
    u, v = p.diff(t), q.diff(t)
    return density * lengths[length] * (u.dot(u) + u.dot(v) + v.dot(v)) / 6


def circles(p: tuple[float, float], r: float, q: tuple[float, float], s: float, side: int) -> tuple[float, float]:
    """Return the directions from p and from q to an intersection of circles about them: left (1) or right of p -> q."""
    x, y = q[0] - p[0], q[1] - p[1]
    distance, heading = hypot(x, y), atan2(y, x)
    at_p = acos((r**2 + distance**2 - s**2) / (2 * r * distance))
    at_q = acos((s**2 + distance**2 - r**2) / (2 * s * distance))
    return heading + side * at_p, heading + 3.141592653589793 - side * at_q


def numbers(place: Matrix, known: dict[Expr, float]) -> tuple[float, float]:
    """Return a position as numbers, for known angles."""
    values = {symbol: NUMBERS[name] for name, symbol in lengths.items()}
    return tuple(float(entry.subs(known | values)) for entry in place)  # type: ignore[return-value]


n, start = NUMBERS, {theta: 0.5}
start[ab], start[aj] = circles(numbers(B, start), n["b"], numbers(P, start), n["j"], 1)
start[ac], start[ak] = circles(numbers(B, start), n["c"], numbers(P, start), n["k"], -1)
start[af], start[ag] = circles(numbers(D, start), n["f"], numbers(E, start), n["g"], -1)

model = Model(
    name="jansen",
    coordinates=coordinates,
    kinetic_energy=J * theta.diff() ** 2 / 2 + sum(energy(*one) for one in bars),
    potential_energy=gravity * density * sum(lengths[name] * (p + q)[1] / 2 for p, q, name in bars) - torque * theta,
    holonomic_constraints=[*(P + bar("j", aj) - C), *(P + bar("k", ak) - E), *(D + bar("f", af) - F)],
    parameters={lengths[name]: value for name, value in n.items()}
    | {density: 1.0, J: 0.02, torque: 1.2, gravity: 9.81},
    initial=start,
    drawing=[
        draw.Ground(O),
        draw.Ground(B),
        draw.Trace(G),
        draw.Line(O, P),
        *(draw.Line(p, q) for p, q, _ in bars),
        draw.Disk(P, lengths["m"] / 10),
        draw.Disk(G, lengths["m"] / 10),
    ],
)
