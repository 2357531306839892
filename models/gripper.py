"""Gripper with parallel pads: a plunger pulls two rods, which turn the fingers; six constraint rows close its loops.

::

       |pad        pad|          z upwards, y to the left; all joints turn about x
       o===o      o===o          o pins
       |   |      |   |          cranks (inner) and rockers (outer) of both fingers
       o   o--. .-o   o
              | |
              [=]  plunger, along z

Coordinates: plunger [m]; crank, rocker and pad of each finger [rad], cranks and rockers from the upright, pads from the
crank. Input: pull [N], downwards on the plunger; it closes the gripper against a spring.

Oracles: homogeneous matrices for the places; the parallelograms keep the pads upright; the energy balance.
"""

from typing import Any

from eigenmotion.codegen.model.tree.tree import Body
from sympy import Matrix, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Tree, draw, multiplier

CRANK, PIN, PALM, LEVER, ROD = 0.06, 0.02, 0.03, 0.02, 0.03
"""Lengths of cranks and rockers; distances of a finger's pins, of the inner pins from the centre; levers, rods [m]"""

pull = dynamicsymbols("pull")
k, d = symbols("k d", positive=True)


class Finger:
    """A crank, a rocker and a pad, which form a parallelogram with the palm, and a rod to the plunger."""

    def __init__(self, tree: Tree, plunger: Body, side: str, sign: int) -> None:
        arm: dict[str, Any] = {"mass": 0.02, "center": (0, 0, CRANK / 2), "inertia": (8e-6, 8e-6, 1e-6), "axis": "x"}
        self.sign, self.plunger = sign, plunger
        self.crank = tree.body(f"{side}_crank", joint="revolute", at=(0, sign * PALM, 0), **arm)
        self.rocker = tree.body(f"{side}_rocker", joint="revolute", at=(0, sign * (PALM + PIN), 0), **arm)
        self.pad = tree.body(f"{side}_pad", self.crank, joint="revolute", axis="x", at=(0, 0, CRANK),
                             mass=0.03, center=(0, 0, 0.02), inertia=(4e-6, 4e-6, 1e-6))  # fmt: skip

    def rod(self) -> tuple[Matrix, Matrix]:
        """Return the ends of the rod, on the crank's lever and on the plunger."""
        end = self.plunger.position((0, self.sign * (PALM - LEVER), -ROD))
        return self.crank.position((0, -self.sign * LEVER, 0)), end

    def rows(self) -> list[object]:
        """Return what the loops hold at zero: the rod's change of length, and the gap in the outer pin."""
        lever, end = self.rod()
        rod = lever - end
        gap = self.pad.position((0, self.sign * PIN, 0)) - self.rocker.position((0, 0, CRANK))
        return [(rod.dot(rod) - ROD**2) / (2 * ROD), gap[1], gap[2]]

    def drawing(self) -> list[object]:
        """Return its lines."""
        a, b, c, e = (body.position((0, 0, z)) for body in (self.crank, self.rocker) for z in (0, CRANK))
        lever, end = self.rod()
        pairs = [(a, b), (c, e), (a, lever), (lever, end), (b, e)]
        corners = [self.pad.position(one) for one in ((-0.02, 0, 0), (0.02, 0, 0), (0.02, 0, 0.05), (-0.02, 0, 0.05))]
        pairs += zip(corners, [*corners[1:], corners[0]], strict=True)
        return [draw.Line(*pair) for pair in pairs]


def model() -> Model:
    """Return the gripper."""
    tree = Tree()
    plunger = tree.body("plunger", joint="prismatic", axis="z", mass=0.1)
    left, right = (Finger(tree, plunger, side, sign) for side, sign in (("left", 1), ("right", -1)))
    s = tree.coordinates[0]
    ends = [plunger.position((0, y, -ROD)) for y in (PALM - LEVER, LEVER - PALM)]
    return Model(
        name="gripper",
        coordinates=tree.coordinates,
        kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy + k * s**2 / 2,
        forces={s: -pull - d * s.diff()},
        holonomic_constraints={"left": left.rows(), "right": right.rows()},
        parameters={k: 1500.0, d: 10.0},
        inputs={pull: 0.0},
        outputs={"gap": left.pad.position()[1] - right.pad.position()[1], "rod": multiplier("left", 0)},
        drawing=[
            draw.Ground((-0.03, 0.06, 0), (-0.03, -0.06, 0), (0.03, -0.06, 0), (0.03, 0.06, 0), (-0.03, 0.06, 0)),
            draw.Line(*ends),
            *left.drawing(),
            *right.drawing(),
        ],
    )
