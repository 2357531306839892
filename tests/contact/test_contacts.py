"""Contacts that close and open, frictions that stick and slide: against closed forms, in every kind of method."""

import pickle
from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipkinc
from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, StopReason, System, t

from ..support.generation import FORMULATIONS, model_of, system_for, system_of

G = 9.81
METHODS = ("dop853", "ra15", "radau5")
x, z = dynamicsymbols("x z")
m, g, e, mu = symbols("m g e mu", positive=True)


# --- a ball comes to rest ---


@pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-12])
def test_forty_bounces_then_rest(tolerance):
    run = system_of("bouncing_ball", "lagrange").simulate((0.0, 20.0), rtol=tolerance, atol=tolerance)
    first = np.sqrt(2 / G)
    expected = np.cumsum([first, *(2 * first * 0.9**k for k in range(1, 40))])
    assert run.t_events[0][:40] == pytest.approx(expected, abs=1e-10)
    count = int(np.ceil(np.log(1e-3 / (G * first)) / np.log(0.9)))  # impacts until it parts slower than 1 mm/s
    assert len(run.t_events[0]) == count
    assert run.stop is StopReason.FINISHED
    assert run.modes[-1] == (pytest.approx(run.t_events[0][-1]), {"floor_held": 1.0})
    assert len(run.modes) == 2
    assert run.x[:, -1] == pytest.approx([4.0, 0.0], abs=1e-12)
    assert run.multipliers[0, 0] == 0.0
    assert run.multipliers[0, -1] == pytest.approx(-G)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9", "radau5"])
def test_rest_in_every_formulation(formulation, method):
    run = system_of("bouncing_ball", formulation).simulate((0.0, 9.0), method=method, rtol=1e-8, atol=1e-10)
    assert run.success
    assert run.x[:, -1] == pytest.approx([1.8, 0.0], abs=1e-9)
    assert run.v[:, -1] == pytest.approx([0.2, 0.0], abs=1e-9)
    assert np.abs(run.position_residual).max() < 1e-12


def test_a_mode_goes_with_an_interpolant_and_to_another_process():
    system = em.build(model_of("bouncing_ball"), formulation="lagrange", flags="-O0")
    run = system.simulate((0.0, 9.0), dense_output=True, t_eval=[0.0, 8.9])
    assert run.sol(8.9)[1] == 0.0
    assert run.multipliers[0] == pytest.approx([0.0, -G])
    assert np.array_equal(pickle.loads(pickle.dumps(run.sol))([1.0, 8.9]), run.sol([1.0, 8.9]))


# --- what rests lets go ---


