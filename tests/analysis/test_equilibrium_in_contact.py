"""Equilibria that lean, stand and stick: closed forms, and the same mechanism with constraints instead."""

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, t

from ..support.generation import system_for
from .mechanisms_in_contact import (
    J,
    al,
    b,
    beam,
    block,
    box,
    dragged,
    g,
    h,
    k,
    ladder,
    leaning,
    m,
    mu,
    p,
    pendulum,
    x,
    y,
)
from .test_linearize import same


@pytest.mark.parametrize("guess", [0.1, 0.5, 1.0, 0.05, -0.6, 0.1 + 1e-13, 0.1 - 1e-13])
def test_an_equilibrium_lies_on_a_stop_and_never_inside(guess):
    rest = em.find_equilibrium(pendulum(), [guess])
    assert rest.success
    assert rest.message == "at rest, wall held"
    assert rest.mode == {"wall_held": 1.0}
    assert rest.x[0] == pytest.approx(0.1, abs=1e-15)
    assert rest.multipliers[0] == pytest.approx(-9.81 * np.sin(0.1), rel=1e-12)
    assert rest.linearize().eigenvalues().size == 0


def test_a_stop_out_of_the_way_changes_nothing():
    for guess, place in ((0.3, 0.0), (3.0, np.pi)):
        rest = em.find_equilibrium(pendulum(), [guess], parameters={"wall": -0.2})
        assert rest.success
        assert rest.message == "at rest"
        assert rest.x[0] == pytest.approx(place, abs=1e-14)


def test_what_is_not_free_stays_inside_and_is_named():
    rest = em.find_equilibrium(pendulum(), [0.05], free=["g"])
    assert not rest.success
    assert "inside 'wall', whose gap is -0.05" in rest.message
    leans = em.find_equilibrium(pendulum(), [0.05], free=["wall"])
    assert not leans.success or leans.parameters["wall"] <= 0.05


def test_what_leans_has_no_eigenvalues_and_what_hangs_below_has_its_own():
    rest = em.find_equilibrium(leaning(), {"p": 0.4, "q": 0.3})
    assert rest.success
    np.testing.assert_allclose(rest.x, [0.1, 0.0], atol=1e-14)
    linear = rest.linearize()
    assert linear.steady
    assert linear.mode == {"wall_held": 1.0}
    same(linear.eigenvalues(), np.array([1j, -1j]) * np.sqrt(9.81 / 0.6))


def test_through_a_sweep_of_gravity():
    """A mass on a spring comes down to the floor as g grows, and pushes with what the spring does not carry."""
    z = dynamicsymbols("z")
    system = system_for(
        Model(name="lowered", coordinates=[z], kinetic_energy=m * z.diff() ** 2 / 2,
              parameters={m: 2.0, g: 1.0, k: 40.0},
              potential_energy=m * g * z + k * z**2 / 2, contacts={"floor": Contact(z + 1)}),
        "lagrange",
    )  # fmt: skip
    for gravity in np.linspace(0.0, 40.0, 41):
        rest = em.find_equilibrium(system, {"z": 0.5}, parameters={"g": gravity})
        assert rest.success
        assert rest.x[0] == pytest.approx(max(-1.0, -2.0 * gravity / 40.0), abs=1e-12)
        assert -rest.multipliers[0] == pytest.approx(max(0.0, 2.0 * gravity - 40.0), abs=1e-10)
        assert ("touches without force" in rest.message) == (gravity == 20.0)


@pytest.mark.parametrize("contact", [False, True])
def test_a_block_on_an_incline_rests_where_friction_holds_it(contact):
    system = block(contact)
    rest = em.find_equilibrium(system)
    assert rest.success
    assert rest.x[0] == 0.7
    assert "rub stuck" in rest.message
    steep = em.find_equilibrium(system, parameters={"al": 0.6})
    assert not steep.success
    assert "rub slides forward" in steep.message
    at_limit = em.find_equilibrium(system, parameters={"al": np.arctan(0.5)})
    assert at_limit.success
    assert "friction 'rub' is at its limit" in at_limit.message


