"""Random trees of bodies: all kinds of joints, skew axes, branches, fixed and massless bodies, parameters."""

from __future__ import annotations

import random

import numpy as np
import sympy
from eigenmotion.codegen.model.tree.tree import Tree

KINDS = ("revolute", "prismatic", "cylindrical", "planar", "spherical", "free", "fixed")
FREEDOMS = {"revolute": 1, "prismatic": 1, "cylindrical": 2, "planar": 3, "spherical": 3, "free": 6, "fixed": 0}


class RandomTree:
    """A tree with at most `most` coordinates; with `driven`, joints that others drive besides; maybe no parameters.

    With `moments`, the same bodies are stated by their first moments.

    Attributes
    ----------
    tree, bodies
    parameters : symbols with their values, for every second mass and length
    """

    def __init__(self, seed: int, most: int = 6, driven: bool = False, parametric: bool = True,
                 moments: bool = False) -> None:  # fmt: skip
        self.moments = moments
        self.chance, self.parametric = random.Random(seed), parametric
        self.parameters: dict[sympy.Symbol, float] = {}
        self.tree = Tree(gravity=[self.number(scale=9.8) for _ in range(3)])
        self.bodies = [self._body(0, None, most)]
        while len(self.bodies) < 7 and len(self.tree.coordinates) < most and self.chance.random() < 0.9:
            parent = self.chance.choice([*self.bodies[-2:], None])
            self.bodies.append(self._body(len(self.bodies), parent, most - len(self.tree.coordinates)))
            if driven:
                self._driven(len(self.bodies) + 100)

    def number(self, scale=1.0, positive=False):
        """A number of either sign, 0 or 1 at times; every second positive one a parameter."""
        if positive:
            value = scale * self.chance.uniform(0.3, 2.0)
            if self.chance.random() < 0.5 or not self.parametric:
                return value
            symbol = sympy.Symbol(f"p{len(self.parameters)}", positive=True)
            self.parameters[symbol] = value
            return symbol
        return self.chance.choice([0, 1, -1, *(scale * self.chance.uniform(-1.5, 1.5) for _ in range(4))])

    def rotation(self):
        """A rotation: none, one that permutes the axes, one near it, or any."""
        kind = self.chance.choice(["none", "permuted", "near", "any", "any"])
        if kind == "none":
            return None
        turned = np.random.default_rng(self.chance.randrange(2**32)).normal(size=(3, 3))
        if kind != "any":
            turned = np.eye(3)[self.chance.sample(range(3), 3)] + (1e-9 * turned if kind == "near" else 0.0)
        Q, R = np.linalg.qr(turned)
        Q = Q * np.sign(np.diag(R))
        return (Q * np.sign(np.linalg.det(Q))).tolist()

    def _body(self, number, parent, room):
        fitting = [kind for kind in KINDS if FREEDOMS[kind] <= room]
        joint = self.chance.choice(fitting if number else [kind for kind in fitting if kind != "fixed"])
        direction = [self.chance.choice([0, 0, 1, -1, self.chance.uniform(-1, 1)]) for _ in range(3)]
        light = self.chance.random() < 0.15
        return self.tree.body(
            f"b{number}", parent, joint=joint, axis=direction if any(direction) else "x",
            at=[self.number() for _ in range(3)], rotation=self.rotation(),
            **self._masses(mass=0 if light else self.number(positive=True),
                           center=[self.number(0.5) for _ in range(3)], inertia=0 if light else self._inertia()),
        )  # fmt: skip

    def _driven(self, number):
        """Add a body on any other, whose joint is at k q + b."""
        q = self.chance.choice(self.tree.coordinates)
        self.tree.body(
            f"b{number}", self.chance.choice(self.bodies), joint=self.chance.choice(["revolute", "prismatic"]),
            axis=[self.chance.uniform(-1, 1) for _ in range(3)], at=[self.number() for _ in range(3)],
            rotation=self.rotation(),
            **self._masses(mass=self.number(positive=True), center=[self.number(0.5) for _ in range(3)],
                           inertia=self._inertia()),
            coordinates=[self.number(positive=True) * q + self.number()],
        )  # fmt: skip

    def _masses(self, mass, center, inertia):
        """Arguments of a body; by its moments about the origin, if those are wanted."""
        if not self.moments or mass == 0:
            return {"mass": mass, "center": center, "inertia": inertia}
        c = sympy.Matrix(center)
        J = sympy.diag(*inertia) if np.ndim(inertia) == 1 else sympy.Matrix(inertia)
        J += mass * (c.dot(c) * sympy.eye(3) - c * c.T)
        return {"mass": mass, "moment": [mass * one for one in center], "inertia": J}

    def _inertia(self):
        """The inertia of masses at random points, so that it is one that a body can have."""
        points = np.random.default_rng(self.chance.randrange(2**32)).normal(size=(4, 3)) * 0.5
        J = sum(np.dot(r, r) * np.eye(3) - np.outer(r, r) for r in points)
        return J.tolist() if self.chance.random() < 0.7 else [float(J[k, k]) for k in range(3)]
