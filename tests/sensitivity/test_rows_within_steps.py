"""Rows and the steps of the variational equations: results that no choice of rows changes, and few rejected steps."""

from functools import cache

import numpy as np
import pytest
from eigenmotion.models.double_pendulum import model as double_pendulum
from sympy import cos, exp, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.runtime.variations import Variations

from ..support.generation import system_for

x = dynamicsymbols("x")
W, END, MOST = np.sqrt(9.81), 10.0, 100.0


@cache
def hanging() -> em.System:
    return system_for(
        em.Model(name="hanging", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=-9.81 * cos(x)),
        "lagrange",
    )


def random_rows(seed: int) -> np.ndarray:
    """Return times of rows: evenly spaced, at random, in clusters, close to the start and to the end."""
    random = np.random.default_rng(seed)
    count = int(10 ** random.uniform(0.0, 2.5))
    rows = [
        np.linspace(0.0, END, count + 1),
        random.uniform(0.0, END, count),
        random.uniform(0.0, END, 3)[:, None] + 10.0 ** random.uniform(-12.0, -1.0, (1, 4)),
        [10.0 ** random.uniform(-12, -2), END - 10.0 ** random.uniform(-12, -2)],
    ]
    chosen = [np.ravel(one) for one in rows if random.random() < 0.5] or [np.ravel(rows[0])]
    return np.unique(np.clip(np.concatenate(chosen), 0.0, END))


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("rtol", [1e-5, 1e-8, 1e-11])
def test_rows_anywhere(rtol: float, seed: int):
    """A pendulum at rest: d theta(t) / d theta(0) = cos(w t), at rows and in the gradient of their weighted sum."""
    t = random_rows(seed)
    given = {"rtol": rtol, "atol": rtol, "t_eval": t, "method": ["dop853", "ra15", "radau9"][seed % 3]}
    run = hanging().simulate((0.0, END), sensitivities=["x"], **given)
    assert np.abs(run.sensitivity["x"].dx[0] - np.cos(W * t)).max() < MOST * rtol
    assert np.abs(run.sensitivity["x"].dv[0] + W * np.sin(W * t)).max() < MOST * rtol * W
    weight = np.random.default_rng(seed).standard_normal(len(t))
    _, pullback = em.vjp(hanging(), (0.0, END), by=["x"], **given)
    off = pullback(dx=weight[None])["x"] - weight @ np.cos(W * t)
    assert abs(off) < MOST * rtol * np.abs(weight).sum()


@pytest.mark.parametrize("count", [11, 31, 101, 301, 1001])
def test_few_steps_are_rejected(count: int, integrations: list[Variations]):
    """A step over a row, whose order is half of that at its end, would be rejected at every row."""
    system_for(double_pendulum, "eigenfactor").simulate(
        (0.0, 10.0), t_eval=np.linspace(0.0, 10.0, count), rtol=1e-9, method="dop853", sensitivities=["theta1", "l1"]
    )
    accepted, rejected, _ = integrations[0].counts
    assert accepted > 50
    assert rejected < 0.2 * accepted


@pytest.mark.parametrize("rtol", [1e-9, 1e-10])
def test_rows_close_to_the_end_cost_no_steps(rtol: float, integrations: list[Variations]):
    """The rounding of a step's errors is subtracted also where steps are as short as rows within them ask for."""
    p, tc = symbols("p tc")
    pushed = em.Model(
        name="pushed_late", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
        forces=[p * exp(-(((em.t - tc) / 0.1) ** 2))], parameters={p: 1.0, tc: 2.5}, initial={x: 0.3},
    )  # fmt: skip
    options = {"method": "dop853", "rtol": rtol, "atol": rtol, "sensitivities": ["x", "tc", "p"]}
    for rows in ([1.5], [1.5 - 1e-9, 1.5]):
        system_for(pushed, "lagrange").simulate((0.0, 1.5), t_eval=rows, **options)
    few, with_rows = (sum(one.counts[:2]) for one in integrations)
    assert with_rows <= 3 * few
