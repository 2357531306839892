"""Mechanisms with more constraint rows than they need run as they are, as the same ones with as many as they need."""

from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest
import sympy
from sympy import Max, cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, System, t
from eigenmotion.results.output.summary import summary

from ..support.generation import FORMULATIONS, system_for

m, g, J, k, w = symbols("m g J k w", positive=True)
X, Y, P = dynamicsymbols("x y p")
TIGHT = {"rtol": 1e-10, "atol": 1e-12}
REFUSED = {"dependent_constraints": "refuse"}


@dataclass(frozen=True)
class Case:
    """A model, rows that are enough, and those whose forces are not unique."""

    model: Model
    enough: tuple[sympy.Expr, ...]
    shared: tuple[int, ...]

    def reduced(self) -> Model:
        return replace(self.model, name=f"{self.model.name}_reduced", holonomic_constraints=self.enough)


def lift() -> Case:
    """A cabin between two pairs of parallel guides, each of which holds it upright, on a spring."""
    model = Model(
        name="lift", coordinates=[X, Y, P], potential_energy=m * g * Y + k * (Y - X) ** 2 / 2,
        kinetic_energy=m * (X.diff() ** 2 + Y.diff() ** 2) / 2 + J * P.diff() ** 2 / 2,
        holonomic_constraints=[X + sin(P), X - sin(P), X + 2 * sin(P), X - 2 * sin(P)],
        parameters={m: 2.0, g: 9.81, J: 0.3, k: 40.0}, initial={Y: 0.3},
    )  # fmt: skip
    return Case(model, (X, P), (0, 1, 2, 3))


def beam() -> Case:
    """A beam on three supports that hold both ways, along which it slides on a spring."""
    supports = [Y - sin(P), Y, Y + sin(P)]
    model = Model(
        name="beam", coordinates=[X, Y, P], potential_energy=m * g * (Y + X * sin(P)) + k * X**2 / 2,
        kinetic_energy=m * (X.diff() ** 2 + Y.diff() ** 2) / 2 + J * P.diff() ** 2 / 2, holonomic_constraints=supports,
        parameters={m: 2.0, g: 9.81, J: 0.3, k: 40.0}, initial={X: 0.2, X.diff(): 1.0},
    )  # fmt: skip
    return Case(model, (Y, P), (0, 1, 2))


def parallel_branches() -> Case:
    """Two Cardan joints side by side between the same two shafts: tan(out) = tan(in) / cos(b), stated for each."""
    one, two = dynamicsymbols("one two")
    bend = sqrt(3) / 2
    row = sin(two) * cos(one) * bend - sin(one) * cos(two)
    branch = dynamicsymbols("branch")
    model = Model(
        name="branches", coordinates=[one, two, branch], potential_energy=k * (1 - cos(two)) + k * one,
        kinetic_energy=J * one.diff() ** 2 / 2 + J * two.diff() ** 2 + J * branch.diff() ** 2 / 3,
        holonomic_constraints=[row, branch - two, sin(branch) * cos(one) * bend - sin(one) * cos(branch)],
        parameters={J: 0.3, k: 0.4}, initial={one.diff(): 2.0, two.diff(): 4 / sqrt(3), branch.diff(): 4 / sqrt(3)},
    )  # fmt: skip
    return Case(model, (row, branch - two), (0, 1, 2))


def spatial_four_bar() -> Case:
    """A parallel crank and rocker in space: by their coupler as a vector, its length besides, and its height."""
    a, b, z = dynamicsymbols("a b z")
    ends = [1.5 + cos(b) - cos(a), sin(b) - sin(a)]
    rows = [ends[0] - 1.5, ends[1], ends[0] ** 2 + ends[1] ** 2 + z**2 - 2.25, z]
    model = Model(
        name="spatial_four_bar", coordinates=[a, b, z], potential_energy=m * g * (sin(a) + sin(b) + z),
        kinetic_energy=m * (a.diff() ** 2 + 2 * b.diff() ** 2 + z.diff() ** 2) / 2, holonomic_constraints=rows,
        parameters={m: 2.0, g: 9.81}, initial={a: 0.7, b: 0.7, a.diff(): 1.0, b.diff(): 1.0},
    )  # fmt: skip
    return Case(model, (b - a, z), (0, 1, 2))


