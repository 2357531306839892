"""Equilibria: rest, steady motion, trim."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arguments.named_values import Vector, overlay, rate_name, spelled, unknown
from ...arguments.options import is_system, no_system
from ...arguments.prescribed import with_prescribed
from ...arguments.states import split_states, whole_v, whole_x
from ...arguments.tables import refuse_tables, with_tables
from ...codegen.model import ModelError
from ...codegen.model.normalise import number
from ...compiled.compiled_system import CompiledSystem
from ...presentation.notebook import table
from ..linear.linearization import Linearization
from ..linear.linearize import linearize, linearized
from ..state.active_contacts import mode_of, mode_text
from ..state.contact_bounds import is_within, sticking, with_most_contacts
from ..state.contact_mode import check_not_inside
from ..state.operating_point import OperatingPoint
from .along_motion import along_motion
from .contact_equilibrium import solve_with_modes
from .equilibrium_equations import Balance


@dataclass(frozen=True)
class Equilibrium:
    """An equilibrium, or the best approximation of one.

    Attributes
    ----------
    success : whether accelerations vanish and the constraints hold; message : description, with residuals on failure
    x, v : (n,); t; inputs, parameters : all values by name, with those that were solved for
    acceleration : (n,) residual; position_residual : (h,) phi; velocity_residual : (m,) A v + b
    multipliers : (m,) of the constraint rows; a possible choice if they are not unique. A contact force is minus its
        multiplier
    mode : the contact mode, as in `Solution.modes`; {} without contacts and friction
    states : name -> value of each first-order state
    """

    system: CompiledSystem
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
    multipliers: Vector
    mode: dict[str, float]
    states: dict[str, float]

    def linearize(self, *, mode: Mapping[Any, float] | None = None) -> Linearization:
        """Return the linearised equations of motion; `mode` as in `System.linearize`, if modes meet there."""
        place = dict(zip(self.system.coordinates, self.x, strict=True)) | self.states
        return linearize(self.system, place, self.v, self.t, self.parameters, self.inputs, mode=mode)

    def __repr__(self) -> str:
        state = ", ".join(f"{name}={value:.6g}" for name, value in zip(self.system.coordinates, self.x, strict=True))
        state += "".join(f", {name}={value:.6g}" for name, value in self.states.items())
        return f"<Equilibrium {self.system.name}: {self.message}; {state}>"

    def _repr_html_(self) -> str:
        pairs = zip(self.system.coordinates, self.x.tolist(), self.v.tolist(), strict=True)
        given = {"parameters": self.parameters, "inputs": self.inputs}
        rows = {"found": self.message, "state": [f"{name} = {x:.6g}, rate {v:.6g}" for name, x, v in pairs]}
        rows |= {what: [f"{name} = {value:.6g}" for name, value in one.items()] for what, one in given.items() if one}
        return table(f"{self.system.name}: equilibrium", rows)


def find_equilibrium(
    system: CompiledSystem,
    x0: Mapping[Any, float] | ArrayLike | None = None,
    *,
    free: Sequence[Any] | None = None,
    v0: Mapping[Any, float] | ArrayLike | None = None,
    t: float = 0.0,
    inputs: Mapping[Any, float] | ArrayLike | None = None,
    parameters: Mapping[Any, float] | ArrayLike | None = None,
    constant: Sequence[Any] | None = None,
) -> Equilibrium:
    """Return a state with zero accelerations that satisfies the constraints: statics, trim, steady motion.

    Parameters
    ----------
    x0
        Initial guess of the coordinates, over the model's `initial`.
    free
        The unknowns, all else being given: coordinates ("theta"), rates ("theta'"), inputs, parameters. All
        coordinates by default.
    v0
        Rates: an array, or a mapping of those that are not 0; None: at rest.
    constant
        Coordinates whose rates must be constant, all by default. (On a circle x' and y' are not.)

    Raises
    ------
    ModelError
        Unknown names; x0, v0 so large that accelerations are not finite. If there is no equilibrium, this is not an
        error: `Equilibrium.success` is False, and `message` contains the residuals.
    EvaluationError
        M is singular at the initial guess.

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/elastic_pendulum.py", formulation="lagrange")
    >>> em.find_equilibrium(system, {"theta": 0.3})
    <Equilibrium elastic_pendulum: at rest; theta=0, r=1.0981>
    """
    if not is_system(system):
        raise no_system("find_equilibrium", system)
    balance = balance_of(system, x0, free, v0, t, inputs, parameters, constant)
    with np.errstate(all="ignore"):  # numbers that are not finite are reported by name
        return _equilibrium(*(solve_with_modes(balance) if system.compiled.switches else _solve(balance)))


def _solve(balance: Balance) -> tuple[Balance, Vector]:
    start = balance.start
    solution = balance.solve(start)
    if not balance.satisfied(solution, start) and balance.of_coordinates_alone:
        solution = balance.solve(balance.follow_to_rest(start))
    elif not balance.satisfied(solution, start) and balance.of_states:
        ends = map(balance.solve, along_motion(balance))
        solution = next((end for end in ends if balance.satisfied(end, start)), solution)
    return balance, solution


def balance_of(system: CompiledSystem, x0: Any, free: Any, v0: Any, t: Any, inputs: Any, parameters: Any, constant: Any
               ) -> Balance:  # fmt: skip
    """Return the equations of `find_equilibrium`."""
    c = system.compiled
    n, (x0, z0) = system.n, split_states(c, x0)
    x = whole_x(c, x0)
    v = whole_v(c, overlay(v0, c.coordinates[:n], np.zeros(n), "coordinate of v0"), z0)
    parameters, inputs = with_prescribed(c, parameters, inputs)
    u = overlay(inputs, c.inputs, c.input_defaults, "input")
    p = overlay(with_tables(c, parameters), c.parameters, c.parameter_defaults, "parameter")
    moving, states = system.coordinates, system.states
    names = (*moving, *(f"integral of {name}" for name in states), *(f"{name}'" for name in moving), *states, *c.inputs,
             *c.parameters)  # fmt: skip
    chosen = (*range(n), *range(c.n + n, 2 * c.n)) if free is None else _places(free, names, "free")
    refuse_tables(c, tuple(names[k] for k in chosen), "free")
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


def _equilibrium(balance: Balance, q: Vector) -> Equilibrium:
    system, wrong = balance.system, balance.unsatisfied(q, balance.start)
    at, bounds = balance.point(q), list[str]()
    multipliers = at.motion[1]
    if not wrong.any():
        at, bounds = _with_most_contacts(at)
        multipliers = at.motion[1] if is_within(at) else multipliers
    inside = _inside(at)
    n, rest = system.n, balance.arguments(q)[2 * system.compiled.n :].tolist()
    A, b = at.model.pfaffian(at.t, at.x, at.prepared)
    phi = at.model.position(at.t, at.x, at.prepared)[0]
    residuals = at.motion[0], phi, A @ at.v + b
    steady = not (wrong.any() or inside) and _stays(at)
    message = inside or _words(balance, at, wrong, steady, bounds, residuals)
    inputs = dict(zip(system.inputs, rest[: len(system.inputs)], strict=True))
    parameters = dict(zip(system.parameters, at.prepared.parameters, strict=True))
    mode = mode_of(at.model, at.prepared)
    return Equilibrium(
        system, steady, message, at.x[:n], at.v[:n], balance.t, inputs, parameters, residuals[0][:n], *residuals[1:],
        at.motion[1], mode, dict(zip(system.states, at.v[n:].tolist(), strict=True)),
    )  # fmt: skip


def _with_most_contacts(at: OperatingPoint) -> tuple[OperatingPoint, list[str]]:
    found, bounds = with_most_contacts(sticking(at))
    return found, [words for _, words in bounds]


def _inside(at: OperatingPoint) -> str:
    """Return a message if the state is inside a contact, else ""."""
    try:
        check_not_inside(at)
    except ModelError as error:
        return f"no equilibrium found: {error}"
    return ""


def _stays(at: OperatingPoint) -> bool:
    """Return whether the motion is steady: accelerations may also vanish only for an instant."""
    return at.rests or linearized(at).steady


def _words(balance: Balance, at: OperatingPoint, wrong: NDArray[np.bool_], steady: bool, bounds: list[str],
           residuals: tuple[Vector, ...]) -> str:  # fmt: skip
    active = mode_text(at)
    if steady:
        kind = "at rest" if at.rests else "steady"
        return "; ".join([f"{kind}, {active}" if active else kind, *bounds])
    if not wrong.any():
        return "accelerations vanish for an instant only: the mechanism moves on, and they do not stay so"
    a, phi, rates = residuals
    names, n = balance.system.compiled.coordinates, balance.system.n
    marks = ["''" if k < n else "'" for k in balance.rows]
    texts = [f"{names[k]}{mark} = {a[k]:.3g}" for k, mark in zip(balance.rows, marks, strict=True)]
    texts += [f"{balance.system.row_names[k]} off by {r:.3g}" for k, r in enumerate(phi)]
    texts += [f"the rate of {balance.system.row_names[k]} off by {r:.3g}" for k, r in enumerate(rates)]
    free = ", ".join(balance.names[k] for k in balance.free)
    left = ", ".join(text for text, is_wrong in zip(texts, wrong, strict=True) if is_wrong)
    where = f", with {active}" if active else ""
    return f"no equilibrium found by varying {free}; what is left is {left}{where}{_rounded(at)}"


def _rounded(at: OperatingPoint) -> str:
    if not (names := at.unresolved):
        return ""
    return f". So large are {', '.join(names)} that the next number after them is another place: begin nearer to 0"
