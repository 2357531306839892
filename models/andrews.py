"""Andrews' squeezing mechanism: seven bodies in the plane, a motor and a spring, with a motion of 0.03 s.

::

              C                         K1: crank O - P, driven by a constant torque `mom`
               \\ spring c0, l0         K2: coupler P - Q
        D ------+ K3                    K3: a rocker about B, to Q; the spring pulls at its corner D
         \\     |                       K4, K5: Q - E - A, at the angles phi + delta and delta
    B o---\\----+                       K6, K7: Q - H - A, at the angles omega + epsilon and epsilon
                \\
    A o== K5 ==E=K4=Q===K2===P          no gravity
      o== K7 ==H=K6=+        | K1
                             o O

Coordinates: beta, theta, gamma, phi, delta, omega, epsilon [rad]. Lengths [m], masses [kg], inertias [kg m^2].
Holonomic constraints: the chain from O, the rocker from B, and two chains from A all end at Q.

Source: G. C. Andrews and M. K. Ormrod, Advent: a simulation program for constrained planar kinematic and dynamic
systems, ASME paper 86-DET-97 (1986); data and reference in the Test Set for IVP Solvers (F. Mazzia and C. Magherini,
release 2.4, 2008) and in Hairer and Wanner, Solving Ordinary Differential Equations II, VII.7.
Oracle: the coordinates published there at t = 0.03 s.
"""

from sympy import Expr, Matrix, Rational, cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

beta, theta, gamma, phi, delta, omega, epsilon = angles = dynamicsymbols("beta theta gamma phi delta omega epsilon")
masses, inertias = symbols("m1:8", positive=True), symbols("I1:8", positive=True)
xa, ya, xb, yb, xc, yc = symbols("xa ya xb yb xc yc")
d, da, e, ea, rr, ra, ss, sa, sb, sc, sd = symbols("d da e ea rr ra ss sa sb sc sd", positive=True)
ta, tb, u, ua, ub, zf, zt = symbols("ta tb u ua ub zf zt", positive=True)
fa = symbols("fa", nonnegative=True)
l0 = symbols("l0", positive=True)
c0 = symbols("c0", nonnegative=True)
mom = symbols("mom", real=True)


def turned(x: Expr, y: Expr, angle: Expr) -> Matrix:
    """Return the vector (x, y) rotated by an angle."""
    return Matrix([x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)])


O, A, B, C = Matrix([0, 0]), Matrix([xa, ya]), Matrix([xb, yb]), Matrix([xc, yc])
P = turned(rr, 0, beta)
Q = P - turned(d, 0, beta + theta)
D = B + turned(sd, -sc, gamma)
E, H = A + turned(zt, 0, delta), A + turned(0, -u, epsilon)
turns = [beta, beta + theta, gamma, phi + delta, delta, omega + epsilon, epsilon]
centres = [
    turned(ra, 0, beta),
    P - turned(da, 0, beta + theta),
    B + turned(sb, -sa, gamma),
    E + turned(0, ea - e, phi + delta),
    A + turned(-tb, ta, delta),
    H + turned(zf - fa, 0, omega + epsilon),
    A + turned(-ub, -ua, epsilon),
]
kinetic_energy = sum(
    Rational(1, 2) * (m * centre.diff(t).dot(centre.diff(t)) + I * turn.diff(t) ** 2)
    for m, I, centre, turn in zip(masses, inertias, centres, turns, strict=True)
)
stretch = sqrt((D - C).dot(D - C)) - l0
ends = [B + turned(0, -ss, gamma), E + turned(0, -e, phi + delta), H + turned(zf, 0, omega + epsilon)]

model = Model(
    name="andrews",
    coordinates=angles,
    kinetic_energy=kinetic_energy,
    potential_energy=c0 * stretch**2 / 2 - mom * beta,
    holonomic_constraints=[entry for end in ends for entry in Q - end],
    parameters=dict(zip(masses, (0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498), strict=True))
    | dict(zip(inertias, (2.194e-6, 4.41e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5), strict=True))
    | {xa: -0.06934, ya: -0.00227, xb: -0.03635, yb: 0.03273, xc: 0.014, yc: 0.072}
    | {d: 0.028, da: 0.0115, e: 0.02, ea: 0.01421, rr: 0.007, ra: 0.00092}
    | {ss: 0.035, sa: 0.01874, sb: 0.01043, sc: 0.018, sd: 0.02, ta: 0.02308, tb: 0.00916}
    | {u: 0.04, ua: 0.01228, ub: 0.00449, zf: 0.02, zt: 0.04, fa: 0.01421, c0: 4530.0, l0: 0.07785, mom: 0.033},
    initial={
        beta: -0.0617138900142764496,
        gamma: 0.455279819163070380,
        phi: 0.222668390165885885,
        delta: 0.487364979543842550,
        omega: -0.222668390165885885,
        epsilon: 1.23054744454982119,
    },
    drawing=[
        draw.Ground(O),
        draw.Ground(A),
        draw.Ground(B),
        draw.Spring(C, D),
        draw.Body([B, ends[0], D]),
        draw.Line(O, P),
        draw.Line(P, Q),
        draw.Line(A, E),
        draw.Line(E, Q),
        draw.Line(A, H),
        draw.Line(H, Q),
        draw.Disk(P, ra),
        draw.Trace(Q),
    ],
)
