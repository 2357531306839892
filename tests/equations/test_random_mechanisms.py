"""Random mechanisms: of polynomials and sines against NumPy, and as users write them against plain SymPy."""

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, t

from ..support.generation import FORMULATIONS, relative, system_for
from ..support.kinematics import acceleration
from . import mechanism_checks

SHAPES = ((1, 0, "band"), (2, 1, "band"), (3, 1, "diagonal"), (3, 2, "band"), (4, 2, "mixed"), (5, 2, "band"))
"""Coordinates, constraint rows, and where R of M = R^T R + D is not zero."""
PATTERNS = {
    "band": lambda i, j, n: i <= j <= i + 2,
    "diagonal": lambda i, j, n: i == j < n - 1,  # blocks of one coordinate, the last of them constant
    "mixed": lambda i, j, n: i <= j < 2 or i == j == 2,  # two coordinates coupled, one alone, one constant
}
TERMS = 2
DAILY = {number: (FORMULATIONS[0], FORMULATIONS[1 + number % 3]) for number in range(len(SHAPES))}
"""The formulations of a shape by day, two of them in turn; the others at night."""
SEEDS_BY_DAY = (0, 1, 2, 3, 4, 6, 7, 9, 14, 15, 16, 17)
"""Every formulation three times, mechanisms of every size among them; the other seeds at night, as thousands more."""


@dataclass(frozen=True)
class Ridge:
    """Sum over terms of weight * f(direction . x + rate t + phase), f sine or square: values and derivatives."""

    weight: np.ndarray
    direction: np.ndarray
    rate: np.ndarray
    phase: np.ndarray
    sines: np.ndarray

    def _parts(self, x, time):
        u = self.direction @ x + self.rate * time + self.phase
        f = np.where(self.sines, np.sin(u), u**2 / 4)
        f_u = np.where(self.sines, np.cos(u), u / 2)
        f_uu = np.where(self.sines, -np.sin(u), 0.5)
        return self.weight * f, self.weight * f_u, self.weight * f_uu

    def value(self, x, time):
        return self._parts(x, time)[0].sum()

    def gradient(self, x, time):
        """Return (d/dx (n,), d/dt)."""
        slope = self._parts(x, time)[1]
        return slope @ self.direction, slope @ self.rate

    def expression(self, x):
        angles = [sum(float(d) * c for d, c in zip(row, x, strict=True)) + float(r) * t + float(p)
                  for row, r, p in zip(self.direction, self.rate, self.phase, strict=True)]  # fmt: skip
        return sum(float(w) * (sympy.sin(u) if sine else u**2 / 4)
                   for w, u, sine in zip(self.weight, angles, self.sines, strict=True))  # fmt: skip


def ridge(random: np.random.Generator, n: int, size: float) -> Ridge:
    direction = random.uniform(-1, 1, (TERMS, n)) * (random.random((TERMS, n)) < 0.7)
    rate = random.uniform(-0.5, 0.5, TERMS) * (random.random(TERMS) < 0.5)
    return Ridge(
        size * random.uniform(-1, 1, TERMS), direction, rate, random.uniform(-1, 1, TERMS), random.random(TERMS) < 0.6
    )


class Mechanism:
    """T = 1/2 v^T (R^T R + D) v + G v + T0 and V, A, b, with R, G, T0, V, A, b ridge functions of x and t.

    The NumPy side forms every derivative by the product rule; it shares nothing with the generator.
    """

    def __init__(self, number: int) -> None:
        self.n, self.m, pattern = SHAPES[number]
        random = np.random.default_rng(100 + number)
        n, m = self.n, self.m
        self.D = np.diag(np.round(random.uniform(0.8, 2.5, n), 3))
        self.R = [[ridge(random, n, 0.5 * PATTERNS[pattern](i, j, n)) for j in range(n)] for i in range(n)]
        self.G = [ridge(random, n, 0.4) for _ in range(n)]
        self.T0, self.V = ridge(random, n, 0.7), ridge(random, n, 2.0)
        self.A = [[ridge(random, n, 0.6) for _ in range(n)] for _ in range(m)]
        self.b = [ridge(random, n, 0.3) for _ in range(m)]
        self.friction = random.uniform(0, 0.5, n)

    def model(self) -> Model:
        x = dynamicsymbols(f"x1:{self.n + 1}")
        v = sympy.Matrix([c.diff() for c in x])
        R = sympy.Matrix([[entry.expression(x) for entry in row] for row in self.R])
        A = [[entry.expression(x) for entry in row] for row in self.A]
        turned = R * v
        T2 = (turned.dot(turned) + v.dot(sympy.Matrix(self.D) * v)) / 2
        return Model(
            name=f"random_{self.n}_{self.m}",
            coordinates=x,
            kinetic_energy=T2
            + sum(g.expression(x) * w for g, w in zip(self.G, v, strict=True))
            + self.T0.expression(x),
            potential_energy=self.V.expression(x),
            forces=[-float(d) * w for d, w in zip(self.friction, v, strict=True)],
            nonholonomic_constraints=[
                sum(a * w for a, w in zip(row, v, strict=True)) + b.expression(x)
                for row, b in zip(A, self.b, strict=True)
            ],
        )

    def acceleration(self, x, v, time):
        """Return xddot, lambda of M a + Mdot v + Gdot - 1/2 v M_x v - G_x^T v - T0_x + V_x - Q + A^T lambda = 0."""
        R, R_x, R_t = tabulated(self.R, x, time)
        _, G_x, G_t = tabulated([self.G], x, time)
        A, A_x, A_t = tabulated(self.A, x, time, self.n)
        b_x, b_t = (np.array([row.gradient(x, time)[k] for row in self.b]) for k in (0, 1))
        M = R.T @ R + self.D
        M_x = np.einsum("aik,aj->ijk", R_x, R) + np.einsum("ai,ajk->ijk", R, R_x)
        M_dot = M_x @ v + R_t.T @ R + R.T @ R_t
        coriolis = np.einsum("ijk,i,j->k", M_x, v, v) / 2 + G_x[0].T @ v
        f = coriolis + self.T0.gradient(x, time)[0] - self.V.gradient(x, time)[0] - self.friction * v
        f -= M_dot @ v + G_x[0] @ v + G_t[0]
        if not self.m:
            return np.linalg.solve(M, f), np.zeros(0)
        gamma = (A_x @ v + A_t) @ v + b_x @ v + b_t
        whole = np.block([[M, A.T], [A, np.zeros((self.m, self.m))]])
        solution = np.linalg.solve(whole, np.concatenate([f, -gamma]))
        return solution[: self.n], solution[self.n :]


