"""Humanoid that squats with both feet planted: 21 joints with PD control, and a closed loop through the ground.

::

            o   head
        o--[ ]--o  shoulders     x forward, y to the left, z upwards
        |  [ ]  |                left foot: the ground of the tree
        o   |   o  elbows        right foot: held to the ground by six constraint rows
           [_]     pelvis
           o o     knees
           | |
          == ==    feet

Coordinates: ankles, knees and hips of both legs, waist, neck, shoulders, elbows [rad], relative angles; 0: upright.
Input: depth, between 0 (almost straight legs) and 1; the joints follow by PD control, with the torques k (target - q) -
d qdot, and gravity is not compensated.

Oracles: homogeneous matrices for the places; statics of the load on the feet; articulated bodies against Cholesky.
"""

from itertools import pairwise
from typing import Any

from eigenmotion.codegen.model.tree.tree import Body
from sympy import Matrix, symbols, sympify
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Tree, draw, multiplier

SHIN = THIGH = 0.42
HIP, ANKLE = 0.1, 0.08
"""Half the distance between the hips, and the height of the ankles [m]"""
BENT, SQUAT = 0.2, 0.9
"""Angles of the ankles at depth 0 and 1 [rad]; knees turn by twice as much, so that the trunk stays upright."""

depth = dynamicsymbols("depth")
k, d = symbols("k d", positive=True)


def rod(mass: float, length: float, radius: float, sign: int = 1) -> dict[str, Any]:
    """Return the mass properties of a cylinder from its joint along z, upwards or downwards."""
    across = mass * (3 * radius**2 + length**2) / 12
    return {"mass": mass, "center": (0, 0, sign * length / 2), "inertia": (across, across, mass * radius**2 / 2)}


class Figure:
    """The tree, the angles at which the controllers hold its joints, and the lines of its drawing."""

    def __init__(self) -> None:
        self.tree = Tree()
        self.targets: dict[Any, Any] = {}
        self.lines: list[Any] = []

    def joint(self, name: str, parent: Body | None, axis: str, target: Any = 0.0, **more: Any) -> Body:
        """Add a revolute joint with its target."""
        body = self.tree.body(name, parent, joint="revolute", axis=axis, **more)
        self.targets[body.coordinates[0]] = sympify(target)
        return body

    def line(self, body: Body, *points: tuple[float, float, float]) -> None:
        """Draw lines between points of a body."""
        places = [body.position(point) for point in points]
        self.lines += [draw.Line(*ends) for ends in pairwise(places)]


def model() -> Model:
    """Return the humanoid."""
    figure, lean = Figure(), BENT + (SQUAT - BENT) * depth
    pelvis = left_leg(figure, lean)
    trunk(figure, pelvis)
    foot = right_leg(figure, pelvis, lean)
    corner = Matrix([0, -2 * HIP, 0])
    held = foot.position() - corner
    R = foot.rotation
    targets, rates = figure.targets, {q: q.diff() for q in figure.tree.coordinates}
    return Model(
        name="humanoid",
        coordinates=figure.tree.coordinates,
        kinetic_energy=figure.tree.kinetic_energy,
        potential_energy=figure.tree.potential_energy,
        forces={q: k * (targets[q] - q) - d * rate for q, rate in rates.items()},
        holonomic_constraints={"sole": list(held), "turn": [R[2, 1], R[0, 2], R[1, 0]]},
        parameters={k: 2000.0, d: 60.0},
        inputs={depth: 0.0},
        initial={q: target.subs(depth, 0) for q, target in targets.items()},
        outputs={"pelvis": pelvis.position()[2], "right_load": -multiplier("sole", 2)},
        drawing=[
            draw.Ground((-0.5, 0.4, 0), (-0.5, -0.6, 0), (0.6, -0.6, 0), (0.6, 0.4, 0), (-0.5, 0.4, 0)),
            *figure.lines,
        ],
    )


