"""Runs of the paper's experiment, and the time histories for its figures."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..building.build import build
from ..models.dual_link import model
from ..results.solution import Solution
from ..system.system import System

T_END = 10.0
MEAN_STEP = 0.024
STEPS = round(T_END / MEAN_STEP)
TOLERANCES = (1e-10, 1e-3)
"""Range in which the tolerance for the mean step is searched."""
ORDER = (2, 1, 3, 0)
"""The paper's order of the eigenvalues 1 to 4: by size at the start, the largest first; 3 is the uncoupled one."""
PAIRS = ((1, 3), (0, 1), (0, 3))
"""Indices (from 0) of the paper's Omega_ij that are not always zero."""


@dataclass(frozen=True)
class History:
    """One run, k rows; eigenvalues and eta in the paper's order.

    Attributes
    ----------
    t : (k,) [s]; x : (4, k) [rad, rad, m, rad]
    eta : (4, k); eigenvalues : (4, k)
    rtol : the tolerance; NaN for fixed steps
    """

    system: System
    solution: Solution
    rtol: float

    @property
    def t(self) -> Vector:
        return np.asarray(self.solution.t)

    @property
    def x(self) -> Vector:
        return np.asarray(self.solution.x)

    @property
    def mean_step(self) -> float:
        """[s]"""
        return float(self.t[-1] - self.t[0]) / int(self.solution.nsteps)

    @property
    def eta(self) -> Vector:
        return np.asarray(self.solution.eta)[list(ORDER)]

    @property
    def eigenvalues(self) -> Vector:
        return np.asarray(self.solution.s)[list(ORDER)] ** 2

    @cached_property
    def Omega(self) -> Vector:
        """(4, 4, k) [1/s], mu_ij / (lambda_j - lambda_i) with mu = C Mdot C^T (31), (32); 0 where mu_ij is 0."""
        rates = [
            np.einsum("kij,k->ij", self.system.mass_matrix_gradient(x), v)
            for x, v in zip(self.x.T, np.asarray(self.solution.v).T, strict=True)
        ]
        C = np.asarray(self.solution.C)[list(ORDER)]
        mu = np.einsum("iak,kab,jbk->ijk", C, np.array(rates), C)
        difference = self.eigenvalues[None, :, :] - self.eigenvalues[:, None, :]
        off = (mu != 0) & ~np.eye(4, dtype=bool)[:, :, None]
        return np.asarray(np.divide(mu, difference, out=np.zeros_like(mu), where=off))

    @property
    def hand(self) -> tuple[Vector, Vector]:
        """x and y (k,) [m] of the hand (56), (57)."""
        p = self.system.parameters
        reach = p["l1"] + self.x[2]
        across = reach * np.cos(self.x[0]) + p["l2"] * np.cos(self.x[1])
        return across, reach * np.sin(self.x[0]) + p["l2"] * np.sin(self.x[1])

    @property
    def violation(self) -> Vector:
        """|y(t) - y(0)| (k,) [m] of the hand: Figure 7."""
        y = self.hand[1]
        return np.asarray(np.abs(y - y[0]))

    @cached_property
    def energy_error(self) -> Vector:
        """The integral of |P(t) - P(0)| up to each row (k,) [J s] (62), by the trapezoidal rule: Figure 8."""
        P = np.asarray(self.solution.energy)
        error = np.abs(P - P[0])
        parts = 0.5 * np.diff(self.t) * (error[1:] + error[:-1])
        return np.concatenate([[0.0], np.cumsum(parts)])


def published() -> System:
    """Return the system in the paper's formulation, with its treatment of close eigenvalues."""
    return build(model, formulation="eigenfactor", close_eigenvalues="extrapolate")


def brute_force() -> System:
    """Return the system of the paper's comparison: the classical equations with an exact algebraic inverse of M."""
    return build(model, formulation="inverse")


def run(system: System, rtol: float, *, project: bool = False, **options: Any) -> History:
    """Run 10 s from rest with the 3rd/4th order method, by default without projection."""
    solution = system.simulate(
        (0.0, T_END), method="rk34", rtol=rtol, atol=rtol, stabilisation="project" if project else "none", **options
    )
    return History(system, solution, rtol)


def at_mean_step(system: System, *, project: bool = False) -> History:
    """Run with the tolerance whose mean step is closest to the paper's 0.024 s."""
    low, high = np.log10(TOLERANCES)
    tried: list[History] = []
    while not tried or (high - low > 1e-3 and tried[-1].solution.nsteps != STEPS):
        middle = 0.5 * (low + high)
        tried.append(run(system, 10.0**middle, project=project))
        if tried[-1].solution.nsteps > STEPS:
            low = middle
        else:
            high = middle
    return min(tried, key=_off)


def _off(history: History) -> int:
    return abs(int(history.solution.nsteps) - STEPS)


def at_fixed_step(system: System) -> History:
    """Run with steps of equal length; the tolerance is so loose that no step is shortened."""
    history = run(system, 0.5, first_step=MEAN_STEP, max_step=MEAN_STEP)
    return History(system, history.solution, np.nan)


@dataclass(frozen=True, slots=True)
class Runs:
    """The runs of one formulation: as published, with fixed steps, and with our projection after each step."""

    published: History
    fixed: History
    projected: History


@dataclass(frozen=True, slots=True)
class Experiment:
    """The runs for the figures and findings."""

    eigenfactor: Runs
    inverse: Runs


def experiment() -> Experiment:
    """Build both systems and run them."""
    return Experiment(_runs(published()), _runs(brute_force()))


def _runs(system: System) -> Runs:
    return Runs(at_mean_step(system), at_fixed_step(system), at_mean_step(system, project=True))
