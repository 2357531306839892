"""Description of a compiled model."""

from ..arguments.named_values import Vector
from ..arguments.states import names_of_states
from ..runtime import CompiledModel
from .bodies import names_of_bodies


class Description:
    """Names, dimensions, defaults and structure of one compiled model."""

    __slots__ = ("_compiled",)

    def __init__(self, compiled: CompiledModel) -> None:
        self._compiled = compiled

    @property
    def name(self) -> str:
        """The model's name."""
        return self._compiled.name

    @property
    def n(self) -> int:
        """The number of coordinates."""
        return self._compiled.n_coordinates

    @property
    def m(self) -> int:
        """The number of constraint rows."""
        return self._compiled.m

    @property
    def h(self) -> int:
        """The number of holonomic rows, which are the first."""
        return self._compiled.h

    @property
    def n_state(self) -> int:
        """The length of the state y."""
        return self._compiled.n_state

    @property
    def formulation(self) -> str:
        """One of "eigenfactor", "cholesky", "lagrange", "inverse", "articulated_body"."""
        return self._compiled.formulation

    @property
    def close_eigenvalues(self) -> str:
        """One of "bounded", "extrapolate"."""
        return self._compiled.close_eigenvalues

    @property
    def schur(self) -> str:
        """The factorisation of Delta."""
        return self._compiled.schur

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of x, in order."""
        return self._compiled.coordinates[: self.n]

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the first-order states z."""
        return names_of_states(self._compiled)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Names of the bodies of its trees, parents before their children; () if its energies are expressions."""
        return names_of_bodies(self._compiled)

    @property
    def parameters(self) -> dict[str, float]:
        """Names and defaults, in order (a copy)."""
        return dict(zip(self._compiled.parameters, self._compiled.parameter_defaults.tolist(), strict=True))

    @property
    def inputs(self) -> dict[str, float]:
        """Names and defaults, in order (a copy)."""
        return dict(zip(self._compiled.inputs, self._compiled.input_defaults.tolist(), strict=True))

    @property
    def prescribed(self) -> tuple[str, ...]:
        """Names of the inputs that prescribe a motion: those in constraints, which are given as smooth signals."""
        return tuple(self._compiled.prescribed)

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of the outputs."""
        return self._compiled.outputs

    @property
    def events(self) -> tuple[str, ...]:
        """Names of the events, in the order of `Solution.t_events`."""
        return self._compiled.events

    @property
    def row_names(self) -> tuple[str, ...]:
        """Labels of the constraint rows in messages: "guide[1]" if they have names, else "row 1"."""
        return self._compiled.row_names

    @property
    def quasi_velocities(self) -> tuple[str, ...]:
        """Names of the quasi-velocities y = P(x, t) xdot (3); () if the model states none."""
        return self._compiled.quasi_velocities

    @property
    def initial(self) -> tuple[Vector, Vector]:
        """The model's initial x (n,), v (n,) (copies)."""
        return self._compiled.initial_x[: self.n].copy(), self._compiled.initial_v[: self.n].copy()

    @property
    def layout(self) -> dict[str, slice]:
        """Name of a part of y -> its slice."""
        return {name: slice(start, start + length) for name, start, length in self._compiled.layout}

    @property
    def left_out(self) -> tuple[str, ...]:
        """Terms that this model's program leaves out, with the reason."""
        return self._compiled.left_out

    @property
    def blocks(self) -> tuple[tuple[int, ...], ...]:
        """The coordinates of each diagonal block of M."""
        return blocks_of(self._compiled, self.n)

    @property
    def scales(self) -> Vector:
        """(n,) units of the coordinates inside the eigenproblem (a copy)."""
        return self._compiled.scales[: self.n].copy()

    @property
    def units(self) -> dict[str, str]:
        """Name -> unit, as the model gives them (a copy); {} for a model without units."""
        return dict(self._compiled.units or {})

    @property
    def conserves_energy(self) -> bool:
        """Whether `jacobi_integral` is a constant of the motion."""
        return self._compiled.conserves_energy

    @property
    def compiled(self) -> CompiledModel:
        """The functions on bare float64 arrays."""
        return self._compiled


def blocks_of(c: CompiledModel, n: int) -> tuple[tuple[int, ...], ...]:
    """Return the coordinates, among the first n, of each diagonal block of M."""
    block = c.block[:n]
    return tuple(tuple(k for k, b in enumerate(block) if b == which) for which in sorted(set(block)))