@pytest.mark.parametrize("guess", [0.0, 0.1, -0.2, 0.19999, 0.7, -3.0])
def test_of_a_range_of_equilibria_the_nearest_is_taken(guess):
    rest = em.find_equilibrium(dragged(), [guess])
    assert rest.success
    assert rest.x[0] == pytest.approx(np.clip(guess, -0.2, 0.2), abs=1e-12)
    assert ("at its limit" in rest.message) == (abs(guess) >= 0.2)


def test_a_box_comes_to_stand_on_its_feet():
    system = system_for(box("contacts"), "lagrange")
    for guess in ({"y": 2.0}, {"y": 2.0, "p": 0.1}, {"y": 0.5, "p": 0.1}, {"y": 0.3}, {"y": 0.5, "q": 0.2}):
        rest = em.find_equilibrium(system, guess)
        assert rest.success, rest.message
        np.testing.assert_allclose(rest.x[1:], [0.5, 0.0, 0.0], atol=1e-12)
        np.testing.assert_allclose(-rest.multipliers[:2], 9.81 / 2, rtol=1e-9)


def test_the_linear_box_is_that_with_constraints():
    system, other = (system_for(box(feet), "lagrange") for feet in ("contacts", "constraints"))
    found, right = system.linearize(), other.linearize()
    assert found.mode == {"left_held": 1.0, "right_held": 1.0, "rub_stuck": 1.0, "rub_slides": 0.0}
    same(found.eigenvalues(), right.eigenvalues())
    np.testing.assert_allclose(found.Z @ found.Z.T, right.Z @ right.Z.T, atol=1e-14)
    np.testing.assert_allclose(found.Z @ found.A @ found.Z.T, right.Z @ right.A @ right.Z.T, atol=1e-12)


def test_a_box_on_a_spring_floor():
    """A table on springs: both feet held, and box and table go up and down as one."""
    table, M = dynamicsymbols("table"), symbols("M", positive=True)
    feet = {
        name: Contact(y + side * b * sin(p) - h * cos(p) - table, rest=0.01)
        for name, side in (("left", -1), ("right", 1))
    }
    system = system_for(
        Model(name="on_springs", coordinates=[y, p, table],
              potential_energy=m * g * y + M * g * table + k * table**2 / 2,
              kinetic_energy=m * y.diff() ** 2 / 2 + J * p.diff() ** 2 / 2 + M * table.diff() ** 2 / 2,
              parameters={m: 1.0, M: 0.5, g: 9.81, b: 0.3, h: 0.5, J: 0.2, k: 300.0}, contacts=feet, initial={y: 1.0}),
        "lagrange",
    )  # fmt: skip
    rest = em.find_equilibrium(system, {"p": 0.02})
    assert rest.success
    down = -1.5 * 9.81 / 300.0
    np.testing.assert_allclose(rest.x, [0.5 + down, 0.0, down], atol=1e-12)
    same(rest.linearize().eigenvalues(), np.array([1j, -1j]) * np.sqrt(300.0 / 1.5))


def test_a_ladder_stays_where_friction_holds_it_and_slips_to_where_it_does():
    """Uniform, half length 1, against a smooth wall: 2 mu tan(p) >= 1."""
    rest = em.find_equilibrium(ladder())
    assert rest.success
    np.testing.assert_array_equal(rest.x, ladder().initial[0])
    push = 9.81 / (2 * np.tan(1.2))
    np.testing.assert_allclose(np.abs(rest.multipliers), [9.81, push, push], rtol=1e-12)
    assert rest.linearize().eigenvalues().tolist() == [0.0] * len(rest.linearize().A)
    slips = em.find_equilibrium(ladder(), parameters={"mu": 0.1})
    assert slips.success
    assert slips.x[2] == pytest.approx(np.arctan(1 / 0.2), rel=1e-10)
    assert "friction 'rub' is at its limit" in slips.message