def left_leg(figure: Figure, lean: Any) -> Body:
    """Add the left leg from the ground upwards, and return the pelvis."""
    roll = figure.joint("left_ankle_roll", None, "x", at=(0, 0, ANKLE))
    shin = figure.joint("left_ankle", roll, "y", lean, **rod(4.0, SHIN, 0.05))
    thigh = figure.joint("left_knee", shin, "y", -2 * lean, at=(0, 0, SHIN), **rod(8.0, THIGH, 0.07))
    pitch = figure.joint("left_hip", thigh, "y", lean, at=(0, 0, THIGH))
    swing = figure.joint("left_hip_roll", pitch, "x")
    pelvis = figure.joint("left_hip_yaw", swing, "z", mass=10.0, center=(0, -HIP, 0.05), inertia=(0.1, 0.08, 0.1))
    figure.line(shin, (0, 0, 0), (0, 0, SHIN))
    figure.lines.append(draw.Line((0, 0, ANKLE), (0.15, 0, 0)))
    figure.line(thigh, (0, 0, 0), (0, 0, THIGH))
    figure.line(pelvis, (0, 0, 0), (0, -2 * HIP, 0), (0, -HIP, 0.1), (0, 0, 0))
    return pelvis


def right_leg(figure: Figure, pelvis: Body, lean: Any) -> Body:
    """Add the right leg from the pelvis downwards, and return its foot, whose origin is on the ground."""
    yaw = figure.joint("right_hip_yaw", pelvis, "z", at=(0, -2 * HIP, 0))
    swing = figure.joint("right_hip_roll", yaw, "x")
    thigh = figure.joint("right_hip", swing, "y", -lean, **rod(8.0, THIGH, 0.07, -1))
    shin = figure.joint("right_knee", thigh, "y", 2 * lean, at=(0, 0, -THIGH), **rod(4.0, SHIN, 0.05, -1))
    pitch = figure.joint("right_ankle", shin, "y", -lean, at=(0, 0, -SHIN))
    roll = figure.joint(
        "right_ankle_roll", pitch, "x", mass=1.0, center=(0.05, 0, -0.05), inertia=(0.002, 0.004, 0.004)
    )
    figure.line(thigh, (0, 0, 0), (0, 0, -THIGH))
    figure.line(shin, (0, 0, 0), (0, 0, -SHIN))
    figure.line(roll, (0, 0, 0), (0.15, 0, -ANKLE))
    return figure.tree.body("right_sole", roll, joint="fixed", at=(0, 0, -ANKLE))


def trunk(figure: Figure, pelvis: Body) -> None:
    """Add the chest, the head and the arms."""
    waist = figure.joint("waist", pelvis, "y", at=(0, -HIP, 0.1))
    chest = figure.joint("chest", waist, "z", mass=25.0, center=(0, 0, 0.25), inertia=(0.9, 0.8, 0.4))
    head = figure.joint("neck", chest, "y", at=(0, 0, 0.5), **rod(5.0, 0.25, 0.1))
    figure.line(chest, (0, 0, 0), (0, 0, 0.5), (0, 0.2, 0.45), (0, -0.2, 0.45), (0, 0, 0.5))
    figure.lines.append(draw.Disk(head.position((0, 0, 0.15)), 0.1))
    for side, sign in (("left", 1), ("right", -1)):
        shoulder = figure.joint(f"{side}_shoulder", chest, "y", -1.2 * depth, at=(0, 0.2 * sign, 0.45))
        upper = figure.joint(f"{side}_shoulder_roll", shoulder, "x", **rod(2.5, 0.3, 0.04, -1))
        lower = figure.joint(f"{side}_elbow", upper, "y", -0.4, at=(0, 0, -0.3), **rod(2.0, 0.3, 0.03, -1))
        figure.line(upper, (0, 0, 0), (0, 0, -0.3))
        figure.line(lower, (0, 0, 0), (0, 0, -0.3))
