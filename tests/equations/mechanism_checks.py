"""One random mechanism against Lagrange's equations by plain SymPy, in every formulation, at states of both signs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices

from eigenmotion import Model, Solution, System

from ..oracles import Lagrange
from ..oracles.direct import Direct
from ..support.generation import FORMULATIONS, loaded, relative
from ..support.kinematics import acceleration
from ..support.random_mechanisms import Maker, State

STATES = 6
LIMIT = 1e-12
"""Of a difference, in units of the condition of the equations."""


@dataclass
class Counts:
    """What came of some mechanisms."""

    mechanisms: int = 0
    systems: int = 0
    states: int = 0
    numbers: int = 0
    runs: int = 0
    wrong: list[str] = field(default_factory=list)


RUN_EVERY = 5
"""One mechanism in so many is run, too."""
ROUGH = 1e-8
RUNS = (("dop853", 1e-11), ("dop853", ROUGH), ("ra15", ROUGH))


class Right:
    """What plain SymPy says of a model at a state."""

    def __init__(self, model: Model) -> None:
        self.model, self.direct, self.lagrange = model, Direct(model), Lagrange(model)

    def terms(self, at: State) -> dict[str, np.ndarray]:
        """M (n, n), A (m, n), b (m,) and the energy."""
        n, m = self.model.n, self.model.m
        p = [at.parameters[str(symbol)] for symbol, _ in self.model.parameters]
        point = [*at.x, *p, at.time, *at.v]
        found = {name: self.direct(name, point) for name in ("M", "A", "b", "energy")}
        return found | {"M": found["M"].reshape(n, n), "A": found["A"].reshape(m, n)}

    def condition(self, M: np.ndarray, A: np.ndarray) -> float:
        """Of the matrix [M A^T; A 0], its rows and columns scaled."""
        size = np.sqrt(np.diag(M))
        unit, rows = M / np.outer(size, size), A / size
        rows = rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-300)
        return float(np.linalg.cond(np.block([[unit, rows.T], [rows, np.zeros((len(A), len(A)))]])))


def check(seed: int, counts: Counts, formulations: Iterable[str] = FORMULATIONS, *flags: str) -> None:
    """Judge the mechanism of one seed."""
    maker = Maker(seed)
    model = maker.model()
    right, states = Right(model), [maker.state() for _ in range(STATES)]
    counts.mechanisms += 1
    for formulation in formulations:
        try:
            system = loaded(compiler.generate(model, Choices(formulation)), *flags, runs=False)
            counts.systems += 1
            for state in states:
                counts.wrong.extend(f"mechanism {seed}, {formulation}: {fault}"
                                    for fault in _faults(system, right, state, counts))  # fmt: skip
        except Exception as error:  # whatever it is, a model that should build and run did not
            counts.wrong.append(f"mechanism {seed}, {formulation}: {type(error).__name__}: {str(error)[-600:]}")


def check_run(seed: int, counts: Counts, *flags: str) -> None:
    """Judge a run by nodes, in one formulation, on lanes, by two of dop853."""
    maker = Maker(seed)
    formulation = FORMULATIONS[seed // RUN_EVERY % len(FORMULATIONS)]
    system = loaded(compiler.generate(maker.model(), Choices(formulation)), *flags, lanes=True)
    for _ in range(STATES):
        at = maker.state()
        try:
            x0, v0 = system.project_initial_state(at.x, at.v, at.time, at.parameters)
            truth, rough, nodes = (_ran(system, at, x0, v0, method, rtol) for method, rtol in RUNS)
        except ValueError:  # there is no start, of any method
            continue
        if not (truth.success and rough.success):
            continue
        counts.runs += 1
        size = 1 + np.abs(truth.x).max() + np.abs(truth.v).max()
        own, off = (max(np.abs(run.x - truth.x).max(), np.abs(run.v - truth.v).max()) / size
                    if run.success else np.inf for run in (rough, nodes))  # fmt: skip
        if off > 30 * (own + ROUGH):
            counts.wrong.append(
                f"mechanism {seed}, {formulation}: ra15 is off by {off:.1e}, dop853 by {own:.1e}: {nodes}"
            )


def _ran(system: System, at: State, x0: np.ndarray, v0: np.ndarray, method: str, rtol: float) -> Solution:
    span = (at.time, at.time + 0.5)
    return system.simulate(span, x0=x0, v0=v0, parameters=at.parameters, inputs=at.inputs, method=method, rtol=rtol,
                           atol=rtol, t_eval=np.linspace(*span, 7), max_steps=20_000)  # fmt: skip


def _faults(system: System, right: Right, at: State, counts: Counts) -> Iterator[str]:
    terms = right.terms(at)
    counts.states += 1
    A, b = system.pfaffian(at.x, at.time, at.parameters)
    found = {"M": system.mass_matrix(at.x, at.time, at.parameters), "A": A, "b": b,
             "energy": [system.energy(at.x, at.v, at.time, at.parameters)]}  # fmt: skip
    yield from _different(found, terms, LIMIT, counts)
    condition = right.condition(terms["M"], terms["A"])
    if condition < 1e6:
        yield from _motion_faults(system, right, at, LIMIT * condition, counts)


def _motion_faults(system: System, right: Right, at: State, limit: float, counts: Counts) -> Iterator[str]:
    """Accelerations and multipliers as they are asked for, and accelerations out of the right-hand side."""
    a, multipliers = right.lagrange(at.x, at.v, at.time, at.parameters, at.inputs)
    asked = system.acceleration(at.x, at.v, at.time, at.parameters, at.inputs)
    found = dict(zip(("acceleration", "multipliers"), asked, strict=True))
    yield from _different(found, {"acceleration": a, "multipliers": multipliers}, limit, counts)
    gap = closest(system, at.x, at.time, at.parameters) if system.formulation == "eigenfactor" else 1.0
    if gap > 1e-4:
        y = system.state(at.x, at.v, at.time, at.parameters)
        dy = system.rhs(at.time, y, at.parameters, at.inputs)
        found = {"right-hand side": acceleration(system, at.time, y, dy, at.parameters)}
        scale = 1 + float(at.v @ at.v)  # Mdot comes of differences here
        yield from _different(found, {"right-hand side": a}, 100 * limit / gap, counts, scale)


def closest(system: System, x: np.ndarray, time: float = 0.0, parameters: object = None) -> float:
    """Smallest distance of two eigenvalues of the scaled M, in units of the largest: what Omega is divided by."""
    M = system.mass_matrix(x, time, parameters)
    eigenvalues = np.linalg.eigvalsh(M * np.outer(system.scales, system.scales))
    return float(np.diff(eigenvalues).min(initial=eigenvalues[-1]) / eigenvalues[-1])


def _different(found: dict, wanted: dict, limit: float, counts: Counts, scale: float = 0.0) -> Iterator[str]:  # type: ignore[type-arg]
    for name, numbers in found.items():
        counts.numbers += np.size(numbers)
        if not relative(numbers, wanted[name], scale) <= limit:
            yield f"{name} {np.ravel(numbers)} for {np.ravel(wanted[name])}, limit {limit:.1e}"
