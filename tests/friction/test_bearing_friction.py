"""Bearings, guides and drawers in closed form: friction in proportion to multipliers of constraints; their names."""

import pickle
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Friction, Model, ModelError, System, multiplier, simulate_ensemble

from ..support.generation import FORMULATIONS, system_for

G = 9.81
TIGHT = {"rtol": 1e-10, "atol": 1e-12}
x, y, phi = dynamicsymbols("x y phi")
m, g, mu, r, I, R = symbols("m g mu r I R", positive=True)
F = symbols("F", real=True)


# --- a shaft in a bearing ---


def shaft(normal="bearing", **changes) -> Model:
    """Of radius r, pressed by its weight and by a belt that pulls sideways with F at the radius R."""
    given = {
        "name": "shaft", "coordinates": [phi, x, y],
        "kinetic_energy": I * phi.diff() ** 2 / 2 + m * (x.diff() ** 2 + y.diff() ** 2) / 2,
        "potential_energy": m * g * y, "forces": {x: F, phi: F * R},
        "holonomic_constraints": {"bearing": [x, y]},
        "contacts": {"rub": Friction(phi.diff(), limit=mu * r, normal=normal)},
        "parameters": {m: 5.0, I: 0.1, mu: 0.2, r: 0.05, g: G, F: 0.0, R: 0.1},
        "initial": {phi.diff(): 20.0},
    }  # fmt: skip
    return Model(**given | changes)


@cache
def shaft_system(formulation: str = "lagrange") -> System:
    return system_for(shaft(), formulation)


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_shaft_runs_down_in_its_bearing(formulation, method):
    run = shaft_system(formulation).simulate((0.0, 5.0), method=method, **TIGHT)
    slows = 0.2 * 0.05 * 5 * G / 0.1
    assert run.t_events[0] == pytest.approx([20.0 / slows], rel=1e-10)
    assert run.x[0, -1] == pytest.approx(20.0**2 / (2 * slows), rel=1e-10)
    assert run.modes[-1][1] == {"rub_stuck": 1.0, "rub_slides": 0.0}


@pytest.mark.parametrize("pull", [3.0, 400.0, -400.0])
def test_a_belt_that_pulls_turns_a_shaft_that_it_presses_into_its_bearing(pull):
    """From rest; it sticks as long as the belt's torque is below what its pull and the weight let the bearing hold."""
    presses = np.hypot(5 * G, pull)
    takes, turns = 0.2 * 0.05 * presses, 0.1 * pull
    run = shaft_system().simulate((0.0, 1.0), v0={"phi": 0.0}, parameters={"F": pull}, **TIGHT)
    expected = 0.0 if abs(turns) <= takes else (turns - np.sign(turns) * takes) / 0.1
    assert run.success, run.message
    assert run.v[0, -1] == pytest.approx(expected, rel=1e-9)
    assert bool(run.modes[0][1]["rub_stuck"]) == (abs(turns) <= takes)
    assert run.multipliers[:2, -1] == pytest.approx([pull, -5 * G])


def test_a_shaft_lets_go_where_the_pull_is_enough():
    """A torque that grows with the time: it sticks until that is mu r m g."""
    u = dynamicsymbols("u")
    model = shaft(inputs={u: 0.0}, forces={phi: u}, name="wound")
    run = system_for(model, "cholesky").simulate(
        (0.0, 1.0), v0={"phi": 0.0}, inputs={"u": ([0.0, 1.0], [0.0, 1.0])}, **TIGHT
    )
    holds = 0.2 * 0.05 * 5 * G
    assert run.t_events[0] == pytest.approx([holds], rel=1e-9)
    assert run.v[0, -1] == pytest.approx((1.0 - holds) ** 2 / 2 / 0.1, rel=1e-8)


def test_a_blow_on_a_bearing_takes_of_the_spin():
    """What strikes a spinning disc radially loads its bearing by an impulse, mu r times which the spin loses."""
    q = dynamicsymbols("q")
    model = shaft(
        name="struck", coordinates=[phi, x, y, q],
        kinetic_energy=I * phi.diff() ** 2 / 2 + m * (x.diff() ** 2 + y.diff() ** 2 + q.diff() ** 2) / 2,
        potential_energy=0, forces={}, contacts={
            "rub": Friction(phi.diff(), limit=mu * r, normal="bearing"), "rim": Contact(q - y, restitution=0.5)},
        parameters={m: 5.0, I: 0.1, mu: 0.2, r: 0.05}, initial={phi.diff(): 20.0, q: 1.0, q.diff(): -2.0})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 1.0), **TIGHT)
    assert run.t_events[1] == pytest.approx([0.5])
    assert run.v[:, -1] == pytest.approx([20.0 - 0.2 * 0.05 * 5.0 * 3.0 / 0.1, 0.0, 0.0, 1.0], abs=1e-10)


