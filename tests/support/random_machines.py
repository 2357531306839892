"""Random machines on trees of bodies: a random tree of any size with springs, dampers and closed loops."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy

from eigenmotion import Model
from tests.oracles.newton_euler import NewtonEuler

from .random_trees import RandomTree

MOST = (3, 5, 6, 9, 14)
"""Coordinates at most, in turn."""


@dataclass(frozen=True)
class Pair:
    """A point on a body, and one on another or on the ground (None)."""

    one: Any
    other: Any
    points: tuple[tuple[float, ...], tuple[float, ...]]

    @property
    def apart(self) -> sympy.Matrix:
        """From the second point to the first, (3, 1)."""
        there = sympy.Matrix(self.points[1]) if self.other is None else self.other.position(self.points[1])
        return sympy.Matrix(self.one.position(self.points[0])) - there


class Machine:
    """A random machine that is at x, and its Newton-Euler equations there; without `parametric` it has no parameters.

    With `moments`, its bodies are stated by their first moments.

    Attributes
    ----------
    model : the constraints are satisfied at its initial state
    x : (n,)
    """

    def __init__(self, seed: int, parametric: bool = True, moments: bool = False) -> None:
        self.made = RandomTree(seed, MOST[seed % len(MOST)], seed % 3 == 0, parametric, moments)
        self.chance, self.tree = self.made.chance, self.made.tree
        self._load()
        self.q = self.tree.coordinates
        self.x = np.array([self.chance.uniform(-0.8, 0.8) for _ in self.q])
        self.springs = [(self._pair(), self.chance.uniform(0.5, 20)) for _ in range(self.chance.choice((0, 1, 2)))]
        self.damping = {q: self.chance.choice((0, 0, self.chance.uniform(0, 2))) for q in self.q}
        self.loops = [self._loop() for _ in range(self.chance.choice((0, 0, 1, 1, 2)))]
        if sum(len(rows) for _, rows in self.loops) >= len(self.q):
            self.loops = []
        at = NewtonEuler(self.tree._links, self.q, self.made.parameters, self.x, np.zeros(len(self.q)))
        self.ends = [[float(one) for one in self._apart(at, pair)[0]] for pair, _ in self.loops]
        self.model = self._model(f"machine{seed}")

    def equations(self, v: np.ndarray) -> tuple[Any, Any, list[Any], list[Any]]:
        """Return M (n, n), F (n,), and A (m, n) by rows, b (m,) of A a + b = 0, at v (n,), in 40 digits."""
        at = NewtonEuler(self.tree._links, self.q, self.made.parameters, self.x, v)
        M, F = at.equations(self.tree.gravity)
        for pair, k in self.springs:
            d, columns, _ = self._apart(at, pair)
            for i, column in enumerate(columns):
                F[i] -= k * sum(a * b for a, b in zip(d, column, strict=True))
        for i, q in enumerate(self.q):
            F[i] -= self.damping[q] * float(v[i])
        A, b = [], []
        for pair, rows in self.loops:
            _, columns, a = self._apart(at, pair)
            for k in rows:
                A.append([column[k] for column in columns])
                b.append(a[k])
        return M, F, A, b

    def _apart(self, at: NewtonEuler, pair: Pair) -> tuple[Any, list[Any], Any]:
        d, columns, a = at.motion[pair.one.link].of(pair.points[0])
        if pair.other is None:
            there = d * 0
            for k in range(3):
                there[k] = pair.points[1][k]
            return d - there, columns, a
        e, others, b = at.motion[pair.other.link].of(pair.points[1])
        return d - e, [one - other for one, other in zip(columns, others, strict=True)], a - b

    def _load(self) -> None:
        """Put masses on bodies that may lack them, so that no coordinate is without inertia."""
        for body in self.made.bodies:
            if body.link.mass == 0:
                self.tree.body(f"load of {body.name}", body, joint="fixed", at=(0.2, 0.1, 0), mass=0.7,
                               inertia=(0.1, 0.2, 0.15))  # fmt: skip

    def _pair(self) -> Pair:
        bodies = [*self.tree.bodies.values()]
        points = [tuple(self.chance.uniform(-1, 1) for _ in range(3)) for _ in range(2)]
        one = self.chance.choice(bodies)
        return Pair(one, self.chance.choice([None, *(body for body in bodies if body is not one)]), tuple(points))

    def _loop(self) -> tuple[Pair, tuple[int, ...]]:
        """A ball joint, a pin in a slot, or a point on a plane; without directions in which nothing moves."""
        pair, rows = self._pair(), self.chance.sample(range(3), self.chance.choice((1, 2, 3)))
        return pair, tuple(k for k in sorted(rows) if pair.apart[k].has(*self.q))

    def _model(self, name: str) -> Model:
        potential = self.tree.potential_energy
        for pair, k in self.springs:
            d = pair.apart
            potential += sympy.Float(k) * (d.T * d)[0] / 2
        rows = [pair.apart[k] - sympy.Float(end[k])
                for (pair, which), end in zip(self.loops, self.ends, strict=True) for k in which]  # fmt: skip
        return Model(
            name=name, coordinates=self.q, kinetic_energy=self.tree.kinetic_energy, potential_energy=potential,
            forces={q: -d * q.diff() for q, d in self.damping.items() if d}, parameters=self.made.parameters,
            holonomic_constraints=rows, initial=dict(zip(self.q, self.x, strict=True)),
        )  # fmt: skip