@cache
def shaken() -> System:
    """A block on a table that moves up and down as a sin(w t): it is left behind where the table falls faster."""
    a, w = symbols("a w", positive=True)
    return system_for(
        Model(name="shaken", coordinates=[z], kinetic_energy=m * z.diff() ** 2 / 2, potential_energy=m * g * z,
              contacts={"table": Contact(z - a * sin(w * t), rest=Rational(1, 100))},
              parameters={m: 2.0, g: G, a: 0.1, w: 12.0}, initial={z.diff(): 1.2}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
def test_a_block_leaves_the_table_where_that_falls_faster(method):
    run = shaken().simulate((0.0, 0.4), method=method, rtol=1e-10, atol=1e-12)
    leaves = np.arcsin(G / (0.1 * 144)) / 12
    height, speed = 0.1 * np.sin(12 * leaves), 1.2 * np.cos(12 * leaves)
    above = lambda s: height + speed * s - G / 2 * s**2 - 0.1 * np.sin(12 * (leaves + s))  # noqa: E731
    lands = leaves + brentq(above, 0.05, 0.5)
    events = run.t_events[0][run.t_events[0] > 1e-3]
    assert events[:2] == pytest.approx([leaves, lands], abs=1e-8)
    held = [mode["table_held"] for _, mode in run.modes]
    assert held[held.index(1.0) :][:3] == [1.0, 0.0, 1.0]
    assert (run.multipliers <= 1e-9).all()


def test_no_contact_is_held_that_pulls():
    """Thrown up from the floor it leaves; pressed down it stays."""
    F = symbols("F")
    model = Model(name="pressed", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, forces={z: F},
                  contacts={"floor": Contact(z)}, parameters={F: -1.0})  # fmt: skip
    system = system_for(model, "lagrange")
    assert system.simulate((0.0, 1.0)).x[0, -1] == 0.0
    assert system.simulate((0.0, 1.0), parameters={"F": 1.0}).x[0, -1] == pytest.approx(0.5)
    assert system.simulate((0.0, 1.0), v0={"z": 1.0}).x[0, -1] == pytest.approx(0.5)


def test_a_dumbbell_tips_on_to_both_its_ends():
    """Two balls on a rod, dropped aslant: plastic ends stay where they strike, and it lies down. Energy never rises."""
    y, phi = dynamicsymbols("y phi")
    l = symbols("l", positive=True)
    model = Model(
        name="dumbbell", coordinates=[x, y, phi],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + (l * phi.diff()) ** 2), potential_energy=2 * m * g * y,
        contacts={"left": Contact(y - l * sin(phi)), "right": Contact(y + l * sin(phi))},
        parameters={m: 1.0, g: G, l: 0.5}, initial={y: 1.0, phi: 0.4, x.diff(): 1.0})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 2.0), rtol=1e-9, atol=1e-11)
    assert run.success, run.message
    first = np.sqrt(2 * (1 - 0.5 * np.sin(0.4)) / G)
    assert run.t_events[0][0] == pytest.approx(first, rel=1e-10)
    assert np.diff(run.energy).max() < 1e-9
    assert run.x[:, -1] == pytest.approx([2.0, 0.0, 0.0], abs=1e-9)
    assert run.multipliers[:, -1] == pytest.approx([-G, -G])  # m g each
    # v+ = v - M^-1 N^T (N M^-1 N^T)^-1 N v of the first end, by hand: N = (0, 1, -l cos(phi)), M = diag(2, 2, 2 l^2)
    c = np.cos(0.4)
    v = -G * first
    struck = v * (1 - 1 / (1 + c**2)), v * c / (1 + c**2) / 0.5
    at = run.y_after_events[0][0]
    assert at[4:6] == pytest.approx(struck, rel=1e-9)


def crate(rubs: bool) -> System:
    """A box, two wide and one high, on two feet; both rub on the floor, where there is friction."""
    tilt = dynamicsymbols("tilt")
    feet = {"left": -1, "right": 1}
    height = {foot: z + side * sin(tilt) + (1 - cos(tilt)) / 2 for foot, side in feet.items()}
    place = {foot: x + side * cos(tilt) + sin(tilt) / 2 for foot, side in feet.items()}
    contacts = {foot: Contact(gap, restitution=e, rest=Rational(1, 1000)) for foot, gap in height.items()}
    if rubs:
        contacts |= {f"rub_{foot}": Friction(place[foot].diff(t), limit=mu, normal=foot) for foot in feet}
    return system_for(
        Model(
            name="crate",
            coordinates=[x, z, tilt],
            kinetic_energy=m * (x.diff() ** 2 + z.diff() ** 2 + tilt.diff() ** 2 / 2) / 2,
            potential_energy=m * g * z,
            contacts=contacts,
            parameters={m: 2.0, g: G, e: 0.3} | ({mu: 0.5} if rubs else {}),
        ),
        "lagrange",
    )


def test_a_box_settles_on_both_its_feet():
    """The last impact brings all of it to rest."""
    system = crate(rubs=False)
    for tilt in (0.0, 0.3, -0.1):
        run = system.simulate((0.0, 3.0), x0={"z": 1.0, "tilt": tilt}, rtol=1e-9, atol=1e-11)
        assert run.stop is StopReason.FINISHED
        assert run.modes[-1][1] == {"left_held": 1.0, "right_held": 1.0}
        assert run.multipliers[:, -1] == pytest.approx([-G, -G])
        assert run.x[:, -1] == pytest.approx(0.0, abs=1e-9)
        assert np.diff(run.energy).max() < 1e-8
    with pytest.raises(em.ModelError, match="x0 is inside contact 'right': its gap is"):
        system.simulate((0.0, 1.0), x0={"tilt": -0.2})
    for method in ("radau9", "radau5"):
        with pytest.raises(em.ModelError, match="x0 is inside contact 'left'"):
            system.simulate((0.0, 1.0), x0={"z": -1e-6}, method=method)
    assert system.simulate((0.0, 1.0), x0={"z": -1e-9}).success  # as much as a start may be off a constraint
    stepper = system.stepper(x0={"z": 1.0})
    stepper.advance(0.3)
    with pytest.raises(ValueError, match="forwards only"):
        stepper.advance(0.2)
    assert stepper.t == 0.3


