"""Recursions of random trees against Lagrange's equations of the energies by forward kinematics, in 40 digits."""

import random
from functools import cache

import mpmath as mp
import numpy as np
import pytest
import sympy
from eigenmotion.codegen.bodies.expansion import Expansion
from eigenmotion.codegen.bodies.scalar import Scalar
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.graph.store import Kind
from eigenmotion.codegen.model.tree.forward_kinematics import Arithmetic, ForwardKinematics
from eigenmotion.codegen.model.tree.quantity import Quantity

from tests.support.random_trees import RandomTree

mp.mp.dps = 40


class Case:
    """A random tree at a random state, its energies by forward kinematics, and its recursions as nodes."""

    def __init__(self, seed, driven=False):
        self.made = RandomTree(seed, driven=driven)
        self.tree, chance = self.made.tree, random.Random(seed)
        self.q = self.tree.coordinates
        self.n = len(self.q)
        self.links = tuple(self.tree._links)
        self.state = {one: [mp.mpf(chance.uniform(-0.8, 0.8)) for _ in self.q] for one in ("q", "v", "a", "u")}
        self.parameters = {symbol: mp.mpf(value) for symbol, value in self.made.parameters.items()}
        self.numbers = {}
        self.graph = Graph(symbol.name for symbol in self.parameters)
        names = {q: f"q{k}" for k, q in enumerate(self.q)} | {q.diff(): f"v{k}" for k, q in enumerate(self.q)}
        nodes = {one: self.graph.symbol(name) for one, name in names.items()}
        nodes |= {symbol: self.graph.symbol(symbol.name) for symbol in self.parameters}
        self.dynamics = Expansion(self.graph).dynamics(self.links, nodes)
        self.gravity = self.dynamics.links.scalars(self.tree.gravity)

    def symbols(self, letter):
        return [Scalar(self.graph, self.graph.symbol(f"{letter}{k}")) for k in range(self.n)]

    def values(self, scalars):
        """Values of nodes at the state."""
        at = {f"{letter}{k}": value for letter, values in self.state.items() for k, value in enumerate(values)}
        at |= {symbol.name: value for symbol, value in self.parameters.items()}
        known = {}
        for node in self.graph.reachable([scalar.node for scalar in scalars]):
            kind, operands = self.graph.records[node]
            if kind is Kind.NUMBER:
                known[node] = mp.mpf(operands[0].numerator) / operands[0].denominator if not isinstance(
                    operands[0], float) else mp.mpf(operands[0])  # fmt: skip
            elif kind is Kind.SYMBOL:
                known[node] = at[operands[0]]
            elif kind is Kind.SUM:
                known[node] = mp.fsum(known[child] * mp.mpf(str(factor)) if isinstance(factor, int) else
                                      known[child] * factor.numerator / factor.denominator if not isinstance(
                                          factor, float) else known[child] * mp.mpf(factor)
                                      for child, factor in operands)  # fmt: skip
            elif kind is Kind.PRODUCT:
                known[node] = mp.fprod(mp.power(known[child], mp.mpf(float(power))) for child, power in operands)
            else:
                known[node] = getattr(mp, operands[0])(known[operands[1]])
        return [known[scalar.node] for scalar in scalars]

    def kinematics(self, q, v):
        arithmetic = Arithmetic(self.number, self.number, mp.sin, mp.cos, lambda one: 1 / one)
        return ForwardKinematics(
            arithmetic, dict(zip(self.q, q, strict=True)) | {w.diff(): x for w, x in zip(self.q, v, strict=True)}
        )

    def number(self, one):
        """The value of an expression in the parameters, once each: SymPy takes its time."""
        if one not in self.numbers:
            values = {symbol: sympy.Float(str(value), 40) for symbol, value in self.parameters.items()}
            self.numbers[one] = mp.mpf(sympy.N(one.xreplace(values), 40))
        return self.numbers[one]

    def energy(self, kind, q, v):
        vector = self.tree.gravity if kind == "potential_energy" else ()
        return self.kinematics(q, v).quantity(Quantity(kind, self.links, vector)) or mp.mpf(0)

    def lagrange(self):
        """M (n, n) and d/dt dL/dv - dL/dq (n,) at zero accelerations, by differences of 40 digits."""
        h, n = mp.mpf(10) ** -12, self.n
        q, v = self.state["q"], self.state["v"]

        def T(q, v):
            return self.energy("kinetic_energy", q, v)

        def moved(x, k, step):
            return [value + step * (j == k) for j, value in enumerate(x)]

        def p(q, v, k):  # T is a quadratic form in v: its central difference is exact
            return (T(q, moved(v, k, 1)) - T(q, moved(v, k, -1))) / 2

        still = [mp.mpf(0)] * n
        M = [[p(q, moved(still, j, 1), k) for j in range(n)] for k in range(n)]
        forward, back = ([x + s * h * w for x, w in zip(q, v, strict=True)] for s in (1, -1))
        bias = []
        for k in range(n):
            rate = (p(forward, v, k) - p(back, v, k)) / (2 * h)
            L = [T(moved(q, k, s * h), v) - self.energy("potential_energy", moved(q, k, s * h), v) for s in (1, -1)]
            bias.append(rate - (L[0] - L[1]) / (2 * h))
        return mp.matrix(M), mp.matrix(bias)