# --- a drawer between two guides ---

e, b, L = symbols("e b L", positive=True)


def drawer(each: bool) -> Model:
    """Pushed by F at e beside its middle; what guides it, L apart, rubs at b beside the middle."""
    slip = x.diff() - b * phi.diff()
    rows = {"front": y + L / 2 * phi, "back": y - L / 2 * phi}
    limits = {"front": Friction(slip, mu, "front"), "back": Friction(slip, mu, "back")}
    one = {"guides": Friction(slip, mu * 2**0.5, ("front", "back"))}
    return Model(
        name="drawer" + "s" * each, coordinates=[x, y, phi],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + phi.diff() ** 2) / 2,
        forces={x: F, phi: -e * F}, holonomic_constraints=rows,
        contacts={f"rub_{name}": one for name, one in (limits if each else one).items()},
        parameters={m: 2.0, mu: 0.3, F: 4.0, e: 0.2, b: 0.05, L: 0.4})  # fmt: skip


@cache
def drawer_system(each: bool, formulation: str = "lagrange") -> System:
    return system_for(drawer(each), formulation)


def slowed(friction: float, force: float, side: float) -> float:
    """What guides that are implicit in their own load hold back: f = 2 mu |N|, L N = e F - b side f."""
    return 2 * friction * 0.2 * force / (0.4 + side * 2 * friction * 0.05)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("each", [True, False])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_drawer_slides_either_way(formulation, each, side):
    system = drawer_system(each, formulation)
    mode = {p: side for p in system.parameters if p.endswith("_slides")}
    a, reactions = system.acceleration([0.0] * 3, [side, 0.0, 0.0], parameters=mode)
    f = slowed(0.3, 4.0, side)
    assert a == pytest.approx([(4.0 - side * f) / 2, 0.0, 0.0])
    assert reactions[:2] == pytest.approx([-f / 0.6, f / 0.6])


@pytest.mark.parametrize("each", [True, False])
@pytest.mark.parametrize("friction", [0.3, 1.2, 2.0])
def test_a_drawer_locks_itself_whatever_pushes(friction, each):
    """Where 2 mu (e - b) >= L it sticks at any push; below, none holds it."""
    for push in (1e-3, 4.0, 1e4):
        run = drawer_system(each).simulate((0.0, 1.0), parameters={"mu": friction, "F": push}, **TIGHT)
        locked = 2 * friction * (0.2 - 0.05) >= 0.4
        expected = 0.0 if locked else (push - slowed(friction, push, 1.0)) / 2
        assert run.success, run.message
        assert run.v[0, -1] == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("each", [True, False])
def test_a_drawer_that_jams_is_named(each):
    """Sliding back with 2 mu b > L, the guides press the more the more they rub."""
    run = drawer_system(each).simulate((0.0, 1.0), v0={"x": -1.0}, parameters={"mu": 5.0})
    assert not run.success
    assert "jams" in run.message
    run = drawer_system(each).simulate((0.0, 1.0), v0={"x": -1.0}, parameters={"mu": 3.9}, **TIGHT)
    assert run.success


def test_reactions_that_are_not_unique_do_not_rub():
    """Three guides in a line: what each presses is anyone's guess, and so would the motion be. Named, by its name."""
    model = replace(
        drawer(False), name="redundant", constraint_names=(), holonomic_constraints={
            "guides": [y + L / 2 * phi, y - L / 2 * phi, y]},
        contacts={"rub": Friction(x.diff(), mu, "guides")}, forces={x: F, phi: -e * F}, nonholonomic_constraints=[],
        events=[], parameters={m: 2.0, mu: 0.3, F: 4.0, e: 0.2, L: 0.4})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 1.0))
    assert not run.success
    assert "guides[0], which is not unique" in run.message


# --- derivatives, ensembles ---


def test_slopes_and_sensitivities_against_differences():
    system, z = drawer_system(False), np.array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0])
    runs = system.simulate((0.0, 0.5), v0=z[3:], sensitivities=["mu", "e", "x'"], **TIGHT)
    for name in ("mu", "e"):
        h, at = 1e-6, system.parameters[name]
        beside = [system.simulate((0.0, 0.5), v0=z[3:], parameters={name: at + d}, **TIGHT).x[0, -1] for d in (h, -h)]
        assert runs.sensitivity[name].dx[0, -1] == pytest.approx((beside[0] - beside[1]) / (2 * h), rel=1e-6)
    assert runs.sensitivity["x'"].dx[0, -1] == pytest.approx(0.5, rel=1e-8)


