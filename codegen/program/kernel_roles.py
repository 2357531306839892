"""Roles of the kernels of a program."""

from dataclasses import dataclass

from ..kernel.kernel import Kernel
from ..schedule.operations import Cost


@dataclass(frozen=True, slots=True)
class Stages:
    """Kernels of one function: the second needs velocities that follow from the first. None: there is nothing to do."""

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
class BreakKernel:
    """When conditions in the time alone change: at, period, terms of each.

    times : None where there are none; count : of them
    named : them, for readers; unsolved : conditions whose times are not found, for readers
    """

    times: Kernel | None
    count: int
    named: tuple[str, ...]
    unsolved: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class PartialKernels:
    """Partial derivatives, row-major; None: there are no such rows.

    state, forcing : of the residuals of motion at fixed a, lambda: by x, v; by inputs, parameters, time
    constraints, events, quasi : of phi and A v + b, of events, of quasi-velocities: by x, v, inputs, parameters, time
    outputs : by a, lambda and these
    impacts, resets, levels : of what events do, as Kernels has them
    breaks : of at and period of each break, by the arguments
    mass_matrix, factored : of M and of what is factored in its place, if anything is, by x (n, n, n)
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
    breaks: Kernel | None
    mass_matrix: Kernel
    factored: Kernel | None


@dataclass(frozen=True, slots=True)
class Kernels:
    """The model-specific straight-line part of each function.

    impacts : N, dphi/dt and the restitution of each; resets : x and v after each
    levels : what switches are held against; pushes : the rows P by which multipliers push
    published, triangular : of the right-hand sides; settled : of what follows an accepted step
    asks_the_root : whether settled are those of the triangular root, with M below its diagonal alone
    mass_matrix : None where settled.masses tell all of it; factored : M + A^T W A, None where it is M
    partials : None where they are left for later
    breaks : when conditions in the time alone change
    """

    prepared: Kernel
    breaks: BreakKernel
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
