"""Several contacts at once: what they share, and what no multiplier is told by."""

import pickle
from functools import cache

import numpy as np
import pytest
from sympy import Rational, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, System

from ..support.generation import system_for, system_of

G = 9.81
SHARED = {"dependent_constraints": "least_norm"}


@cache
def box(feet: tuple[int, ...], rough: bool = False) -> System:
    """A plank on feet, dropped aslant."""
    x, y, phi = dynamicsymbols("x y phi")
    m, g, l, e, mu = symbols("m g l e mu", nonnegative=True)
    contacts = {f"foot{k}": Contact(y + at * l * sin(phi), e, Rational(1, 100)) for k, at in enumerate(feet)}
    rubs = {f"rub{k}": Friction(x.diff() - at * l * sin(phi) * phi.diff(), mu, f"foot{k}") for k, at in enumerate(feet)}
    return system_for(
        Model(name=f"box{len(feet)}{'r' * rough}", coordinates=[x, y, phi],
              kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + (l * phi.diff()) ** 2 / 3) / 2,
              potential_energy=m * g * y, contacts=contacts | (rubs if rough else {}),
              parameters={m: 1.0, g: G, l: 0.5, e: 0.3, mu: 0.4},
              initial={y: 1.0, phi: 0.3, x.diff(): 1.0}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("options", [{}, {"stabilisation": "none"}, {"method": "radau5"}], ids=str)
def test_a_plank_rattles_and_lies_down(options):
    run = box((-1, 1)).simulate((0.0, 5.0), **options)
    assert run.success, run.message
    assert run.x[:, -1] == pytest.approx([5.0, 0.0, 0.0], abs=1e-9)
    assert np.diff(run.energy).max() < 1e-8  # a short flight may be one step, good to rtol of its velocities
    assert run.multipliers[:, -1] == pytest.approx([-G / 2, -G / 2])


@pytest.mark.parametrize("options", [{}, SHARED], ids=str)
def test_a_foot_too_many_is_idle(options):
    run = box((-1, 0, 1)).simulate((0.0, 5.0), **options)
    assert run.success, run.message
    assert run.x[:, -1] == pytest.approx([5.0, 0.0, 0.0], abs=1e-9)
    assert set(run.modes[-1][1].values()) == {1.0}
    forces = -run.multipliers[:, -1]
    assert forces.min() > -1e-9
    assert forces.sum() == pytest.approx(G)
    assert forces[2] == pytest.approx(forces[0])  # no moment


@pytest.mark.parametrize("method", ["dop853", "radau5"])
def test_feet_that_slide_stop_where_their_friction_has_taken_the_speed(method):
    run = box((-1, 1), rough=True).simulate((0.0, 2.0), x0=[0, 0, 0], v0={"x": 1.0}, method=method, **SHARED)
    assert run.success, run.message
    assert run.x[0, -1] == pytest.approx(1 / (2 * 0.4 * G), rel=1e-9)
    assert run.modes[-1][1] == {f"{what}{k}_{how}": value for k in (0, 1) for what, how, value in
                                (("foot", "held", 1.0), ("rub", "stuck", 1.0), ("rub", "slides", 0.0))}  # fmt: skip


@pytest.mark.parametrize("method", ["dop853", "radau5"])
@pytest.mark.parametrize("at", [None, (0.0, 0.3, 8.9, 9.0)])
def test_members_of_an_ensemble_have_modes_of_their_own(at, method):
    system = system_of("bouncing_ball", "lagrange")
    e, g = [0.3, 0.5, 0.6], [G, 2 * G, -G]  # the last one flies away
    runs = em.simulate_ensemble(
        system, (0.0, 9.0), parameters={"e": e, "g": g}, t_eval=at, method=method, workers=2, max_step=1.0
    )
    assert runs.success.all()
    for k, run in enumerate(runs):
        alone = system.simulate((0.0, 9.0), parameters={"e": e[k], "g": g[k]}, t_eval=at, method=method, max_step=1.0)
        rows = slice(None) if at else slice(-1, None)
        assert run.modes == alone.modes
        for name in ("x", "multipliers"):
            assert np.array_equal(getattr(runs, name)[k], alone[name][:, rows])
            assert np.array_equal(run[name], alone[name][:, rows])
        for name, values in alone.outputs.items():
            assert np.array_equal(runs.outputs[name][k], values[rows])
    assert runs.multipliers[:, 0, -1] == pytest.approx([-G, -2 * G, 0.0])
    assert np.array_equal(pickle.loads(pickle.dumps(runs._results)).y, runs.y.swapaxes(1, 2))


@cache
def stack() -> System:
    """Three blocks of height 1 on one another, which do not bounce on the floor for long, but do on each other."""
    z = dynamicsymbols("z1:4")
    m, g, e, r = symbols("m g e r", nonnegative=True)
    gaps = {"floor": (z[0], r), "lower": (z[1] - z[0] - 1, e), "upper": (z[2] - z[1] - 1, e)}
    return system_for(
        Model(name="stack_of_blocks", coordinates=list(z), kinetic_energy=m * sum(one.diff() ** 2 for one in z) / 2,
              potential_energy=m * g * sum(z),
              contacts={name: Contact(gap, bounce, Rational(1, 100)) for name, (gap, bounce) in gaps.items()},
              parameters={m: 1.0, g: G, e: 1.0, r: 0.5}, initial=dict(zip(z, (0.5, 1.5, 2.5), strict=True))),
        "lagrange")  # fmt: skip


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau5"])
def test_what_falls_side_by_side_is_struck(method):
    """A gap of what falls together is -1e-11 by then, by blows before; and rounding from start to end of a step."""
    run = stack().simulate((0.0, 2.6), method=method, rtol=1e-8, atol=1e-10)
    assert run.success, run.message
    assert (np.diff(run.x, axis=0) - 1).min() > -1e-9
    assert len(run.t_events[1]) == pytest.approx(2 * len(run.t_events[2]), abs=40)  # down, then up to what it hands on
    assert run.nsteps < 10_000