def test_a_beam_on_three_supports():
    for torque, success, bounds in ((0.0, True, False), (3.0, True, False), (9.81, True, True), (10.0, False, False)):
        rest = em.find_equilibrium(beam(), parameters={"F": torque})
        assert rest.success == success, torque
        assert ("without force" in rest.message) == bounds
        if success:
            np.testing.assert_allclose(rest.x, 0.0, atol=1e-15)
            assert (rest.multipliers <= 1e-9).all()
        if success and not bounds:
            assert rest.mode == {"left_held": 1.0, "mid_held": 1.0, "right_held": 1.0}
            assert rest.linearize().eigenvalues().size == 0
    falls = em.find_equilibrium(beam(), {"y": 1.0, "p": 0.2}, parameters={"F": 3.0})
    np.testing.assert_allclose(falls.x, 0.0, atol=1e-12)


def on_a_slope() -> Model:
    """A box on two rough feet; x along the slope."""
    feet = {name: (x + side * b * cos(p) + h * sin(p), y + side * b * sin(p) - h * cos(p))
            for name, side in (("left", -1), ("right", 1))}  # fmt: skip
    rub = {f"rub_{name}": Friction(foot[0].diff(t), limit=mu, normal=name) for name, foot in feet.items()}
    return Model(name="on_a_slope", coordinates=[x, y, p], potential_energy=m * g * (y * cos(al) - x * sin(al)),
                 kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2 + J * p.diff() ** 2 / 2,
                 contacts={name: Contact(foot[1], rest=0.01) for name, foot in feet.items()} | rub,
                 parameters={m: 1.0, g: 9.81, b: 0.3, h: 0.5, J: 0.2, mu: 0.6, al: 0.2}, initial={y: 0.5})  # fmt: skip


def test_random_boxes_on_slopes_stand_where_they_neither_slide_nor_tip():
    """tan(slope) < min(mu, b / h); and whatever else is found lies in no contact, where none pulls."""
    system, random = system_for(on_a_slope(), "lagrange"), np.random.default_rng(3)
    for _ in range(25):
        low, high = [0.1, 0.2, 0.1, 0.0, 0.1], [0.6, 1.0, 1.5, 0.8, 100.0]
        given = dict(zip(("b", "h", "mu", "al", "g"), random.uniform(low, high).tolist(), strict=True))
        rest = em.find_equilibrium(system, {"y": given["h"] * random.choice([1.0, 1.3])}, parameters=given)
        stands = rest.success and abs(rest.x[2]) < 1e-9 and abs(rest.x[1] / given["h"] - 1) < 1e-9
        assert stands == (np.tan(given["al"]) < min(given["mu"], given["b"] / given["h"])), (given, rest)
        if rest.success:
            gaps = rest.x[1] + np.array([-1, 1]) * given["b"] * np.sin(rest.x[2]) - given["h"] * np.cos(rest.x[2])
            normal, rubbing = -rest.multipliers[:2], np.abs(rest.multipliers[2:])
            assert (gaps > -1e-9).all()
            assert (normal > -1e-9 * given["g"]).all()
            assert (rubbing <= given["mu"] * normal + 1e-9 * given["g"]).all()


@pytest.mark.parametrize("length", [1e-6, 1e6])
def test_units_make_no_difference_to_what_leans(length):
    units = {"g": 9.81 * length, "b": 0.3 * length, "h": 0.5 * length, "J": 0.2 * length**2}
    system = system_for(box("contacts"), "lagrange")
    rest = em.find_equilibrium(system, {"y": 2.0 * length, "p": 0.1}, parameters=units)
    assert rest.success
    np.testing.assert_allclose(rest.x[1] / length, 0.5, rtol=1e-12)
    assert rest.x[2] == pytest.approx(0.0, abs=1e-12)
    same(rest.linearize().eigenvalues(), [0.0, np.sqrt(7.0) * 1j, -np.sqrt(7.0) * 1j])


def test_a_run_from_an_equilibrium_stays_there():
    for system, guess in ((pendulum(), [0.4]), (beam(), [1.0, 0.1]), (ladder(), None)):
        rest = em.find_equilibrium(system, guess)
        run = em.simulate(system, (0.0, 5.0), x0=rest.x, parameters=rest.parameters)
        assert run.success
        np.testing.assert_allclose(run.x[:, -1], rest.x, atol=1e-9)
