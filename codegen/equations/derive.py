"""Derivation of M, G, Q, A, b and the other terms from energies, forces and constraints."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import sympy

from ..bodies.expansion import Expansion
from ..calculus.derivatives import Tangent, gradient
from ..calculus.identity_test import Zeros
from ..graph.convert import FromSympy, ToSympy
from ..graph.graph import Graph
from ..graph.nested_sums import NestedSums
from ..graph.node_reference import References
from ..graph.rewrite import Substitution
from ..graph.store import Node
from ..model.normalise import ModelError, name_of
from ..model.statement.drawing import Shape
from ..model.statement.mechanism import Mechanism
from .event_actions import EventActions, Impact, Reset
from .mass_regularisation import weights
from .plain_symbols import Names
from .tree.massless import massless
from .tree.separation import Trees, separated


@dataclass(frozen=True, slots=True)
class Mechanics:
    """The terms of (7)-(11) as SymPy expressions in plain symbols x, v = xdot, t, parameters and inputs.

    n coordinates x_k [u_k], m constraint rows of which the first h are holonomic.

    Attributes
    ----------
    x, v : (n,) symbols; the name of v_k is that of x_k followed by `_dot`.
    M : (n, n), symmetric [J s^2 / (u_i u_j)] (5)
    W : (m,) weights of the constraint rows in M + A^T W A, which is factored if M is singular; otherwise all zero
    G : (n,) [J s / u_i] (6)
    kinetic_energy, T0, V : [J]; kinetic_energy is T(x, v, t) as the user wrote it (4)
    Q : (n,) [J / u_i]
    A : (m, n); b : (m,) (8)
    phi : (h,) the holonomic constraints
    outputs, events : (name, expression) with a_k = xddot_k and lambda_i as symbols
    drawing : the shapes, in x, t, parameters and first-order states
    quasi_velocities : (name, P(x, t) v) (3), n of them or none
    impacts, resets : the actions of events
    P : (m + r, n); the force of the multipliers, and of r norms rho of multipliers, is -P^T (lambda, rho). P is A (and
    zeros), minus the derivatives of forces with respect to (lambda, rho), as for friction
    norms : (r,) the rows whose multipliers' norm is each rho
    levels : `level` and `at_rest` of each switch of the model
    reaction_rates : (index, expression) of the rates of first-order states that depend on multipliers; Q is 0 there
    n_states : number of first-order states; these are the last entries of v, and nothing depends on their x
    trees : the trees of bodies whose energies T and V contain. With `trees.table`, M, T and V leave the trees out, and
    C adds them
    graph : that to whose nodes all expressions refer, with trees or nested sums; None: they are written out in symbols
    """

    name: str
    x: tuple[sympy.Symbol, ...]
    v: tuple[sympy.Symbol, ...]
    time: sympy.Symbol
    parameters: tuple[sympy.Symbol, ...]
    inputs: tuple[sympy.Symbol, ...]
    accelerations: tuple[sympy.Symbol, ...]
    multipliers: tuple[sympy.Symbol, ...]
    M: sympy.ImmutableDenseMatrix
    W: tuple[sympy.Expr, ...]
    G: tuple[sympy.Expr, ...]
    kinetic_energy: sympy.Expr
    T0: sympy.Expr
    V: sympy.Expr
    Q: tuple[sympy.Expr, ...]
    A: sympy.ImmutableDenseMatrix
    b: tuple[sympy.Expr, ...]
    phi: tuple[sympy.Expr, ...]
    outputs: tuple[tuple[str, sympy.Expr], ...]
    events: tuple[tuple[str, sympy.Expr], ...]
    quasi_velocities: tuple[tuple[str, sympy.Expr], ...]
    drawing: tuple[Shape, ...]
    impacts: tuple[Impact, ...]
    resets: tuple[Reset, ...]
    P: sympy.ImmutableDenseMatrix
    norms: tuple[tuple[int, ...], ...]
    levels: tuple[tuple[sympy.Expr, sympy.Expr], ...]
    reaction_rates: tuple[tuple[int, sympy.Expr], ...]
    n_states: int
    trees: Trees | None
    graph: Graph | None

    @property
    def coordinate_names(self) -> tuple[str, ...]:
        """(n) names of coordinates for users; a coordinate that represents a first-order state has the state's name."""
        n = len(self.x) - self.n_states
        return tuple(symbol.name for symbol in (*self.x[:n], *self.v[n:]))

    @property
    def pushes(self) -> bool:
        """Whether forces contain multipliers, as those of friction do, so that P differs from A."""
        return bool(self.P != self.A)

    @property
    def augmented(self) -> bool:
        """Whether M + A^T W A is factored in place of M."""
        return any(w != 0 for w in self.W)

    @property
    def factored(self) -> sympy.ImmutableDenseMatrix:
        """(n, n) the matrix that is factored: M + A^T W A, which is M if all weights are zero."""
        added = [self.A[row, :].T * w * self.A[row, :] for row, w in enumerate(self.W) if w != 0]
        return sum(added, self.M)

    def mass_matrix_gradient(self) -> tuple[sympy.ImmutableDenseMatrix, ...]:
        """Return dM/dx_k, k = 1 .. n, each (n, n)."""
        return tuple(self.M.diff(symbol) for symbol in self.x)


