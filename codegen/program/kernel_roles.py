"""Records of the kernels of a program, by role."""

from dataclasses import dataclass

from ..kernel.kernel import Kernel
from ..schedule.operations import Cost
from .structure import Structure


@dataclass(frozen=True, slots=True)
class Stages:
    """The two kernels of a function; the velocities that `motion` needs follow from `masses`. None: not needed."""

    masses: Kernel | None
    motion: Kernel | None

    @property
    def cost(self) -> Cost:
        """Operation counts of both kernels."""
        return sum((kernel.cost for kernel in (self.masses, self.motion) if kernel), Cost())

    @property
    def called(self) -> frozenset[str]:
        """Names of the functions that the kernels call."""
        return frozenset().union(*(kernel.called for kernel in (self.masses, self.motion) if kernel))


@dataclass(frozen=True, slots=True)
class TimeEventKernel:
    """The kernel that computes `at`, `period` and `terms` of each time event.

    times : the kernel, None if there are no time events; count : their number
    named : their formulas as text; unsolved : the conditions that cannot be solved for time, as text
    """

    times: Kernel | None
    count: int
    named: tuple[str, ...]
    unsolved: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TableUse:
    """An expression that is argument number `axis` of a table.

    order : the highest derivative with respect to it that is evaluated; timed : 1 if it varies with time alone
    """

    table: str
    axis: int
    order: int
    timed: int


@dataclass(frozen=True, slots=True)
class TableKernel:
    """The kernel that computes the arguments of tables in the motion; None if there are no tables."""

    arguments: Kernel | None
    uses: tuple[TableUse, ...]


@dataclass(frozen=True, slots=True)
class PartialKernels:
    """Kernels of partial derivatives, row-major; None: there are no such rows.

    In the following, the arguments are x, v, inputs, parameters and time.

    state, forcing : of the residuals of motion at fixed a, lambda, with respect to x, v and to the other arguments
    equations : of the same with M itself, with respect to the arguments, if M + A^T W A is factored instead
    constraints, events, quasi : of phi and A v + b, events, and quasi-velocities, with respect to the arguments
    outputs : with respect to a, lambda and the arguments
    impacts, resets, levels : of the event actions (see `Kernels`), with respect to the arguments
    time_events : of at and period of each time event, with respect to the arguments
    mass_matrix, factored : of M, and of M + A^T W A if that is factored instead, with respect to x (n, n, n)
    blow : the impact balance: of M a + A^T lambda and A a at fixed a, lambda
    structure : what is not zero in the equations
    in_loops : whether state, mass_matrix and blow leave out the trees of bodies, which C adds in loops
    """

    in_loops: bool
    structure: Structure
    state: Kernel
    forcing: Kernel
    equations: Kernel | None
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
    levels : the bounds that contacts and frictions are compared with; pushes : P, by which multipliers act as forces
    rates_in_rhs, reaction_rates : of states that depend on multipliers, in a right-hand side and at x, v; None: no such
    reaction_rate_partials : their derivatives with respect to multipliers
    published, triangular : right-hand sides in modes 0 and 1; settled : the treatment of an accepted state
    asks_the_root : whether `settled` shares the kernels of the triangular root, which compute the lower triangle of M
    velocity_of_eta, eta_of_velocity : if `published` takes the triangular root from articulated bodies
    mass_matrix : None if settled.masses computes all of M; factored : M + A^T W A, None if M itself is factored
    bias : None if it is `required` at zero accelerations
    required : inverse dynamics; None if it follows from M and bias
    input_columns : derivatives of forces with respect to inputs; None if there are no inputs
    mixed_inputs : (inputs, inputs) 1 where the column of one input depends on another, or on itself
    partials : None if derivatives are not generated
    time_events : the times at which conditions on time alone change; tables : the arguments of tables
    own_masses : entries of M besides those that C adds in loops; None if there are none
    frames : the numbers that place bodies on their parents; None if there are no bodies
    """

    prepared: Kernel
    time_events: TimeEventKernel
    tables: TableKernel
    frames: Kernel | None
    own_masses: Kernel | None
    mass_matrix: Kernel | None
    factored: Kernel | None
    pfaffian: Kernel
    position: Kernel
    bias: Kernel | None
    required: Kernel | None
    input_columns: Kernel | None
    mixed_inputs: tuple[int, ...]
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
    rates_in_rhs: Kernel | None
    reaction_rates: Kernel
    reaction_rate_partials: Kernel
    published: Stages
    triangular: Stages
    settled: Stages
    asks_the_root: bool
    velocity_of_eta: Kernel | None
    eta_of_velocity: Kernel | None
