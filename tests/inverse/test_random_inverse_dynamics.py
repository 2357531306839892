"""Inverse dynamics of random mechanisms: with the forces found, Lagrange's equations give the accelerations back."""

import random
from itertools import combinations

import numpy as np
import pytest
from eigenmotion.codegen.choices import FORMULATIONS

import eigenmotion as em

from ..oracles.lagrange import Lagrange
from ..support.generation import system_for
from ..support.random_mechanisms import Maker

STATES = 4
LIMIT = 1e-13
"""Of a difference, in units of the condition of the equations."""
SAFE = 1e6
"""Condition up to which actuators are taken."""


class Oracle:
    """Lagrange's equations of a mechanism at one state, by plain SymPy: M a + A^T lambda = f, A a = drift."""

    def __init__(self, lagrange, at, x, v):
        n, m = self.n, self.m = lagrange.n, lagrange.m
        values = lagrange._function(*lagrange._arguments(x, v, at.time, at.parameters, at.inputs))
        numbers = np.array(values, dtype=float)
        self.M, rest = numbers[: n * n].reshape(n, n), numbers[n * n :]
        self.f, self.drift, self.A = rest[:n], rest[n : n + m], rest[n + m :].reshape(m, n)
        self.whole = np.block([[self.M, self.A.T], [self.A, np.zeros((m, m))]])
        size = np.sqrt(np.abs(np.diag(self.M)))
        rows = np.linalg.norm(self.A / size, axis=1)
        self.unit = np.concatenate([size, rows]) if m == 0 or rows.min() > 0 else None

    def condition(self):
        """Of the equations, with rows and columns scaled; infinite where a row vanishes."""
        if self.unit is None or not np.isfinite(self.whole).all() or not self.unit.all():
            return np.inf
        return np.linalg.cond(self.whole / self.unit[:, None] / self.unit)

    def forward(self, forces):
        """Return a (n,) and lambda (m,) with more forces (n,)."""
        solved = np.linalg.solve(self.whole, [*(self.f + forces), *self.drift])
        return solved[: self.n], solved[self.n :]

    def tangent(self):
        """Return directions (f, n) that the constraints allow."""
        return np.linalg.svd(self.A)[2][self.m :] if self.m else np.eye(self.n)


def check(seed):
    """Return the number of states at which a mechanism was looked at."""
    maker, draws = Maker(seed), random.Random(seed)
    model = maker.model()
    lagrange, system, seen = Lagrange(model), system_for(model, FORMULATIONS[seed % len(FORMULATIONS)]), 0
    for _ in range(STATES):
        at = maker.state()
        try:
            x, v = system.project_initial_state(at.x, at.v, at.time, at.parameters, inputs=at.inputs)
        except (em.EvaluationError, em.ModelError):  # no point of the constraints is near, or none is known well enough
            continue
        with np.errstate(all="ignore"):  # expressions have no value everywhere
            oracle = Oracle(lagrange, at, x, v)
            condition = oracle.condition()
        if not condition < SAFE:
            continue
        own, _ = oracle.forward(np.zeros(model.n))
        weights = np.array([draws.uniform(-1, 1) for _ in range(model.n - oracle.m)])
        a = own + weights @ oracle.tangent() * (1 + np.abs(own).max())
        arguments = (x, v, a, at.time, at.parameters, at.inputs)
        judge(oracle, a, system.inverse_dynamics(*arguments), condition, seed)
        for chosen in actuators(oracle, draws):
            found = system.inverse_dynamics(*arguments, actuators=[system.coordinates[k] for k in chosen])
            forces = np.zeros(model.n)
            forces[list(chosen)] = found.forces
            judge(oracle, a, type(found)(forces, found.multipliers, found.residual), condition, seed)
        seen += 1
    return seen


def actuators(oracle, draws):
    """Yield one choice of as many coordinates as freedoms, and one of more, that drive all motions well."""
    free, count = oracle.tangent(), oracle.n - oracle.m
    for k in {count, min(count + 1, oracle.n)}:
        parts = {one: np.linalg.svd(free[:, list(one)], compute_uv=False) for one in combinations(range(oracle.n), k)}
        good = [one for one, sizes in parts.items() if sizes.min(initial=1.0) > 1e-3]
        if good:
            yield draws.choice(good)


def judge(oracle, a, found, condition, seed):
    """With the forces, the accelerations and multipliers result."""
    again, multipliers = oracle.forward(found.forces)
    size = np.abs(np.linalg.solve(oracle.M, np.abs(found.forces) + np.abs(oracle.f))) + np.abs(a)
    assert np.abs(again - a).max() <= LIMIT * condition * size.max(), seed
    if oracle.m:
        push = np.abs(oracle.A.T @ multipliers).max() + np.abs(found.forces).max() + np.abs(oracle.f).max()
        assert np.abs(oracle.A.T @ (found.multipliers - multipliers)).max() <= LIMIT * condition * push, seed
    assert not found.residual.any()


@pytest.mark.parametrize(
    "block", [0, *(pytest.param(block, marks=pytest.mark.nightly("random cases")) for block in range(1, 100))]
)
def test_forward_of_inverse_is_the_motion(block):
    seen = [check(seed) for seed in range(10 * block, 10 * block + 10)]
    assert sum(seen) >= 10
