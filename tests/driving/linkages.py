"""Linkages with motors: a six-bar of Watt's second kind, a delta robot and a Stewart platform with massive legs."""

import numpy as np
from sympy import Matrix, cos, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em


def six_bar() -> em.Model:
    """Two four-bars in a row: the rocker of the first, a rigid triangle, is the crank of the second."""
    q = dynamicsymbols("q1:6")
    (u,) = inputs = dynamicsymbols("u:1")
    t = em.t
    lengths, masses = (0.3, 0.9, 0.7, 0.8, 0.75), (0.5, 1.2, 1.0, 0.9, 1.1)
    ground, far, angle = Matrix([1.0, 0.0]), Matrix([1.9, 0.1]), 0.4

    def along(k: int) -> Matrix:
        return lengths[k] * Matrix([cos(q[k]), sin(q[k])])

    arm = 0.5 * Matrix([cos(q[2] - angle), sin(q[2] - angle)])  # of the triangle, to the second four-bar
    centers = [along(0) / 2, along(0) + along(1) / 2, ground + (along(2) + arm) / 3, ground + arm + along(3) / 2,
               far + along(4) / 2]  # fmt: skip
    return em.Model(
        name="six_bar",
        coordinates=q,
        kinetic_energy=sum(
            m * (p.diff(t).dot(p.diff(t)) + length**2 / 12 * one.diff() ** 2) / 2
            for m, p, length, one in zip(masses, centers, lengths, q, strict=True)
        ),
        potential_energy=9.81 * sum(m * p[1] for m, p in zip(masses, centers, strict=True)),
        forces={q[0]: u},
        inputs=dict.fromkeys(inputs, 0.0),
        holonomic_constraints={
            "first": list(along(0) + along(1) - ground - along(2)),
            "second": list(ground + arm + along(3) - far - along(4)),
        },
        initial={q[0]: 0.9, q[1]: 0.4, q[2]: 1.3, q[3]: 0.0, q[4]: 1.2},
    )


def turned(angle: float) -> np.ndarray:
    """Return R (3, 3) about z."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def delta() -> em.Model:
    """Three arms with motors u_a, u_b, u_c, whose parallelograms keep the platform (x, y, z) level."""
    tree = em.Tree()
    tree.body("x", joint="prismatic", axis="x", mass=0.01, inertia=(1e-4, 1e-4, 1e-4))
    tree.body("y", "x", joint="prismatic", axis="y", mass=0.01, inertia=(1e-4, 1e-4, 1e-4))
    platform = tree.body("z", "y", joint="prismatic", axis="z", mass=0.5, inertia=(1e-3, 1e-3, 1e-3))
    rows, motors = {}, {}
    for k, side in enumerate("abc"):
        direction = turned(2 * np.pi * k / 3)
        arm = tree.body(f"arm_{side}", joint="revolute", axis="y", at=tuple(direction @ (0.2, 0, 0)), mass=0.3,
                        rotation=direction, center=(0.15, 0, 0), inertia=(1e-4, 2e-3, 2e-3))  # fmt: skip
        swing = tree.body(f"swing_{side}", arm, joint="revolute", axis="y", at=(0.3, 0, 0), mass=0.01,
                          inertia=(1e-5, 1e-5, 1e-5))  # fmt: skip
        rod = tree.body(f"rod_{side}", swing, joint="revolute", axis="x", mass=0.2, center=(0, 0, -0.3),
                        inertia=(6e-3, 6e-3, 1e-4))  # fmt: skip
        rows[side] = list(platform.position(tuple(direction @ (0.05, 0, 0))) - rod.position((0, 0, -0.6)))
        motors[side] = tree.coordinates[-3]
    inputs = dict(zip("abc", dynamicsymbols("u_a u_b u_c"), strict=True))
    return em.Model(
        name="delta_robot",
        coordinates=tree.coordinates,
        kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy,
        forces={motors[side]: inputs[side] for side in "abc"},
        inputs=dict.fromkeys(inputs.values(), 0.0),
        holonomic_constraints=rows,
        initial={tree.coordinates[2]: -0.45} | {one: 0.6 for one in tree.coordinates if "swing" in str(one)},
    )


def stewart() -> em.Model:
    """A platform on six legs with motors u0 ... u5, each a universal joint and a slide: 24 coordinates, 18 rows."""
    tree = em.Tree()
    platform = tree.body("platform", joint="free", mass=5.0, inertia=(0.1, 0.1, 0.2))
    inputs, rows, forces, height = dynamicsymbols("u0:6"), {}, {}, 0.8
    initial = {tree.coordinates[2]: height}
    for k in range(6):
        low = np.pi / 3 * (k // 2 * 2) + (0.25 if k % 2 else -0.25)
        high = np.pi / 3 * (k // 2 * 2 + (1 if k % 2 else -1)) + (-0.2 if k % 2 else 0.2)
        foot = np.array([np.cos(low), np.sin(low), 0.0])
        head = 0.5 * np.array([np.cos(high), np.sin(high), 0.0])
        leg = head + np.array([0.0, 0.0, height]) - foot
        length = float(np.linalg.norm(leg))
        tilt = tree.body(f"tilt{k}", joint="revolute", axis="x", at=tuple(foot), mass=0.1, inertia=(1e-3, 1e-3, 1e-3))
        lower = tree.body(f"lower{k}", tilt, joint="revolute", axis="y", mass=1.0, center=(0, 0, 0.2),
                          inertia=(0.02, 0.02, 1e-3))  # fmt: skip
        upper = tree.body(f"upper{k}", lower, joint="prismatic", axis="z", mass=0.7, center=(0, 0, -0.2),
                          inertia=(0.01, 0.01, 1e-3))  # fmt: skip
        about_x, about_y, slide = tree.coordinates[-3:]
        initial |= {
            about_x: float(np.arctan2(-leg[1], leg[2])),
            about_y: float(np.arcsin(leg[0] / length)),
            slide: length,
        }
        rows[f"leg{k}"] = list(upper.position((0, 0, 0)) - platform.position(tuple(head)))
        forces[slide] = inputs[k]
    return em.Model(
        name="stewart_platform",
        coordinates=tree.coordinates,
        kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy,
        forces=forces,
        inputs=dict.fromkeys(inputs, 0.0),
        holonomic_constraints=rows,
        initial=initial,
    )
