"""States in which a mechanism stays: rest, steady motion, trim."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arguments.names import Vector, overlay, rate_name, spelled, unknown
from ..arguments.options import is_system, no_system
from ..codegen.model import ModelError
from ..codegen.model.normalise import number
from ..pages.notebook import table
from .balance import Balance
from .linearization import Linearization
from .place import Place

if TYPE_CHECKING:
    from ..system.system import System


@dataclass(frozen=True)
class Equilibrium:
    """Where a mechanism stays as it is, or as near as the solver came.

    Attributes
    ----------
    success : whether accelerations vanish and the constraints hold; message : in words, and what does not
    x, v : (n,); t; inputs, parameters : all of them by name, those that were solved for included
    acceleration : (n,) that is left; position_residual : (h,) phi; velocity_residual : (m,) A v + b
    """

    system: "System"
    success: bool
    message: str
    x: Vector
    v: Vector
    t: float
    inputs: dict[str, float]
    parameters: dict[str, float]
    acceleration: Vector
    position_residual: Vector
    velocity_residual: Vector

    def linearize(self) -> Linearization:
        """Return the linearised equations of motion there."""
        return self.system.linearize(self.x, self.v, self.t, self.parameters, self.inputs)

    def __repr__(self) -> str:
        state = ", ".join(f"{name}={value:.6g}" for name, value in zip(self.system.coordinates, self.x, strict=True))
        return f"<Equilibrium {self.system.name}: {self.message}; {state}>"

    def _repr_html_(self) -> str:
        pairs = zip(self.system.coordinates, self.x.tolist(), self.v.tolist(), strict=True)
        given = {"parameters": self.parameters, "inputs": self.inputs}
        rows = {"found": self.message, "state": [f"{name} = {x:.6g}, rate {v:.6g}" for name, x, v in pairs]}
        rows |= {what: [f"{name} = {value:.6g}" for name, value in one.items()] for what, one in given.items() if one}
        return table(f"{self.system.name}: equilibrium", rows)


def find_equilibrium(
    system: "System",
    x0: Mapping[Any, float] | ArrayLike | None = None,
    *,
    free: Sequence[Any] | None = None,
    v0: Mapping[Any, float] | ArrayLike | None = None,
    t: float = 0.0,
    inputs: Mapping[Any, float] | ArrayLike | None = None,
    parameters: Mapping[Any, float] | ArrayLike | None = None,
    constant: Sequence[Any] | None = None,
) -> Equilibrium:
    """Return a state at which accelerations vanish and constraints hold: statics, trim, steady motion.

    Parameters
    ----------
    x0
        Where to look: coordinates over the model's `initial`.
    free
        What is solved for, the rest being given: coordinates ("theta"), rates ("theta'"), inputs, parameters.
        All coordinates by default.
    v0
        Rates: an array, or a mapping of those that are not 0; None: at rest.
    constant
        Coordinates whose rates shall stay what they are, all by default: on a circle x' and y' do not.

    Raises
    ------
    ModelError
        Unknown names; x0, v0 so large that accelerations there are not finite. That there is no such state is no error:
        `Equilibrium.success` is False, and `message` says what could not be satisfied.
    EvaluationError
        M is singular where the search begins.

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/elastic_pendulum.py", formulation="lagrange")
    >>> em.find_equilibrium(system, {"theta": 0.3})
    <Equilibrium elastic_pendulum: at rest; theta=0, r=1.0981>
    """
    if not is_system(system):
        raise no_system("find_equilibrium", system)
    balance = _balance(system, x0, free, v0, t, inputs, parameters, constant)
    with np.errstate(all="ignore"):  # what is not finite has a name of its own
        return _found(balance, _sought(balance))


def _sought(balance: Balance) -> Vector:
    start = balance.start
    solution = balance.solved(start)
    if not balance.satisfied(solution, start) and balance.of_coordinates_alone:
        solution = balance.solved(balance.relaxed(start))
    return solution


def _balance(system: "System", x0: Any, free: Any, v0: Any, t: Any, inputs: Any, parameters: Any, constant: Any
             ) -> Balance:  # fmt: skip
    c = system.compiled
    x = overlay(x0, c.coordinates, c.initial_x, "coordinate of x0")
    v = overlay(v0, c.coordinates, np.zeros(c.n), "coordinate of v0")
    u = overlay(inputs, c.inputs, c.input_defaults, "input")
    p = overlay(parameters, c.parameters, c.parameter_defaults, "parameter")
    names = (*c.coordinates, *(f"{name}'" for name in c.coordinates), *c.inputs, *c.parameters)
    chosen = tuple(range(c.n)) if free is None else _places(free, names, "free")
    if not chosen:
        raise ModelError("free names nothing: there is nothing to solve for")
    rows = tuple(range(c.n)) if constant is None else _places(constant, c.coordinates, "coordinate of constant")
    return Balance(system, names, np.concatenate([x, v, u, p]), chosen, rows, number(t, "t"))


def _places(given: object, names: tuple[str, ...], what: str) -> tuple[int, ...]:
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise ModelError(f"{what} is {given!r}: give a list of names")
    spelt = [f"{rate_name(name)}'" if rate_name(name) != spelled(name) else spelled(name) for name in given]
    if wrong := set(spelt) - set(names):
        raise ModelError(unknown(f"name in {what}", wrong, names))
    return tuple(names.index(name) for name in dict.fromkeys(spelt))


def _found(balance: Balance, q: Vector) -> Equilibrium:
    at, system = balance.place(q), balance.system
    wrong = balance.unsatisfied(q, balance.start)
    z = balance.arguments(q)[2 * system.n :].tolist()
    count = len(system.inputs)
    A, b = at.model.pfaffian(at.t, at.x, at.prepared)
    phi = at.model.position(at.t, at.x, at.prepared)[0]
    residuals = at.motion[0], phi, A @ at.v + b
    steady = not wrong.any() and _stays(balance, at)
    return Equilibrium(
        system, steady, _words(balance, q, wrong, steady, residuals), at.x, at.v, balance.t,
        dict(zip(system.inputs, z[:count], strict=True)), dict(zip(system.parameters, z[count:], strict=True)),
        *residuals,
    )  # fmt: skip


def _stays(balance: Balance, at: Place) -> bool:
    """Whether a motion goes on as it is: accelerations may vanish for an instant only."""
    if not at.v.any():
        return True
    return balance.system.linearize(at.x, at.v, at.t, at.prepared, at.u).steady


def _words(balance: Balance, q: Vector, wrong: NDArray[np.bool_], steady: bool, residuals: tuple[Vector, ...]) -> str:
    if steady:
        return "at rest" if not balance.place(q).v.any() else "steady"
    if not wrong.any():
        return "accelerations vanish for an instant only: the mechanism moves on, and they do not stay so"
    a, phi, rates = residuals
    said = [f"{balance.system.coordinates[k]}'' = {a[k]:.3g}" for k in balance.rows]
    said += [f"row {k} off by {r:.3g}" for k, r in enumerate(phi)]
    said += [f"the rate of row {k} off by {r:.3g}" for k, r in enumerate(rates)]
    free = ", ".join(balance.names[k] for k in balance.free)
    left = ", ".join(text for text, is_wrong in zip(said, wrong, strict=True) if is_wrong)
    return f"no equilibrium found by varying {free}; what is left is {left}{_rounded(balance.place(q))}"


def _rounded(at: Place) -> str:
    if not (names := at.unresolved):
        return ""
    return f". So large are {', '.join(names)} that the next number after them is another place: begin nearer to 0"
