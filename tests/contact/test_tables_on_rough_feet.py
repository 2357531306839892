"""Tables on rough feet: loads are shared as long as they can be, and what slides first is what a convex program says.

Frictions are cones, rows that hold depend on each other, and forces are not unique; the motion is.
"""

from functools import cache

import numpy as np
import pytest
from scipy.optimize import linprog
from sympy import Matrix, Symbol, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, t

from ..support.generation import system_for

M, G, J, MU, H = 2.0, 9.81, 0.3, 0.5, 0.1
SIDES = 7200
TRIPOD = tuple((0.8 * np.cos(f), 0.8 * np.sin(f)) for f in (0.3, 0.3 + 2 * np.pi / 3, 0.3 + 4 * np.pi / 3))


@cache
def model_for(count: int) -> Model:
    """A rigid table; feet at (p_i, q_i), pushed along x by X t, along y by Y t, turned by T t."""
    x, y, z, a, b, c = coordinates = dynamicsymbols("x y z a b c")
    m, g, j, mu, h = symbols("m g J mu h", positive=True)
    X, Y, T = symbols("X Y T", real=True)
    R = turned(c, 2) * turned(b, 1) * turned(a, 0)
    rates = R.T * R.diff(t)
    omega = (rates[2, 1], rates[0, 2], rates[1, 0])
    contacts, parameters = {}, {m: M, g: G, j: J, mu: MU, h: H, X: 0.0, Y: 0.0, T: 0.0}
    for k in range(count):
        p, q = Symbol(f"p{k}", real=True), Symbol(f"q{k}", real=True)
        parameters |= {p: 0.0, q: 0.0}
        foot = Matrix([x, y, z]) + R * Matrix([p, q, -h])
        v = foot.diff(t)
        contacts |= {f"foot{k}": Contact(foot[2], 0, 1e-6), f"rub{k}": Friction((v[0], v[1]), mu, f"foot{k}")}
    return Model(
        name=f"table_{count}", coordinates=coordinates, potential_energy=m * g * z, contacts=contacts,
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2 + j * sum(w**2 for w in omega) / 2,
        forces={x: X * t, y: Y * t, c: T * t}, parameters=parameters,
    )  # fmt: skip


def turned(angle, axis):
    c, s = cos(angle), sin(angle)
    i, j = [k for k in range(3) if k != axis]
    R = Matrix.eye(3)
    sign = -1 if axis == 1 else 1
    R[i, i] = R[j, j] = c
    R[i, j], R[j, i] = -sign * s, sign * s
    return R


def run_of(feet, span, formulation="lagrange", **options):
    values = {f"p{k}": p for k, (p, _) in enumerate(feet)} | {f"q{k}": q for k, (_, q) in enumerate(feet)}
    parameters = values | options.pop("parameters")
    options = {"method": "radau9", "rtol": 1e-9, "atol": 1e-11} | options
    return system_for(model_for(len(feet)), formulation).simulate(
        (0.0, span), x0={"z": H}, parameters=parameters, **options
    )


def breaks_at(feet, X, Y, T):
    """Return the time at which no forces within their cones balance the load any longer: a linear program.

    Discs are polygons about them: the time is too late by less than 1 / SIDES^2 * 5.
    """
    n = len(feet)
    A, b, size = np.zeros((6, 3 * n + 1)), np.zeros(6), 3 * n + 1
    for k, (p, q) in enumerate(feet):
        A[:3, 3 * k : 3 * k + 3] = np.eye(3)
        A[3:, 3 * k : 3 * k + 3] = [[0, H, q], [-H, 0, -p], [-q, p, 0]]
    A[:, -1] = [X, Y, 0, 0, 0, T]
    b[2] = M * G
    angles = 2 * np.pi * np.arange(SIDES) / SIDES
    rows = np.zeros((n * SIDES, size))
    for k in range(n):
        rows[k * SIDES : (k + 1) * SIDES, 3 * k : 3 * k + 3] = np.column_stack(
            [np.cos(angles), np.sin(angles), -MU * np.ones(SIDES)]
        )
    done = linprog(-np.eye(size)[-1], A_ub=rows, b_ub=np.zeros(len(rows)), A_eq=A, b_eq=b, bounds=[(None, None)] * size)
    return float(done.x[-1])


def in_cones(run, column):
    """Return the least reserve of the feet, and the force all of them push with (2,)."""
    n = len(run.multipliers) // 3
    lifts = -run.multipliers[:n, column]
    slips = run.multipliers[n:, column].reshape(n, 2)
    return (MU * lifts - np.linalg.norm(slips, axis=1)).min(), slips.sum(axis=0)


@pytest.mark.parametrize("formulation", ["lagrange", "eigenfactor", "cholesky"])
@pytest.mark.parametrize("push", [1.0, -2.5])
def test_a_tripod_that_is_pushed_slides_as_a_block_does(formulation, push):
    begins = MU * M * G / abs(push)
    run = run_of(TRIPOD, begins + 1.0, formulation, parameters={"X": push})
    assert run.success
    assert [when for when, _ in run.modes] == pytest.approx([0.0, begins], rel=1e-9)
    assert run.x[0, -1] == pytest.approx(push / M / 6, rel=1e-7)
    assert np.abs(run.x[[1, 5], -1]).max() < 1e-9
    stuck = np.flatnonzero((run.t > 0) & (run.t < 0.999 * begins))
    for column in stuck:
        reserve, force = in_cones(run, column)
        assert reserve > -1e-9
        assert force == pytest.approx([push * run.t[column], 0.0], abs=1e-9)


