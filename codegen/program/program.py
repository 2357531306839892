"""The `Program` record that templates print: strings, numbers, truth values and tuples."""

from __future__ import annotations

from dataclasses import dataclass

from ..kernel.printer import IN_VECTORS
from .kernel_roles import Kernels


@dataclass(frozen=True, slots=True)
class BlockCoordinate:
    """Coordinate k, number `local` of its block; its velocity in the block is multiplied by `scale` ("" or "2.0*")."""

    k: int
    local: int
    scale: str


@dataclass(frozen=True, slots=True)
class BlockView:
    """A block of M, for templates.

    number, size, coordinates, block_coordinates, names : its coordinates, in the order of its triangular root
    turning, single, fixed : how its eigenfactors are computed (exactly one is true; see `specialise.Kind`)
    constrained : whether one of them occurs in a constraint row
    home : where its root is stored, an em_root_location
    C, s, L, r : offsets: in the prepared parameters if fixed; otherwise C, s in the state, L, r in the memory of a run
    """

    number: int
    size: int
    coordinates: tuple[int, ...]
    block_coordinates: tuple[BlockCoordinate, ...]
    names: str
    turning: bool
    single: bool
    fixed: bool
    constrained: bool
    home: str
    C: int
    s: int
    L: int
    r: int

    @property
    def root_array(self) -> str:
        """The array that holds its triangular root."""
        return "memory" if self.home in ("EM_IN_STATE", "EM_IN_MEMORY") else "c"

    @property
    def factor_array(self) -> str:
        """The array that holds its C and s."""
        return "y" if self.home == "EM_IN_STATE" else "c"


@dataclass(frozen=True, slots=True)
class RowGroup:
    """Constraint rows that Delta couples. C and s are the offsets of its eigenfactors in the state (47).

    kept : offset in the memory of a run of Omega_D and its rate, if (53) is extrapolated
    """

    number: int
    size: int
    rows: tuple[int, ...]
    C: int
    s: int
    kept: int


@dataclass(frozen=True, slots=True)
class Slice:
    """The part y[start .. start + length) of the state, with its name."""

    name: str
    start: int
    length: int


@dataclass(frozen=True, slots=True)
class Named:
    """A name with its default value, as C text."""

    name: str
    value: str


@dataclass(frozen=True, slots=True)
class Declared:
    """The values that a symbol may take: as bits of em_assumptions.h, and as text."""

    bits: int
    words: str


@dataclass(frozen=True, slots=True)
class EventView:
    """An event: its name, its direction, whether it ends the run, and its actions.

    impact, reset, held : the numbers of its impact, its reset and its contact's switch, or -1
    acts : whether it has any action
    keeps_apart : nonzero if it also happens at zero where the motion is about to cross in its direction: 1 for
        downwards, -1 for upwards
    """

    name: str
    direction: int
    terminal: int
    impact: int
    reset: int
    held: int
    keeps_apart: int
    acts: int


@dataclass(frozen=True, slots=True)
class SwitchView:
    """A contact or friction: the numbers of its event and constraint row, and of its parameters (see `Switch`).

    slides : -1 for a contact
    over : the switch whose multiplier is the normal force; -2 - k: it is norm k of multipliers; -1: there is none
    idles : the parameter with the tolerance of its row while the row is idle
    poisson : whether its impacts follow Poisson's law
    shift : for a friction cone, which has two consecutive rows, the first of its two shifts; otherwise -1
    """

    event: int
    holds: int
    slides: int
    over: int
    row: int
    idles: int
    poisson: int
    shift: int


@dataclass(frozen=True, slots=True)
class ShapeView:
    """A shape of the drawing: its kind, its numbers p[first .. first + count), and the corners of a solid."""

    kind: str
    first: int
    count: int
    corners: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TableView:
    """A table: its name, C identifier and C function; number of arguments; index of its parameter; its numbers.

    is_input : whether it is an input of the model that prescribes a motion
    """

    name: str
    identifier: str
    function: str
    arguments: int
    parameter: int
    numbers: tuple[str, ...]
    is_input: bool


@dataclass(frozen=True, slots=True)
class TableUseView:
    """An argument of a table in the motion (see `TableUse`); the table is given by its number."""

    table: int
    axis: int
    order: int
    timed: int


@dataclass(frozen=True, slots=True)
class BodyView:
    """A body: its name, its parent's number, the kind of its joint, the numbers of its coordinates."""

    name: str
    parent: int
    joint: str
    coordinates: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class LinksView:
    """The table of moving bodies over which recursions in C loop.

    bodies : their joints; slots : number of coordinates of all joints
    start : offset of the table in the prepared parameters; numbers : its numbers, 0 for those that depend on parameters
    solves : whether accelerations are computed in loops, too; yields : whether pivots are, without M
    """

    bodies: tuple[BodyView, ...]
    slots: int
    start: int
    numbers: tuple[str, ...]
    solves: bool
    yields: bool


