"""Derivatives of motions through events that act: against closed forms, and differences of what events do."""

from functools import cache

import mpmath
import numpy as np
import pytest
from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, ModelError, System
from eigenmotion.runtime.variations import act_along, constraint_partials

from ..support.generation import system_for, system_of
from .differences import differences

TIGHT = {"rtol": 1e-11, "atol": 1e-13}
x, z = dynamicsymbols("x z")
g, e = symbols("g e", positive=True)


@cache
def ball() -> System:
    """A unit mass above z = 0."""
    events = {"floor": Event(z, direction=-1, impact=(z, e)), "top": Event(z.diff(), direction=-1)}
    return system_for(
        Model(name="dropped", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
              parameters={g: 9.81, e: 0.9}, events=events, initial={z: 1.0}), "lagrange")  # fmt: skip


def bounced(t, h, g, e, count):
    """Height, velocity at t and the time of the last of `count` bounces of a ball let go at h."""
    speed = mpmath.sqrt(2 * g * h)
    at = speed / g + sum(2 * speed * e**k / g for k in range(1, count))
    up = speed * e**count
    return up * (t - at) - g * (t - at) ** 2 / 2, up - g * (t - at), at


@pytest.mark.parametrize("method", ["dop853", "ra15"])
def test_five_bounces(method):
    end, count, names = 3.6, 5, ["z", "g", "e"]
    run = ball().simulate((0.0, end), method=method, sensitivities=names, t_eval=[end], **TIGHT)
    assert len(run.t_events[0]) == count
    given = [mpmath.mpf(value) for value in (1.0, 9.81, 0.9)]
    for k, name in enumerate(names):
        right = [
            float(mpmath.diff(lambda p: bounced(end, *given[:k], p, *given[k + 1 :], count)[which], given[k]))  # noqa: B023
            for which in range(3)
        ]
        found = run.sensitivity[name]
        assert [found.dx[0, 0], found.dv[0, 0], found.dt_events[0][-1]] == pytest.approx(right, rel=1e-12)
        assert found.dt_events[1].shape == run.t_events[1].shape


def test_rows_before_and_after_an_impact():
    """At fixed time: the place of the ball where it strikes does not change, so dz + z' dt = 0 on both sides."""
    run = ball().simulate((0.0, 1.0), sensitivities=["z"], **TIGHT)
    (at,) = np.flatnonzero(np.diff(run.t) == 0)
    found = run.sensitivity["z"]
    for row in (at, at + 1):
        assert found.dx[0, row] + run.v[0, row] * found.dt_events[0][0] == pytest.approx(0.0, abs=1e-12)
    assert found.dt_events[0][0] == pytest.approx(np.sqrt(2 / 9.81) / 2)


@cache
def kicked() -> System:
    """A unit mass on a line; past x = s it is put to a place, at a velocity, of its own and of parameters."""
    s, a, b = symbols("s a b")
    reset = {x: x - a * x.diff(), x.diff(): b * x.diff() + em.t * a}
    return system_for(
        Model(name="kicked", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, parameters={s: 1.0, a: 0.25, b: -0.5},
              events={"gate": Event(x - s, direction=1, reset=reset)}, initial={x.diff(): 2.0}),
        "lagrange")  # fmt: skip


def test_a_reset_of_parameters_and_time():
    end, names = 1.25, ["x", "x'", "s", "a", "b"]
    run = kicked().simulate((0.0, end), sensitivities=names, t_eval=[end], **TIGHT)

    def moved(x0, v, s, a, b):
        at = (s - x0) / v
        after = b * v + at * a
        return s - a * v + after * (end - at)

    given = [mpmath.mpf(value) for value in (0.0, 2.0, 1.0, 0.25, -0.5)]
    for k, name in enumerate(names):
        right = mpmath.diff(lambda p: moved(*given[:k], p, *given[k + 1 :]), given[k])  # noqa: B023
        assert run.sensitivity[name].dx[0, 0] == pytest.approx(float(right), rel=1e-12)


