"""Inverse dynamics with closed contacts: statics, runs that decide their own mode, and conditions of optimality."""

import dataclasses

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson
from scipy.optimize import linprog, nnls
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.analysis.inverse.least_forces import least_forces

from ..support.generation import system_for

G = 9.81


def block(mu=0.5, slope=0.0):
    """A block of mass 2 on a plane that rises by `slope` along x, with a motor on x and a crane on z."""
    x, z, u, w = dynamicsymbols("x z u w")
    return em.Model(
        name="block", coordinates=[x, z], kinetic_energy=x.diff() ** 2 + z.diff() ** 2,
        potential_energy=2 * G * (float(np.cos(slope)) * z + float(np.sin(slope)) * x), forces={x: u, z: w},
        inputs={u: 0.0, w: 0.0}, contacts={"floor": em.Contact(z), "rub": em.Friction(x.diff(), mu, "floor")},
    )  # fmt: skip


@pytest.mark.parametrize("speed", [1.5, -0.3])
def test_a_block_that_slides(speed):
    system = system_for(block())
    found = system.inverse_dynamics([0.0, 0.0], [speed, 0.0], [3.0, 0.0], actuators=["u"])
    assert found.forces == pytest.approx([6.0 + np.sign(speed) * 0.5 * 2 * G], rel=1e-13)
    assert found.multipliers[0] == pytest.approx(-2 * G, rel=1e-13)
    begins = system.inverse_dynamics([0.0, 0.0], [0.0, 0.0], [3.0, 0.0], actuators=["u"])
    assert begins.forces == pytest.approx([6.0 + 0.5 * 2 * G], rel=1e-13)


@pytest.mark.parametrize("slope", [0.2, 0.9, -0.9])
def test_a_block_that_rests_needs_what_friction_does_not_give(slope):
    system = system_for(block(0.5, slope))
    found = system.inverse_dynamics([0.0, 0.0], [0.0, 0.0], [0.0, 0.0], actuators=["u"])
    lacks = 2 * G * max(np.sin(abs(slope)) - 0.5 * np.cos(slope), 0.0)
    assert found.forces == pytest.approx([np.sign(slope) * lacks], abs=1e-12)
    assert found.multipliers[0] == pytest.approx(-2 * G * np.cos(slope), rel=1e-12)


def test_contacts_do_not_pull():
    system = system_for(block())
    lifted = system.inverse_dynamics([0.0, 0.0], [0.0, 0.0], [0.0, 1.0], actuators=["u", "w"])
    assert lifted.forces == pytest.approx([0.0, 2 * (G + 1)])
    assert not lifted.multipliers.any()
    with pytest.raises(em.ModelError, match="leads into contact 'floor'"):
        system.inverse_dynamics([0.0, 0.0], [0.0, 0.0], [0.0, -1.0], actuators=["u", "w"])
    with pytest.raises(em.ModelError, match="leads into contact 'floor'"):
        system.inverse_dynamics([0.0, 0.0], [0.0, -1.0], [0.0, 0.0], actuators=["u", "w"])
    with pytest.raises(em.ModelError, match=r"'floor' is closed, .* Name the actuators"):
        system.inverse_dynamics([0.0, 0.0], [0.0, 0.0], [0.0, 0.0])
    model = block()
    rise = -30 * model.coordinates[1]
    balloon = dataclasses.replace(model, name="balloon", potential_energy=rise)
    with pytest.raises(em.ModelError, match="contact 'floor' would have to pull: no forces of u give this motion"):
        system_for(balloon).inverse_dynamics([0.0, 0.0], [0.0, 0.0], [0.0, 0.0], actuators=["u"])
    held = system_for(balloon).inverse_dynamics([0.0, 0.0], [0.0, 0.0], [0.0, 0.0], actuators=["u", "w"])
    assert held.forces == pytest.approx([0.0, -30.0])


def test_derivatives_inside_the_bounds():
    """The block pushed along a slope: 2 a + friction; at the limit of friction there are none."""
    system = system_for(block(0.5, 0.2))
    found = system.inverse_dynamics_derivatives([0, 0], [0.4, 0], [1.0, 0], actuators=["u"], by=[])
    assert found.da == pytest.approx(np.array([[2.0, 0.5 * 2.0]]))  # of z with the push, and so the friction
    system = system_for(block(0.5, 0.9))
    with pytest.raises(em.ModelError, match="friction 'rub' is at its limit, where forces have no derivatives"):
        system.inverse_dynamics_derivatives([0, 0], [0, 0], [0, 0], actuators=["u"])