def tabulated(rows, x, time, width=None):
    """Return values (r, c), d/dx (r, c, n) and d/dt (r, c) of a table of ridge functions."""
    shape = (len(rows), width or len(rows[0]))
    gradients = [[entry.gradient(x, time) for entry in row] for row in rows]
    values = np.array([[entry.value(x, time) for entry in row] for row in rows]).reshape(shape)
    in_x = np.array([[g[0] for g in row] for row in gradients]).reshape(*shape, len(x))
    return values, in_x, np.array([[g[1] for g in row] for row in gradients]).reshape(shape)


@cache
def mechanism(number: int) -> Mechanism:
    return Mechanism(number)


@cache
def system(number: int, formulation: str) -> System:
    return system_for(mechanism(number).model(), formulation)


POINTS = st.tuples(st.integers(0, 2**32 - 1), st.floats(0, 3))


def named(number: int) -> str:
    return "n{}m{}_{}".format(*SHAPES[number])


def at_night(condition: bool) -> tuple[pytest.MarkDecorator, ...]:
    return (pytest.mark.nightly,) if condition else ()


EACH = [pytest.param(number, one, id=f"{named(number)}-{one}", marks=at_night(one not in DAILY[number]))
        for number in DAILY for one in FORMULATIONS]  # fmt: skip
TOGETHER = [
    pytest.param(DAILY, id="day"),
    pytest.param(dict.fromkeys(DAILY, FORMULATIONS), id="night", marks=at_night(True)),
]


@pytest.mark.parametrize(("number", "formulation"), EACH)
def test_every_formulation_agrees_with_numpy(number, formulation):
    compiled, right = system(number, formulation), mechanism(number)

    @given(POINTS)
    @settings(max_examples=20, deadline=None, derandomize=True, database=None)
    def agree(point):
        seed, time = point
        random = np.random.default_rng(seed)
        x, v = random.uniform(-1.5, 1.5, right.n), random.normal(size=right.n)
        a, multipliers = right.acceleration(x, v, time)
        found, rows = compiled.acceleration(x, v, time)
        A, _ = compiled.pfaffian(x, time)
        hard = np.linalg.cond(A) ** 2 if right.m else 1.0
        assert relative(found, a) < 1e-11 * hard
        assert relative(rows, multipliers, 1.0) < 1e-11 * hard
        y = compiled.state(x, v, time)
        dy = compiled.rhs(time, y)
        gap = closest(compiled, x, time) if formulation == "eigenfactor" else 1.0
        assert relative(acceleration(compiled, time, y, dy), a, 1.0) < 1e-10 * hard / gap

    agree()


def closest(compiled: System, x: np.ndarray, time: float) -> float:
    """Smallest distance of two eigenvalues: what Omega is divided by."""
    eigenvalues = np.linalg.eigvalsh(compiled.mass_matrix(x, time))
    return min(1.0, float(np.diff(eigenvalues).min(initial=1.0)))


@pytest.mark.parametrize("formulations", TOGETHER)
@pytest.mark.parametrize("number", DAILY, ids=named)
def test_every_formulation_moves_alike(number, formulations):
    ends = []
    for formulation in formulations[number]:
        one = system(number, formulation)
        x, v = one.project_initial_state(np.zeros(one.n), np.linspace(0.3, 1, one.n))
        run = one.simulate((0, 1.5), x0=x, v0=v, rtol=1e-11, atol=1e-12)
        assert run.success, run.message
        assert run.factor_residual.max() < 1e-13
        assert np.abs(run.constraint_residual).max(initial=0.0) < 1e-12
        ends.append(np.concatenate([run.x[:, -1], run.v[:, -1]]))
    assert max(relative(end, ends[-1], 1.0) for end in ends) < 1e-9


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # NumPy passes through the roots a Piecewise does not choose
@pytest.mark.parametrize("seed", [pytest.param(k, marks=at_night(k not in SEEDS_BY_DAY)) for k in range(20)])
def test_mechanisms_with_roots_and_absolute_values_agree_with_lagranges_equations(seed):
    """One formulation each; `make fuzz` takes all of them, and thousands of mechanisms."""
    counts = mechanism_checks.Counts()
    mechanism_checks.check(seed, counts, [FORMULATIONS[seed % len(FORMULATIONS)]], "-O0")
    assert counts.wrong == []
    assert counts.numbers > counts.states > 0