@cache
def struck_bar() -> System:
    """Two ends of a bar, its length stated twice; the second strikes a wall that moves, with a restitution of x."""
    p, q, r, s = dynamicsymbols("p q r s")
    m, l, w = symbols("m l w", positive=True)
    wall, square = q - w * sin(em.t) - r * s / 5, (p - q) ** 2 + (r - s) ** 2
    return system_for(
        Model(name="struck_bar", coordinates=[p, q, r, s],
              kinetic_energy=m * (p.diff() ** 2 + r.diff() ** 2) / 2 + (1 + p**2) * (q.diff() ** 2 + s.diff() ** 2) / 2,
              holonomic_constraints=[square - l**2, 2 * square - 2 * l**2],
              parameters={m: 2.0, l: 1.5, w: 0.3, e: 0.7},
              events={"wall": Event(wall, impact=(wall, e * cos(r) ** 2))},
              initial={p: 0.3, q: 1.1, r: -0.2, s: 0.9, p.diff(): 0.5, s.diff(): -0.8}), "lagrange")  # fmt: skip


@cache
def quasi() -> System:
    """A reset in quasi-velocities y = P(x, t, parameters) v."""
    a, b = dynamicsymbols("a b")
    y1, y2 = dynamicsymbols("y1 y2")
    k = symbols("k")
    rates = {y1: cos(a) * a.diff() + k * b.diff(), y2: b.diff() - em.t * sin(b) * a.diff()}
    reset = {y1: k * y2 + a, y2: y1 * k, a: a + k * b / 10}
    return system_for(
        Model(name="set_quasi", coordinates=[a, b], kinetic_energy=(a.diff() ** 2 + b.diff() ** 2) / 2,
              quasi_velocities=rates, parameters={k: 0.4}, events={"gate": Event(a - 2, reset=reset)},
              initial={a: 0.3, b: 0.5, a.diff(): 1.0, b.diff(): -0.7}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("scene", [struck_bar, quasi])
def test_what_events_do_against_differences(scene):
    """Impacts whose M, N and restitution change, along rows that depend on each other; quasi-velocities set anew."""
    system = scene()
    c, n, t, h = system.compiled, system.n, 0.7, 2e-4
    x0, v0 = system.project_initial_state(t=t, dependent_constraints="least_norm")
    names, base = list(system.parameters), np.array(list(system.parameters.values()))
    P0 = np.random.default_rng(1).uniform(-1.0, 1.0, (len(names) + 1, 3))
    S0 = np.random.default_rng(2).uniform(-1.0, 1.0, (2 * n, 3))

    def acted(column, change):
        p, at = c.prepare(base + change * P0[:-1, column]), t + change * P0[-1, column]
        xs, vs = c.project(at, x0 + change * S0[:n, column], v0 + change * S0[n:, column], p, True)
        x1, v1, _, _ = act_along(c, at, xs, vs, p, [], True, [1], 0.0 * S0, 0.0 * P0)
        return np.concatenate([xs, vs]), np.concatenate([x1, v1])

    def slope(column, which):
        ahead = [acted(column, change)[which] for change in (h, -h, 2 * h, -2 * h)]
        return (8 * (ahead[0] - ahead[1]) - (ahead[2] - ahead[3])) / (12 * h)

    prepared = c.prepare(base)
    S = np.array([slope(column, 0) for column in range(3)]).T
    x1, v1, _, found = act_along(c, t, x0, v0, prepared, [], True, [1], S, P0)
    np.testing.assert_allclose(found, np.array([slope(column, 1) for column in range(3)]).T, atol=2e-10)
    D = constraint_partials(c, t, x1, v1, prepared)
    np.testing.assert_allclose(D[:, : 2 * n] @ found + D[:, 2 * n :] @ P0, 0.0, atol=1e-12)


def test_a_block_that_stops_and_stays():
    """v0 = s', slowed by a = g (mu cos alpha + sin alpha): it comes to rest v0^2 / (2 a) further up, and stays."""
    system = system_of("block_on_incline", "lagrange")
    run = system.simulate((0.0, 3.0), sensitivities=["s'", "mu", "g"], t_eval=[3.0], **TIGHT)
    p, v = system.parameters, float(system.start()[1][0])
    slows = p["g"] * (p["mu"] * np.cos(p["alpha"]) + np.sin(p["alpha"]))
    by_mu = -(v**2) / (2 * slows**2) * p["g"] * np.cos(p["alpha"])
    right = {"s'": v / slows, "mu": by_mu, "g": -(v**2) / (2 * slows * p["g"])}
    for name, expected in right.items():
        assert run.sensitivity[name].dx[0, 0] == pytest.approx(expected, rel=1e-9)
        assert abs(run.sensitivity[name].dv[0, 0]) < 1e-12


NIGHT = pytest.mark.nightly


@pytest.mark.parametrize(("name", "end", "by"), [
    ("pendulum_with_stop", 3.0, ["l", "e", "stop", "theta", "theta'"]),
    pytest.param("bouncing_ball", 4.0, ["g", "e", "z", "z'", "x'"], marks=NIGHT),
    pytest.param("rimless_wheel", 1.5, ["l", "alpha", "gamma", "theta", "theta'"], marks=NIGHT),
    pytest.param("block_on_incline", 1.5, ["g", "alpha", "mu", "s'"], marks=NIGHT),
])  # fmt: skip
def test_against_differences_of_runs(name, end, by):
    system = system_of(name, "lagrange")
    run = system.simulate((0.0, end), sensitivities=by, t_eval=[end], **TIGHT)
    assert any(len(times) for times in run.t_events)
    for one in by:
        found, right = run.sensitivity[one], differences(system, one, end, rtol=1e-13)
        close = np.concatenate([found.dx[:, -1], found.dv[:, -1]])
        np.testing.assert_allclose(close, right, atol=2e-8 * np.abs(right).max())


@NIGHT
def test_every_formulation_alike():
    asked = {"sensitivities": ["l", "theta"], "t_eval": [3.0]} | TIGHT
    systems = (system_of("pendulum_with_stop", one) for one in ("lagrange", "cholesky", "eigenfactor", "inverse"))
    runs = [system.simulate((0.0, 3.0), **asked) for system in systems]
    for run in runs[1:]:
        for name in ("l", "theta"):
            np.testing.assert_allclose(run.sensitivity[name].dx, runs[0].sensitivity[name].dx, rtol=1e-8)


def test_two_events_at_once_are_refused_by_name():
    y = dynamicsymbols("y")
    struck = {name: Event(q, direction=-1, impact=(q, Rational(1, 2))) for name, q in (("left", x), ("right", y))}
    both = Model(name="both", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                 potential_energy=g * (x + y), parameters={g: 9.81}, events=struck,
                 initial={x: 1.0, y: 1.0})  # fmt: skip
    system = system_for(both, "lagrange")
    with pytest.raises(ModelError, match=r"'left' and 'right' act at once.*t = 0.4515.*: end the run before, start"):
        system.simulate((0.0, 0.6), sensitivities=["x"])
    run = system.simulate((0.0, 0.6), sensitivities=["g"], t_eval=[0.6], **TIGHT)  # both come as much earlier
    assert run.sensitivity["g"].dx[0, 0] == pytest.approx(run.sensitivity["g"].dx[1, 0])


def test_the_end_at_a_terminal_event():
    """At fixed time, of the motion up to there; the state at the event is that and v dt."""
    wall = Model(name="ends", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces=[-g], parameters={g: 1.0},
                 initial={x: 2.0}, events={"here": Event(x, terminal=True)})  # fmt: skip
    run = system_for(wall, "lagrange").simulate((0.0, 5.0), sensitivities=["x"], **TIGHT)
    found = run.sensitivity["x"]
    assert found.dx[0, -1] == pytest.approx(1.0)
    assert found.dt_events[0] == pytest.approx([0.5])
    assert found.dx[0, -1] + run.v[0, -1] * found.dt_events[0][0] == pytest.approx(0.0, abs=1e-12)


def test_ensembles_through_events():
    heights = [1.0, 2.0]
    runs = em.simulate_ensemble(ball(), (0.0, 2.0), x0={"z": heights}, sensitivities=["e"], **TIGHT)
    for k, height in enumerate(heights):
        one = ball().simulate((0.0, 2.0), x0={"z": height}, sensitivities=["e"], **TIGHT)
        assert runs.sensitivity["e"].dx[k, :, 0] == pytest.approx(one.sensitivity["e"].dx[:, -1], rel=1e-9)
        assert runs[k].sensitivity["e"].dt_events[0] == pytest.approx(one.sensitivity["e"].dt_events[0], rel=1e-9)