def test_a_box_skids_on_two_feet_and_sticks():
    """The foot in front bears what friction below the middle asks for. Of two that stick one is idle."""
    system = crate(rubs=True)
    start = {"v0": {"x": 2.0}, "rtol": 1e-10, "atol": 1e-12}
    stops = 2.0 / (0.5 * G)
    run = system.simulate((0.0, 0.9 * stops), **start)
    assert run.multipliers[:2, -1] == pytest.approx([-0.75 * G, -1.25 * G])  # moments: mu m g / 2 over 2
    assert run.x[0, -1] == pytest.approx(0.5 * G * stops**2 * (1 - 0.01) / 2)
    held = system.simulate((0.0, 1.0), **start)
    assert held.success
    assert held.t_events[2] == pytest.approx([stops], abs=1e-9)
    assert held.x[:, -1] == pytest.approx([0.5 * G * stops**2 / 2, 0.0, 0.0], abs=1e-9)
    assert held.multipliers[:, -1] == pytest.approx([-G, -G, 0.0, 0.0], abs=1e-9)


def test_a_pendulum_leans_on_its_stop():
    run = system_of("pendulum_with_stop", "lagrange").simulate((0.0, 30.0), rtol=1e-11, atol=1e-12)
    amplitude = 1.2
    k2 = np.sin(amplitude / 2) ** 2
    quarter = ellipkinc(np.pi / 2, k2) - ellipkinc(np.arcsin(np.sin(0.05) / np.sqrt(k2)), k2)
    assert run.t_events[0][0] == pytest.approx(quarter / np.sqrt(G), rel=1e-9)
    speeds = np.sqrt(2 * G * (np.cos(0.1) - np.cos(1.2))) * 0.8 ** np.arange(1, 20)
    after = run.y_after_events[0][:19, 1]
    assert after == pytest.approx(speeds, rel=1e-8)
    assert run.x[0, -1] == pytest.approx(0.1, abs=1e-15)
    assert run.modes[-1][1] == {"wall_held": 1.0}
    assert run.multipliers[0, -1] == pytest.approx(-G * np.sin(0.1))


# --- what is refused ---


@pytest.mark.parametrize(
    ("contacts", "words"),
    [
        (lambda: {"a b": Contact(z)}, "Python identifier"),
        (lambda: {"floor": z}, "Give a Contact or a Friction"),
        (lambda: {"floor": Contact(g)}, "gap of contacts\\[floor\\] contains no coordinate"),
        (lambda: {"floor": Contact(z.diff())}, "gap of contacts\\[floor\\] contains the velocity"),
        (lambda: {"floor": Contact(z, rest=-1)}, "speed"),
        (lambda: {"floor": Contact(z, restitution=1.5)}, "restitution of a contact"),
        (lambda: {"floor": Contact(z, restitution=symbols("q"))}, "restitution of contacts.*'q'"),
        (lambda: {"rub": Friction(z.diff() ** 2, 1)}, "not linear"),
        (lambda: {"rub": Friction(z, 1)}, "not linear"),
        (lambda: {"rub": Friction(z.diff(), em.multiplier(0))}, "multiplier"),
        (lambda: {"rub": Friction(z.diff(), 1, normal="floor")}, "Name a Contact"),
        (lambda: {"rub": Friction(z.diff(), -0.3)}, "Turn its sign"),
    ],
)
def test_what_no_contact_is_is_refused_by_name(contacts, words):
    with pytest.raises(em.ModelError, match=words):
        Model(name="refused", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
              parameters={g: G}, contacts=contacts())  # fmt: skip


def test_delta_eigenfactors_do_not_change_their_rows():
    model = Model(name="two", coordinates=[x, z], kinetic_energy=(x.diff() ** 2 + z.diff() ** 2) / 2,
                  contacts={"a": Contact(x), "b": Contact(z + cos(x))})  # fmt: skip
    with pytest.raises(em.ModelError, match='schur="eigenfactor"'):
        em.build(model, schur="eigenfactor")
