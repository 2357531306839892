"""Consistent starts: em_start_check.h refuses those that NumPy finds to be off, and Python says so."""

from typing import Any

import numpy as np
import pytest
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.codegen.model import ModelError
from sympy import log, sin, sqrt

from eigenmotion.simulation.initial_state.consistency import start_state

from ..support.failing_runs import X, Y, plane
from ..support.generation import system_for, system_of
from ..support.hand_written import bead

pytestmark = pytest.mark.filterwarnings("ignore:.*:RuntimeWarning")

RTOL, ATOL = 1e-6, 1e-9  # residuals of 1e-5 of their terms pass, and what changes of 1e-8 make
CONSTRAINED = ("four_bar", "slider_crank", "dual_link", "rolling_disk", "driven_pendulum")


def consistent(name: str, formulation: str = "inverse"):
    system = system_of(name, formulation)
    prepared = system.prepare()
    x, v = system.project_initial_state(*system.start(), dependent_constraints="least_norm")
    return system.compiled, prepared, 0.0, x, v


def wrong(model: Any, prepared: Any, t: float, x: np.ndarray, v: np.ndarray) -> tuple[str, list[int], float]:
    """What a start is off by more than it may, in NumPy; which rows; how near the closest row is to its limit."""
    A, b = model.pfaffian(t, x, prepared)
    M, (phi, terms) = model.factored_matrix(t, x, prepared), model.position(t, x, prepared)
    lengths = np.sqrt(np.einsum("ri,ir->r", A, np.linalg.solve(M, A.T)))
    moved, least = np.abs(A) @ np.full(model.n, 10 * ATOL), 8 * np.finfo(float).eps
    allowed = [10 * RTOL * size + (moved + least * np.sqrt(q @ M @ q) * lengths)[: len(size)]
               for q, size in ((x, terms), (v, np.abs(A) @ np.abs(v) + np.abs(b)))]  # fmt: skip
    near = min(
        abs(np.log(np.abs(r) / limit)).min(initial=9.0) for r, limit in zip((phi, A @ v + b), allowed, strict=True)
    )
    for what, residual, limit in zip(("x0 is off", "v0 does not satisfy"), (phi, A @ v + b), allowed, strict=True):
        if rows := np.flatnonzero(~(np.abs(residual) <= limit)).tolist():
            return what, rows, near
    return "", [], near


@pytest.mark.parametrize("name", CONSTRAINED)
def test_starts_are_refused_that_are_off_their_constraints(name):
    """Starts moved by 1e-16 to 1 in random directions, on both sides of the tolerance."""
    model, prepared, t, x0, v0 = consistent(name)
    random, refused, atol = np.random.default_rng(1), 0, np.full(model.n, ATOL)
    for size in 10.0 ** random.uniform(-16, 0, 400):
        dx, dv = random.choice((0.0, size)) * random.normal(size=model.n), size * random.normal(size=model.n)
        at = (model, prepared, t, x0 + dx, v0 + dv)
        with np.errstate(divide="ignore"):
            words, rows, near = wrong(*at)
        if near < 1e-6:
            continue
        refusal, y, _, off = model.start(t, x0 + dx, v0 + dv, prepared, RTOL, atol)
        refused += words != ""
        assert bool(refusal) == (words != ""), (size, words)
        if refusal:
            assert np.flatnonzero(off).tolist() == rows
            with pytest.raises(ModelError, match=words):
                start_state(*at, RTOL, atol)
        else:
            np.testing.assert_array_equal(y, model.state(t, x0 + dx, v0 + dv, prepared))
    assert 50 < refused < 350