def derive(model: Mechanism, may_loop: bool = False, nested: bool = False) -> Mechanics:
    """Derive M, G, T0, V, Q, A and b from the energies, forces and constraints.

    `may_loop`: energies and M may leave out large trees of bodies, which C then adds (see `Trees.table`).
    `nested`: sums share what they begin with (`NestedSums`); the model has no trees.

    T(x, v, t) = 1/2 v^T M v + G^T v + T0 (4)-(6): M_ij = d2T / dv_i dv_j, G_i = dT / dv_i at v = 0. Where M_ij contains
    x_k but does not depend on it, x_k is replaced by a number; with nested sums, whose entries share subexpressions,
    only where M_ij is constant.

    Raises
    ------
    ModelError
        T is of higher than second degree in the velocities, a constraint is not linear in them, a symbol is unknown
        (names it), a term divides by velocities, or a number is beyond the range of a double.
    """
    try:
        try:
            return _Derivation(model, may_loop, nested).mechanics()
        except _MasslessError:  # whether M is singular along the constraints, too, is decided with all of it
            return _Derivation(model, may_loop=False, nested=nested).mechanics()
    except ZeroDivisionError as error:
        raise ModelError(
            f"model {model.name}: kinetic_energy or a nonholonomic constraint divides by what is zero at rest; "
            "cancel the velocities in the denominators, with sympy.cancel or by hand"
        ) from error
    except OverflowError as error:
        raise ModelError(
            f"model {model.name}: a power of a number in it is beyond what C's double holds; choose other units"
        ) from error


class _MasslessError(Exception):
    """A coordinate moves no mass, in trees that nodes leave out."""