CASES = {made.__name__: made for made in (lift, beam, parallel_branches, spatial_four_bar)}
ALL = pytest.mark.parametrize("name", list(CASES))


@cache
def case(name: str) -> Case:
    return CASES[name]()


def systems(name: str, formulation: str = "lagrange") -> tuple[System, System]:
    return system_for(case(name).model, formulation), system_for(case(name).reduced(), formulation)


@ALL
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_they_move_as_with_the_rows_they_need(name, formulation):
    whole, reduced = systems(name, formulation)
    for method in ("dop853", "radau9"):
        found, right = (s.simulate((0, 2), t_eval=[1.0, 2.0], method=method, **TIGHT) for s in (whole, reduced))
        assert found.success, found.message
        np.testing.assert_allclose(found.x, right.x, atol=1e-8)
        np.testing.assert_allclose(found.v, right.v, atol=1e-7)
        assert found.nsteps < 1.2 * right.nsteps + 3


@ALL
def test_the_result_says_which_forces_are_not_unique(name):
    whole, reduced = systems(name)
    found = whole.simulate((0, 0.5))
    assert set(found.not_unique) <= set(case(name).shared)
    assert len(found.not_unique) > 1
    assert f"{', '.join(f'row {k}' for k in found.not_unique)} are not unique" in found.message
    assert "not unique" in summary(whole, found, 0.1)
    right = reduced.simulate((0, 0.5))
    assert right.not_unique == ()
    assert "not unique" not in summary(reduced, right, 0.1)
    for row, (force, same) in enumerate(zip(pushes(found, whole), pushes(right, reduced), strict=True)):
        np.testing.assert_allclose(force, same, atol=1e-4, err_msg=str(row))


def pushes(found, system) -> list[np.ndarray]:
    """A^T lambda at the ends of the run."""
    return [system.pfaffian(found.x[:, at], found.t[at])[0].T @ found.multipliers[:, at] for at in (0, -1)]


@ALL
def test_who_wants_refuses_them_by_name(name):
    whole, _ = systems(name)
    found = whole.simulate((0, 1), **REFUSED)
    assert found.stop is em.StopReason.DEPENDENT_CONSTRAINTS
    assert found.t.size == 1
    with pytest.raises(em.ModelError, match="auto, refuse, least_norm"):
        whole.simulate((0, 1), dependent_constraints="allow")


@ALL
def test_ensembles_steppers_and_starts_run_them_too(name):
    whole, reduced = systems(name)
    right = reduced.simulate((0, 1), t_eval=[1.0], **TIGHT)
    runs = em.simulate_ensemble(whole, (0, 1), parameters={"m": [2.0, 2.0]} if "m" in whole.parameters else None,
                                **TIGHT)  # fmt: skip
    assert runs.success.all()
    np.testing.assert_allclose(runs.x[-1, :, -1], right.x[:, -1], atol=1e-9)
    assert runs[0].not_unique == whole.simulate((0, 1), **TIGHT).not_unique
    stepper = whole.stepper(**TIGHT)
    stepper.advance(0.5)
    saved = stepper.save()
    stepper.advance(1.0)
    np.testing.assert_allclose(stepper.x, right.x[:, -1], atol=1e-9)
    assert stepper.not_unique == runs[0].not_unique
    stepper.restore(saved)
    stepper.advance(1.0)
    np.testing.assert_allclose(stepper.x, right.x[:, -1], atol=1e-9)
    x, v = whole.project_initial_state(right.x[:, -1] + 1e-3, right.v[:, -1])
    near = reduced.project_initial_state(right.x[:, -1] + 1e-3, right.v[:, -1])
    np.testing.assert_allclose(x, near.x, atol=1e-9)
    np.testing.assert_allclose(v, near.v, atol=1e-8)
    np.testing.assert_allclose(whole.acceleration(x, v)[0], reduced.acceleration(x, v)[0], atol=1e-7)