@pytest.mark.parametrize("torque", [2.0, -1.0])
def test_a_tripod_that_is_turned_spins_about_its_middle(torque):
    begins = MU * M * G * 0.8 / abs(torque)
    run = run_of(TRIPOD, begins + 0.5, parameters={"T": torque})
    assert run.success
    assert [when for when, _ in run.modes] == pytest.approx([0.0, begins], rel=1e-9)
    assert run.x[5, -1] == pytest.approx(torque / J / 6 * 0.5**3, rel=1e-7)
    assert np.abs(run.x[:2, -1]).max() < 1e-8


@pytest.mark.parametrize("seed", range(8))
def test_tables_begin_to_slide_where_no_forces_hold_them_any_longer(seed):
    random = np.random.default_rng(seed)
    count = 2 + seed % 3
    around = np.sort(random.uniform(0.0, 2 * np.pi / count, count)) + 2 * np.pi * np.arange(count) / count
    feet = [(r * np.cos(f), r * np.sin(f)) for r, f in zip(random.uniform(0.5, 1.5, count), around, strict=True)]
    if count == 2:  # which stand under the middle, and are not pushed over
        feet[1] = (-0.7 * feet[0][0], -0.7 * feet[0][1])
    load = dict(zip("XYT", random.normal(size=3), strict=True)) if count > 2 else {"X": 0.0, "Y": 0.0, "T": 1.7}
    begins = breaks_at(feet, *load.values())
    run = run_of(feet, 1.05 * begins, parameters=load)
    changes = [when for when, mode in run.modes if any(v for name, v in mode.items() if name.endswith("slides"))]
    assert run.success, run.message
    assert changes[0] == pytest.approx(begins, rel=1e-6)
    for column in np.flatnonzero(run.t < 0.999 * begins):
        reserve, force = in_cones(run, column)
        assert reserve > -1e-9
        assert force == pytest.approx([load["X"] * run.t[column], load["Y"] * run.t[column]], abs=1e-8)


def test_what_shares_may_be_refused():
    run = run_of(TRIPOD, 1.0, parameters={"X": 1.0}, dependent_constraints="refuse")
    assert not run.success
    assert "depends on" in run.message


def test_tables_that_drop_stand():
    run = system_for(model_for(3), "lagrange").simulate(
        (0.0, 1.0), x0={"z": H + 0.2}, v0={"x": 0.3},
        parameters={f"{n}{k}": v for k, foot in enumerate(TRIPOD) for n, v in zip("pq", foot, strict=True)},
        method="radau9", rtol=1e-9, atol=1e-11,
    )  # fmt: skip
    falls = np.sqrt(2 * 0.2 / G)
    after = 0.3 - MU * G * falls  # friction takes as much as the blow presses: M v of the fall
    assert run.success
    assert run.t_events[0][0] == pytest.approx(falls, rel=1e-9)
    assert after < 0
    assert np.abs(run.v[:, -1]).max() < 1e-9
    assert run.x[0, -1] == pytest.approx(0.3 * falls, rel=1e-8)


def test_ensembles_share_as_runs_do():
    pushes = [1.0, 3.0, -2.0]
    values = {f"{n}{k}": v for k, foot in enumerate(TRIPOD) for n, v in zip("pq", foot, strict=True)}
    many = em.simulate_ensemble(
        system_for(model_for(3), "lagrange"), (0.0, 6.0), x0={"z": [H] * 3}, parameters=values | {"X": pushes},
        method="radau9", rtol=1e-9, atol=1e-11,
    )  # fmt: skip
    for k, push in enumerate(pushes):
        alone = run_of(TRIPOD, 6.0, parameters={"X": push})
        assert alone.success
        assert many.success[k]
        assert many.x[k, :, -1] == pytest.approx(alone.x[:, -1], rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("load", [(0.0, 0.0), (0.5, 0.1), (9.0, 0.0)], ids=["alone", "turned", "nearly slides"])
def test_a_table_that_sticks_has_no_derivatives_but_those_by_its_place(load):
    """Wherever it stands on the ground it stays, whatever its mass and friction: dx/dmu = dx/dm = 0, dx/dx0 = 1."""
    X, T = load
    run = run_of(TRIPOD, 0.9, parameters={"X": X, "T": T}, sensitivities=["mu", "m", "x"])
    assert run.success
    by_mu, by_m, by_x = (run.sensitivity[name].dx for name in ("mu", "m", "x"))
    assert max(np.abs(by_mu).max(), np.abs(by_m).max()) < 1e-13
    assert by_x[0] == pytest.approx(1, abs=1e-12)
    assert np.abs(by_x[1:]).max() < 1e-12