class _Derivation:
    """The symbols, graph and operators that the steps of one derivation share."""

    def __init__(self, model: Mechanism, may_loop: bool, nested: bool) -> None:
        self.model = model
        self.names = Names(model)
        self.graph = Graph(symbol.name for symbol in self.names.parameters)
        self.expansion = Expansion(self.graph)
        self.from_sympy = FromSympy(self.graph, self.expansion)
        self.nested: NestedSums | None = None
        if nested:
            self.nested = NestedSums(self.graph, list(map(self.node, _stated(model))))
        self.trees = separated(model, self.expansion, self.node, may_loop)
        back = References if self.trees or self.nested else ToSympy
        self.to_sympy: Callable[[Node], sympy.Expr] = back(self.graph, self.names.by_name())
        self.zeros = Zeros(self.graph, self.names.signs())
        self.at_rest = Substitution(self.graph, {v.name: self.graph.zero for v in self.names.v})
        self.at_origin = Substitution(self.graph, {x.name: self.graph.zero for x in (*self.names.x, self.names.time)})
        self.along = {name: Tangent(self.graph, {name: self.graph.one})
                      for name in (*(x.name for x in self.names.x), self.names.time.name)}  # fmt: skip

    @property
    def in_loops(self) -> bool:
        """Whether nodes leave out the trees of bodies."""
        return self.trees is not None and self.trees.table is not None

    def kinetic_energy(self) -> Node:
        """Return T, without trees that nodes leave out."""
        return self.trees.T if self.in_loops and self.trees else self.node(self.model.kinetic_energy)

    def potential_energy(self) -> Node:
        """Return V, without trees that nodes leave out."""
        return self.trees.V if self.in_loops and self.trees else self.node(self.model.potential_energy)

    def mechanics(self) -> Mechanics:
        model, names = self.model, self.names
        T = self.kinetic_energy()
        apart = self.trees.T if self.trees else T
        momenta = gradient(self.graph, apart, [v.name for v in names.v])
        M, (rows, b), phi = self.mass_matrix(momenta), self.constraints(), list(map(self.node, self.phi()))
        back = partial(map, self.to_sympy)
        actions = EventActions(model, self.graph, names, self.node, self.to_sympy)
        Q, from_forces = actions.forces()
        A = sympy.ImmutableDenseMatrix(len(rows), len(names.x), [e for row in rows for e in back(row)])
        norms = tuple(dict.fromkeys(switch.presses for switch in model.switches if switch.presses))
        P = A.col_join(sympy.ImmutableDenseMatrix.zeros(len(norms), len(names.x))) - from_forces
        return Mechanics(
            name=model.name, x=names.x, v=names.v, time=names.time, parameters=names.parameters, inputs=names.inputs,
            accelerations=names.accelerations, multipliers=names.multipliers,
            M=self.matrix(M), W=tuple(back(self.weights(M, rows, phi))),
            G=tuple(back(self.simplified(map(self.at_rest, momenta)))),
            kinetic_energy=self.to_sympy(T), T0=self.to_sympy(self.at_rest(apart)),
            V=self.to_sympy(self.potential_energy()), Q=tuple(back(Q)), A=A, P=P,
            b=tuple(back(b)), phi=tuple(back(phi)),
            outputs=tuple((name, self.to_sympy(self.node(e))) for name, e in model.outputs),
            events=tuple((name, self.to_sympy(self.node(e.expression))) for name, e in model.events),
            quasi_velocities=tuple((name_of(y), self.to_sympy(self.node(y))) for y, _ in model.quasi_velocities),
            drawing=tuple(map(self.shape, model.drawing)), impacts=tuple(actions.impacts()),
            resets=tuple(actions.resets()), norms=norms, levels=tuple(actions.levels()), n_states=len(model.states),
            reaction_rates=tuple((k, self.to_sympy(rate)) for k, rate in actions.reaction_rates),
            trees=self.trees, graph=self.graph if self.trees or self.nested else None,
        )  # fmt: skip

    def matrix(self, rows: Sequence[Sequence[Node]]) -> sympy.ImmutableDenseMatrix:
        """Return a matrix in SymPy; entries that are not zero are few in large systems."""
        zero, width = self.graph.zero, len(rows[0])
        entries = {(i, j): self.to_sympy(one) for i, row in enumerate(rows) for j, one in enumerate(row) if one != zero}
        return sympy.ImmutableDenseMatrix(sympy.SparseMatrix(len(rows), width, entries))

    def shape(self, source: Shape) -> Shape:
        return replace(source, numbers=tuple(self.to_sympy(self.node(number)) for number in source.numbers))

    def node(self, expression: sympy.Expr) -> Node:
        try:
            node = self.from_sympy(self.names.plain(expression))
        except ModelError as error:
            raise ModelError(f"Model {self.model.name!r}: {error}") from error
        return self.nested(node) if self.nested else node

    def weights(self, M: list[list[Node]], A: list[list[Node]], phi: list[Node]) -> list[Node]:
        start = dict(zip((x.name for x in self.names.x), self.model.initial_x, strict=True))
        constants = {symbol.name: value for symbol, value in self.model.parameters}
        if self.in_loops and self.trees:
            if massless(self.trees, M, [*start], constants) is not None:
                raise _MasslessError
            return [self.graph.zero] * len(A)
        W = weights(self.graph, M, A, phi, start | {self.names.time.name: 0.0}, constants)
        if self.trees and all(one == self.graph.zero for one in W):
            self.refuse_massless(self.trees, M, [*start], constants)
        return W

    def refuse_massless(self, trees: Trees, M: list[list[Node]], x: list[str], constants: Mapping[str, float]) -> None:
        place = massless(trees, M, x, constants)
        if place is not None:
            raise ModelError(
                f"model {self.model.name}: {x[place]!r} moves no mass, so that its acceleration is undetermined. Give "
                "what it moves an inertia, or make its joint fixed (locked=[...] for a robot from a file)."
            )

    def simplified(self, nodes: Iterable[Node]) -> list[Node]:
        """Replace nodes that are identically zero by zero."""
        return [self.graph.zero if self.zeros(node) else node for node in nodes]

    def mass_matrix(self, momenta: Sequence[Node]) -> list[list[Node]]:
        n = len(momenta)
        M = [[self.graph.zero] * n for _ in range(n)]
        for j, v in enumerate(self.names.v):
            if all(one == self.graph.zero for one in momenta[j:]):
                continue
            along = Tangent(self.graph, {v.name: self.graph.one})
            for i in range(j, n):
                M[i][j] = M[j][i] = self.independent(self.quadratic(along(momenta[i]), i, j))
        return self.trees.with_masses(M) if self.trees else M

    def quadratic(self, entry: Node, i: int, j: int) -> Node:
        """Return M_ij at rest, after checking that it does not depend on velocities."""
        rest = self.at_rest(entry)
        if rest != entry and not self.zeros.equal(rest, entry):
            velocities = [v.name for v in self.names.v if self.graph.depends(entry, v.name)]
            raise ModelError(
                f"model {self.model.name}: the kinetic energy is of higher than second degree in the velocities: "
                f"d2T / d{self.names.v[i]} d{self.names.v[j]} still depends on {', '.join(velocities)}; "
                "T must be T2 + T1 + T0, at most quadratic in them"
            )
        return rest

    def independent(self, entry: Node) -> Node:
        """Eliminate the coordinates on which an entry does not depend although it contains them."""
        if self.zeros(entry):
            return self.graph.zero
        if self.nested:
            return self._constant(entry)
        for symbol in (*self.names.x, self.names.time):
            if self.graph.depends(entry, symbol.name):
                entry = self._without(entry, symbol.name)
        return entry

    def _constant(self, entry: Node) -> Node:
        """Return an entry that contains coordinates but depends on none of them without them."""
        try:
            candidate = self.at_origin(entry)
        except ZeroDivisionError:
            return entry
        return candidate if self.zeros.equal(candidate, entry) else entry

    def _without(self, entry: Node, name: str) -> Node:
        if self.zeros(self.along[name](entry)):
            for value in (self.graph.zero, self.graph.one):
                candidate = self._with(entry, name, value)
                if self.zeros.equal(candidate, entry):
                    return candidate
        return entry

    def _with(self, entry: Node, name: str, value: Node) -> Node:
        try:
            return Substitution(self.graph, {name: value})(entry)
        except ZeroDivisionError:
            return self.graph.number(float("nan"))

    def phi(self) -> list[sympy.Expr]:
        return list(self.model.holonomic_constraints)

    def constraints(self) -> tuple[list[list[Node]], list[Node]]:
        """Return A (m, n) and b (m,): the holonomic rows dphi/dx and dphi/dt, then the nonholonomic rows (8)."""
        rows, b = [], []
        xs, vs = [x.name for x in self.names.x], [v.name for v in self.names.v]
        for phi in map(self.node, self.phi()):
            rows.append(self.simplified(gradient(self.graph, phi, xs)))
            b.append(Tangent(self.graph, {self.names.time.name: self.graph.one})(phi))
        for number, expression in enumerate(self.model.nonholonomic_constraints):
            psi = self.node(expression)
            row = gradient(self.graph, psi, vs)
            rows.append(self.simplified(self.linear(entry, number, expression) for entry in row))
            b.append(self.at_rest(psi))
        return rows, self.simplified(b)

    def linear(self, entry: Node, number: int, expression: sympy.Expr) -> Node:
        rest = self.at_rest(entry)
        if rest != entry and not self.zeros.equal(rest, entry):
            raise ModelError(
                f"model {self.model.name}: nonholonomic constraint {number} is not linear in the velocities: "
                f"{expression}; write it as A(x, t) xdot + b(x, t)"
            )
        return rest


def _stated(model: Mechanism) -> list[sympy.Expr]:
    """Return the expressions from which the equations of motion follow."""
    rows = (*model.holonomic_constraints, *model.nonholonomic_constraints)
    return [model.kinetic_energy, model.potential_energy, *model.forces, *rows]