def walker(feet=2):
    """A trunk in a plane on legs of two joints, with a motor in each joint; feet rub on the floor."""
    x, y, turn = dynamicsymbols("x y turn")
    joints, motors = dynamicsymbols(f"q:{2 * feet}"), dynamicsymbols(f"u:{2 * feet}")
    t, contacts, T, V = em.t, {}, 3 * (x.diff() ** 2 + y.diff() ** 2) + turn.diff() ** 2 / 8, 6 * G * y
    for k in range(feet):
        place = np.array([x, y]) + (k - (feet - 1) / 2) * np.array([cos(turn), sin(turn)])
        angle = turn
        for q, mass in zip(joints[2 * k : 2 * k + 2], (0.8, 0.4), strict=True):
            angle = angle + q
            along = np.array([sin(angle), -cos(angle)]) / 2
            middle = place + along / 2
            T += mass * sum(one.diff(t) ** 2 for one in middle) / 2 + mass * angle.diff(t) ** 2 / 100
            V += mass * G * middle[1]
            place = place + along
        contacts[f"foot{k}"] = em.Contact(place[1])
        contacts[f"rub{k}"] = em.Friction(place[0].diff(t), symbols("mu"), f"foot{k}")
    return em.Model(name=f"walker{feet}", coordinates=[x, y, turn, *joints], kinetic_energy=T, potential_energy=V,
                    forces=dict(zip(joints, motors, strict=True)), inputs=dict.fromkeys(motors, 0.0),
                    parameters={symbols("mu"): 0.6}, contacts=contacts)  # fmt: skip


def standing(feet, knees):
    """x (n,) of a walker whose trunk is level, with every foot below its hip: joints bend by `knees`."""
    joints = np.concatenate([[-knee, 2 * knee] for knee in knees])
    return np.array([0.0, np.cos(knees[0]), 0.0, *joints])


@pytest.mark.parametrize("seed", range(4))
def test_forces_of_a_motion_that_decided_its_own_contacts(seed):
    """Random torques of a hopper on one foot, at rest: the foot sticks, slides or lifts off as it must."""
    system, random = system_for(walker(1), "lagrange"), np.random.default_rng(seed)
    seen = set()
    for _ in range(30):
        x, u = standing(1, [random.uniform(0.3, 1.0)]), random.normal(0, 20, 2)
        torques = dict(zip(system.inputs, u, strict=True))
        run = system.simulate((0.0, 1e-9), x0=x, inputs=torques, method="rk34", max_step=1e-9)
        a, multipliers = run.trajectory.accelerations[-1], run.trajectory.multipliers[-1]
        mode = tuple(run.modes[-1][1][name] for name in ("foot0_held", "rub0_stuck", "rub0_slides"))
        seen.add(mode)
        found = system.inverse_dynamics(x, np.zeros(5), a, actuators=tuple(system.inputs))
        if mode[1]:  # the motor torques of a foot that sticks are those of least squares
            assert np.linalg.norm(found.forces) <= np.linalg.norm(u) * (1 + 1e-9)
        else:
            assert found.forces == pytest.approx(u, abs=1e-8 * np.abs(u).max())
            assert found.multipliers[0] == pytest.approx(multipliers[0], abs=1e-7 * (1 + np.abs(multipliers).max()))
    assert len(seen) > 2


@pytest.mark.parametrize("feet", [2, 3])
def test_a_walker_stands_and_crouches_on_its_feet(feet):
    """The torques of a crouch: forward, in the mode that a run decides, they give its accelerations and reactions."""
    system, knee = system_for(walker(feet), "lagrange"), 0.6
    x, rate, more = standing(feet, [knee] * feet), 0.7, -2.0
    bend = np.array([-1.0, 2.0] * feet)
    v = np.array([0.0, -np.sin(knee) * rate, 0.0, *(bend * rate)])
    a = np.array([0.0, -np.sin(knee) * more - np.cos(knee) * rate**2, 0.0, *(bend * more)])
    found = system.inverse_dynamics(x, v, a, actuators=tuple(system.inputs))
    assert (found.multipliers[:feet] < 0.0).all()
    weight = 6.0 + 1.2 * feet
    assert -found.multipliers[:feet].sum() > 0.5 * weight * G
    run = system.simulate((0.0, 1e-9), x0=x, v0=v, inputs=dict(zip(system.inputs, found.forces, strict=True)),
                          method="rk34", max_step=1e-9)  # fmt: skip
    assert run.trajectory.accelerations[-1] == pytest.approx(a, abs=1e-6 * np.abs(a).max())
    derivatives = system.inverse_dynamics_derivatives(x, v, a, actuators=tuple(system.inputs), by=["mu"])
    assert np.abs(derivatives.by["mu"]).max() < 1e-9 * np.abs(found.forces).max()


