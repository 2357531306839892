"""Robot arm of six revolute joints as a tree of bodies, with a payload, springs and dampers in its joints.

::

                 elbow      wrist
        shoulder   o----------o--o  hand, payload
           o______/              |
           |
         __|__ turret (z)        all others about y, y, y, z, y

Coordinates: turret, shoulder, elbow, wrist_1, wrist_2, wrist_3 [rad], relative angles.
Inputs: the torques of the motors tau_1 ... tau_6 [N m].

Oracles: Lagrange's equations of the energies by forward kinematics; articulated bodies against Cholesky.
"""

from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Tree, draw

NAMES = ("turret", "shoulder", "elbow", "wrist_1", "wrist_2", "wrist_3")
AXES = "zyyyzy"
PLACES = ((0, 0, 0.09), (0, 0.13, 0), (0, -0.12, 0.42), (0, 0, 0.39), (0, 0.09, 0), (0, 0, 0.09))
MASSES = (3.7, 8.4, 2.3, 1.2, 1.2, 0.2)
CENTRES = ((0, 0.07, 0), (0, 0, 0.21), (0, 0, 0.19), (0, 0.05, 0), (0, 0, 0.05), (0, 0.03, 0))
INERTIAS = ((0.010, 0.010, 0.007), (0.225, 0.225, 0.015), (0.049, 0.049, 0.004), (0.004, 0.003, 0.004),
            (0.004, 0.004, 0.003), (0.0002, 0.0002, 0.0002))  # fmt: skip


def model() -> Model:
    """Return the arm."""
    payload, k, d = symbols("payload k d", nonnegative=True)
    torques = dynamicsymbols("tau_1:7")
    tree, body = Tree(), None
    points = []
    for name, axis, at, mass, center, inertia in zip(NAMES, AXES, PLACES, MASSES, CENTRES, INERTIAS, strict=True):
        body = tree.body(name, body, joint="revolute", axis=axis, at=at, mass=mass, center=center, inertia=inertia)
        points.append(body.position())
    hand = tree.body("hand", body, joint="fixed", at=(0, 0.08, 0), mass=payload)
    points.append(hand.position())
    angles = tree.coordinates
    return Model(
        name="robot_arm",
        coordinates=angles,
        kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy + sum(k * q**2 / 2 for q in angles),
        forces={q: tau - d * q.diff() for q, tau in zip(angles, torques, strict=True)},
        parameters={payload: 2.0, k: 30.0, d: 0.5},
        inputs=dict.fromkeys(torques, 0.0),
        initial=dict(zip(angles, (0.3, 0.9, -1.1, 0.4, 0.2, 0.1), strict=True)),
        outputs={f"hand_{letter}": hand.position()[i] for i, letter in enumerate("xyz")},
        drawing=[
            draw.Ground((0, 0, 0)),
            *(draw.Line(start, end) for start, end in zip([(0, 0, 0), *points[:-1]], points, strict=True)),
            draw.Trace(points[-1]),
        ],
    )
