"""Lyapunov exponents against closed forms, traces and published values."""

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, ModelError

from ..support.generation import system_for, system_of
from .test_find_cycle import duffing

x, y, z = dynamicsymbols("x y z")
a, b, c = symbols("a b c")


def test_linear_motions():
    """The exponents are the real parts of the eigenvalues: a saddle, and a state that decays."""
    saddle = Model(name="saddle", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=-(x**2),
                   forces=[-x.diff()], states={z: -5 * z + x}, initial={x: 1e-30})  # fmt: skip
    found = em.lyapunov(system_for(saddle, "lagrange"), 20.0, transient=10.0)
    assert found.exponents == pytest.approx([1.0, -2.0, -5.0], abs=1e-7)
    assert (found.spread < 1e-7).all()


def test_a_constraint_takes_two_exponents():
    """An overturned pendulum in Cartesian coordinates: plus and minus sqrt(g / l)."""
    overturned = Model(name="overturned", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                       potential_energy=9 * y, holonomic_constraints=[x**2 + y**2 - 1],
                       initial={x: 0, y: 1})  # fmt: skip
    found = em.lyapunov(system_for(overturned, "lagrange"), 10.0, transient=5.0)
    assert found.exponents == pytest.approx([3.0, -3.0], abs=1e-7)


def test_an_impact_that_conserves_volume():
    """A ball in a gravity field that bounces without loss: exponents are 0, and volume is conserved."""
    gap = y
    ball = Model(name="ball", coordinates=[y], kinetic_energy=y.diff() ** 2 / 2, potential_energy=y,
                 initial={y: 1.0}, events={"floor": em.Event(gap, direction=-1, impact=(gap, 1.0))})  # fmt: skip
    found = em.lyapunov(system_for(ball, "lagrange"), 2000.0, pieces=100)
    assert sum(found.exponents) == pytest.approx(0.0, abs=1e-10)
    assert np.abs(found.exponents).max() < 0.01


def test_the_multipliers_of_a_cycle_are_exponents():
    """A rimless wheel: ln(cos(2 alpha)^2) / T, and 0 along the motion."""
    system = system_of("rimless_wheel", "lagrange")
    cycle = em.find_cycle(system, x0={"theta": -0.3}, v0={"theta": 1.2}, section="step")
    found = em.lyapunov(system, 100 * cycle.period, x0=cycle.x0, v0=cycle.v0, pieces=90)
    assert found.exponents == pytest.approx([0.0, np.log(0.5) / cycle.period], abs=1e-3)


def test_the_sum_is_that_of_the_damping():
    found = em.lyapunov(duffing(), 300.0, x0={"x": 1.0}, parameters={"alpha": -1.0, "A": 0.3, "w": 1.2})
    assert sum(found.exponents) == pytest.approx(-0.2, abs=1e-9)
    assert np.sum(found.local, axis=1) == pytest.approx(-0.2, abs=1e-7)


def test_a_chaotic_pendulum():
    """x'' + 0.1 x' + sin x = 2.5 cos t: 0.160 and -0.262 are published, arXiv physics/0303077."""
    driven = Model(name="driven", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=-cos(x),
                   forces=[-b * x.diff() + a * sin(em.t)], parameters={a: 2.5, b: 0.1})  # fmt: skip
    found = em.lyapunov(system_for(driven, "lagrange"), 4000.0, x0={"x": 0.1}, rtol=1e-7)
    assert sum(found.exponents) == pytest.approx(-0.1, abs=1e-6)
    assert abs(found.exponents[0] - 0.160) < 4 * found.spread[0]
    assert found.spread[0] < 0.02
    assert found.dimension == pytest.approx(1 + found.exponents[0] / -found.exponents[1])


def test_friction_that_sticks_forgets():
    rub = Model(name="belt", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                forces=[a * x.diff()], contacts={"belt": em.Friction(x.diff() - b, limit=c)},
                parameters={c: 1.0, b: 0.5, a: 0.1})  # fmt: skip
    found = em.lyapunov(system_for(rub, "lagrange"), 200.0, x0={"x": 0.0}, v0={"x": 0.2}, pieces=20)
    assert abs(found.exponents[0]) < 0.02
    assert found.exponents[1] == -np.inf


@pytest.mark.parametrize("given", [{"t_end": 0.0}, {"t_end": 1.0, "transient": 2.0}, {"t_end": 1.0, "pieces": 3}])
def test_wrong_arguments(given):
    with pytest.raises(ModelError, match="leave no run"):
        em.lyapunov(duffing(), **given)