def test_members_are_what_runs_alone_are():
    frictions = np.linspace(0.1, 2.0, 5)
    many = simulate_ensemble(drawer_system(True), (0.0, 1.0), parameters={"mu": frictions}, v0={"x": 0.3})
    for k, value in enumerate(frictions):
        alone = drawer_system(True).simulate((0.0, 1.0), parameters={"mu": value}, v0={"x": 0.3})
        assert np.array_equal(many.x[k, :, -1], alone.x[:, -1])


# --- names ---


def test_names_of_constraints_stay_with_a_model():
    model = replace(shaft(), name="renamed")
    assert model.row_names == ("bearing[0]", "bearing[1]", "")
    assert pickle.loads(pickle.dumps(model)) == model
    assert model.canonical() != shaft(normal=(0, 1), holonomic_constraints=[x, y], name="renamed").canonical()
    assert model.forces == shaft(normal=(1, 0), holonomic_constraints=[x, y]).forces


def test_multipliers_are_named_behind_contacts_too():
    """Rows of contacts stand behind the holonomic ones, and before others."""
    model = Model(
        name="named", coordinates=[x, y], kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2, parameters={m: 1.0},
        holonomic_constraints={"guide": y}, nonholonomic_constraints={"drive": x.diff() - 1},
        contacts={"wall": Contact(x + 5)},
        outputs={"guide": multiplier("guide"), "drive": multiplier("drive", 0), "wall": multiplier("wall")},
    )  # fmt: skip
    assert model.outputs == (("guide", multiplier(0)), ("drive", multiplier(2)), ("wall", multiplier(1)))
    assert replace(model, outputs={"wall": multiplier("wall")}).outputs == (("wall", multiplier(1)),)
    assert model.row_names == ("guide", "", "drive")


def test_messages_speak_of_rows_by_name():
    system = shaft_system()
    assert system.row_names == ("bearing[0]", "bearing[1]", "row 2")
    with pytest.raises(ModelError, match=r"constraint bearing\[1\] by 0.1"):
        system.simulate((0.0, 1.0), x0=[0.0, 0.0, 0.1])


@pytest.mark.parametrize(("model", "words"), [
    (lambda: shaft(normal="bering"), "'bering'. Name a Contact or a constraint"),
    (lambda: shaft(normal=2), "those of frictions do not press"),
    (lambda: shaft(normal=("bearing", 0)), "has row 0 twice"),
    (lambda: shaft(normal=True), "normal of a friction"),
    (lambda: shaft(normal=()), "normal of a friction is ()"),
    (lambda: shaft(outputs={"N": multiplier("bearing")}), "which are 2 rows. Say which"),
    (lambda: shaft(outputs={"N": multiplier("bearing", 2)}), "row 2. It has 2, counted from 0"),
    (lambda: shaft(outputs={"N": multiplier("other", 2)}), "No constraint or contact has that name"),
    (lambda: shaft(holonomic_constraints={"rub": [x, y]}), "a name that is taken"),
    (lambda: shaft(holonomic_constraints={"bearing": []}), "has no row"),
    (lambda: shaft(holonomic_constraints={3: x}), "a Python identifier"),
    (lambda: shaft(forces={x: multiplier(0) ** 2}), "not linear in the multipliers"),
])  # fmt: skip
def test_what_is_refused(model, words):
    with pytest.raises(ModelError) as caught:
        system_for(model(), "lagrange")
    assert words in str(caught.value)


@pytest.mark.parametrize("law", ["newton", "poisson"])
@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_a_block_in_a_groove_bounces_and_slides_to_rest(law, method):
    """Its side is pressed by 3 N all along, its floor by impulses, then by its weight; both press by their norm."""
    z = dynamicsymbols("z")
    model = Model(
        name="groove", coordinates=[x, y, z], kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=m * g * y, forces={z: 3.0}, holonomic_constraints={"side": z},
        contacts={"rub": Friction(x.diff(), limit=mu, normal=("floor", "side")),
                  "floor": Contact(y, restitution=0.5, rest=1e-3, law=law)},
        parameters={m: 2.0, g: G, mu: 0.3}, initial={x.diff(): 5.0, y: 1.0})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 6.0), method=method, **TIGHT)
    flight, rises, v, far = np.sqrt(2 / G), G * np.sqrt(2 / G), 5.0, 0.0
    for bounce in range(13):
        far, v = far + v * flight - 0.45 * flight**2 / 2, v - 0.45 * flight
        v -= 0.3 * rises * (1.5 if bounce < 12 else 1.0)
        rises, flight = rises / 2, rises / G
    assert len(run.t_events[1]) == 13
    assert run.x[0, -1] == pytest.approx(far + v**2 / (0.3 * np.hypot(3.0, 2.0 * G)), rel=1e-9)
    assert run.v[0, -1] == 0.0
