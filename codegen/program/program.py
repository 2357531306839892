"""The record that templates print: strings, numbers, truth values and tuples."""

from __future__ import annotations

from dataclasses import dataclass

from ..kernel.printer import IN_VECTORS
from .kernel_roles import Kernels


@dataclass(frozen=True, slots=True)
class BlockCoordinate:
    """Coordinate k is number `local` of its block; its velocity there is multiplied by `scale` ("" or "2.0*")."""

    k: int
    local: int
    scale: str


@dataclass(frozen=True, slots=True)
class BlockView:
    """A block of M as the templates see it.

    number, size, coordinates, block_coordinates, names : which coordinates
    turning, single, fixed : how its eigenfactors come about (one is true)
    constrained : whether a constraint row holds one of them
    home : where its root is: an em_home
    C, s, L, r : places: in the prepared parameters (fixed); else C, s in the state, L, r in the memory of a run
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
    """Constraint rows that Delta couples: C and s are the places of its eigenfactors in the state (47).

    kept : place in the memory of a run of Omega_D and its rate, where (53) is extrapolated
    """

    number: int
    size: int
    rows: tuple[int, ...]
    C: int
    s: int
    kept: int


@dataclass(frozen=True, slots=True)
class Slice:
    """y[start .. start + length) is called name."""

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
    """Which numbers a symbol may have: bits of em_assumptions.h, and in words."""

    bits: int
    words: str


@dataclass(frozen=True, slots=True)
class EventView:
    """An event's name, direction and whether it ends the run; what it does.

    impact, reset, held : which of the program's impacts, resets and switches it is, -1: none; frictions are not held
    acts : whether it does anything
    keeps_apart : whether it happens at zero, too, where the motion is about to leave that in its direction: 1 for
        downwards, -1 for upwards, 0: it does not
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
    """What changes with a mode: the numbers of its event and constraint row, the places of its parameters.

    slides : -1: a contact; over : the switch whose multiplier is what presses, -1: none, -2 - k: norm k of multipliers
    idles : the place of how far the row may be off where others keep it
    poisson : whether it strikes by Poisson's law
    shift : of a cone, which has two rows, the other behind this one: the place of the first of its two shifts; else -1
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
    """The numbers p[first .. first + count) of the drawing are a shape of this kind."""

    kind: str
    first: int
    count: int


@dataclass(frozen=True, slots=True)
class TableView:
    """A table: its name, in C and as a function there; its arguments; the place of its parameter; its numbers."""

    name: str
    identifier: str
    function: str
    arguments: int
    parameter: int
    numbers: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TableUseView:
    """An argument of a table that motion looks up (`TableUse`), the table by its number."""

    table: int
    axis: int
    order: int
    timed: int


@dataclass(frozen=True, slots=True)
class Program:
    """Everything that the files of one model say.

    eigenfactor, cholesky : whether that is the formulation
    carries_v : whether the state holds xdot itself
    bounded : whether a triangular root takes over where eigenvalues come close
    delta_eigenfactors : whether the eigenfactors of Delta are states, too (47)-(55)
    extrapolate : whether (32), (53) extrapolate Omega there; `extrapolated`: where the memory says so, and since when
    on_lanes : whether the right-hand side can be compiled for vectors, too: it needs no memory
    in_lanes : whether a run can have its steps made in one lane, others in those beside it
    needs_mass : whether velocities follow from the state only with M(x)
    augmented : whether M + A^T W A is factored in place of M, which is singular
    settles : whether there is anything to do after an accepted step; settling: what, in order, for readers
    layout : the parts of the state vector
    quasi_velocities, initial_y : their names; their values at the start where the model starts from them
    rows : names of the constraint rows, () where none has one
    pushes : whether forces take part of multipliers, so that those push by other rows than A
    normals : of each norm of multipliers that takes part in forces, for each row 1 or 0: whether it is among them
    n_impacts, resets, switches : what events do; of resets, whether they are in quasi-velocities
    shapes, dimension : of the drawing; numbers a position has in it, 0 where there is none
    n_prepared : numbers of a parameter set, the constants that kernels share among them
    costs : operations of the model-specific part and of the whole right-hand side, for readers
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
    kernels: Kernels

    @property
    def acts(self) -> bool:
        """Whether events change the state, or what holds."""
        return bool(self.n_impacts or self.resets or self.switches)

    @property
    def n_time_events(self) -> int:
        """How many times, or series of them, there are at which conditions in the time alone change."""
        return self.kernels.time_events.count

    @property
    def table_uses(self) -> tuple[TableUseView, ...]:
        """What motion looks up in tables."""
        places = {table.name: k for k, table in enumerate(self.tables)}
        return tuple(
            TableUseView(places[one.table], one.axis, one.order, one.timed) for one in self.kernels.tables.uses
        )

    @property
    def pushed(self) -> str:
        """How many numbers push: multipliers, and norms of them."""
        return "N_PUSHED" if self.normals else "N_ROWS"

    @property
    def settles_in_lanes(self) -> bool:
        """Whether accepted steps are settled there, too: Newton's method on positions is for numbers."""
        return self.in_lanes and not self.h

    @property
    def switched_rows(self) -> str:
        """The bits of the rows that hold at times."""
        return f"{sum((1 + 2 * (switch.shift >= 0)) << switch.row for switch in self.switches):#x}"

    @property
    def cones(self) -> bool:
        """Whether some friction is a cone."""
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
        """Blocks that a constraint row holds."""
        return tuple(block for block in self.blocks if block.constrained)

    @property
    def coupled(self) -> tuple[RowGroup, ...]:
        """Groups of more than one constraint row."""
        return tuple(group for group in self.row_groups if group.size > 1)

    @property
    def lane_by_lane(self) -> tuple[str, ...]:
        """Functions of its right-hand sides that vectors do not have."""
        kernels = self.kernels
        return tuple(sorted((kernels.published.called | kernels.triangular.called) - IN_VECTORS))
