"""Coordinates that come to rest: subnormal numbers count as zero in runs, and only there."""

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

TINY = np.finfo(float).tiny


@pytest.fixture(scope="module")
def system():
    """A mass on a spring, and one that a damper stops within hundredths of a second."""
    x, y = dynamicsymbols("x y")
    m, k, d = symbols("m k d", positive=True)
    return em.build(em.Model(
        name="stopped", coordinates=[x, y], kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=k * (x**2 + y**2) / 2, forces={y: -d * y.diff()},
        parameters={m: 1.0, k: 1e4, d: 200.0}, initial={x: 1.0, y: 1.0, x.diff(): 0.0, y.diff(): 0.0},
    ))  # fmt: skip


def has_subnormal(numbers):
    return bool(((numbers != 0) & (np.abs(numbers) < TINY)).any())


def is_gradual():
    """Whether this thread has subnormal numbers. The numbers are of an array: constants would be folded."""
    return bool((np.full(3, TINY) * np.full(3, 0.5) > 0).all())


@pytest.mark.parametrize("method", ["dop853", "rk34", "ra15", "radau9"])
def test_what_comes_to_rest_is_at_zero(system, method):
    """The damper is critical: y = (1 + 100 t) exp(-100 t), which is below 2e-308 from 7.2 s on."""
    run = system.simulate((0, 9), method=method, rtol=1e-6, max_steps=10**6)
    assert run.success
    assert not has_subnormal(run.x)
    assert not has_subnormal(run.v)
    assert is_gradual()


def test_ensembles_and_steppers_leave_the_thread_as_it_was(system):
    runs = em.simulate_ensemble(system, (0, 8), x0={"x": np.linspace(0.5, 1, 8)}, t_eval=[0, 8], workers=1)
    assert not has_subnormal(runs.x)
    stepper = system.stepper()
    stepper.advance(8.0)
    assert not has_subnormal(stepper.x)
    assert is_gradual()


def test_a_run_from_subnormal_numbers_is_that_from_zero(system):
    runs = [system.simulate((0, 1), x0=[1.0, rest], v0=[0.0, rest], rtol=1e-9) for rest in (0.0, 1e-320)]
    assert runs[0].nfev == runs[1].nfev
    assert np.array_equal(runs[0].x[0], runs[1].x[0])