PLANTED = {  # what is wrong at the start given, and what is said of it
    "infinite_mass": (
        plane("infinite_mass", kinetic_energy=X.diff() ** 2 / X + Y.diff() ** 2),
        {"x0": {"x": 0.0}},
        "mass matrix at x0 is not finite in row 'x', column 'x'",
    ),
    "undefined_mass": (
        plane("undefined_mass", kinetic_energy=X.diff() ** 2 + sqrt(1 + X) * Y.diff() ** 2),
        {"x0": {"x": -2.0}},
        "mass matrix at x0 is not finite in row 'y', column 'y'",
    ),
    "indefinite_mass": (
        plane("indefinite_mass", kinetic_energy=X.diff() ** 2 + Y.diff() ** 2 + 4 * sin(X) * X.diff() * Y.diff()),
        {"x0": {"x": 1.0}},
        "not positive definite at coordinate 'y'",
    ),
    "undefined_position": (
        plane("undefined_position", holonomic_constraints=[log(X) - Y], initial={X: 1.0}),
        {"x0": {"x": -1.0}},
        "holonomic constraint row 0 is not finite at x0. Look in it for",
    ),
    "undefined_row": (
        plane("undefined_row", nonholonomic_constraints=[log(X) * X.diff() - Y.diff()], initial={X: 1.0}),
        {"x0": {"x": -1.0}},
        "A v + b of constraint row 0 is not finite at x0, v0. Look in it for",
    ),
}


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("kind", list(PLANTED))
def test_what_is_not_finite_or_not_definite_is_named(kind, formulation):
    model, start, words = PLANTED[kind]
    with pytest.raises(ModelError) as caught:
        system_for(model, formulation).simulate((0, 1), **start)
    assert words in str(caught.value)


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky"])
def test_a_state_that_overflows_is_refused(formulation):
    heavy = plane("heavy", kinetic_energy=10**6 * (X.diff() ** 2 + Y.diff() ** 2))
    with pytest.raises(ModelError, match="the state at x0, v0 is not finite"):
        system_for(heavy, formulation).simulate((0, 1), v0=[1e308, 0])


@pytest.mark.parametrize(("x", "v"), [([1.0], [0.0, 0.0]), ([1.5, 0.0], [0.0]), (1.5, [0.0, 0.0])])
def test_starts_of_a_wrong_shape_are_refused(x, v):
    with pytest.raises(ValueError, match="shape"):
        bead().compiled.start(0.0, x, v, bead().prepare(), 1e-5, np.zeros(2))


def test_rows_of_a_wrong_shape_are_refused():
    compiled, prepared, t = bead().compiled, bead().prepare(), np.zeros(3)
    for x, v in (((2, 2), (3, 2)), ((3, 2), (3, 1)), ((3,), (3, 2))):
        with pytest.raises(ValueError, match="shape"):
            compiled.energy_rows(t, np.ones(x), np.ones(v), prepared)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_run_of_no_length_gives_the_first_row_of_any_run(formulation):
    system = system_of("four_bar", formulation)
    near = system.initial[0] + 1e-7
    assert abs(system.compiled.position(0.5, near, system.prepare())[0]).max() > 1e-8
    first, found = (system.simulate((0.5, end), x0=near) for end in (0.6, 0.5))
    np.testing.assert_array_equal(found.y, first.y[:, :1])
    assert (found.t.tolist(), found.nfev) == ([0.5], 0)
    assert abs(found.position_residual).max() < 1e-14


def test_a_projected_velocity_is_consistent_to_its_own_rounding():
    """v0 is a million times the velocity that is left of it: the rounding of v0 is no rounding of that."""
    row = X.diff() / 3 + sqrt(2) * Y.diff() / 7
    model = plane("inclined", kinetic_energy=X.diff() ** 2 + 3 * Y.diff() ** 2, nonholonomic_constraints=[row])
    system = system_for(model, "inverse")
    A, _ = system.pfaffian([0.0, 0.0])
    normal = np.linalg.solve(system.mass_matrix([0.0, 0.0]), A[0])
    for seed in range(50):
        v0 = normal + 1e-7 * np.random.default_rng(seed).normal(size=2)
        found = system.project_initial_state([0.0, 0.0], v0)
        assert abs(A[0] @ found.v) <= 4 * np.finfo(float).eps * np.abs(A[0]) @ np.abs(found.v)
        system.linearize(found.x, found.v)
