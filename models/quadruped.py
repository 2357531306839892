"""Quadruped that walks on the floor: a free trunk, four legs of two joints with PD control, four feet with friction.

::

       ___________________       z upwards, x forward
      |___________________|==    trunk, free to move
      /      \\     /      \\      thighs: hips turn about y
      \\       \\    \\       \\
       \\      /     \\      /     shanks: knees turn about y
    ___.o____o______.o____o___   feet: points; each a contact with friction along x and y

Coordinates: x, y, z [m] of the trunk, its modified Rodrigues parameters s_1, s_2, s_3; hips and knees [rad].
Parameters: the trot, of diagonal legs, has the frequency f [Hz], stride [rad] of the hips and lift [rad] of the knees;
0: it stands. J [kg m^2] is the inertia of a motor's rotor, behind its gears: feet of light legs jam where they slide.

Oracles: the weight, which the contacts bear at rest; energy balance; homogeneous matrices for the places.
"""

from sympy import Max, cos, pi, sin, symbols, tanh
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Friction, Model, Tree, draw, multiplier, t

LENGTH, WIDTH = 0.25, 0.15
"""Half the distances between the hips [m]"""
THIGH = SHANK = 0.25
BENT = 0.6
"""Angle of the hips as it stands [rad]; knees turn by twice as much."""
DROP = 0.005
"""Height of the feet at the start [m]"""
LEGS = {"left_front": (1, 1, 0), "right_front": (1, -1, 1), "left_hind": (-1, 1, 1), "right_hind": (-1, -1, 0)}
"""Signs of x and y of the hips, and half turns by which the phase of a leg is behind"""

f, stride, lift = symbols("f stride lift", nonnegative=True)
k, d, mu, J = symbols("k d mu J", positive=True)


def model() -> Model:
    """Return the quadruped."""
    tree = Tree()
    place = dynamicsymbols("x y z s_1 s_2 s_3")
    trunk = tree.body("trunk", joint="free", mass=12.0, inertia=(0.12, 0.4, 0.5), coordinates=place)
    targets, feet, lines = {}, {}, []
    contacts: dict[str, Contact | Friction] = {}
    for name, (ahead, aside, late) in LEGS.items():
        thigh = tree.body(f"{name}_hip", trunk, joint="revolute", axis="y", at=(ahead * LENGTH, aside * WIDTH, 0),
                          mass=1.0, center=(0, 0, -0.1), inertia=(0.006, 0.006, 0.001))  # fmt: skip
        shank = tree.body(f"{name}_knee", thigh, joint="revolute", axis="y", at=(0, 0, -THIGH),
                          mass=0.3, center=(0, 0, -0.1), inertia=(0.002, 0.002, 0.0001))  # fmt: skip
        phase = 2 * pi * f * t + pi * late
        slowly = tanh(2 * t)
        targets[thigh.coordinates[0]] = BENT + stride * slowly * sin(phase)
        targets[shank.coordinates[0]] = -2 * BENT - lift * slowly * Max(0, -cos(phase)) ** 2
        feet[name] = shank.position((0, 0, -SHANK))
        slip = shank.velocity((0, 0, -SHANK))
        contacts[name] = Contact(feet[name][2])
        for letter, one in zip("xy", slip[:2], strict=True):
            contacts[f"{name}_{letter}"] = Friction(one, limit=mu, normal=name)
        lines += [draw.Line(thigh.position(), shank.position()), draw.Line(shank.position(), tuple(feet[name]))]
    corners = [(LENGTH, WIDTH), (LENGTH, -WIDTH), (-LENGTH, -WIDTH), (-LENGTH, WIDTH)]
    edges = [trunk.position((x, y, 0)) for x, y in corners]
    lines += [draw.Line(*ends) for ends in zip(edges, [*edges[1:], edges[0]], strict=True)]
    return Model(
        name="quadruped",
        coordinates=tree.coordinates,
        kinetic_energy=tree.kinetic_energy + sum(J * q.diff() ** 2 / 2 for q in targets),
        potential_energy=tree.potential_energy,
        forces={q: k * (target - q) - d * q.diff() for q, target in targets.items()},
        contacts=contacts,
        parameters={k: 300.0, d: 12.0, mu: 0.6, J: 0.2, f: 3.0, stride: 0.1, lift: 0.4},
        initial={place[2]: 2 * THIGH * cos(BENT) + DROP} | {q: target.subs({t: 0}) for q, target in targets.items()},
        outputs={"load": -sum(multiplier(name) for name in LEGS)},
        drawing=[
            draw.Ground((-0.5, 0.5, 0), (-0.5, -0.5, 0), (1, -0.5, 0), (1, 0.5, 0), (-0.5, 0.5, 0)),
            *lines,
            draw.Trace(trunk.position()),
        ],
    )
