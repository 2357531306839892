"""Units of the eigenproblem: the motion does not depend on them."""

import dataclasses
from functools import cache

import numpy as np
import pytest
from sympy import Expr

from eigenmotion import Model, System

from ..support.generation import model_of, system_for
from ..support.models_table import BY_NAME

CHOICES = {
    "elastic_pendulum": ({"r": 0.02}, {"theta": 100.0, "r": 0.5}),
    "slider_crank": ({"x": 0.01}, {"theta": 3.0, "phi": 0.1, "x": 7.0}),
    "rolling_disk": ({"x": 0.05, "y": 0.05}, {"phi": 10.0, "psi": 0.1}),
    "veering": ({"x": 3.0}, {"z": 1.1}),
    "dual_link": ({"theta1": 2.0, "theta3": 0.25},),
}
CASES = [(name, choice) for name, choices in CHOICES.items() for choice in range(len(choices))]
SPAN = {"veering": 6.0, "dual_link": 4.0}
TIGHT = {"rtol": 1e-11, "atol": 1e-13}


def named(model: Model) -> dict[str, Expr]:
    return {str(x).removesuffix("(t)"): x for x in model.coordinates}


@cache
def scaled(name: str, choice: int = -1, formulation: str = "eigenfactor", **options: str) -> System:
    """The model with one of its CHOICES of units; -1: with the units 1."""
    model = model_of(name)
    given = CHOICES[name][choice] if choice >= 0 else {}
    assert set(given) <= set(named(model))
    units = tuple(float(given.get(x, 1.0)) for x in named(model))
    return system_for(_rescaled(model, units), formulation, **options)


def _rescaled(model: Model, units: tuple[float, ...]) -> Model:
    fields = {field.name: getattr(model, field.name) for field in dataclasses.fields(model)}
    return Model(**(fields | {"scales": dict(zip(model.coordinates, units, strict=True))}))


@pytest.mark.parametrize(("name", "choice"), CASES)
def test_accelerations_do_not_depend_on_them(name, choice):
    """By the right-hand side itself: d/dt (C^T S^-1 eta) at the same x, v, differentiated along the flow."""
    plain, other = scaled(name), scaled(name, choice)
    random = np.random.default_rng(2)
    for _ in range(10):
        x = plain.initial[0] + random.uniform(-0.2, 0.2, plain.n)
        x, v = plain.project_initial_state(x, random.normal(size=plain.n))
        expected = plain.acceleration(x, v)
        for found, right in zip(other.acceleration(x, v), expected, strict=True):
            np.testing.assert_allclose(found, right, rtol=1e-11, atol=1e-11)
        for system in (plain, other):
            np.testing.assert_allclose(_acceleration_of_state(system, x, v), expected[0], rtol=2e-6, atol=2e-6)


def _acceleration_of_state(system: System, x: np.ndarray, v: np.ndarray) -> np.ndarray:
    y, h = system.state(x, v), 1e-5
    dy = system.rhs(0.0, y)
    ahead, behind = (system.rhs(0.0, y + sign * h * dy)[: system.n] for sign in (1, -1))
    np.testing.assert_allclose(dy[: system.n], v, rtol=1e-12, atol=1e-13)
    return (ahead - behind) / (2 * h)


@pytest.mark.parametrize(("name", "choice"), CASES)
def test_the_motion_does_not_depend_on_them(name, choice):
    t_end = SPAN.get(name, 2.0)
    found = [system.simulate((0, t_end), t_eval=[0, t_end], **TIGHT) for system in (scaled(name), scaled(name, choice))]
    size = np.abs(found[0].x).max()
    np.testing.assert_allclose(found[1].x, found[0].x, atol=1e-9 * size)
    largest = np.abs(found[0].multipliers).max(initial=1.0)
    np.testing.assert_allclose(found[1].multipliers, found[0].multipliers, atol=1e-7 * largest)
    np.testing.assert_allclose(found[1].energy, found[0].energy, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("options", [{"close_eigenvalues": "extrapolate"}, {"schur": "eigenfactor"}])
def test_nor_does_it_with_other_options(options):
    found = [
        system.simulate((0, 1), t_eval=[0, 1.0], **TIGHT)
        for system in (scaled("slider_crank"), scaled("slider_crank", 1, **options))
    ]
    np.testing.assert_allclose(found[1].x, found[0].x, atol=1e-9)


@pytest.mark.parametrize("formulation", ["cholesky", "lagrange", "inverse"])
def test_formulations_without_eigenfactors_are_the_same_to_the_last_bit(formulation):
    found = [scaled("slider_crank", choice, formulation).simulate((0, 1)) for choice in (-1, 0)]
    np.testing.assert_array_equal(found[1].y, found[0].y)


def test_an_error_of_the_same_size_at_the_same_tolerance():
    """Errors are measured in x and v, so that units of the eigenproblem do not loosen or tighten a run."""
    right = BY_NAME["slider_crank"].reference()
    errors, costs = [], []
    for choice in (-1, 0, 1):
        found = scaled("slider_crank", choice).simulate((0, 2), rtol=1e-8, atol=1e-8)
        errors.append(np.abs(found.x[:, -1] - right.x).max())
        costs.append(found.nfev)
    assert max(errors) < 10 * min(errors)
    assert max(costs) < 2 * min(costs)


def test_C_and_s_are_those_of_the_scaled_problem():
    system = scaled("slider_crank", 1)
    unit = system.scales
    np.testing.assert_array_equal(unit, [3.0, 0.1, 7.0])
    found = system.simulate((0, 1), rtol=1e-9)
    for k in (0, found.t.size // 2, -1):
        M = system.mass_matrix(found.x[:, k]) * np.outer(unit, unit)
        np.testing.assert_allclose(found.C[..., k].T @ np.diag(found.s[:, k] ** 2) @ found.C[..., k], M, atol=1e-12)
        np.testing.assert_allclose(np.sort(found.s[:, k] ** 2), np.linalg.eigvalsh(M), rtol=1e-12)
        eta = found.s[:, k] * (found.C[..., k] @ (found.v[:, k] / unit))
        np.testing.assert_allclose(found.eta[:, k], eta, atol=1e-12)
    assert found.factor_residual.max() < 1e-14


def test_with_units_that_set_eigenvalues_apart_the_published_system_runs_throughout():
    """veering crosses in its own units; with very different ones the eigenvalues stay apart, and the motion is its."""
    crossing, apart = (scaled("veering", choice).simulate((0, 6), **TIGHT) for choice in (-1, 0))
    assert crossing.n_bounded > 0
    assert apart.n_bounded == 0
    np.testing.assert_allclose(apart.x[:, -1], crossing.x[:, -1], atol=1e-9)