@dataclass(frozen=True, slots=True)
class Program:
    """All data that the files of one model contain.

    eigenfactor, cholesky : whether that is the formulation
    carries_v : whether the state is (x, xdot)
    bounded : whether a triangular root replaces the eigenfactors near coincident eigenvalues
    delta_eigenfactors : whether the eigenfactors of Delta are states, too (47)-(55)
    extrapolate : whether Omega is extrapolated there (32), (53)
    extrapolated : offset in the memory of whether, and since when, it is
    on_lanes : whether the right-hand side can also be compiled for vectors, since it needs no memory
    in_lanes : whether a run can make its steps in one lane of a vector, beside other runs
    needs_mass : whether velocities follow from the state only with M(x)
    augmented : whether M + A^T W A is factored instead of M, which is singular
    settles : whether accepted states must be settled; settling : the parts of this, in order, as text
    layout : the parts of the state vector
    quasi_velocities, initial_y : their names; their initial values if the model gives these
    rows : names of the constraint rows, () if none has one
    pushes : whether forces contain multipliers, so that the multipliers act by P instead of A
    normals : for each norm of multipliers in forces, 1 or 0 for each row: whether it is part of the norm
    reaction_rates : coordinates of the first-order states whose rates depend on multipliers
    n_impacts, resets, switches : the actions of events; for each reset, whether it is in quasi-velocities
    shapes, dimension : of the drawing; 2 or 3, 0 if there is none
    rotations : the coordinates that are modified Rodrigues parameters and may be replaced by their shadow set
    n_prepared : length of the prepared parameters, which include the constants that kernels share
    links : trees of bodies that C adds to M, energies and bias in loops
    costs : operation counts of the model-specific straight-line part, as text
    """

    name: str
    formulation: str
    close_eigenvalues: str
    schur: str
    eigenfactor: bool
    cholesky: bool
    carries_v: bool
    bounded: bool
    delta_eigenfactors: bool
    extrapolate: bool
    extrapolated: int | None
    on_lanes: bool
    in_lanes: bool
    needs_mass: bool
    settles: bool
    settling: tuple[str, ...]
    augmented: bool
    n: int
    m: int
    h: int
    n_state: int
    n_memory: int
    n_C: int
    n_s: int
    n_C_delta: int
    n_s_delta: int
    row_groups: tuple[RowGroup, ...]
    coordinates: tuple[Named, ...]
    n_states: int
    velocities: tuple[str, ...]
    parameters: tuple[Named, ...]
    inputs: tuple[Named, ...]
    declared: tuple[Declared, ...]
    outputs: tuple[str, ...]
    events: tuple[EventView, ...]
    n_impacts: int
    resets: tuple[int, ...]
    rows: tuple[str, ...]
    pushes: bool
    normals: tuple[tuple[int, ...], ...]
    reaction_rates: tuple[int, ...]
    switches: tuple[SwitchView, ...]
    shapes: tuple[ShapeView, ...]
    dimension: int
    quasi_velocities: tuple[str, ...]
    initial_y: tuple[str, ...]
    blocks: tuple[BlockView, ...]
    block_of: tuple[int, ...]
    carried: tuple[int, ...]
    scales: tuple[str, ...]
    layout: tuple[Slice, ...]
    left_out: tuple[str, ...]
    conserves_energy: bool
    n_prepared: int
    costs: tuple[str, ...]
    tables: tuple[TableView, ...]
    bodies: tuple[BodyView, ...]
    rotations: tuple[tuple[int, ...], ...]
    links: LinksView | None
    kernels: Kernels

    @property
    def acts(self) -> bool:
        """Whether events change the state or the mode."""
        return bool(self.n_impacts or self.resets or self.switches)

    @property
    def n_time_events(self) -> int:
        """Number of time events; a periodic one counts once."""
        return self.kernels.time_events.count

    @property
    def table_uses(self) -> tuple[TableUseView, ...]:
        """The arguments of tables in the motion."""
        places = {table.name: k for k, table in enumerate(self.tables)}
        return tuple(
            TableUseView(places[one.table], one.axis, one.order, one.timed) for one in self.kernels.tables.uses
        )

    @property
    def pushed(self) -> str:
        """The number of rows of P, as C text: multipliers, and norms of multipliers in forces."""
        return "N_PUSHED" if self.normals else "N_ROWS"

    @property
    def settles_in_lanes(self) -> bool:
        """Whether accepted states are settled on lanes, too; Newton's method on positions is not available there."""
        return self.in_lanes and not self.h

    @property
    def switched_rows(self) -> str:
        """The bits of the rows that belong to contacts and frictions, as C text."""
        return f"{sum((1 + 2 * (switch.shift >= 0)) << switch.row for switch in self.switches):#x}"

    @property
    def cones(self) -> bool:
        """Whether there is a friction cone."""
        return any(switch.shift >= 0 for switch in self.switches)

    @property
    def turning(self) -> tuple[BlockView, ...]:
        """Blocks whose eigenvectors change."""
        return tuple(block for block in self.blocks if block.turning)

    @property
    def varying(self) -> tuple[BlockView, ...]:
        """Blocks that are not constant."""
        return tuple(block for block in self.blocks if not block.fixed)

    @property
    def constrained(self) -> tuple[BlockView, ...]:
        """Blocks with a coordinate in a constraint row."""
        return tuple(block for block in self.blocks if block.constrained)

    @property
    def coupled(self) -> tuple[RowGroup, ...]:
        """Groups of more than one constraint row."""
        return tuple(group for group in self.row_groups if group.size > 1)

    @property
    def lane_by_lane(self) -> tuple[str, ...]:
        """Functions called by right-hand sides that have no vector version."""
        kernels = self.kernels
        return tuple(sorted((kernels.published.called | kernels.triangular.called) - IN_VECTORS))