def test_a_drive_stands_on_the_floor():
    system, t = system_for(walker(2), "lagrange"), em.t
    knee = 0.6 + 0.2 * sin(3 * t)
    paths = {"x": 0, "y": cos(knee), "turn": 0, "q0": -knee, "q1": 2 * knee, "q2": -knee, "q3": 2 * knee}
    squat = em.drive(system, np.linspace(0.0, 2.0, 401), paths, actuators=tuple(system.inputs))
    assert (squat.multipliers[:2] < 0.0).all()
    T_and_V = [system.energy(x, v) for x, v in zip(squat.x.T, squat.v.T, strict=True)]
    work = cumulative_simpson(squat.power.sum(axis=0), x=squat.t, initial=0.0)
    assert np.abs(work - (np.array(T_and_V) - T_and_V[0])).max() < 1e-6 * np.ptp(T_and_V)


@pytest.mark.parametrize("seed", range(120))
def test_least_forces_satisfy_the_conditions_of_optimality(seed):
    """Karush-Kuhn-Tucker conditions, which are sufficient; without forces linear programming finds none either."""
    random = np.random.default_rng(seed)
    n, count, m, bounds = random.integers([3, 1, 1, 1], [8, 6, 6, 7])
    B, P, r = random.normal(size=(n, count)), random.normal(size=(m, n)), random.normal(size=n)
    if random.random() < 0.7:  # a choice, of multipliers too
        P[-1] = P[0]
        r = B @ random.normal(size=count) - P.T @ random.normal(size=m)
    G, w = random.normal(size=(bounds, m)), random.uniform(0.1, 9, count)
    units = 10.0 ** random.uniform(-6, 6, m)
    P, G = P * units[:, None], G * units
    found = least_forces(B, P, r, G, w)
    K = np.hstack([B, -P.T / units])
    below = -np.hstack([np.zeros((bounds, count)), G / units])
    feasible = linprog(np.zeros(count + m), A_ub=below, b_ub=np.zeros(bounds), A_eq=K, b_eq=r, bounds=(None, None))
    assert (found is not None) == (feasible.status == 0)
    if found is None:
        return
    tau, multipliers = found
    assert np.abs(B @ tau - P.T @ multipliers - r).max() < 1e-9
    margin = G @ multipliers / np.linalg.norm(G / units, axis=1)
    assert (margin > -1e-8 * (1 + np.abs(multipliers * units).max())).all()
    active = margin < 1e-7
    stationary = np.concatenate([w * tau, np.zeros(m)])  # = K^T mu + (0, G^T u), u >= 0 on the active bounds
    columns = np.hstack([K.T, -K.T, np.vstack([np.zeros((count, bounds)), (G / units).T])[:, active]])
    assert nnls(columns / np.linalg.norm(columns, axis=0), stationary)[1] < 1e-7 * np.linalg.norm(stationary) + 1e-9


def skid(cone=False, at_rest=None, push=0.0):
    """A block on a floor, free in space, pushed along x."""
    x, y, z = dynamicsymbols("x y z")
    slips = (x.diff(), y.diff()) if cone else x.diff()
    rub = em.Friction(slips, 0.3, "floor", **({} if at_rest is None else {"limit_at_rest": at_rest}))
    return em.Model(
        name="skid", coordinates=[x, y, z], kinetic_energy=x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2,
        potential_energy=2 * G * z - push * x, contacts={"floor": em.Contact(z), "rub": rub},
    )  # fmt: skip


