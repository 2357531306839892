"""One random machine on a tree of bodies against Newton-Euler equations in 40 digits, and runs of two formulations."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from mpmath import mp

from eigenmotion import System
from tests.equations.mechanism_checks import closest
from tests.oracles.newton_euler import DIGITS, constrained
from tests.support.generation import loaded, relative
from tests.support.kinematics import acceleration
from tests.support.random_machines import Machine

OTHERS = ("lagrange", "cholesky", "eigenfactor")
"""Formulations beside that of articulated bodies, one a seed in turn."""
STATES = 2
LIMIT = 1e-12
"""Of a difference, in units of the condition of the equations."""
ILL = 1e6
"""Of equations whose condition is worse only M is compared."""
NEAR = 1e-4
"""Of eigenvalues of M that are nearer to each other no right-hand side with eigenfactors is compared."""
RUN_EVERY = 4
"""One machine in so many is run, too."""


@dataclass
class Counts:
    """What came of some machines."""

    machines: int = 0
    systems: int = 0
    states: int = 0
    closed: int = 0
    ill: int = 0
    runs: int = 0
    wrong: list[str] = field(default_factory=list)


def check(seed: int, counts: Counts, *flags: str, moments: bool = False) -> None:
    """Judge the machine of one seed, maybe stated by first moments; now and then its motion."""
    with mp.workdps(DIGITS):
        machine = Machine(seed, moments=moments)
        random = np.random.default_rng(seed)
        at = [(v, machine.equations(v)) for v in random.normal(size=(STATES, len(machine.q)))]
        counts.machines += 1
        counts.closed += bool(machine.loops)
        runs, systems = seed % RUN_EVERY == 0, []
        for formulation in ("articulated_body", OTHERS[seed % len(OTHERS)]):
            systems.append(loaded(compiler.generate(machine.model, Choices(formulation)), *flags, runs=runs))
            counts.systems += 1
            for v, equations in at:
                counts.wrong.extend(f"machine {seed}, {formulation}: {fault}"
                                    for fault in faults(systems[-1], machine.x, v, equations, counts))  # fmt: skip
    if runs:
        counts.wrong.extend(f"machine {seed}: {fault}" for fault in _run_faults(systems, machine, counts))


def faults(system: System, x: np.ndarray, v: np.ndarray, equations: tuple, counts: Counts) -> Iterator[str]:  # type: ignore[type-arg]
    """Yield what differs from Newton-Euler equations at x, v (n,)."""
    M, F, A, b = equations
    counts.states += 1
    known = np.array(M.tolist(), dtype=float)
    if not relative(system.mass_matrix(x), known) <= LIMIT:
        yield f"M differs by {relative(system.mass_matrix(x), known):.1e}"
    condition = _condition(known, np.array(A, dtype=float).reshape(len(A), len(x)))
    if condition > ILL:
        counts.ill += 1
        return
    wanted, multipliers = constrained(M, F, A, b)
    size = float(np.abs([float(one) for one in F]).max() / np.diag(known).max())
    a, forces = system.acceleration(x, v)
    if not relative(a, wanted, size) <= LIMIT * condition:
        yield f"a differs by {relative(a, wanted, size):.1e} at the condition {condition:.0e}"
    if not relative(forces, multipliers, float(np.abs([float(one) for one in F]).max())) <= LIMIT * condition:
        yield f"lambda differs by {relative(forces, multipliers):.1e} at the condition {condition:.0e}"
    gap = closest(system, x) if system.formulation == "eigenfactor" else 1.0
    if gap < NEAR:
        return
    y = system.state(x, v)
    out = acceleration(system, 0.0, y, system.rhs(0.0, y))
    if not relative(out, wanted, size) <= 100 * LIMIT * condition * (1 + v @ v) / gap:
        yield f"the right-hand side differs by {relative(out, wanted, size):.1e} at the condition {condition:.0e}"


def _condition(M: np.ndarray, A: np.ndarray) -> float:
    """Of the matrix [M A^T; A 0], its coordinates scaled: a row that is small comes of terms that cancel."""
    size = np.sqrt(np.diag(M))
    rows = A / size
    rows = rows / np.abs(rows).max(initial=1e-300)
    return float(np.linalg.cond(np.block([[M / np.outer(size, size), rows.T], [rows, np.zeros((len(A), len(A)))]])))


def _run_faults(systems: list[System], machine: Machine, counts: Counts) -> Iterator[str]:
    """Two formulations and methods go the same way, and the loops remain closed."""
    try:
        x0, v0 = systems[0].project_initial_state(machine.x, np.random.default_rng(1).normal(size=len(machine.q)))
        first, second = (
            system.simulate((0, 0.4), x0=x0, v0=v0, rtol=1e-10, atol=1e-10, method=method, max_steps=20_000)
            for system, method in zip(systems, ("dop853", "ra15"), strict=True)
        )
    except ValueError:  # there is no start
        return
    if not (first.success and second.success):
        return
    counts.runs += 1
    open_by = max(np.abs(system.compiled.position(0.0, x, system.prepare())[0]).max(initial=0.0)
                  for system, x in zip(systems, (first.x[:, -1], second.x[:, -1]), strict=True))  # fmt: skip
    if not open_by <= 1e-9 * (1 + np.abs(first.x).max()):
        yield f"loops are open by {open_by:.1e}"
    off = _apart(systems, (first.x[:, -1], second.x[:, -1])) / (1 + np.abs(first.x).max())
    off = max(off, abs(first.energy[-1] - second.energy[-1]) / (1 + np.abs(first.energy).max()))
    if off > 1e-6:
        yield f"runs differ by {off:.1e}"


def _apart(systems: list[System], ends: tuple[np.ndarray, ...]) -> float:
    """Return how far bodies are apart, in place or rotation: parameters of rotations may be those of the shadow set."""
    one, other = (
        np.array([np.column_stack(system.pose(name, x)) for name in system.bodies])
        for system, x in zip(systems, ends, strict=True)
    )
    return float(np.abs(one - other).max())
