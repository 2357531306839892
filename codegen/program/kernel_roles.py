"""Roles of the kernels of a program."""

from dataclasses import dataclass

from ..kernel.kernel import Kernel
from ..schedule.operations import Cost


@dataclass(frozen=True, slots=True)
class Stages:
    """The two kernels of a function: `motion` needs velocities that follow from `masses`. None: nothing to compute."""

    masses: Kernel | None
    motion: Kernel | None

    @property
    def cost(self) -> Cost:
        """Operations of both."""
        return sum((kernel.cost for kernel in (self.masses, self.motion) if kernel), Cost())

    @property
    def called(self) -> frozenset[str]:
        """Names of the functions that they call."""
        return frozenset().union(*(kernel.called for kernel in (self.masses, self.motion) if kernel))


@dataclass(frozen=True, slots=True)
class TimeEventKernel:
    """The kernel of time events: `at`, `period` and `terms` of each.

    times : the kernel, None without time events; count : their number
    named : their formulas as text; unsolved : conditions whose times cannot be found, as text
    """

    times: Kernel | None
    count: int
    named: tuple[str, ...]
    unsolved: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TableUse:
    """An expression that is argument number `axis` of a table.

    order : the highest derivative by it that is taken; timed : 1 where it varies with the time alone
    """

    table: str
    axis: int
    order: int
    timed: int


@dataclass(frozen=True, slots=True)
class TableKernel:
    """Where motion looks up its tables; None: it has none."""

    arguments: Kernel | None
    uses: tuple[TableUse, ...]


@dataclass(frozen=True, slots=True)
class PartialKernels:
    """Kernels of partial derivatives, row-major; None: there are no such rows.

    state, forcing : of the residuals of motion at fixed a, lambda: by x, v; by inputs, parameters, time
    constraints, events, quasi : of phi and A v + b, of events, of quasi-velocities: by x, v, inputs, parameters, time
    outputs : by a, lambda and these
    impacts, resets, levels : of the event actions, as Kernels has them
    time_events : of at and period of each time event, by the arguments
    mass_matrix, factored : of M, and of M + A^T W A if that is factored instead, by x (n, n, n)
    blow : of M a + A^T lambda and A a at fixed a, lambda
    """

    state: Kernel
    forcing: Kernel
    constraints: Kernel | None
    outputs: Kernel | None
    events: Kernel | None
    quasi: Kernel | None
    impacts: Kernel | None
    resets: Kernel | None
    levels: Kernel | None
    blow: Kernel | None
    time_events: Kernel | None
    mass_matrix: Kernel
    factored: Kernel | None


@dataclass(frozen=True, slots=True)
class Kernels:
    """The model-specific straight-line part of each function.

    impacts : N, dphi/dt and the restitution of each; resets : x and v after each
    levels : the bounds that contacts and frictions are compared with; pushes : the rows P by which multipliers act
    published, triangular : right-hand sides in modes 0 and 1; settled : the treatment of an accepted state
    asks_the_root : whether `settled` are the kernels of the triangular root, with M below its diagonal alone
    mass_matrix : None where settled.masses computes all of it; factored : M + A^T W A, None where it is M
    partials : None where they are compiled on demand
    time_events : the times at which conditions on time alone change; tables : the lookups of tables
    """

    prepared: Kernel
    time_events: TimeEventKernel
    tables: TableKernel
    mass_matrix: Kernel | None
    factored: Kernel | None
    pfaffian: Kernel
    position: Kernel
    bias: Kernel
    energy: Kernel
    outputs: Kernel
    events: Kernel
    quasi: Kernel
    drawing: Kernel
    partials: PartialKernels | None
    impacts: Kernel
    resets: Kernel
    levels: Kernel
    pushes: Kernel
    published: Stages
    triangular: Stages
    settled: Stages
    asks_the_root: bool
