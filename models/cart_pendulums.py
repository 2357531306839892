"""Pendulum of n links on a cart that is driven by a force.

::

                 o m2
          l2    /
               /  q2: from the upright, to the left
              o m1
        l1     \\  q1                          | g
                \\                             v
        F -->  [ m0 ]  x
        ========o==o==========

Coordinates: x [m] of the cart, q1 ... qn [rad]. Point masses on rods without mass. Input: F [N], on the cart.

The model is built from SymPy's bodies by `from_mechanics`: speeds v, u1 ... un become quasi-velocities, weights become
V, the force becomes Q.
Source: `sympy.physics.mechanics.models.n_link_pendulum_on_cart`; tests compare with its Kane's equations.
Oracles: Lagrange equations; high-precision integration.
"""

from itertools import pairwise

from sympy import symbols
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, dynamicsymbols

from eigenmotion import Model, draw, from_mechanics


def model(n: int = 3) -> Model:
    """Return the pendulum of n links."""
    x, *angles = coordinates = dynamicsymbols(f"x q1:{n + 1}")
    v, *rates = speeds = dynamicsymbols(f"v u1:{n + 1}")
    F = dynamicsymbols("F")
    masses, lengths, g = symbols(f"m:{n + 1}", positive=True), symbols(f"l1:{n + 1}", positive=True), symbols("g")

    N, origin = ReferenceFrame("N"), Point("origin")
    origin.set_vel(N, 0)
    joint = origin.locatenew("cart", x * N.x)
    joint.set_vel(N, v * N.x)
    bodies = [Particle("cart", joint, masses[0])]
    for k, (q, u, m, l) in enumerate(zip(angles, rates, masses[1:], lengths, strict=True), 1):
        link = N.orientnew(f"link{k}", "Axis", [q, N.z])
        link.set_ang_vel(N, u * N.z)
        below, joint = joint, joint.locatenew(f"mass{k}", l * link.y)
        joint.v2pt_theory(below, N, link)
        bodies.append(Particle(f"mass{k}", joint, m))

    places = [body.masscenter.pos_from(origin).to_matrix(N)[:2] for body in bodies]
    size = lengths[0] / 4
    return from_mechanics(
        bodies,
        frame=N,
        fixed_point=origin,
        coordinates=coordinates,
        speeds=speeds,
        kinematic_equations=[q.diff() - u for q, u in zip(coordinates, speeds, strict=True)],
        loads=[*((body.masscenter, -body.mass * g * N.y) for body in bodies), (bodies[0].masscenter, F * N.x)],
        name=f"cart_pendulums_{n}",
        parameters={masses[0]: 2.0} | dict.fromkeys(masses[1:], 0.5) | dict.fromkeys(lengths, 0.4) | {g: 9.81},
        inputs={F: 0.0},
        initial={angle: 0.1 + 0.05 * k for k, angle in enumerate(angles)},
        drawing=[
            draw.Ground((6 * size, -size), (-6 * size, -size)),
            draw.Body([(x + a * size, b * size) for a, b in ((-1, -1), (1, -1), (1, 0), (-1, 0))]),
            *(draw.Line(p, q) for p, q in pairwise(places)),
            *(draw.Disk(place, size / 5) for place in places[1:]),
            draw.Trace(places[-1]),
        ],
    )
