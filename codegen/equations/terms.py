"""Terms of the equations of motion as nodes of one graph, in the cheapest of several equivalent forms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import sympy

from ..calculus.derivatives import Tangent, gradient
from ..calculus.error_bound import Rounding
from ..calculus.trigonometry import expansion
from ..graph.convert import FromSympy
from ..graph.graph import Graph
from ..graph.rewrite import Rewriter
from ..graph.store import Node
from ..schedule.schedule import weight
from .specialise import Scene
from .time_events import TimeEvents

ONE, MINUS, HALF = 1, -1, Fraction(1, 2)
Rows = tuple[tuple[Node, ...], ...]


@dataclass(frozen=True, slots=True)
class Motion:
    """Mdot : (n, n); force : (n,), the vector that S^-1 C multiplies in (36): 1/2 xdot^T M_x xdot + G_x^T xdot + F."""

    Mdot: Rows
    force: tuple[Node, ...]


class Terms:
    """All terms that a right-hand side may need, as nodes; those that cost time are computed on first use."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        mechanics = self.mechanics = scene.mechanics
        self.graph = self._own_graph()
        self.node = FromSympy(self.graph)
        self.x = [symbol.name for symbol in mechanics.x]
        self.v = [symbol.name for symbol in mechanics.v]
        rates = dict(zip(self.x, map(self.graph.symbol, self.v), strict=True))
        self.along = Tangent(self.graph, rates | {mechanics.time.name: self.graph.one})

        n = len(self.x)
        self.M: Rows = self._matrix(mechanics.M)
        """(n, n) (5)"""
        self.W = self._nodes(mechanics.W)
        """(m,) weights in M + A^T W A"""
        self.factored: Rows = self._matrix(mechanics.factored) if mechanics.augmented else self.M
        """(n, n), M or M + A^T W A"""
        self.A: Rows = _rows(self._nodes(mechanics.A), n)
        """(m, n) (8)"""
        self.P: Rows = _rows(self._nodes(mechanics.P), n) if mechanics.pushes else self.A
        """(m + r, n), the force of multipliers and norms of multipliers is -P^T (lambda, rho)"""
        lambdas = mechanics.multipliers
        self.norms = self._nodes(sympy.sqrt(sympy.Add(*(lambdas[k] ** 2 for k in rows))) for rows in mechanics.norms)
        """(r,) norms of multipliers"""
        self.reaction_rates = self._nodes(rate for _, rate in mechanics.reaction_rates)
        """rates of first-order states that depend on multipliers"""
        self.G, self.b, self.Q = map(self._nodes, (mechanics.G, mechanics.b, mechanics.Q))
        self.phi = self._nodes(mechanics.phi)
        self.T0, self.V, self.T = self._nodes((mechanics.T0, mechanics.V, mechanics.kinetic_energy))
        self.expanded = self._expansion()

    def _own_graph(self) -> Graph:
        return self.mechanics.graph or Graph(symbol.name for symbol in self.mechanics.parameters)

    def _nodes(self, expressions: Iterable[sympy.Expr]) -> tuple[Node, ...]:
        return tuple(map(self.node, expressions))

    def _matrix(self, matrix: sympy.ImmutableDenseMatrix) -> Rows:
        nonzero = {place: self.node(entry) for place, entry in sorted(matrix.todok().items(), key=lambda one: one[0])}
        columns = range(matrix.cols)
        return tuple(tuple(nonzero.get((i, j), self.graph.zero) for j in columns) for i in range(matrix.rows))

    def _expansion(self) -> Rewriter:
        """Choose the sums of angles to expand for all terms together, since sines needed by one term are shared."""
        matrices = (self.M, self.A, self.factored) if self.mechanics.augmented else (self.M, self.A)
        entries = [entry for rows in matrices for row in rows for entry in row]
        return expansion(self.graph, [*entries, *self.G, *self.b, *self.Q, *self.phi, self.T0, self.V])

    @cached_property
    def dM(self) -> tuple[Rows, ...]:
        """(n, n, n) dM_ij / dx_k as [k][i][j]"""
        return self._gradient(self.M)

    @cached_property
    def factored_gradient(self) -> tuple[Rows, ...]:
        """(n, n, n) derivatives of `factored`, indexed like dM"""
        return self._gradient(self.factored)

    @cached_property
    def T2(self) -> Node:
        """1/2 v^T M v (4), without first-order states, whose unit masses are auxiliary"""
        n = len(self.v) - self.mechanics.n_states
        return self.graph.scale(self.dot(self._velocities[:n], self._momentum[:n]), HALF)

    @cached_property
    def T1(self) -> Node:
        """G^T v (4)"""
        return self.dot(self.G, self._velocities)

    @cached_property
    def gamma(self) -> tuple[Node, ...]:
        """(m,) Adot v + bdot, where bdot is the total derivative: A xddot + gamma = 0 (39)"""
        return tuple(self.graph.add(self.dot(row, self._velocities), self.along(b))
                     for row, b in zip(self.Adot, self.b, strict=True))  # fmt: skip

    @cached_property
    def Adot(self) -> Rows:
        """(m, n)"""
        return tuple(tuple(map(self.along, row)) for row in self.A)

    @cached_property
    def phi_terms(self) -> tuple[Node, ...]:
        """(h,) sizes of the terms of phi; eps times that is its rounding error"""
        return tuple(map(Rounding(self.graph), self.phi))

    @cached_property
    def motion(self) -> Motion:
        """Mdot and the force of (36), in the cheapest form; both include A^T W A where that is added to M."""
        forms = [self._motion(gradient_of_L) for gradient_of_L in self._gradients_of_L()]
        return min(forms, key=lambda form: self._weight([*(e for row in form.Mdot for e in row), *form.force]))

    @cached_property
    def bias(self) -> tuple[Node, ...]:
        """(n,) force - Mdot v, the right-hand side of M xddot + A^T lambda = bias (11), in the cheapest form.

        Where A^T W A is added to M, -A^T W gamma is added to the bias.
        """
        return self._plus_rows(self.loads, self.W, self.A, map(self.graph.negative, self.gamma))

    @cached_property
    def loads(self) -> tuple[Node, ...]:
        """(n,) force - Mdot v without what belongs to A^T W A."""
        rates = self._rates_of_momentum()
        forms = [
            tuple(self._difference(force, rate) for force, rate in zip(self._force(form), kinetic, strict=True))
            for form in self._gradients_of_L()
            for kinetic in rates
        ]
        return min(forms, key=self._weight)

    @cached_property
    def required(self) -> tuple[Node, ...]:
        """(n,) M a - loads: the forces that must act besides, for accelerations a: inverse dynamics."""
        return tuple(
            self._difference(self.dot(row, self._accelerations), load)
            for row, load in zip(self.M, self.loads, strict=True)
        )

    @cached_property
    def row_accelerations(self) -> tuple[Node, ...]:
        """(m,) A a + gamma, 0 for accelerations that the constraints allow (39)."""
        return tuple(self.graph.add(self.dot(row, self._accelerations), gamma)
                     for row, gamma in zip(self.A, self.gamma, strict=True))  # fmt: skip

    @cached_property
    def input_columns(self) -> Rows:
        """(n, n_inputs) derivatives of the forces by the inputs."""
        inputs = [symbol.name for symbol in self.mechanics.inputs]
        energetic = any(self.graph.depends(energy, u) for energy in self._energies for u in inputs)
        forces = map(self.graph.negative, self.required) if energetic else self.Q
        return tuple(gradient(self.graph, force, inputs) for force in forces)

    @cached_property
    def time_events(self) -> TimeEvents:
        """The time events of all expressions on which motion and events depend."""
        mechanics = self.mechanics
        return TimeEvents(self.graph, mechanics.time.name, [symbol.name for symbol in mechanics.inputs], self.roots)

    @cached_property
    def evaluated(self) -> list[Node]:
        """The expressions that motion and events evaluate: `roots`, and the derivatives that the motion contains."""
        return [*self.roots, *self.bias, *self.gamma, *(entry for row in self.M for entry in row)]

    @cached_property
    def roots(self) -> list[Node]:
        """The expressions on which motion and events depend."""
        mechanics, node = self.mechanics, self.node
        acts = [*((*one.N, one.rate, one.restitution) for one in mechanics.impacts),
                *(one.after for one in mechanics.resets), *mechanics.levels]  # fmt: skip
        rows = [entry for row in (*self.A, *self.P) for entry in row]
        return [self.T, self.V, *self.Q, *self.reaction_rates, *self.b, *self.phi, *rows,
                *(node(one) for _, one in mechanics.events), *(node(one) for row in acts for one in row)]  # fmt: skip

    # -- pieces --------------------------------------------------------------------------------------------------

    @property
    def _velocities(self) -> list[Node]:
        return [self.graph.symbol(name) for name in self.v]

    @property
    def _accelerations(self) -> list[Node]:
        return [self.graph.symbol(symbol.name) for symbol in self.mechanics.accelerations]

    @property
    def _energies(self) -> tuple[Node, ...]:
        return self.T, self.V

    @cached_property
    def _momentum(self) -> list[Node]:
        return [self.dot(row, self._velocities) for row in self.M]

    def dot(self, first: Iterable[Node], second: Iterable[Node]) -> Node:
        """Return the scalar product."""
        pairs = zip(first, second, strict=True)
        return self.graph.sum((self.graph.mul(a, b), ONE) for a, b in pairs)

    def _difference(self, first: Node, second: Node) -> Node:
        return self.graph.sum([(first, ONE), (second, MINUS)])

    def _weight(self, nodes: Sequence[Node]) -> int:
        return weight(self.graph, list(map(self.expanded, nodes)))

    def _rates_of_momentum(self) -> list[list[Node]]:
        """Return Mdot v in two forms: from M v, and from dT/dv."""
        return [[self.along(p) for p in self._momentum], self._rates_from_T()]

    def _rates_from_T(self) -> list[Node]:
        """Return Mdot v = d/dt (dT/dv - G)."""
        return [
            self.graph.add(self.along(p), self.graph.negative(self.along(g)))
            for p, g in zip(gradient(self.graph, self.T, self.v), self.G, strict=True)
        ]

    def _gradients_of_L(self) -> list[tuple[Node, ...]]:
        """Return dL/dx at fixed velocities (10) in three forms: from T as written, from 1/2 v^T M v, and from dM."""
        graph = self.graph
        rest = graph.sum([(self.T1, ONE), (self.T0, ONE), (self.V, MINUS)])
        from_T = gradient(graph, self._difference(self.T, self.V), self.x)
        from_M = gradient(graph, graph.add(self.T2, rest), self.x)
        quadratic = [self._quadratic(dM_k) for dM_k in self.dM]
        from_dM = tuple(map(graph.add, quadratic, gradient(graph, rest, self.x)))
        return [from_T, from_M, from_dM]

    def _gradient(self, rows: Rows) -> tuple[Rows, ...]:
        along = [Tangent(self.graph, {name: self.graph.one}) for name in self.x]
        return tuple(tuple(tuple(map(rate, row)) for row in rows) for rate in along)

    def _quadratic(self, matrix: Rows) -> Node:
        """Return 1/2 v^T matrix v for a symmetric matrix, with each pair of velocities once."""
        graph, v = self.graph, self._velocities
        pairs = [(i, j) for i in range(len(v)) for j in range(i + 1)]
        return graph.sum((graph.mul(matrix[i][j], v[i], v[j]), HALF if i == j else ONE) for i, j in pairs)

    def _force(self, gradient_of_L: tuple[Node, ...]) -> tuple[Node, ...]:
        """Return Q + dL/dx - Gdot, where Gdot is the total derivative (29)."""
        terms = zip(gradient_of_L, self.Q, self.G, strict=True)
        return tuple(self.graph.sum([(dL, ONE), (q, ONE), (self.along(g), MINUS)]) for dL, q, g in terms)

    def _plus_rows(
        self, forces: tuple[Node, ...], weights: Sequence[Node], rows: Rows, factors: Iterable[Node]
    ) -> tuple[Node, ...]:
        """Return forces + rows^T W factors, where W are the weights and factors (m,)."""
        weighted = [self.graph.mul(w, factor) for w, factor in zip(weights, factors, strict=True)]
        return tuple(self.graph.add(force, self.dot(weighted, (row[k] for row in rows)))
                     for k, force in enumerate(forces))  # fmt: skip

    def _motion(self, gradient_of_L: tuple[Node, ...]) -> Motion:
        """Return Mdot and the force of (36) from a form of dL/dx.

        If A^T W A is added to M, Mdot v contains Adot^T W A v + A^T W Adot v + A^T Wdot A v in addition. The force
        compensates the first and third term. The second, with -A^T W bdot in the force, gives the -A^T W gamma of bias.
        """
        Mdot, force = tuple(tuple(map(self.along, row)) for row in self.factored), self._force(gradient_of_L)
        if not self.mechanics.augmented:
            return Motion(Mdot, force)
        along_rows = [self.dot(row, self._velocities) for row in self.A]
        force = self._plus_rows(force, self.W, self.Adot, along_rows)
        force = self._plus_rows(force, list(map(self.along, self.W)), self.A, along_rows)
        return Motion(
            Mdot, self._plus_rows(force, self.W, self.A, (self.graph.negative(self.along(b)) for b in self.b))
        )


def _rows(nodes: Sequence[Node], width: int) -> Rows:
    return tuple(tuple(nodes[start : start + width]) for start in range(0, len(nodes), width))
