"""From a scene to the record that the templates print."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

from ..choices import Choices
from ..graph.graph import Node
from ..graph.inverse import LARGEST, inverse
from ..graph.schedule import Constants, Cost
from ..model.model import Event, ModelError
from ..physics.specialise import Block, Kind, Scene
from ..physics.terms import Rows, Terms
from .printer import Assignments, Body, Naming, body, c_identifiers
from .program import BlockView, Bodies, EventView, Named, Place, Program, RowGroup, Slice


@dataclass(frozen=True, slots=True)
class Defaults:
    """The numbers of a model that the generated file carries.

    parameters, inputs : name -> value; x, v : (n); y : (n) or (); events : name -> Event
    """

    parameters: tuple[tuple[str, float], ...]
    inputs: tuple[tuple[str, float], ...]
    x: tuple[float, ...]
    v: tuple[float, ...]
    y: tuple[float, ...]
    events: tuple[tuple[str, Event], ...]


def lower(scene: Scene, defaults: Defaults, choices: Choices) -> Program:
    """Lay out state and memory, and write the straight-line part of each function."""
    names, mechanics, eigen = scene.mechanics.name, scene.mechanics, choices.eigenfactor
    blocks, first_delta, first_kept, n_fixed = _views(scene, choices)
    groups, n_state, n_memory = _row_groups(scene, choices, first_delta, first_kept)
    bodies, n_constants = _Writing(scene, choices, blocks, n_fixed).bodies()
    n, turning = scene.n, [block for block in blocks if block.turning]
    couples = eigen and any(block.size > 1 for block in turning)
    return Program(
        name=names, formulation=choices.formulation, close_eigenvalues=choices.close_eigenvalues, schur=choices.schur,
        eigenfactor=eigen, cholesky=choices.formulation == "cholesky",
        inverse=choices.formulation == "inverse", carries_v=choices.carries_v,
        bounded=(couples or bool(groups)) and not choices.extrapolate,
        extrapolate=(couples or bool(groups)) and choices.extrapolate, extrapolated=first_kept - 2,
        needs_mass=_needs_mass(blocks, choices), settles=_settles(scene, choices),
        augmented=mechanics.augmented, n=n, m=scene.m, h=scene.h, n_state=n_state, n_memory=n_memory,
        n_prepared=len(mechanics.parameters) + n_fixed + n_constants,
        n_C=sum(block.size**2 for block in turning) * eigen, n_s=sum(block.size for block in turning) * eigen,
        coordinates=tuple(Named(x.name, repr(value)) for x, value in zip(mechanics.x, defaults.x, strict=True)),
        velocities=tuple(map(repr, defaults.v)), parameters=_named(defaults.parameters),
        inputs=_named(defaults.inputs), outputs=tuple(name for name, _ in mechanics.outputs),
        events=tuple(EventView(name, event.direction, int(event.terminal)) for name, event in defaults.events),
        quasi_velocities=tuple(name for name, _ in mechanics.quasi_velocities), initial_y=tuple(map(repr, defaults.y)),
        blocks=blocks, block_of=_block_of(scene), carried=_carried(scene, eigen),
        scales=tuple(map(repr, scene.scales)),
        delta_eigenfactors=bool(groups), row_groups=groups,
        n_C_delta=sum(group.size**2 for group in groups if group.size > 1),
        n_s_delta=sum(group.size for group in groups if group.size > 1),
        layout=_layout(n, blocks, groups, choices), left_out=scene.left_out,
        conserves_energy=scene.conserves_energy, costs=_costs(bodies, choices.formulation), bodies=bodies,
    )  # fmt: skip


def _needs_mass(blocks: Sequence[BlockView], choices: Choices) -> bool:
    """Whether velocities follow from the state only with M(x): every varying block that carries no C and s."""
    carried = choices.eigenfactor
    return any(block.single or block.turning and (not carried or block.size > 1) for block in blocks)


def _settles(scene: Scene, choices: Choices) -> bool:
    """Whether a step leaves anything to put right or to remember."""
    return scene.m > 0 or not choices.carries_v and any(b.kind is not Kind.FIXED for b in scene.blocks)


def _named(defaults: Iterable[tuple[str, float]]) -> tuple[Named, ...]:
    return tuple(Named(name, repr(value)) for name, value in defaults)


def _block_of(scene: Scene) -> tuple[int, ...]:
    by_coordinate = {k: block.number - 1 for block in scene.blocks for k in block.coordinates}
    return tuple(by_coordinate[k] for k in range(scene.n))


def _views(scene: Scene, choices: Choices) -> tuple[tuple[BlockView, ...], int, int, int]:
    """Lay out C and s in the state, factors in the memory and, for fixed blocks, in the prepared parameters.

    Returns the blocks and the lengths of state, memory and fixed factors.
    """
    eigen, n, turning = choices.eigenfactor, scene.n, scene.turning
    first_fixed = len(scene.mechanics.parameters)
    C = s = 2 * n
    s += sum(block.size**2 for block in turning) * eigen
    kept, fixed = 0, first_fixed
    views = []
    for block in scene.blocks:
        views.append(_view(scene, block, eigen, (C, s, kept, fixed)))
        room = block.size**2 + block.size
        kept += (2 * block.size**2 if choices.extrapolate else room) * (block.kind is not Kind.FIXED)
        fixed += 2 * room * (block.kind is Kind.FIXED)
        if eigen and block.kind is Kind.TURNING:
            C, s = C + block.size**2, s + block.size
    n_memory = 0 if choices.carries_v else kept + 2 * choices.extrapolate
    return tuple(views), s, n_memory, fixed - first_fixed


def _scale(scene: Scene, eigen: bool, k: int) -> str:
    return f"{scene.scales[k]!r}*" if eigen and scene.scales[k] != 1 else ""


def _view(scene: Scene, block: Block, eigen: bool, starts: tuple[int, int, int, int]) -> BlockView:
    C, s, kept, fixed = starts
    square, size = block.size**2, block.size
    return BlockView(
        number=block.number, size=size, coordinates=block.coordinates,
        places=tuple(Place(k, local, _scale(scene, eigen, k)) for local, k in enumerate(block.coordinates)),
        names=", ".join(scene.mechanics.x[k].name for k in block.coordinates),
        turning=block.kind is Kind.TURNING, single=block.kind is Kind.SINGLE, fixed=block.kind is Kind.FIXED,
        constrained=block.constrained, C=C, s=s, C_fixed=fixed, s_fixed=fixed + square, L_fixed=fixed + square + size,
        r_fixed=fixed + 2 * square + size, L_kept=kept, r_kept=kept + square,
    )  # fmt: skip


def _carried(scene: Scene, eigen: bool) -> tuple[int, ...]:
    turning = {k for block in scene.turning for k in block.coordinates} if eigen else set()
    return tuple(int(k in turning) for k in range(scene.n))


def _row_groups(scene: Scene, choices: Choices, first: int, first_kept: int) -> tuple[tuple[RowGroup, ...], int, int]:
    """Lay out the eigenfactors of Delta behind those of M: of each group of two rows and more; a lone row needs none.

    Returns the groups, none if Delta is factored numerically, and the lengths of state and memory.
    """
    coupled = scene.row_groups if choices.eigenfactor and choices.schur == "eigenfactor" else ()
    if all(len(rows) < 2 for rows in coupled):
        return (), first, first_kept
    carried = [len(rows) * (len(rows) > 1) for rows in coupled]
    groups, C, s, kept = [], first, first + sum(size**2 for size in carried), first_kept
    for number, (rows, size) in enumerate(zip(coupled, carried, strict=True), 1):
        groups.append(RowGroup(number, len(rows), rows, C, s, kept))
        C, s, kept = C + size**2, s + size, kept + 2 * size**2 * choices.extrapolate
    return tuple(groups), s, kept


def _layout(n: int, blocks: Sequence[BlockView], groups: Sequence[RowGroup], choices: Choices) -> tuple[Slice, ...]:
    slices = [Slice("x", 0, n), Slice("v" if choices.carries_v else "eta", n, n)]
    turning = [block for block in blocks if block.turning]
    if choices.eigenfactor and turning:
        slices.append(Slice("C", turning[0].C, sum(block.size**2 for block in turning)))
        slices.append(Slice("s", turning[0].s, sum(block.size for block in turning)))
    carried = [group for group in groups if group.size > 1]
    if carried:
        slices.append(Slice("C_delta", carried[0].C, sum(group.size**2 for group in carried)))
        slices.append(Slice("s_delta", carried[0].s, sum(group.size for group in carried)))
    return tuple(slices)


def _costs(bodies: Bodies, formulation: str) -> tuple[str, ...]:
    named = [(formulation, bodies.published), ("triangular root", bodies.triangular), ("projection", bodies.settle)]
    return tuple(f"{name}: {_count(one)}" for name, one in named if one.sections)


def _count(one: Body) -> str:
    words = ("additions", "multiplications", "divisions", "roots", "function calls")
    return ", ".join(f"{count} {word}" for count, word in zip(one.cost.counts(), words, strict=True) if count) or "none"


class _Writing:
    """Writes the body of each function; constants are gathered on the way and written last."""

    def __init__(self, scene: Scene, choices: Choices, blocks: tuple[BlockView, ...], n_fixed: int) -> None:
        self.scene, self.choices, self.blocks = scene, choices, blocks
        self.mechanics, self.terms = scene.mechanics, Terms(scene)
        self.scales = scene.scales if choices.eigenfactor else (1.0,) * scene.n
        every = (*self.mechanics.parameters, *self.mechanics.x, *self.mechanics.v, *self.mechanics.inputs,
                 *self.mechanics.accelerations, *self.mechanics.multipliers)  # fmt: skip
        self.identifiers = c_identifiers(symbol.name for symbol in every) | {"t": "t"}
        self.constants = Constants(self.terms.graph)
        self.first_constant = len(self.mechanics.parameters) + n_fixed

    def bodies(self) -> tuple[Bodies, int]:
        eigen = self.choices.eigenfactor
        published = {"lagrange": self.lagrange, "inverse": self.inverse}.get(
            self.choices.formulation, partial(self.right_hand_side, eigen)
        )()
        nothing = Body((), (), Cost())
        written = {
            "mass_matrix": self.mass_matrix(self.terms.M), "mass_matrix_gradient": self.gradient(self.terms.dM),
            "factored": nothing, "factored_gradient": nothing, "pfaffian": self.pfaffian(),
            "position": self.position(), "bias": self.bias(), "energy": self.energy(), "outputs": self.outputs(),
            "events": self.events(), "quasi": self.quasi(), "published": published, "settle": self.settle(eigen),
            "triangular": self.right_hand_side(False) if self.bounded() else nothing,
        }  # fmt: skip
        if self.mechanics.augmented:
            written["factored"] = self.mass_matrix(self.terms.factored)
            written["factored_gradient"] = self.gradient(self.terms.factored_gradient)
        prepare = self.prepare()
        return Bodies(prepare=prepare, **written), len(self.constants.nodes)

    def bounded(self) -> bool:
        eigen = self.choices.bounded
        return eigen and (any(block.size > 1 for block in self.scene.turning) or self.carries_delta())

    def carries_delta(self) -> bool:
        chosen = self.choices.eigenfactor and self.choices.schur == "eigenfactor"
        return chosen and any(len(rows) > 1 for rows in self.scene.row_groups)

    # -- places --------------------------------------------------------------------------------------------------

    def naming(self, x: str, v: Mapping[int, str] | str, more: Mapping[str, str] | None = None) -> Naming:
        """Say where symbols live: x and v are arrays, or places by coordinate."""
        mechanics = self.mechanics
        places = {p.name: f"c[{k}]" for k, p in enumerate(mechanics.parameters)}
        places |= {s.name: f"{x}[{k}]" for k, s in enumerate(mechanics.x)}
        places |= {s.name: f"{v}[{k}]" if isinstance(v, str) else v[k] for k, s in enumerate(mechanics.v)}
        places |= {s.name: f"u[{k}]" for k, s in enumerate(mechanics.inputs)}
        return Naming(self.identifiers, places | {"t": "t"} | dict(more or {}), self.first_constant)

    def in_blocks(self) -> dict[int, str]:
        """Return where the velocity of each coordinate lives in a right-hand side."""
        places = {}
        for block in self.blocks:
            for place in block.places:
                places[place.k] = f"{place.scale}v{block.number}[{place.local}]"
        return places

    def write(self, sections: Sequence[Assignments], naming: Naming, arguments: Sequence[str]) -> Body:
        expanded = [[(target, self.terms.expanded(node)) for target, node in section] for section in sections]
        return body(self.terms.graph, expanded, naming, self.constants, arguments)

    def scaled(self, node: Node, *coordinates: int) -> Node:
        factor = Fraction(1)
        for k in coordinates:
            factor *= Fraction(self.scales[k])
        return self.terms.graph.scale(node, factor)

    # -- assignments ---------------------------------------------------------------------------------------------

    def masses(self, full: bool, settle: bool = False) -> list[tuple[str, Node]]:
        """M of the blocks that vary: the lower triangle, or both; of a single coordinate a number."""
        given: list[tuple[str, Node]] = []
        velocities_only = settle and self.choices.carries_v
        for block in self.blocks:
            if velocities_only and not block.constrained:
                continue
            if block.single:
                (k,) = block.coordinates
                given.append((f"const double M{block.number}", self.scaled(self.terms.factored[k][k], k, k)))
            elif block.turning:
                given.extend(self.symmetric("M", block, self.terms.factored, full))
        return given

    def symmetric(self, name: str, block: BlockView, rows: Sequence[Sequence[Node]], full: bool) -> Assignments:
        array, given = f"{name}{block.number}", []
        for i, row in enumerate(block.coordinates):
            for j, column in enumerate(block.coordinates[: i + 1]):
                mirror = f"{array}[{j}][{i}] = " if full and i != j else ""
                given.append((f"{mirror}{array}[{i}][{j}]", self.scaled(rows[row][column], row, column)))
        return given

    def rates(self) -> list[tuple[str, Node]]:
        """Mdot of the blocks that vary."""
        given: list[tuple[str, Node]] = []
        for block in self.blocks:
            if block.single:
                (k,) = block.coordinates
                given.append((f"const double Mdot{block.number}", self.scaled(self.terms.motion.Mdot[k][k], k, k)))
            elif block.turning:
                given.extend(self.symmetric("Mdot", block, self.terms.motion.Mdot, True))
        return given

    def forces(self, forces: Sequence[Node]) -> list[tuple[str, Node]]:
        return [(f"f{block.number}[{local}]", self.scaled(forces[k], k))
                for block in self.blocks for local, k in enumerate(block.coordinates)]  # fmt: skip

    def constraint_rows(self) -> list[tuple[str, Node]]:
        return self.by_row("A", self.terms.A)

    def constraint_rates(self) -> list[tuple[str, Node]]:
        return self.by_row("Adot", self.terms.Adot)

    def by_row(self, name: str, rows: Sequence[Sequence[Node]]) -> list[tuple[str, Node]]:
        return [(f"{name}{block.number}[{row}][{local}]", self.scaled(entries[k], k))
                for block in self.blocks if block.constrained
                for row, entries in enumerate(rows)
                for local, k in enumerate(block.coordinates)]  # fmt: skip

    def column(self, target: str, nodes: Iterable[Node]) -> list[tuple[str, Node]]:
        return [(f"{target}[{row}]", node) for row, node in enumerate(nodes)]

    # -- functions -----------------------------------------------------------------------------------------------

    def right_hand_side(self, eigen: bool) -> Body:
        """Sections: what the root of M needs; then, with the velocities known, Mdot, f, A and gamma."""
        single = [entry for entry in self.masses(False) if not eigen or entry[0].startswith("const")]
        gamma = self.column("gamma", self.terms.gamma)
        moving = [*self.rates(), *self.forces(self.terms.motion.force), *self.constraint_rows(), *gamma]
        if eigen and self.carries_delta():
            moving.extend(self.constraint_rates())
        return self.write([single, moving], self.naming("y", self.in_blocks()), ("t", "c", "u"))

    def lagrange(self) -> Body:
        return self.in_velocities(self.masses(False))

    def inverse(self) -> Body:
        return self.in_velocities([entry for block in self.blocks for entry in self.inverse_of(block)])

    def inverse_of(self, block: BlockView) -> list[tuple[str, Node]]:
        if block.size > LARGEST:
            raise ModelError(
                f"model {self.mechanics.name}: formulation 'inverse' writes the inverse of M out, which is for blocks "
                f"of up to {LARGEST} coordinates; {{{block.names}}} are {block.size}; choose another formulation"
            )
        M = [[self.terms.factored[i][j] for j in block.coordinates] for i in block.coordinates]
        entries, determinant = inverse(self.terms.graph, M)
        given = [(f"W{block.number}[{i}][{j}]", entry) for i, row in enumerate(entries) for j, entry in enumerate(row)]
        diagonal = self.terms.graph.mul(*(M[i][i] for i in range(block.size)))
        named = [(f"const double det{block.number}", determinant), (f"const double diagonal{block.number}", diagonal)]
        return [*named, *given]

    def in_velocities(self, masses: list[tuple[str, Node]]) -> Body:
        """The equations in x, v: what is needed of M, then force - Mdot v, A and gamma."""
        n, gamma = self.scene.n, self.column("gamma", self.terms.gamma)
        given = [*masses, *self.forces(self.terms.bias), *self.constraint_rows(), *gamma]
        return self.write([given], self.naming("y", {k: f"y[{n + k}]" for k in range(n)}), ("t", "c", "u"))

    def settle(self, full: bool) -> Body:
        given = [*self.masses(full, settle=True), *self.constraint_rows(), *self.column("b", self.terms.b)]
        return self.write([given, self.turning() if full else []], self.naming("y", self.in_blocks()), ("t", "c"))

    def turning(self) -> list[tuple[str, Node]]:
        """What Omega of M at an accepted step needs and, where it is extrapolated, Omega of Delta."""
        if not (self.carries_delta() and self.choices.extrapolate):
            return [entry for entry in self.rates() if not entry[0].startswith("const")]
        held = {f"const double Mdot{block.number}" for block in self.blocks if block.constrained}
        rates = [entry for entry in self.rates() if not entry[0].startswith("const") or entry[0] in held]
        return [*rates, *self.constraint_rates()]

    def mass_matrix(self, M: Rows) -> Body:
        n = self.scene.n
        given = [(f"M[{i * n + j}]" + (f" = M[{j * n + i}]" if i != j else ""), M[i][j])
                 for i in range(n) for j in range(i + 1)]  # fmt: skip
        return self.write([given], self.naming("x", "v"), ("t", "x", "c"))

    def gradient(self, dM: Sequence[Rows]) -> Body:
        n, zero = self.scene.n, self.terms.graph.zero
        entries = [(k, i, j, dM[k][i][j]) for k in range(n) for i in range(n) for j in range(i + 1)]
        given = [(f"dM[{(k * n + i) * n + j}]" + (f" = dM[{(k * n + j) * n + i}]" if i != j else ""), node)
                 for k, i, j, node in entries if node != zero]  # fmt: skip
        return self.write([given], self.naming("x", "v"), ("t", "x", "c"))

    def pfaffian(self) -> Body:
        A = self.column("A", (node for row in self.terms.A for node in row))
        return self.write([[*A, *self.column("b", self.terms.b)]], self.naming("x", "v"), ("t", "x", "c", "A", "b"))

    def position(self) -> Body:
        given = [*self.column("phi", self.terms.phi), *self.column("terms", self.terms.phi_terms)]
        return self.write([given], self.naming("x", "v"), ("t", "x", "c", "phi", "terms"))

    def bias(self) -> Body:
        given = [*self.column("bias", self.terms.bias), *self.column("gamma", self.terms.gamma)]
        return self.write([given], self.naming("x", "v"), ("t", "x", "v", "c", "u", "gamma"))

    def energy(self) -> Body:
        terms = self.terms
        given = self.column("e", (terms.T2, terms.T1, terms.T0, terms.V))
        return self.write([given], self.naming("x", "v"), ("t", "x", "v", "c"))

    def outputs(self) -> Body:
        mechanics = self.mechanics
        places = {s.name: f"a[{k}]" for k, s in enumerate(mechanics.accelerations)}
        places |= {s.name: f"lambda[{k}]" for k, s in enumerate(mechanics.multipliers)}
        given = self.column("out", (self.terms.node(expression) for _, expression in mechanics.outputs))
        return self.write([given], self.naming("x", "v", places), ("t", "x", "v", "c", "u", "a", "lambda", "out"))

    def events(self) -> Body:
        given = self.column("crossing", (self.terms.node(expression) for _, expression in self.mechanics.events))
        return self.write([given], self.naming("x", "v"), ("t", "x", "v", "c", "u", "crossing"))

    def quasi(self) -> Body:
        given = self.column("y", (self.terms.node(row) for _, row in self.mechanics.quasi_velocities))
        return self.write([given], self.naming("x", "v"), ("t", "x", "v", "c", "y"))

    def prepare(self) -> Body:
        """M of the fixed blocks, then the constants that the other functions asked for."""
        given: list[tuple[str, Node]] = []
        for block in self.blocks:
            if block.fixed:
                given.extend(self.symmetric("M", block, self.terms.factored, True))
        given.extend((f"c[{self.first_constant + k}]", node) for k, node in enumerate(self.constants.nodes))
        return body(self.terms.graph, [given], self.naming("x", "v"), None, ())
