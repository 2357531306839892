"""Construction of the kernels of a program: the assignments of each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy

from ..calculus.derivatives import gradient
from ..calculus.inverse import LARGEST, inverse
from ..choices import Choices
from ..equations.specialise import Scene
from ..equations.terms import Rows
from ..equations.tree.articulated_bodies import armature
from ..equations.tree.link_table import is_parametric
from ..equations.tree.tree_terms import TreeTerms, terms_of
from ..equations.tree.triangular_root import eta_names
from ..graph.store import Node
from ..kernel.kernel import Array, Draft, Entry, Kernel, Symbols, both_triangles, written
from ..model.model import ModelError
from ..schedule.schedule import Constants, weight
from .inverse_kernels import inverse_kernels, is_recursive
from .kernel_roles import Kernels, Stages
from .memory_layout import Layout, places_of
from .partial_kernels import partial_kernels
from .program import BlockView
from .table_kernel import table_kernel
from .time_event_kernel import time_event_kernel

OF_STATE = {"x": "y", "v": "dy"}
"""The arrays of coordinates and velocities in a right-hand side."""
WITH_ETA = OF_STATE | {"eta": "y + N"}


def kernels_of(scene: Scene, choices: Choices, layout: Layout, differentiated: Scene | None) -> tuple[Kernels, int]:
    """Return all kernels, and the number of constants that they share.

    `differentiated` is the scene with all terms, of which there are derivatives; None: there are none.
    """
    writing = _Writing(scene, choices, layout)
    return writing.kernels(differentiated), len(writing.constants.nodes)


class _Writing:
    """Writes one kernel after the other; collects their constants, and writes the kernel of these last."""

    def __init__(self, scene: Scene, choices: Choices, layout: Layout) -> None:
        self.scene, self.choices, self.layout, self.blocks = scene, choices, layout, layout.blocks
        self.mechanics, self.terms = scene.mechanics, terms_of(scene)
        self.scales = scene.scales if choices.eigenfactor else (1.0,) * scene.n
        self.constants = Constants(self.terms.graph)
        self.places = places_of(self.mechanics)
        if layout.from_tips:
            self.places |= {name: ("eta", k) for k, name in enumerate(eta_names(self.mechanics))}

    def kernels(self, differentiated: Scene | None) -> Kernels:
        recursive = self.recursive_root()
        published, triangular, settled = self.beside(recursive) if recursive else self.equations()
        shared = settled.masses is not None and settled.masses.exported
        has_M = shared and not any(block.fixed for block in self.blocks)  # without rows, nothing is added to M
        mass_matrix = None if has_M or self.scene.in_loops else self.mass_matrix("mass_matrix", self.terms.M)
        by_name: dict[str, Any] = {
            "pfaffian": self.pfaffian(), "position": self.position(), "bias": self.bias(), "energy": self.energy(),
            "outputs": self.outputs(), "events": self.events(), "quasi": self.quasi(),
            "impacts": self.impacts(), "resets": self.resets(), "levels": self.levels(), "pushes": self.pushes(),
        }  # fmt: skip
        reactions = self.of_reactions() | inverse_kernels(self.terms, self.one, self.column)
        velocity_of_eta, eta_of_velocity = self.maps_of_root() if recursive else (None, None)
        factored = self.mass_matrix("factored_matrix", self.terms.factored) if self.mechanics.augmented else None
        drawing = self.drawing()  # last, so that the numbers of the other constants do not depend on it
        symbols = Symbols(self.places, self.layout.first_constant)
        time_events, tables = time_event_kernel(self.terms, symbols), table_kernel(self.terms, symbols)
        frames, own_masses = self.frames(symbols), self.own_masses()
        prepared = self.prepared()
        terms = self.terms if differentiated is self.scene else None
        if differentiated and not terms:
            terms = terms_of(differentiated)
        partials = partial_kernels(terms, symbols) if terms else None  # last, so that no other kernel changes
        return Kernels(published=published, triangular=triangular, settled=settled, factored=factored,
                       drawing=drawing, partials=partials, time_events=time_events, tables=tables,
                       frames=frames, own_masses=own_masses, prepared=prepared, **reactions,
                       asks_the_root=shared, mass_matrix=mass_matrix, velocity_of_eta=velocity_of_eta,
                       eta_of_velocity=eta_of_velocity, **by_name)  # fmt: skip

    @property
    def root_suffices(self) -> bool:
        """Whether the triangular root's kernels compute all that others need: no rows, and all varying blocks turn."""
        turns = any(block.turning for block in self.blocks) and not any(block.single for block in self.blocks)
        return turns and not (self.scene.m or self.choices.extrapolate)

    def equations(self) -> tuple[Stages, Stages, Stages]:
        """Return the kernels of the formulation, of the triangular root that replaces it, and of accepted steps."""
        none, cholesky = Stages(None, None), self.choices.formulation == "cholesky"
        root, passing = (
            self.root_kernels() if cholesky or self.choices.bounded and self.layout.couples else (none, None)
        )
        if passing and root.motion:
            return self.with_root_kernels(root, root.motion, passing)
        settled = self.stages(self.settled_masses(), self.settled_rates())
        return (root, none, settled) if cholesky else (self.published(), root, settled)

    def beside(self, recursive: Stages) -> tuple[Stages, Stages, Stages]:
        """Return `equations` with a recursive root."""
        return recursive, Stages(None, None), self.stages(self.settled_masses(), self.settled_rates())

    def root_kernels(self) -> tuple[Stages, Kernel | None]:
        """Return the triangular root's kernels; if they suffice and are long, also one of the values passed on."""
        drafts = self.drafts("triangular")
        if not self.root_suffices:
            return self.stages(*drafts), None
        passing_only = Draft("eigenfactor_ahead", (), actual=OF_STATE, on_lanes=True)
        masses, motion, *passing = self.write(*drafts, passing_only=passing_only)
        return Stages(masses, motion), passing[0] if passing else None

    def with_root_kernels(self, root: Stages, motion: Kernel, passing: Kernel) -> tuple[Stages, Stages, Stages]:
        """Return `equations` whose long kernels are shared, so that they are compiled once.

        Accepted steps have no inputs: they need a kernel of their own if `motion` reads some.
        """
        if self.choices.formulation == "cholesky":
            return root, Stages(None, None), Stages(root.masses, None)
        rates = self.write(self.settled_rates())[0] if "u" in motion.reads else motion
        alone = Stages(None, replace(motion, cost=passing.cost))
        return Stages(passing, motion) if passing.statements else alone, root, Stages(root.masses, rates)

    def stages(self, masses: Draft, motion: Draft) -> Stages:
        """Write two kernels that are called one after the other; a kernel without assignments becomes None."""
        drafts = [draft for draft in (masses, motion) if draft.entries]
        kernels = dict(zip((draft.name for draft in drafts), self.write(*drafts), strict=True))
        return Stages(kernels.get(masses.name), kernels.get(motion.name))

    def write(self, *drafts: Draft, passing_only: Draft | None = None) -> list[Kernel]:
        symbols = Symbols(self.places, self.layout.first_constant)
        expanded = [replace(draft, entries=[self.expanded(entry) for entry in draft.entries]) for draft in drafts]
        return written(self.terms.graph, expanded, symbols, self.constants, passing_only)

    def expanded(self, entry: Entry) -> Entry:
        return replace(entry, node=self.terms.expanded(entry.node))

    def one(self, name: str, entries: Sequence[Entry], *arguments: str) -> Kernel:
        """Write a function with a fixed signature."""
        return self.write(Draft(name, entries, arguments))[0]

    # -- assignments ---------------------------------------------------------------------------------------------

    def scaled(self, node: Node, *coordinates: int) -> Node:
        factor = Fraction(1)
        for k in coordinates:
            factor *= Fraction(self.scales[k])
        return self.terms.graph.scale(node, factor)

    def masses(self, blocks: Iterable[BlockView], full: bool) -> list[Entry]:
        """Return the assignments of M of blocks: the lower triangle, or both triangles if `full`."""
        return [entry for block in blocks for entry in self.symmetric("M", block, self.terms.factored, full)]

    def rates(self, blocks: Iterable[BlockView]) -> list[Entry]:
        return [entry for block in blocks for entry in self.symmetric("Mdot", block, self.terms.motion.Mdot, True)]

    def symmetric(self, name: str, block: BlockView, rows: Sequence[Sequence[Node]], full: bool) -> list[Entry]:
        size = f"[N{block.number}]"
        array, entries = Array(f"{name}{block.number}", size + size), []
        for i, row in enumerate(block.coordinates):
            for j, column in enumerate(block.coordinates[: i + 1]):
                mirror = (f"[{j}][{i}]",) if full and i != j else ()
                entries.append(Entry(array, (*mirror, f"[{i}][{j}]"), self.scaled(rows[row][column], row, column)))
        return entries

    def forces(self, forces: Sequence[Node], name: str = "f") -> list[Entry]:
        return [Entry(Array(f"{name}{block.number}", f"[N{block.number}]"), (f"[{local}]",), self.scaled(forces[k], k))
                for block in self.blocks for local, k in enumerate(block.coordinates)]  # fmt: skip

    def by_row(self, name: str, rows: Sequence[Sequence[Node]]) -> list[Entry]:
        size = "N_ROWS" if len(rows) == self.scene.m else "N_PUSHED"
        return [Entry(Array(f"{name}{block.number}", f"[{size}][N{block.number}]"),
                      (f"[{row}][{local}]",), self.scaled(entries[k], k))
                for block in self.blocks if block.constrained for row, entries in enumerate(rows)
                for local, k in enumerate(block.coordinates)]  # fmt: skip

    def pushed(self) -> list[Entry]:
        return self.by_row("P", self.terms.P) if self.mechanics.pushes else []

    def column(self, name: str, nodes: Iterable[Node], size: str = "") -> list[Entry]:
        """Return the entries of an array; its size is the number of nodes, by the name that C has for it."""
        entries = list(nodes)
        array = Array(name, f"[{size or len(entries)}]")
        return [Entry(array, (f"[{row}]",), node) for row, node in enumerate(entries)]

    # -- right-hand sides ----------------------------------------------------------------------------------------

    def published(self) -> Stages:
        varying = [block for block in self.blocks if not block.fixed]
        if self.choices.formulation == "lagrange":
            return self.in_velocities(self.masses(varying, False))
        if self.choices.formulation == "inverse":
            return self.in_velocities([entry for block in self.blocks for entry in self.inverse_of(block)])
        if self.choices.formulation == "articulated_body":
            return self.articulated()
        return self.stages(*self.drafts("eigenfactor" if self.choices.eigenfactor else "triangular"))

    def drafts(self, name: str) -> tuple[Draft, Draft]:
        """Return the drafts of M for its root, and of Mdot, f, A and gamma, which need the velocities."""
        eigen = name == "eigenfactor"
        exported = self.root_suffices and not eigen
        varying = [block for block in self.blocks if not block.fixed]
        masses = self.masses([block for block in varying if block.single or not eigen], False)
        gamma = self.column("gamma", self.terms.gamma, "N_ROWS")
        moving = [*self.rates(varying), *self.forces(self.terms.motion.force), *self.by_row("A", self.terms.A), *gamma]
        moving.extend(self.pushed())
        if eigen and self.layout.row_groups:
            moving.extend(self.by_row("Adot", self.terms.Adot))
        return (
            Draft(f"{name}_masses", masses, actual=OF_STATE, on_lanes=True, exported=exported),
            Draft(f"{name}_motion", moving, actual=OF_STATE, on_lanes=True, exported=exported),
        )

    def in_velocities(self, masses: list[Entry]) -> Stages:
        """Return the kernels of equations in (x, v): the entries for M, then force - Mdot v, A and gamma."""
        gamma = self.column("gamma", self.terms.gamma, "N_ROWS")
        entries = [*masses, *self.forces(self.terms.bias), *self.by_row("A", self.terms.A), *gamma, *self.pushed()]
        name = self.choices.formulation
        return self.stages(
            Draft(f"{name}_masses", ()),
            Draft(f"{name}_motion", entries, actual={"x": "y", "v": "y + N"}, on_lanes=True),
        )

    def articulated(self) -> Stages:
        """Return the kernels of articulated bodies: accelerations a, M^-1 P^T, pivots, A and gamma."""
        if not isinstance(self.terms, TreeTerms):
            raise ModelError(
                f"model {self.mechanics.name}: formulation 'articulated_body' is for masses in trees of bodies; state "
                "them by eigenmotion.Tree, or choose another formulation"
            )
        table = self.terms.trees.table
        if table and table.solves:
            return self.loads_of_trees(self.terms)
        given = self.terms.yielded
        pivots = self.column("pivots", given.pivots, "N")
        entries = [*pivots, *self.forces(given.accelerations, "a"), *self.by_row("WA", given.rows)]
        rows = [*self.by_row("A", self.terms.A), *self.column("gamma", self.terms.gamma, "N_ROWS")]
        return self.stages(
            Draft("articulated_body_masses", ()),
            Draft("articulated_body_motion", [*entries, *rows], actual={"x": "y", "v": "y + N"}, on_lanes=True),
        )

    def loads_of_trees(self, terms: TreeTerms) -> Stages:
        """Return the kernel of what loops over trees need: forces and armature (n,), rows of P (m, n), A and gamma."""
        entries = [*self.column("force", terms.forces, "N"),
                   *self.column("armature", armature(self.mechanics, terms.trees), "N")]  # fmt: skip
        flat = [node for row in terms.P for node in row]
        size = "N_ROWS" if len(terms.P) == self.scene.m else "N_PUSHED"
        rows = [
            *self.column("rows", flat, f"{size}*N"),
            *self.by_row("A", terms.A),
            *self.column("gamma", terms.gamma, "N_ROWS"),
        ]
        return self.stages(
            Draft("articulated_body_masses", ()),
            Draft("articulated_body_motion", [*entries, *rows], actual={"x": "y", "v": "y + N"}, on_lanes=True),
        )

    def recursive_root(self) -> Stages | None:
        """Return the kernels of the root by articulated bodies; None if there are none, or M and its root cost less."""
        if not (self.layout.from_tips and isinstance(self.terms, TreeTerms)):
            return None
        drafts = self.recursive_drafts(self.terms)
        rows = len(self.terms.A) + len(self.terms.P) * self.mechanics.pushes
        if not self.scene.in_loops:  # M is not written then
            by_M = self.weight(*self.drafts("triangular")) + sum(dense_weight(block, rows) for block in self.blocks)
            if by_M <= self.weight(*drafts):
                return None
        return self.stages(*drafts)

    def weight(self, *drafts: Draft) -> int:
        """Return the approximate time of kernels, in additions."""
        nodes = [self.terms.expanded(entry.node) for draft in drafts for entry in draft.entries]
        return weight(self.terms.graph, nodes)

    def recursive_drafts(self, terms: TreeTerms) -> tuple[Draft, Draft]:
        """Return the drafts of the root by articulated bodies: pivots and v, then a, rows B (and Q) and gamma.

        gamma is A v' + gamma at zero multipliers, since v' is not among what the right-hand side computes.
        """
        root, size = terms.root, Array("v", "[N]")
        velocities = [*self.column("pivots", root.pivots, "N"),
                      *(Entry(size, (f"[{k}]",), node) for k, node in enumerate(root.v))]  # fmt: skip
        moving = [*self.forces(root.eta_rates(terms.forces), "a"), *self.by_row("B", list(map(root.row, terms.A)))]
        if self.mechanics.pushes:
            moving.extend(self.by_row("Q", list(map(root.row, terms.P))))
        moving.extend(self.column("gamma", terms.root_loads, "N_ROWS"))
        return (
            Draft("root_velocities", velocities, actual=WITH_ETA, on_lanes=True),
            Draft("root_motion", moving, actual=WITH_ETA, on_lanes=True),
        )

    def maps_of_root(self) -> tuple[Kernel | None, Kernel | None]:
        """Write v of eta and eta of v by the recursive root, as functions of a state."""
        if not isinstance(self.terms, TreeTerms):
            return None, None
        root, pivots = self.terms.root, self.column("pivots", self.terms.root.pivots)
        eta = root.eta_of([self.terms.graph.symbol(name) for name in self.terms.v])
        arguments = "t", "x", "c", "pivots"
        velocities, quasi = self.column("rates", root.v), self.column("quasi", eta)
        return (
            self.one("velocity_of_eta", [*pivots, *velocities], *arguments, "eta", "rates"),
            self.one("eta_of_velocity", [*pivots, *quasi], *arguments, "v", "quasi"),
        )

    def inverse_of(self, block: BlockView) -> list[Entry]:
        """Return the assignments of det = (determinant of M, product of its diagonal) and W = M^-1."""
        if block.size > LARGEST:
            raise ModelError(
                f"model {self.mechanics.name}: formulation 'inverse' writes the inverse of M out, which is for blocks "
                f"of up to {LARGEST} coordinates; {{{block.names}}} are {block.size}; choose another formulation"
            )
        M = [[self.terms.factored[i][j] for j in block.coordinates] for i in block.coordinates]
        entries, determinant = inverse(self.terms.graph, M)
        W = Array(f"W{block.number}", f"[N{block.number}][N{block.number}]")
        diagonal = self.terms.graph.mul(*(M[i][i] for i in range(block.size)))
        inverted = [Entry(W, (f"[{i}][{j}]",), entry) for i, row in enumerate(entries) for j, entry in enumerate(row)]
        return [*self.column(f"det{block.number}", (determinant, diagonal), "2"), *inverted]

    # -- at accepted steps ---------------------------------------------------------------------------------------

    def settled_masses(self) -> Draft:
        """Return the draft of M of the blocks that vary, A and b."""
        constrained_only = self.choices.carries_v and self.scene.h  # lanes need all blocks of M
        varying = [b for b in self.blocks if not b.fixed and (b.constrained or not constrained_only)]
        entries = [
            *self.masses(() if self.scene.in_loops else varying, self.choices.eigenfactor),
            *self.by_row("A", self.terms.A),
            *self.column("b", self.terms.b, "N_ROWS"),
        ]
        return Draft("settled_masses", entries, actual={"x": "y"}, on_lanes=not self.scene.h)

    def settled_rates(self) -> Draft:
        """Return the draft of the terms for Omega of M at an accepted step, and for Omega of Delta if extrapolated."""
        if not (self.choices.eigenfactor and self.layout.couples):
            return Draft("settled_rates", ())
        extrapolates_delta = bool(self.layout.row_groups) and self.choices.extrapolate
        blocks = [b for b in self.blocks if b.turning or b.single and b.constrained and extrapolates_delta]
        entries = [*self.rates(blocks), *(self.by_row("Adot", self.terms.Adot) if extrapolates_delta else ())]
        return Draft("settled_rates", entries, actual=OF_STATE, on_lanes=not self.scene.h)

    # -- functions of a state, with fixed signatures -------------------------------------------------------------

    def mass_matrix(self, name: str, M: Rows) -> Kernel:
        return self.one(name, both_triangles("M", 0, M), "t", "x", "c", "M")

    def own_masses(self) -> Kernel | None:
        """Write the entries of M that are not 0, besides those that C adds; None if all are 0, or C adds none."""
        M = both_triangles("M", 0, self.terms.M) if self.scene.in_loops else []
        entries = [entry for entry in M if entry.node != self.terms.graph.zero]
        return self.write(Draft("own_masses", entries, on_lanes=True))[0] if entries else None

    def pfaffian(self) -> Kernel:
        A = self.column("A", (node for row in self.terms.A for node in row))
        return self.one("pfaffian", [*A, *self.column("b", self.terms.b, "N_ROWS")], "t", "x", "c", "A", "b")

    def position(self) -> Kernel:
        entries = [*self.column("phi", self.terms.phi), *self.column("terms", self.terms.phi_terms)]
        return self.one("position", entries, "t", "x", "c", "phi", "terms")

    def bias(self) -> Kernel | None:
        if is_recursive(self.terms):
            return None
        entries = [*self.column("bias", self.terms.bias), *self.column("gamma", self.terms.gamma, "N_ROWS")]
        name = "own_bias" if self.scene.in_loops else "motion_bias"
        return self.one(name, entries, "t", "x", "v", "c", "u", "bias", "gamma")

    def energy(self) -> Kernel:
        entries = self.column("e", (self.terms.T2, self.terms.T1, self.terms.T0, self.terms.V))
        return self.one("own_energies" if self.scene.in_loops else "energy", entries, "t", "x", "v", "c", "e")

    def outputs(self) -> Kernel:
        entries = self.column("out", (self.terms.node(expression) for _, expression in self.mechanics.outputs))
        return self.one("observe", entries, "t", "x", "v", "a", "lambda", "c", "u", "out")

    def events(self) -> Kernel:
        entries = self.column("crossing", (self.terms.node(expression) for _, expression in self.mechanics.events))
        return self.one("model_events", entries, "t", "x", "v", "c", "u", "crossing")

    def impacts(self) -> Kernel:
        rows = [(*one.N, one.rate, one.restitution) for one in self.mechanics.impacts]
        return self.moving("impacts", "impact_data", rows)

    def resets(self) -> Kernel:
        return self.moving("resets", "after", [one.after for one in self.mechanics.resets])

    def levels(self) -> Kernel:
        return self.moving("levels", "level", self.mechanics.levels)

    def pushes(self) -> Kernel:
        return self.moving("pushes", "P", self.mechanics.P.tolist() if self.mechanics.pushes else [])

    def of_reactions(self) -> dict[str, Any]:
        """Write the rates of first-order states that depend on multipliers, and their derivatives by these."""
        rates = self.terms.reaction_rates
        names = [symbol.name for symbol in self.mechanics.multipliers] if rates else []
        by = [entry for rate in rates for entry in gradient(self.terms.graph, rate, names)]
        entries = [Entry(Array("rate", f"[{len(rates)}]"), (f"[{k}]",), rate) for k, rate in enumerate(rates)]
        actual = {"x": "y", "v": "y + N"} if self.choices.carries_v else OF_STATE
        given = ("t", "x", "v", "lambda", "c", "u")
        return {
            "rates_in_rhs": self.write(Draft("rates_in_rhs", entries, actual=actual, on_lanes=True))[0]
            if rates
            else None,
            "reaction_rates": self.one("reaction_rates", entries, *given, "rate"),
            "reaction_rate_partials": self.one("reaction_rate_partials", self.column("by", by), *given, "by"),
        }

    def moving(self, name: str, array: str, rows: Sequence[Sequence[sympy.Expr]]) -> Kernel:
        """Write a function of rows of expressions, which may contain anything but accelerations and multipliers."""
        entries = self.column(array, (self.terms.node(entry) for row in rows for entry in row))
        return self.one(name, entries, "t", "x", "v", "c", "u", array)

    def quasi(self) -> Kernel:
        entries = self.column("y", (self.terms.node(row) for _, row in self.mechanics.quasi_velocities))
        return self.one("quasi", entries, "t", "x", "v", "c", "y")

    def drawing(self) -> Kernel:
        """Write the numbers of the drawing; each is computed once, since shapes share points."""
        numbers = (self.terms.node(number) for shape in self.mechanics.drawing for number in shape.numbers)
        return self.one("draw", _each_once("p", numbers), "t", "x", "v", "c", "p")

    def frames(self, symbols: Symbols) -> Kernel | None:
        """Write the numbers of the joints of bodies that are not 0; None if the model has no bodies."""
        trees = self.mechanics.trees
        if not (trees and trees.placements):
            return None
        numbers = (number for body in trees.placements for number in body.frame)
        entries = [one for one in _each_once("numbers", numbers) if one.node != trees.graph.zero]
        return written(trees.graph, [Draft("frames", entries, ("c", "numbers"))], symbols, None)[0]

    def prepared(self) -> Kernel:
        """Write M of the fixed blocks, then the constants that the other kernels need."""
        entries = self.masses([block for block in self.blocks if block.fixed], True)
        first, c = self.layout.first_constant, Array("prepared", "[N_PREPARED]")
        entries += [Entry(c, (f"[{place}]",), node) for place, node in self.parametric_links()]
        entries += [Entry(c, (f"[{first + k}]",), node, f"c_{k}") for k, node in enumerate(self.constants.nodes)]
        places = {name: ("parameters" if array == "c" else array, k) for name, (array, k) in self.places.items()}
        (kernel,) = written(self.terms.graph, [Draft("prepared_constants", entries, actual={"prepared": "c"})],
                            Symbols(places, first), None)  # fmt: skip
        return kernel

    def parametric_links(self) -> Iterator[tuple[int, Node]]:
        """Yield the entries of the table of links that depend on parameters, with their places."""
        trees = self.mechanics.trees
        numbers = [node for row in trees.table.rows for node in row.numbers] if trees and trees.table else []
        for place, node in enumerate(numbers, self.layout.first_link):
            if is_parametric(self.terms.graph, node):
                yield place, node


def _each_once(array: str, nodes: Iterable[Node]) -> list[Entry]:
    """Return the assignments of the entries of an array, equal ones in one."""
    places: dict[Node, list[str]] = {}
    for k, node in enumerate(nodes):
        places.setdefault(node, []).append(f"[{k}]")
    return [Entry(Array(array, ""), tuple(at), node) for node, at in places.items()]


def dense_weight(block: BlockView, rows: int) -> int:
    """Return the approximate time, in additions, of a root of M, of L^-1 Mdot L^-T and of rows, where C loops."""
    n = block.size
    return 0 if block.fixed else 7 * n**3 // 3 + (6 + rows) * n**2
