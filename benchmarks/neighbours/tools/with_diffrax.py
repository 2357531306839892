"""Runs the equations in diffrax: the second run, after it is compiled."""

from collections.abc import Iterator
from time import perf_counter

import diffrax as dx
import jax
import jax.numpy as jnp
import numpy as np
from four_bar import SPAN, Trial, start, system

TOLERANCE = 1e-9


def trials() -> Iterator[Trial]:
    """Integrate the equations in JAX's arrays by Dopri8; the second run, after it is compiled."""
    jax.config.update("jax_enable_x64", True)

    def rates(_t: object, y: object, _args: object) -> object:
        matrix, right = system(y[:3], y[3:], jnp)
        return jnp.concatenate([y[3:], jnp.linalg.solve(jnp.array(matrix), jnp.array(right))[:3]])

    @jax.jit
    def run(y: object) -> object:
        control = dx.PIDController(rtol=TOLERANCE, atol=TOLERANCE)
        term, save = dx.ODETerm(rates), dx.SaveAt(t1=True)
        return dx.diffeqsolve(
            term, dx.Dopri8(), 0.0, SPAN, 0.01, y, saveat=save, stepsize_controller=control, max_steps=100_000
        ).ys[0]

    run(np.concatenate(start())).block_until_ready()
    before = perf_counter()
    end = np.array(run(np.concatenate(start())))
    yield Trial(f"Dopri8, {TOLERANCE:g}", end[:3], end[3:], perf_counter() - before)