@ALL
def test_their_linear_motion_is_that_of_the_rows_they_need(name):
    whole, reduced = systems(name)
    right = reduced.simulate((0, 1), t_eval=[1.0], **TIGHT)
    x, v = right.x[:, -1], right.v[:, -1]
    one, two = (np.sort_complex(s.linearize(x, v).eigenvalues()) for s in (whole, reduced))
    np.testing.assert_allclose(one, two, atol=1e-6)


@pytest.mark.parametrize(("name", "by"), [
    ("lift", ["k", "m", "g", "y", "y'"]), ("beam", ["k", "m", "x", "x'"]), ("parallel_branches", ["k", "J"]),
    ("spatial_four_bar", ["m", "g", "a"]),
])  # fmt: skip
def test_their_sensitivities_are_those_of_the_rows_they_need(name, by):
    """Also of coordinates that do not move, and by a common factor of all forces: of these rounding alone is left."""
    runs = [s.simulate((0, 1), sensitivities=by, t_eval=[1.0], **TIGHT) for s in systems(name)]
    for one in by:
        found, right = (run.sensitivity[one] for run in runs)
        np.testing.assert_allclose(found.dx, right.dx, atol=1e-8)
        np.testing.assert_allclose(found.dv, right.dv, atol=1e-7)


@pytest.mark.parametrize("which", [0, 1])
def test_they_change_as_springs_say(which):
    """The cabin on its spring: y = c + (y_0 - c) cos(w t), c = -m g / k, w = sqrt(k / m)."""
    run = systems("lift")[which].simulate((0, 1), sensitivities=["y", "g", "k"], **TIGHT)
    M, G, K, at = 2.0, 9.81, 40.0, run.t
    w, c = np.sqrt(K / M), -M * G / K
    by_y, by_g, by_k = (run.sensitivity[name].dx for name in ("y", "g", "k"))
    np.testing.assert_allclose(by_y[1], np.cos(w * at), atol=1e-8)
    np.testing.assert_allclose(by_g[1], -M / K * (1 - np.cos(w * at)), atol=1e-8)
    slope = -c / K * (1 - np.cos(w * at)) - (0.3 - c) * at * w / (2 * K) * np.sin(w * at)
    np.testing.assert_allclose(by_k[1], slope, atol=1e-8)
    for one in (by_y, by_g, by_k):
        np.testing.assert_allclose(one[[0, 2]], 0.0, atol=1e-12)


def test_rows_that_come_to_depend_on_each_other_are_named_by_default():
    """Redundant from the start, and then a row that turns into another's: rank 2 of 3, and from t = 1 on 1."""
    z = dynamicsymbols("z")
    model = Model(
        name="turning_row", coordinates=[X, Y, z], kinetic_energy=(X.diff() ** 2 + Y.diff() ** 2 + z.diff() ** 2) / 2,
        nonholonomic_constraints=[X.diff(), 2 * X.diff(), X.diff() + Max(0, 1 - t) * Y.diff()], initial={z.diff(): 1.0},
    )  # fmt: skip
    found = system_for(model, "lagrange").simulate((0, 2), max_step=0.25)
    assert found.stop is em.StopReason.DEPENDENT_CONSTRAINTS
    assert found.t[-1] == pytest.approx(1.0, abs=0.3)


def test_a_singular_position_at_the_start_is_no_redundancy():
    """A cone's tip, and a row that is met where it vanishes: nothing says which way these go."""
    for row, start in ((X**2 + Y**2 - P**2, [0.0, 0.0, 0.0]), (X**2 * (1 + Y), [0.0, 0.3, 0.0])):
        energy = (X.diff() ** 2 + Y.diff() ** 2 + P.diff() ** 2) / 2
        system = system_for(Model(name="tip", coordinates=[X, Y, P], kinetic_energy=energy, potential_energy=g * Y,
                                  holonomic_constraints=[row], parameters={g: 9.81}), "lagrange")  # fmt: skip
        found = system.simulate((0, 1), x0=start)
        assert found.stop is em.StopReason.DEPENDENT_CONSTRAINTS
