"""Impacts of random mechanisms against Newton's law in NumPy."""

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from scipy.linalg import null_space
from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, System, t

from ..support.generation import FORMULATIONS, system_for

EPS = np.finfo(float).eps
WHEN = 0.1
SHAPES = {"free": (2, 0, 0), "row": (3, 1, 0), "rows": (5, 2, 0), "redundant": (4, 2, 1)}
"""Coordinates, constraint rows, and how many more there are that depend on those."""


@dataclass(frozen=True)
class Shape:
    """A mechanism T = 1/2 sum d_i v_i^2 + 1/2 sum_k (d/dt sin(a_k . x))^2, rows sin(c_r . x) = 0, struck where
    sin(w . x) = s t.

    Everything in it is a parameter, so that one build serves many mechanisms.
    """

    n: int
    m: int
    more: int

    def model(self, name: str) -> Model:
        x = dynamicsymbols(f"x1:{self.n + 1}")
        d = symbols(f"d1:{self.n + 1}", positive=True)
        a, c, w = (symbols(f"{letter}1:{count * self.n + 1}") for letter, count in (("a", 2), ("c", self.m), ("w", 1)))
        e, s = symbols("e s")
        along = lambda row: sum(p * q for p, q in zip(row, x, strict=True))  # noqa: E731
        bodies = [sin(along(a[k * self.n : (k + 1) * self.n])) for k in range(2)]
        rows = [sin(along(c[k * self.n : (k + 1) * self.n])) for k in range(self.m)]
        parameters = dict.fromkeys((*a, *c, *w, *d), 1.0) | {e: 0.5, s: 0.0}
        parameters |= {symbol: 0.3 + 0.1 * k for k, symbol in enumerate((*a, *c, *w))}
        return Model(
            name=name,
            coordinates=list(x),
            kinetic_energy=Rational(1, 2) * (sum(p * q.diff() ** 2 for p, q in zip(d, x, strict=True))
                                             + sum(body.diff(t) ** 2 for body in bodies)),
            potential_energy=sum(map(cos, x)),
            holonomic_constraints=[*rows, *(row * 2 for row in rows[: self.more])],
            events={"strike": Event(t - Rational(1, 10), direction=1, impact=(sin(along(w)) - s * t, e))},
            parameters=parameters,
        )  # fmt: skip


@cache
def shaped(name: str, formulation: str) -> tuple[Shape, System]:
    shape = Shape(*SHAPES[name])
    return shape, system_for(shape.model(f"struck_{name}"), formulation)


@dataclass(frozen=True)
class Case:
    """Numbers of one mechanism, and Newton's law for it."""

    shape: Shape
    values: dict[str, float]

    def table(self, letter: str, rows: int) -> np.ndarray:
        n = self.shape.n
        return np.array([[self.values[f"{letter}{k * n + i + 1}"] for i in range(n)] for k in range(rows)]).reshape(
            rows, n
        )

    def terms(self, x: np.ndarray) -> tuple[np.ndarray, ...]:
        """M, A, N and the rate of phi at rest."""
        a, c, w = self.table("a", 2), self.table("c", self.shape.m), self.table("w", 1)
        g = np.cos(a @ x)[:, None] * a
        M = np.diag([self.values[f"d{i + 1}"] for i in range(self.shape.n)]) + g.T @ g
        return M, np.cos(c @ x)[:, None] * c, (np.cos(w @ x)[:, None] * w)[0], -self.values["s"]

    def struck(self, x: np.ndarray, v: np.ndarray) -> np.ndarray:
        """v+ = v - M^-1 R^T (R M^-1 R^T)^-1 (0, (1 + e)(N v + rate)), R = (A, N)."""
        M, A, N, rate = self.terms(x)
        R = np.vstack([A, N])
        wanted = np.append(np.zeros(len(A)), (1 + self.values["e"]) * (N @ v + rate))
        return v - np.linalg.solve(M, R.T @ np.linalg.solve(R @ np.linalg.solve(M, R.T), wanted))