@cache
def case_of(seed, driven=False):
    """A case and what Lagrange's equations say of it: once for all that look at it."""
    case = Case(seed, driven)
    return case, *case.lagrange()


SEEDS = [*range(8), *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(8, 120))]


def close(got, expected, tolerance=1e-13):
    got, expected = (np.array([float(x) for x in mp.matrix(one)]) for one in (got, expected))
    assert np.abs(got - expected).max(initial=0.0) <= tolerance * max(1.0, np.abs(expected).max(initial=0.0))


@pytest.mark.parametrize("driven", [False, True], ids=["", "driven"])
@pytest.mark.parametrize("seed", SEEDS)
def test_recursions_give_lagranges_equations(seed, driven):
    case, M, bias = case_of(seed, driven)
    T, V = case.values([case.dynamics.kinetic_energy, case.dynamics.potential_energy(case.gravity)])
    close([T], [case.energy("kinetic_energy", case.state["q"], case.state["v"])])
    close([V], [case.energy("potential_energy", case.state["q"], case.state["v"])])
    rows = case.values([entry for row in case.dynamics.mass_matrix for entry in row])
    close(rows, list(M))
    close(case.values(case.dynamics.inverse_dynamics(None, case.gravity)), bias)
    torques = case.values(case.dynamics.inverse_dynamics(case.symbols("a"), case.gravity))
    close(torques, M * mp.matrix(case.state["a"]) + bias)


@pytest.mark.parametrize("driven", [False, True], ids=["", "driven"])
@pytest.mark.parametrize("seed", SEEDS)
def test_articulated_bodies_solve_for_accelerations(seed, driven):
    case, M, bias = case_of(seed, driven)
    if mp.svd_r(M, compute_uv=False)[case.n - 1] < 1e-8:
        pytest.skip("a massless body at the end of a branch: M is singular")
    a = mp.matrix(case.values(case.dynamics.accelerations(case.symbols("u"), case.gravity)))
    close(M * a + bias, case.state["u"], 1e-12)
    armature = [Scalar(case.graph, case.graph.number(one)) for one in (0.5, 0, 2, 0.25, 1, 3)[: case.n]]
    solved = mp.matrix(case.values(case.dynamics.solved(case.symbols("u"), armature)))
    close(M * solved + mp.diag(case.values(armature)) * solved, case.state["u"], 1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_places_and_velocities_are_those_of_forward_kinematics(seed):
    case, _, _ = case_of(seed)
    kinematics = case.kinematics(case.state["q"], case.state["v"])
    expansion = Expansion(case.graph)
    point = tuple(map(sympy.Rational, ("1/3", "-2", "1/7")))
    for body in case.made.bodies:
        chain = body._chain
        for kind, places in (("position", ((k,) for k in range(3))), ("velocity", ((k,) for k in range(3))),
                             ("angular_velocity", ((k,) for k in range(3))),
                             ("rotation", ((i, j) for i in range(3) for j in range(3)))):  # fmt: skip
            vector = point if kind in ("position", "velocity") else ()
            quantities = [Quantity(kind, chain, vector, place) for place in places]
            got = [Scalar(case.graph, expansion.quantity(one, _operands(case, one))) for one in quantities]
            close(case.values(got), [kinematics.quantity(one) or 0 for one in quantities])


def _operands(case, quantity):
    names = {q: f"q{k}" for k, q in enumerate(case.q)} | {q.diff(): f"v{k}" for k, q in enumerate(case.q)}
    return [case.graph.symbol(names.get(one, getattr(one, "name", ""))) for one in quantity.variables]