@pytest.mark.parametrize("cone", [False, True])
@pytest.mark.parametrize("z", [0.0, 0.5])
@pytest.mark.parametrize("v", [(0, 0, 0), (1, 0, 0), (1, -2, 0.5)])
def test_open_contacts_press_no_friction(z, v, cone):
    """In flight, and as it lifts off, forces are M a + gravity."""
    a = np.array([2.0, -1.0, 1.0])
    system = system_for(skid(cone))
    found = system.inverse_dynamics([0, 0, z], v, a, actuators=("x", "y", "z"))
    assert found.forces == pytest.approx(2 * a + [0, 0, 2 * G], rel=1e-13)
    assert not found.multipliers.any()
    derivatives = system.inverse_dynamics_derivatives([0, 0, z], v, a, actuators=("x", "y", "z"))
    assert derivatives.da == pytest.approx(2 * np.eye(3))
    assert not derivatives.dv.any()


@pytest.mark.parametrize("cone", [False, True])
@pytest.mark.parametrize(("push", "lacks"), [(8.0, 0.0), (-8.0, 0.0), (13.0, 13.0 - 0.6 * 2 * G)])
def test_frictions_that_stick_have_their_own_limit(push, lacks, cone):
    system = system_for(skid(cone, 0.6, push))
    found = system.inverse_dynamics([0, 0, 0], [0, 0, 0], [0, 0, 0], actuators=("x",))
    assert found.forces == pytest.approx([-lacks], abs=1e-8)
    if lacks == 0.0:
        derivatives = system.inverse_dynamics_derivatives([0, 0, 0], [0, 0, 0], [0, 0, 0], actuators=("x", "y"))
        assert not derivatives.dx.any()


@pytest.mark.parametrize("push", [3.0, 6.0, 9.0, 9.7])
def test_a_box_on_two_feet_with_cones(push):
    """Feet share the load so that each is within its cone; 0.5 m g = 9.81 N is the most."""
    x, y, z, tilt = dynamicsymbols("x y z tilt")
    feet = {}
    for name, side in (("l", -1), ("r", 1)):
        feet[f"foot{name}"] = em.Contact(z + side * sin(tilt) / 5 - 0.3 * cos(tilt))
        slips = ((x + side * cos(tilt) / 5 + 0.3 * sin(tilt)).diff(em.t), y.diff())
        feet[f"rub{name}"] = em.Friction(slips, 0.5, f"foot{name}")
    V = 2 * G * z - symbols("push") * x
    box = em.Model(name="box", coordinates=[x, y, z, tilt], potential_energy=V, contacts=feet,
                   kinetic_energy=x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2 + tilt.diff() ** 2 / 20,
                   parameters={symbols("push"): 3.0}, initial={z: 0.3})  # fmt: skip
    system, still = system_for(box), [0.0] * 4
    at = [0, 0, 0.3, 0], still, still
    found = system.inverse_dynamics(*at, actuators=("tilt",), parameters={"push": push})
    assert found.forces == pytest.approx([0.0], abs=1e-7)
    with pytest.raises(em.ModelError, match="would have to take more than its limit: no forces of tilt"):
        system.inverse_dynamics(*at, actuators=("tilt",), parameters={"push": 9.9})
    helped = system.inverse_dynamics(*at, actuators=("x",), parameters={"push": 12.0})
    assert helped.forces == pytest.approx([9.81 - 12.0], abs=1e-7)


def test_places_inside_a_contact_and_no_states():
    system = system_for(skid())
    with pytest.raises(em.ModelError, match=r"x is inside contact 'floor': its gap is -0\.5"):
        system.inverse_dynamics([0, 0, -0.5], [0, 0, 0], [0, 0, 0], actuators=("x",))
    none = np.zeros((3, 0))
    assert system.inverse_dynamics(none, none, none, actuators=("x",)).forces.shape == (1, 0)


def test_a_run_that_comes_to_rest_takes_no_forces():
    """Accelerations at rest are rounding."""
    for cone in (False, True):
        system = system_for(skid(cone))
        run = system.simulate((0, 3), x0={"z": 1.0}, v0={"x": 6.0, "y": 0.5}, t_eval=np.linspace(0, 3, 31), rtol=1e-9)
        for k in range(31):
            a = run.trajectory.accelerations[k]
            found = system.inverse_dynamics(run.x[:, k], run.v[:, k], a, actuators=("x", "y", "z"))
            assert np.abs(found.forces).max() < 1e-6, k