def drawn(shape: Shape, seed: int) -> tuple[Case, np.ndarray, np.ndarray]:
    """Return a case, and where it starts from."""
    random = np.random.default_rng(seed)
    names = [
        f"{letter}{k + 1}" for letter, count in (("a", 2), ("c", shape.m), ("w", 1)) for k in range(count * shape.n)
    ]
    values = dict(zip(names, random.normal(size=len(names)), strict=True))
    values |= {f"d{i + 1}": random.uniform(0.1, 3.0) for i in range(shape.n)}
    values |= {"e": random.choice([0.0, 1.0, random.uniform()]), "s": random.choice([0.0, random.normal()])}
    return Case(shape, values), random.normal(size=shape.n), random.normal(size=shape.n)


def check_struck(name: str, formulation: str, seed: int) -> None:
    shape, system = shaped(name, formulation)
    case, x0, v0 = drawn(shape, seed)
    way_out = {"dependent_constraints": "least_norm"} if shape.more else {}
    if not shape.more:
        x0, v0 = system.project_initial_state(x0, v0, parameters=case.values)
    else:
        x0 = np.zeros(shape.n)
        A = case.terms(x0)[1]
        v0 = v0 - A.T @ np.linalg.solve(A @ A.T, A @ v0)
    run = system.simulate((0.0, 2 * WHEN), x0=x0, v0=v0, parameters=case.values, rtol=1e-9, atol=1e-9, **way_out)
    assert run.success, run.message
    assert run.t_events[0] == pytest.approx([WHEN], rel=1e-14)
    rows = np.array([run.y_events[0][0], run.y_after_events[0][0]])
    (x, after), (v, v_after) = rows[:, : shape.n], velocities(system, rows, case)
    M, A, N, rate = case.terms(x)
    size = np.sqrt(v @ M @ v) + np.sqrt(v_after @ M @ v_after)
    off = v_after - case.struck(x, v)
    assert np.abs(x - after).max() <= 4 * np.finfo(float).eps * np.abs(x).max()  # a leg begins on the constraints
    assert np.sqrt(off @ M @ off) <= 1e-11 * size * max(1.0, np.linalg.cond(np.vstack([A, N])))
    free = null_space(np.vstack([A, N]))
    assert np.abs(free.T @ M @ (v_after - v)).max(initial=0.0) <= 1e-12 * np.abs(M @ v).max() * np.linalg.cond(M)
    assert np.abs(A @ v_after).max(initial=0.0) <= 1e-12 * (np.abs(A) @ np.abs(v_after)).max(initial=1.0)
    assert abs(N @ v_after + rate + case.values["e"] * (N @ v + rate)) <= 1e-11 * (
        np.abs(N) @ np.abs(v_after) + abs(rate)
    )
    if rate == 0.0:
        assert v_after @ M @ v_after <= v @ M @ v * (1 + 1e-13)


def velocities(system: System, rows: np.ndarray, case: Case) -> np.ndarray:
    return system.compiled.velocity_rows(np.full(len(rows), WHEN), rows, system.prepare(case.values))


@pytest.mark.parametrize("seed", range(10))
def test_random_impacts_are_newtons(seed):
    check_struck(*(("row", "eigenfactor"), ("redundant", "lagrange"))[seed % 2], seed)


@pytest.mark.nightly
@pytest.mark.parametrize("seed", range(200))
def test_many_random_impacts_are_newtons(seed):
    check_struck(tuple(SHAPES)[seed % 4], FORMULATIONS[seed // 4 % 4], seed)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_eta_C_and_S_are_those_of_the_velocities_after(formulation):
    run = shaped_run(formulation)
    assert run.success
    assert len(run.t_events[0]) == 1
    assert run.factor_residual.max() < 1e-13
    at = np.flatnonzero(np.diff(run.t) == 0)[0]
    assert np.abs(run.C[..., at + 1] - run.C[..., at]).max() < 1e-12
    assert np.abs(run.eta[:, at + 1] - run.eta[:, at]).max() > 1e-3
    assert np.abs(run.constraint_residual).max() < 1e-12


def shaped_run(formulation: str) -> em.Solution:
    _, system = shaped("row", formulation)
    x0, v0 = system.project_initial_state([0.3, -0.2, 0.5], [1.0, 0.5, -0.3])
    return system.simulate((0.0, 0.3), x0=x0, v0=v0, rtol=1e-9, atol=1e-9)
