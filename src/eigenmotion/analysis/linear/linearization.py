"""Linearisation: the result, with eigenvalues and modes."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import ModelError
from ...presentation.notebook import table
from ...runtime import CompiledModel
from .modes import Mode, Reduced, eigenvalues, modes


class StateSpace(NamedTuple):
    """d/dt z = A z + B u, y = C z + D u, for deviations z, u, y."""

    A: Vector
    B: Vector
    C: Vector
    D: Vector


@dataclass(frozen=True)
class Linearization:
    """Deviations from a motion, (dx, dv) = Z z with d/dt z = A z + B du, dy = C z + D du.

    Attributes
    ----------
    A, B, C, D : (k, k), (k, n_inputs), (n_outputs, k), (n_outputs, n_inputs); inputs and outputs are the model's
    Z : (2 n + p, k) orthonormal basis of the tangent space of the constraints, in x, v and p first-order states;
        k = 2 n + p - h - m + dependent rows
    full : A, B, C, D of all these numbers (x, v, z), with constraints
    t, x, v, z, u : the state; acceleration : (n,) at this state
    mode : the contact mode, as in `Solution.modes`; {} without contacts and friction
    steady : whether these equations are constant along the motion (except for coordinates that no equation depends on).
        If not, they hold only at this instant: eigenvalues are those of deviations of independent coordinates, and do
        not decide about stability

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/elastic_pendulum.py", formulation="lagrange")
    >>> em.find_equilibrium(system, {"theta": 0.3}).linearize().modes()[0].words
    'oscillates at 0.4757 Hz, undamped: theta'
    """

    model: CompiledModel
    t: float
    x: Vector
    v: Vector
    z: Vector
    u: Vector
    acceleration: Vector
    A: Vector
    B: Vector
    C: Vector
    D: Vector
    Z: Vector
    full: StateSpace
    steady: bool
    independent: Reduced
    basis: Vector
    inertia: Vector
    mode: dict[str, float]

    def eigenvalues(self) -> Vector:
        """Return the k eigenvalues [1 / s], the least stable first.

        They are computed from deviations of independent coordinates and velocities, scaled and without those that no
        equation depends on. At steady motions they are those of A. Constraints add none.
        """
        return eigenvalues(self.independent)

    @cached_property
    def _modes(self) -> tuple[Mode, ...]:
        return modes(self.independent, self.basis, self.inertia, self.model.coordinates)

    def modes(self) -> tuple[Mode, ...]:
        """Return the natural modes, the least stable first, with one mode for each pair of complex eigenvalues."""
        return self._modes

    @property
    def message(self) -> str:
        """A description of the state: at rest, steady motion, or not steady."""
        if self.steady:
            return "steady: at rest" if not self.v.any() else "steady motion"
        return ("not steady: the mechanism does not stay in this state, so these equations change along its motion and "
                "hold at this instant only")  # fmt: skip

    def to_scipy(self) -> Any:
        """Return a `scipy.signal.StateSpace`; if the model has no outputs, y are the coordinates.

        Raises
        ------
        ModelError
            The model has no inputs, which SciPy requires.
        """
        from scipy.signal import StateSpace as Continuous  # noqa: PLC0415, takes half a second

        if not self.model.n_inputs:
            raise ModelError(f"{self.model.name} has no inputs, and scipy.signal.StateSpace needs some: "
                             "use A, C and eigenvalues(), or give the model an input")  # fmt: skip
        n = len(self.x)
        C, D = (self.C, self.D) if self.model.n_outputs else (self.Z[:n], np.zeros((n, 1)))
        return Continuous(self.A, self.B, C, np.broadcast_to(D, (len(C), self.model.n_inputs)))

    def __repr__(self) -> str:
        values = ", ".join(f"{value:.4g}" for value in self.eigenvalues()[:4])
        more = ", ..." if len(self.A) > 4 else ""
        return f"<Linearization {self.model.name}: {len(self.A)} states, {self.message.split(':')[0]}, {values}{more}>"

    def _repr_html_(self) -> str:
        names = self.model.coordinates
        state = [f"{name} = {x:g}, {name}' = {v:g}" for name, x, v in zip(names, self.x, self.v, strict=False)]
        state += [f"{name} = {z:g}" for name, z in zip(names[len(self.x) :], self.z, strict=True)]
        return table(
            f"{self.model.name}, linearised: {len(self.A)} states, {self.message}",
            {
                "state": state,
                **({"mode": [f"{name} = {value:g}" for name, value in self.mode.items()]} if self.mode else {}),
                "acceleration": [f"{name}: {a:g}" for name, a in zip(names, self.acceleration, strict=False)],
                "modes": [f"{eigenvalue_text(mode.eigenvalue)}  {mode.words}" for mode in self.modes()],
                "inputs": self.model.inputs or "none",
                "outputs": self.model.outputs or "none",
            },
        )


def eigenvalue_text(value: complex) -> str:
    """Return an eigenvalue, or a pair of them, as text."""
    real = value.real + 0.0  # no -0
    return f"{real:.4g} ± {value.imag:.4g} i" if value.imag else f"{real:.4g}"
