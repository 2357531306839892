"""Directions that are zero, in any unit of time, directions that are nothing but rounding, and units of coordinates."""

from functools import cache

import numpy as np
import pytest
from eigenmotion.models.polar_particle import model as polar_particle
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.runtime.variations import Variations

from ..methods.test_no_absolute_tolerance import beside
from ..support.generation import system_for


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("unit", [1e-6, 1e-3, 1.0, 1e3, 1e9])
def test_a_direction_with_zeros_is_as_accurate_in_any_unit_of_time(unit: float, method: str):
    """At rest: d x(t) / d x(0) = cos(w t) and d y(t) / d x(0) = 0, whose size relative to its own is not a number."""
    end, w = 20.0 * unit, 1.0 / unit
    t = np.linspace(0.0, end, 7)
    given = {"parameters": {"w": w}, "t_eval": t, "rtol": 1e-9, "atol": 1e-9, "x0": {"x": 0.0}, "method": method}
    run = system_for(beside, "lagrange").simulate((0.0, end), sensitivities=["x"], **given)
    assert run.sensitivity["x"].dx == pytest.approx(np.array([np.cos(w * t), 0.0 * t]), abs=1e-7)
    assert run.sensitivity["x"].dv * unit == pytest.approx(np.array([-np.sin(w * t), 0.0 * t]), abs=1e-7)
    _, pullback = em.vjp(system_for(beside, "lagrange"), (0.0, end), by=["x"], **given)
    weight = np.random.default_rng(0).standard_normal((2, 7))
    assert pullback(dx=weight)["x"] == pytest.approx(weight[0] @ np.cos(w * t), abs=1e-7 * np.abs(weight).sum())


@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
@pytest.mark.parametrize("rtol", [1e-6, 1e-9, 1e-11])
def test_a_parameter_that_cancels_takes_few_steps(rtol: float, formulation: str, integrations: list[Variations]):
    """The mass of a planet cancels, but for rounding, which no shorter step resolves."""
    system = system_for(polar_particle, formulation)
    run = system.simulate((0.0, 5.0), rtol=rtol, atol=rtol, sensitivities=["m", "mu"])
    accepted, rejected, _ = integrations[0].counts
    assert accepted + rejected <= 70
    assert np.abs(run.sensitivity["m"].dx).max() < 1e-12
    solution, pullback = em.vjp(system, (0.0, 5.0), rtol=rtol, atol=rtol, by=["m"])
    assert abs(pullback(dx=np.ones_like(solution.x))["m"]) < 1e-12
    assert sum(integrations[-1].counts[:2]) <= 70


@cache
def chain_in_units() -> em.System:
    """Return three masses between springs; coordinate k in a unit of its own, s_k."""
    q, s = dynamicsymbols("q1:4"), symbols("s1:4", positive=True)
    x = [a * b for a, b in zip(s, q, strict=True)]
    stretch = [x[0], x[1] - x[0], x[2] - x[1]]
    return em.build(
        em.Model(
            name="chain_in_units", coordinates=q, kinetic_energy=sum(one.diff(em.t) ** 2 for one in x) / 2,
            potential_energy=sum(k * one**2 for k, one in zip((1, 2, 3), stretch, strict=True)) / 2,
            parameters=dict.fromkeys(s, 1.0),
        ), formulation="lagrange",
    )  # fmt: skip


@pytest.mark.parametrize("s", [(1.0, 1.0, 1.0), (1e3, 1e-8, 1e-2), (1e-8, 1e8, 1e-8), (1e12, 1.0, 1e-12)])
@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_units_of_coordinates_take_no_steps(method: str, s: tuple[float, ...], integrations: list[Variations]):
    """Pivots are compared in balanced units: else small numbers have the rounding of large ones, and steps crawl."""
    K = np.array([[3.0, -2.0, 0.0], [-2.0, 5.0, -3.0], [0.0, -3.0, 3.0]])
    w2, modes = np.linalg.eigh(K)
    right = modes @ np.diag(np.cos(np.sqrt(w2) * 10.0)) @ modes.T
    unit, names = np.array(s), ["q1", "q2", "q3"]
    given = {
        "parameters": dict(zip(["s1", "s2", "s3"], s, strict=True)), "x0": dict(zip(names, 1.0 / unit, strict=True)),
        "atol": dict(zip(names, 1e-9 / unit, strict=True)), "rtol": 1e-9, "method": method,
    }  # fmt: skip
    for k, name in enumerate(names):
        run = chain_in_units().simulate((0.0, 10.0), sensitivities=[name], **given)
        found = run.sensitivity[name].dx[:, -1] * unit / unit[k]
        assert found == pytest.approx(right[:, k], abs=1e-7)
        assert sum(integrations[-1].counts[:2]) < 60
    _, pullback = em.vjp(chain_in_units(), (0.0, 10.0), by=names, t_eval=[10.0], **given)
    found = pullback(dx=np.array([[0.0], [unit[1]], [0.0]]))
    assert [found[name] / one for name, one in zip(names, unit, strict=True)] == pytest.approx(right[1], abs=1e-7)


x = dynamicsymbols("x")
k, mu = symbols("k mu", positive=True)
STUCK = em.Model(
    name="rubbed_at_the_start", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=k * x**2 / 2,
    forces=[cos(em.t)], contacts={"rub": em.Friction(x.diff(), limit=mu)}, parameters={k: 1.0, mu: 0.5},
)  # fmt: skip


@pytest.mark.parametrize("v", [0.0, 1e-20, -1e-20, 1e-15, -1e-15])
@pytest.mark.parametrize(("t", "at", "sticks"), [(1.5, 0.1, True), (2.5, 0.2, False), (0.1, -0.3, False)])
def test_a_start_that_rounding_moves_is_a_start_at_rest(v, t, at, sticks):
    """Whether a friction sticks at first is the run's decision: a velocity of rounding is none (closed form)."""
    system = system_for(STUCK, "lagrange")
    given = {"x0": {"x": at}, "v0": {"x": v}, "rtol": 1e-11, "t_eval": [t + 0.05]}
    found = system.simulate((t, t + 0.05), sensitivities=["x", "x'", "mu"], **given).sensitivity
    _, pullback = em.vjp(system, (t, t + 0.05), by=["x", "x'", "mu"], **given)
    side = -np.sign(np.cos(t) - at)
    slides = {"x": np.cos(0.05), "x'": np.sin(0.05), "mu": side * (1.0 - np.cos(0.05))}
    expected = {"x": 1.0, "x'": 0.0, "mu": 0.0} if sticks else slides
    assert {name: one.dx[0, 0] for name, one in found.items()} == pytest.approx(expected, rel=1e-8, abs=1e-14)
    assert pullback(dx=np.ones((1, 1))) == pytest.approx(expected, rel=1e-8, abs=1e-14)
