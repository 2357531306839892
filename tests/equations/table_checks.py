"""One random mechanism with tables, or prescribed motions, against Lagrange's equations with SciPy's interpolants.

What is compared: accelerations, multipliers, outputs, rates of states, right-hand sides, exact Jacobians, linear
models, and which arguments are refused.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from types import SimpleNamespace

import numpy as np
import sympy
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices

from eigenmotion import EvaluationError, ModelError, System, t

from ..oracles import Lagrange
from ..oracles.curves import Curve, calls_in, rounded
from ..support.generation import FORMULATIONS, loaded, relative, system_for
from ..support.kinematics import acceleration, slope
from ..support.random_mechanisms import State
from ..support.random_tables import TableMaker
from .mechanism_checks import LIMIT, STATES, Counts, Right, closest

Expressions = list[sympy.Expr]
Compiled = Callable[[Expressions], Callable[["Place"], np.ndarray]]
ROUNDING = 1e-13
"""Of a curve, in parts of its terms."""
STEP = 2e-4
"""Of differences, in units of what is differentiated."""
DIFFERENCES = 1e-7
"""What differences are good for, in units of the condition."""


@dataclass
class Place:
    """A state, with the value of a first-order state and what a run is given there."""

    at: State
    z: np.ndarray
    inputs: dict[str, object]

    def moved(self, x: np.ndarray, v: np.ndarray, z: np.ndarray) -> Place:
        return Place(State(x, v, self.at.time, self.at.parameters, self.at.inputs), z, self.inputs)


class Curves:
    """The curves that expressions call, at places."""

    def __init__(self, calls: list[tuple[Curve, tuple[sympy.Expr, ...]]], function: Compiled) -> None:
        self.calls = calls
        self.arguments = function([one for _, arguments in calls for one in arguments])

    def __call__(self, place: Place) -> list[tuple[Curve, tuple[float, ...]]]:
        values = iter(self.arguments(place))
        return [(curve, tuple(float(next(values)) for _ in arguments)) for curve, arguments in self.calls]

    def pieces(self, place: Place) -> list[tuple[int, ...] | None]:
        """The piece of each curve that is asked for; None: nobody knows, to rounding."""
        return [curve.place(point) for curve, point in self(place)]

    @property
    def refuse_rates(self) -> bool:
        """Whether velocities of a state may be refused: nothing then tells how the others are mapped to its rates."""
        return any(curve.outside == "refuse" and any(one.has(sympy.Derivative) for one in arguments)
                   for curve, arguments in self.calls)  # fmt: skip

    def refused(self, place: Place) -> set[str]:
        """The names of the tables that are asked for what they refuse."""
        return {curve.name for curve, point in self(place) if np.isnan(curve.value((0,) * len(point), point))}


class Oracle:
    """What SciPy and plain SymPy say of a mechanism."""

    def __init__(self, maker: TableMaker) -> None:
        model = self.model = maker.equations()
        self.states, self.outputs = model.states, model.outputs
        of_motion = SimpleNamespace(**vars(model) | {"inputs": (*model.inputs, *((z, 0.0) for z in self.states))})
        self.motion = Lagrange(of_motion)
        self.names = [str(p) for p, _ in model.parameters]
        functions = [*(q.diff() for q in maker.q), *maker.q, *self.states, *(u for u, _ in model.inputs)]
        self.plain = dict(zip(functions, (sympy.Dummy(real=True) for _ in functions), strict=True))
        self.others = self._function([*self.outputs.values(), *self.states.values()])
        entering = [model.kinetic_energy, model.potential_energy, *model.forces, *self.states.values(),
                    *model.holonomic_constraints, *model.nonholonomic_constraints]  # fmt: skip
        self.curves = Curves(calls_in(entering), self._function)
        self.of_outputs = Curves(calls_in(self.outputs.values()), self._function)

    def _function(self, expressions: list[sympy.Expr]) -> Callable[[Place], np.ndarray]:
        entries = [sympy.sympify(one).doit().xreplace(self.plain) for one in expressions]
        function = sympy.lambdify([list(self.plain.values()), [p for p, _ in self.model.parameters], t], entries)

        def at_place(place: Place) -> np.ndarray:
            at = place.at
            values = [*at.v, *at.x, *place.z, *at.inputs.values()]
            return np.array(function(values, [at.parameters[name] for name in self.names], at.time), dtype=float)

        return at_place

    def acceleration(self, place: Place) -> tuple[np.ndarray, np.ndarray]:
        at = place.at
        inputs = at.inputs | {z.func.__name__: value for z, value in zip(self.states, place.z, strict=True)}
        return self.motion(at.x, at.v, at.time, at.parameters, inputs)

    def outputs_and_rates(self, place: Place) -> tuple[np.ndarray, np.ndarray]:
        return np.split(self.others(place), [len(self.outputs)])

    def noise(self, place: Place) -> list[float]:
        """How far rounding in curves moves accelerations, multipliers, outputs and rates."""
        right = [*self.acceleration(place), *self.outputs_and_rates(place)]
        most = [0.0] * len(right)
        for seed in range(3):
            with rounded(ROUNDING, seed):
                moved = [*self.acceleration(place), *self.outputs_and_rates(place)]
            off = [float(np.nan_to_num(np.abs(a - b)).max(initial=0.0)) for a, b in zip(moved, right, strict=True)]
            most = list(map(max, most, off))
        return most

    def derivative(self, place: Place) -> np.ndarray:
        """d/dt of (x, v, z)."""
        return np.concatenate([place.at.v, self.acceleration(place)[0], self.outputs_and_rates(place)[1]])

    def slopes(self, place: Place) -> np.ndarray | None:
        """The derivatives of `derivative` along x, v and z; None: near a kink."""
        at, sizes = place.at, (len(place.at.x), len(place.at.v), len(place.z))
        y, pieces = np.concatenate([at.x, at.v, place.z]), self.curves.pieces(place)

        def moved(k: int, h: float) -> Place:
            return place.moved(*np.split(y + h * np.eye(len(y))[k], np.cumsum(sizes)[:2]))

        if any(self.curves.pieces(moved(k, h)) != pieces for k in range(len(y)) for h in (-5 * STEP, 5 * STEP)):
            return None
        columns = [[slope(lambda h, k=k, one=one: self.derivative(moved(k, h * one * 100)))
                    / (one * 100) for k in range(len(y))] for one in (STEP, STEP / 3)]  # fmt: skip
        coarse, fine = (np.array(one).T for one in columns)
        return coarse if relative(coarse, fine, 1.0) < DIFFERENCES else None  # abs(v) is a kink, too


def check(
    seed: int, counts: Counts, formulations: Iterable[str] = FORMULATIONS, *flags: str, tables: bool, driven: bool
) -> None:
    """Judge the mechanism of one seed."""
    made = partial(TableMaker, seed, tables=tables, driven=driven)
    maker, oracle = made(plain=False), Oracle(made(plain=True))
    model = maker.model()
    random = np.random.default_rng([seed, 3])
    places = [Place(maker.state(), random.normal(size=len(model.states)), maker.signals) for _ in range(STATES)]
    counts.mechanisms += 1
    for formulation in formulations:
        try:
            system = loaded(compiler.generate(model, Choices(formulation)), *flags, runs=False)
            counts.systems += 1
            for place in places:
                with np.errstate(all="ignore"):
                    counts.wrong.extend(f"tables {seed}, {formulation}: {fault}"
                                        for fault in _faults(system, oracle, place, counts))  # fmt: skip
        except Exception as error:
            counts.wrong.append(f"tables {seed}, {formulation}: {type(error).__name__}: {str(error)[-600:]}")


def check_jacobian(seed: int, counts: Counts, *, tables: bool, driven: bool) -> None:
    """Judge the exact Jacobian of a formulation whose state has eta: against differences of its right-hand side."""
    made = partial(TableMaker, seed, tables=tables, driven=driven)
    maker, oracle = made(plain=False), Oracle(made(plain=True))
    model = maker.model()
    system = system_for(model, ("eigenfactor", "cholesky")[seed % 2])
    random = np.random.default_rng([seed, 3])
    for _ in range(STATES):
        place = Place(maker.state(), random.normal(size=len(model.states)), maker.signals)
        with np.errstate(all="ignore"):
            counts.wrong.extend(f"tables {seed}: {fault}" for fault in _rate_faults(system, oracle, place, counts))


def _prepared(system: System, place: Place):
    return system.prepare_both(place.at.parameters, dict(place.at.inputs) | place.inputs)


def _usual(system: System, oracle: Oracle, place: Place, prepared) -> float | None:
    """The condition of the equations at a place; None where they are too hard, or a table refuses or nobody knows."""
    at = place.at
    if None in oracle.curves.pieces(place) or oracle.curves.refused(place):
        return None
    A = system.pfaffian(at.x, at.time, prepared)[0]
    M = system.mass_matrix(at.x, at.time, prepared)
    if not np.isfinite(M).all() or np.linalg.eigvalsh(M)[0] <= 0:
        return None
    condition = Right.condition(None, M, A)
    return condition if condition < 1e6 else None


def _rate_faults(system: System, oracle: Oracle, place: Place, counts: Counts) -> Iterator[str]:
    prepared, inputs = _prepared(system, place)
    condition, at = _usual(system, oracle, place, prepared), place.at
    if condition is None or oracle.slopes(place) is None:
        return
    gap = closest(system, at.x, at.time, at.parameters)
    if gap < 1e-3:
        return
    y = system.state(np.concatenate([at.x, place.z]), at.v, at.time, prepared)
    found = system.jacobian(at.time, y, prepared, inputs)
    columns = [slope(lambda h, one=one: system.rhs(at.time, y + h * STEP * 100 * one, prepared, inputs)) / (STEP * 100)
               for one in np.eye(len(y))]  # fmt: skip
    counts.states += 1
    counts.numbers += found.size
    if not relative(found, np.array(columns).T, 1.0) <= DIFFERENCES * condition / gap:
        yield f"Jacobian off by {relative(found, np.array(columns).T, 1.0):.1e}"


def _faults(system: System, oracle: Oracle, place: Place, counts: Counts) -> Iterator[str]:
    counts.states += 1
    prepared, inputs = _prepared(system, place)
    if None in oracle.curves.pieces(place):
        return
    if refused := oracle.curves.refused(place):
        yield from _not_refused(system, refused, place)
        return
    condition = _usual(system, oracle, place, prepared)
    if condition is not None:
        yield from _motion_faults(system, oracle, place, (prepared, inputs), condition, counts)


def _not_refused(system: System, refused: set[str], place: Place) -> Iterator[str]:
    at = place.at
    try:
        found = system.acceleration(np.concatenate([at.x, place.z]), at.v, at.time, at.parameters,
                                    at.inputs | place.inputs)  # fmt: skip
    except EvaluationError as error:
        if not any(repr(name) in str(error) for name in refused):
            yield f"refused without one of {refused}: {error}"
    else:
        yield f"outside of {refused}: {found}"


def _motion_faults(system: System, oracle: Oracle, place: Place, given, condition: float, counts: Counts):  # type: ignore[no-untyped-def]
    (prepared, inputs), at, limit = given, place.at, LIMIT * condition
    a, multipliers = oracle.acceleration(place)
    outputs, rates = oracle.outputs_and_rates(place)
    x = np.concatenate([at.x, place.z])
    found = system.acceleration(x, at.v, at.time, at.parameters, at.inputs | place.inputs)
    noise = oracle.noise(place)
    yield from _different("acceleration", found[0], a, limit, counts, more=noise[0])
    yield from _different("multipliers", found[1], multipliers, limit, counts, more=noise[1])
    if None not in oracle.of_outputs.pieces(place):
        yield from _different("outputs", _outputs(system, place, prepared), outputs, limit, counts, more=noise[2])
    gap = closest(system, at.x, at.time, prepared) if system.formulation == "eigenfactor" else 1.0
    if gap < 1e-4:
        return
    y = system.state(x, at.v, at.time, prepared)
    dy = system.rhs(at.time, y, prepared, inputs)
    yield from _different("rates", dy[system.layout["z"]] if len(rates) else rates, rates, limit, counts,
                          more=noise[3])  # fmt: skip
    if not len(rates) and ("v" in system.layout or not oracle.curves.refuse_rates):
        moved = acceleration(system, at.time, y, dy, prepared)
        scale = 1 + float(at.v @ at.v)  # Mdot comes of differences here
        yield from _different("right-hand side", moved, a, 100 * limit / gap, counts, scale, 100 * noise[0] / gap)
    if "v" in system.layout:
        yield from _slope_faults(system, oracle, place, (prepared, inputs), condition, counts)


def _slope_faults(system: System, oracle: Oracle, place: Place, given, condition: float, counts: Counts):  # type: ignore[no-untyped-def]
    right, at = oracle.slopes(place), place.at
    if right is None:
        return
    y = system.state(np.concatenate([at.x, place.z]), at.v, at.time, given[0])
    order = np.concatenate(
        [np.arange(len(y))[system.layout[name]] for name in ("x", "v", "z")[: 3 if len(place.z) else 2]]
    )
    found = system.jacobian(at.time, y, *given)[np.ix_(order, order)]
    yield from _different("Jacobian", found, right, DIFFERENCES * condition, counts, 1.0)
    yield from _linear_faults(system, oracle, place, given, counts)


def _linear_faults(system: System, oracle: Oracle, place: Place, given, counts: Counts) -> Iterator[str]:  # type: ignore[no-untyped-def]
    """The linear model, at the nearest state that the constraints allow."""
    at = place.at
    try:
        x, v = system.project_initial_state(at.x, at.v, at.time, given[0])
    except (EvaluationError, ModelError):  # there is none near
        return
    place = place.moved(x, v, place.z)
    condition = _usual(system, oracle, place, given[0])
    right = oracle.slopes(place) if condition is not None else None
    if right is not None:
        A = system.linearize(np.concatenate([x, place.z]), v, t=at.time, parameters=given[0], inputs=given[1]).full.A
        yield from _different("linear model", A, right, DIFFERENCES * condition, counts, 1.0)


def _outputs(system: System, place: Place, prepared) -> np.ndarray:
    at = place.at
    x, v = system.begin(np.concatenate([at.x, place.z]), at.v, at.time, prepared)
    u = np.array([[at.inputs[name] for name in system.inputs]])
    return system.compiled.output_rows(np.array([at.time]), x[None], v[None], u, prepared, False)[0]


def _different(  # type: ignore[no-untyped-def]
    name: str, found, wanted, limit: float, counts: Counts, scale: float = 1.0, more: float = 0.0
) -> Iterator[str]:
    """Yield what is off by more than a limit, relative to the largest number or `scale`, and `more`."""
    counts.numbers += np.size(wanted)
    if np.shape(found) != np.shape(wanted):
        yield f"{name} of shape {np.shape(found)} for {np.shape(wanted)}"
        return
    same = np.isnan(found) & np.isnan(wanted)  # what is refused is no number on both sides
    off = np.where(same, 0.0, np.abs(found - wanted))
    allowed = limit * max(float(np.abs(wanted[~same]).max(initial=0.0)), scale) + more
    if not off.max(initial=0.0) <= allowed:
        k = np.unravel_index(np.argmax(np.where(np.isnan(off), np.inf, off)), np.shape(wanted))
        yield f"{name}{list(map(int, k))} {found[k]} for {wanted[k]}, more than {allowed:.1e} apart"
