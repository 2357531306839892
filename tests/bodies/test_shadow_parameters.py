"""Rotations of spherical and free joints through many turns, against quaternions, closed forms and Euler angles."""

from dataclasses import fields
from functools import lru_cache

import numpy as np
import pytest
from eigenmotion.codegen.equations.tree.shadow_parameters import rotations
from scipy.integrate import solve_ivp

import eigenmotion as em

INERTIA = np.array([1.0, 2.0, 2.5])
CENTER = np.array([0.1, -0.05, 0.2])
HOOK = np.array([0.3, 0.1, -0.2])
MASS, STIFFNESS, GRAVITY = 1.5, 6.0, 2.0
SPIN, PUSH = np.array([0.4, 2.2, -0.3]), np.array([0.5, 0.2, -0.1])
MARK = np.array([0.0, 0.0, -1.0])
END = 12.0
METHODS = ("dop853", "dopri5", "rk34", "ra15", "radau5", "radau9")
TIGHT = {"rtol": 1e-10, "atol": 1e-12}


def swinging_body(events=lambda body: {}):
    """A free body on a spring to the ground: n = 6; the angular velocity SPIN and the velocity PUSH at the start."""
    tree = em.Tree(gravity=(0, 0, -GRAVITY))
    body = tree.body("box", joint="free", mass=MASS, center=tuple(CENTER), inertia=tuple(INERTIA))
    hook, (x, y, z, *s) = body.position(tuple(HOOK)), tree.coordinates
    start = {q.diff(): rate for q, rate in zip((x, y, z, *s), (*PUSH, *SPIN / 4), strict=True)}
    return em.Model(
        name="swinging_body", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy + STIFFNESS * hook.dot(hook) / 2,
        outputs={f"R{i}{j}": body.rotation[i, j] for i in range(3) for j in range(3)}, initial=start,
        events=events(body),
    )  # fmt: skip


def marked_body():
    """The same with an event: a point of the body passes a height."""
    return swinging_body(events=lambda body: {"low": body.position(tuple(MARK))[2] + 0.4})


@lru_cache
def built(make, formulation, flags=None):
    return em.build(make(), formulation=formulation, flags=flags)


def rotation_of(q):
    """R (3, 3) of a unit quaternion w, x, y, z."""
    w, x, y, z = q
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def by_quaternion(_, y):
    """Rates of centre, velocity, quaternion and angular velocity in the body's axes, by Newton's and Euler's laws."""
    r, v, q, w = y[:3], y[3:6], y[6:10], y[10:]
    R = rotation_of(q / np.linalg.norm(q))
    arm = R @ (HOOK - CENTER)
    force = -STIFFNESS * (r + arm)
    torque = R.T @ np.cross(arm, force)
    spin = 0.5 * np.array([-q[1:] @ w, *(q[0] * w + np.cross(q[1:], w))])
    return np.concatenate([v, force / MASS - [0, 0, GRAVITY], spin, (np.cross(INERTIA * w, w) + torque) / INERTIA])


def height(_, y):
    return (y[:3] + rotation_of(y[6:10] / np.linalg.norm(y[6:10])) @ (MARK - CENTER))[2] + 0.4


@lru_cache
def truth(at=END):
    """Times (k,), R (k, 3, 3), the place of the body's origin (k, 3), and the times at which `height` is zero."""
    start = np.concatenate([CENTER, PUSH + np.cross(SPIN, CENTER), [1, 0, 0, 0], SPIN])
    times = np.linspace(0, at, 97)
    run = solve_ivp(by_quaternion, (0, at), start, t_eval=times, rtol=1e-13, atol=1e-14, method="DOP853", events=height)
    R = np.array([rotation_of(q / np.linalg.norm(q)) for q in run.y[6:10].T])
    return times, R, run.y[:3].T - R @ CENTER, run.t_events[0]


def rotations_of(run):
    return np.array([[run.outputs[f"R{i}{j}"] for j in range(3)] for i in range(3)]).transpose(2, 0, 1)


@pytest.mark.parametrize("formulation", ["eigenfactor", "articulated_body", "lagrange", "cholesky", "inverse"])
def test_a_body_turns_many_times(formulation):
    """By all methods, with the same motion as that by quaternions."""
    times, R, place, _ = truth()
    system = built(swinging_body, formulation)
    for method in METHODS:
        run = system.simulate((0, END), t_eval=times, method=method, **TIGHT)
        assert run.success
        assert np.abs(rotations_of(run) - R).max() < 3e-7, method
        assert np.abs(run.x[:3].T - place).max() < 3e-7, method
        jumps = np.abs(np.diff(run.x[3:], axis=1)).max(axis=0) > 1
        assert jumps.sum() >= 4


def test_the_motion_is_not_chaotic():
    """The tolerances of the other tests are those of the methods."""
    system = built(swinging_body, "articulated_body")
    S = system.simulate((0, END), sensitivities=["box_4'"], t_eval=[END], **TIGHT).sensitivity["box_4'"]
    assert np.abs(S.dx).max() < 1e4


def test_it_is_no_event_of_the_model():
    model = swinging_body()
    assert model.events == ()
    assert em.Model(**{field.name: getattr(model, field.name) for field in fields(model)}) == model
    assert rotations(model) == ((3, 4, 5),)


@pytest.mark.parametrize("method", ["dop853", "ra15"])
def test_rows_and_dense_output_are_one_motion(method):
    """Each change has a row before and a row after it, of the same rotation; dense output continues across it."""
    times, R, _, _ = truth()
    system = built(swinging_body, "articulated_body")
    run = system.simulate((0, END), method=method, dense_output=True, rtol=1e-9, atol=1e-11)
    twice = np.flatnonzero(np.diff(run.t) == 0)
    assert len(twice) >= 4
    s = run.x[3:]
    shadow = -s[:, twice] / (s[:, twice] ** 2).sum(axis=0)
    assert np.abs(s[:, twice + 1] - shadow).max() < 1e-14
    assert ((s[:, twice] ** 2).sum(axis=0) > 1.44).all()
    assert np.delete((s**2).sum(axis=0), twice).max() <= 1.44
    assert np.abs(rotations_of(run)[twice] - rotations_of(run)[twice + 1]).max() < 1e-14
    either = np.concatenate([run.t[twice] - 1e-9, run.t[twice] + 1e-9])
    near = np.array([system.pose("box", run.sol(one)[:6])[0] for one in either])
    assert np.abs(near[: len(twice)] - near[len(twice) :]).max() < 1e-7
    dense = np.array([system.pose("box", run.sol(one)[:6])[0] for one in times])
    assert np.abs(dense - R).max() < 1e-6


@pytest.mark.parametrize("method", ["dop853", "ra15"])
@pytest.mark.parametrize("formulation", ["eigenfactor", "articulated_body"])
def test_events_are_found_in_steps_that_leave_the_chart(formulation, method):
    expected = truth()[3]
    system = built(marked_body, formulation)
    run = system.simulate((0, END), method=method, **TIGHT)
    assert len(run.t_events[0]) == len(expected)
    assert np.abs(run.t_events[0] - expected).max() < 3e-7
    ends = np.flatnonzero(np.diff(run.t) == 0)
    inside = [np.any((run.t[k - 1] < expected) & (expected <= run.t[k])) for k in ends]
    loose = system.simulate((0, END), method="ra15", rtol=1e-4)
    ends = np.flatnonzero(np.diff(loose.t) == 0)
    inside += [np.any((loose.t[k - 1] < loose.t_events[0]) & (loose.t_events[0] <= loose.t[k])) for k in ends]
    assert any(inside)


@pytest.mark.parametrize("formulation", ["eigenfactor", "articulated_body"])
@pytest.mark.parametrize("make", [swinging_body, marked_body])
def test_lanes_have_the_numbers_of_single_runs(formulation, make):
    system = built(make, formulation, "-O0")
    times, pushes = truth()[0], np.linspace(-0.5, 0.5, 13)
    task = {"t_eval": times, "method": "dop853", "rtol": 1e-9, "atol": 1e-11}
    all_runs = em.simulate_ensemble(system, (0, END), v0={"box_5": pushes}, **task)
    assert all_runs.success.all()
    for k, push in enumerate(pushes):
        one = system.simulate((0, END), v0={"box_5": push}, **task)
        assert (one.nfev, one.nsteps) == (all_runs.nfev[k], all_runs.nsteps[k])
        assert np.abs(all_runs.x[k] - one.x).max() < 1e-8


@pytest.mark.parametrize("formulation", ["eigenfactor", "articulated_body"])
def test_sensitivities_go_through_changes(formulation):
    """Against central differences of runs at a tighter tolerance, as derivatives of rotations, places and times."""
    system = built(marked_body, formulation)
    ends, h = [3.0, 5.0], 1e-5
    names = ["box_2", "box_6'"]
    run = system.simulate((0, 5), t_eval=ends, sensitivities=names, **TIGHT)
    for name in names:
        which, key = ("v0", name[:-1]) if name.endswith("'") else ("x0", name)
        start = (*np.zeros(6), *PUSH, *SPIN / 4)[system.coordinates.index(key) + 6 * (which == "v0")]
        one, other = (
            system.simulate((0, 5), t_eval=ends, rtol=1e-13, atol=1e-14, **{which: {key: start + step}})
            for step in (-h, h)
        )
        S = run.sensitivity[name]
        for ours, low, high in ((S.dx, one.x, other.x), (S.dv, one.v, other.v)):
            assert np.abs(ours - (high - low) / (2 * h)).max() < 1e-6 * np.abs(ours).max()
        slope = (other.t_events[0] - one.t_events[0]) / (2 * h)
        assert np.abs(S.dt_events[0] - slope).max() < 1e-6 * np.abs(slope).max()


def test_sensitivities_at_every_step():
    """Rows before and after a change: directions that the derivative of the map takes into each other."""
    system = built(swinging_body, "articulated_body")
    run = system.simulate((0, 5), sensitivities=["box_6'"], rtol=1e-9, atol=1e-11)
    S, h = run.sensitivity["box_6'"], 1e-6
    twice = np.flatnonzero(np.diff(run.t) == 0)
    assert len(twice)

    def shadow(s, v):
        q = s @ s
        return np.concatenate([-s / q, -v / q + 2 * s * (s @ v) / q**2])

    for k in twice:
        s, v, ds, dv = run.x[3:, k], run.v[3:, k], S.dx[3:, k], S.dv[3:, k]
        expected = (shadow(s + h * ds, v + h * dv) - shadow(s - h * ds, v - h * dv)) / (2 * h)
        ours = np.concatenate([S.dx[3:, k + 1], S.dv[3:, k + 1]])
        assert np.abs(ours - expected).max() < 1e-6 * np.abs(expected).max()


@pytest.mark.parametrize("method", ["rk4", "dop853"])
def test_steppers_turn_and_can_be_restored(method):
    """Steppers, in lanes if their steps have a fixed size, against a single one; and from saved bytes."""
    system = built(swinging_body, "lagrange")
    speeds = [0.0, 0.2, 0.4]
    task = {"method": method} | ({"step": 1e-3} if method == "rk4" else TIGHT)
    many = system.steppers(3, v0={"box_4": speeds}, **task)
    many.advance(2.0)
    saved = many.save()
    many.advance(5.0)
    x = many.x.copy()
    many.restore(saved)
    many.advance(5.0)
    assert np.array_equal(many.x, x)
    for k, speed in enumerate(speeds):
        one = system.stepper(v0={"box_4": speed}, **task)
        largest = 0.0
        for t in np.arange(0.05, 5.01, 0.05):
            one.advance(t)
            largest = max(largest, np.linalg.norm(one.x[3:]))
        assert largest < 1.2
        R, place = system.pose("box", one.x)
        other, there = system.pose("box", x[k])
        assert np.abs(R - other).max() + np.abs(place - there).max() < 1e-7


def rolling_ball():
    """A ball of radius 0.5 rolls along (1, 2) on a floor: by a holonomic row and two rows on velocities."""
    tree = em.Tree()
    ball = tree.body("ball", joint="free", mass=2.0, inertia=(0.2, 0.2, 0.2))
    x, y, z, *s = tree.coordinates
    w = ball.angular_velocity
    start = zip((x, y, s[0], s[1]), (1.0, 2.0, -1.0, 0.5), strict=True)  # s' = omega / 4
    return em.Model(
        name="rolling_ball", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy, holonomic_constraints=[ball.position()[2] - 0.5],
        nonholonomic_constraints=[x.diff() - w[1] / 2, y.diff() + w[0] / 2],
        initial={z: 0.5, **{q.diff(): rate for q, rate in start}},
    )  # fmt: skip


@pytest.mark.parametrize("formulation", ["eigenfactor", "articulated_body"])
def test_a_ball_rolls_straight_on(formulation):
    """In lanes and alone: its place and its angle grow with time; the constraints hold in all parameters."""
    system, times = built(rolling_ball, formulation, "-O0"), np.linspace(0, 10, 101)
    direction = np.array([-2.0, 1.0, 0.0]) / np.sqrt(5)
    for method in ("dop853", "ra15", "radau9"):
        run = system.simulate((0, 10), t_eval=times, method=method, **TIGHT)
        assert np.abs(run.x[:2] - [times, 2 * times]).max() < 1e-8
        assert np.abs(run.constraint_residual).max() < 1e-12
        angle = 4 * np.arctan(direction @ run.x[3:])
        assert np.abs(np.sin((angle - 2 * np.sqrt(5) * times) / 2)).max() < 1e-8
    lanes = em.simulate_ensemble(system, (0, 10), x0={"ball_1": np.arange(9.0)}, t_eval=times, method="dop853", **TIGHT)
    alone = system.simulate((0, 10), t_eval=times, method="dop853", **TIGHT)
    assert np.abs(lanes.x[:, 0] - (np.arange(9.0)[:, None] + times)).max() < 1e-8
    assert np.abs(lanes.x[:, 1:] - alone.x[1:]).max() < 1e-9


def bouncing_box():
    """A box that falls on its corners."""
    tree = em.Tree()
    box = tree.body("box", joint="free", mass=2.0, inertia=(0.1, 0.15, 0.2))
    _, _, z, *s = tree.coordinates
    corners = [(x, y, w) for x in (-0.3, 0.3) for y in (-0.2, 0.2) for w in (-0.1, 0.1)]
    gaps = {f"corner {k}": box.position(corner)[2] for k, corner in enumerate(corners)}
    spin = {q.diff(): rate for q, rate in zip(s, (0.9, 1.3, -0.4), strict=True)}
    return em.Model(
        name="bouncing_box", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy, initial={z: 1.5, **spin},
        events={name: em.Event(gap, direction=-1, impact=(gap, 0.6)) for name, gap in gaps.items()},
        outputs=gaps | {"turned": (box.rotation[0, 0] + box.rotation[1, 1] + box.rotation[2, 2]) / 3},
    )  # fmt: skip


def test_impacts_and_changes_follow_each_other():
    """No corner is below the ground, at rows of any method, and directions go through both."""
    system, at, h = built(bouncing_box, "articulated_body"), np.linspace(0, 2, 81), 1e-6
    runs = [system.simulate((0, 2), t_eval=at, method=method, **TIGHT) for method in ("dop853", "ra15", "radau9")]
    assert (np.abs(np.diff(runs[0].x[3:], axis=1)).max(axis=0) > 0.8).sum() >= 2
    assert sum(map(len, runs[0].t_events)) == 8
    for run in runs:
        for name, values in run.outputs.items():
            assert name == "turned" or values.min() > -1e-9
            assert np.abs(values - runs[0].outputs[name]).max() < 1e-7
    S = system.simulate((0, 1.5), t_eval=[1.5], sensitivities=["box_5'"], **TIGHT).sensitivity["box_5'"].dx
    low, high = (
        system.simulate((0, 1.5), t_eval=[1.5], rtol=1e-13, atol=1e-14, v0={"box_5": 1.3 + step}).x for step in (-h, h)
    )
    assert np.abs(S - (high - low) / (2 * h)).max() < 1e-6 * np.abs(S).max()


def test_runs_are_compared_in_the_same_parameters():
    """The error that a second run shows, at rows and times where one of them has changed and the other has not."""
    times, R, _, _ = truth()
    system = built(swinging_body, "articulated_body")
    loose = {"rtol": 1e-6, "atol": 1e-8, "estimate_error": True}
    run = system.simulate((0, END), t_eval=times, **loose)
    error = np.abs(rotations_of(run) - R).max()
    assert 0.1 * error < run.error_estimate.scaled_largest < 10 * error
    every = system.simulate((0, END), **loose)
    assert 0.1 * error < every.error_estimate.scaled_largest < 10 * error


def test_a_motion_turns_back():
    system = built(swinging_body, "articulated_body")
    there = system.simulate((0, END), **TIGHT)
    back = system.simulate((END, 0), start=there, **TIGHT)
    assert (np.diff(back.t) == 0).sum() >= 4
    assert np.abs(back.x[:, -1]).max() < 1e-5
    assert np.abs(back.v[:, -1] - [*PUSH, *SPIN / 4]).max() < 1e-5


def test_a_unit_turns(tmp_path):
    """Its C, compiled as a whole, told in steps of 62.5 ms."""
    fmpy = pytest.importorskip("fmpy")
    times, R, _, _ = truth()
    path = em.export_fmu(swinging_body(), tmp_path / "body.fmu", formulation="articulated_body", rtol=1e-9)
    rows = fmpy.simulate_fmu(str(path), stop_time=END, output_interval=END / 192, relative_tolerance=1e-10)
    at = np.searchsorted(rows["time"], times - 1e-9)
    assert np.abs(rows["time"][at] - times).max() < 1e-9
    assert np.abs(rows["R01"][at] - R[:, 0, 1]).max() < 1e-5
    assert np.abs(np.diff(rows["box_5"])).max() > 0.8


def spinning(name, **more):
    """A body that turns about one axis: at angle 0.3 + 2 t."""
    tree = em.Tree()
    body = tree.body("top", joint="spherical", mass=1.0, inertia=tuple(INERTIA))
    s = tree.coordinates
    more = {key: value(body, s) for key, value in more.items()}
    start = {s[0]: np.tan(0.3 / 4), s[0].diff(): 0.5 * (1 + np.tan(0.3 / 4) ** 2)}
    return em.Model(name=name, coordinates=s, kinetic_energy=tree.kinetic_energy, initial=start, **more)


def test_a_function_of_the_parameters_is_no_event_where_they_change():
    """The quaternion changes its sign there; it is zero where sin(angle / 2) is."""
    system = em.build(spinning("spinning", events=lambda body, s: {"upright": body.quaternion[1]}))
    run = system.simulate((0, 10), **TIGHT)
    assert run.t_events[0] == pytest.approx((2 * np.pi * np.arange(1, 4) - 0.3) / 2, abs=1e-8)
    assert (np.diff(run.t) == 0).sum() == 3


def test_parameters_stay_where_the_shadow_has_another_motion():
    """A spring of the parameters themselves: from its energy, up to the largest rotation; `left_out` says so."""
    k = 0.02
    model = spinning("wound", potential_energy=lambda body, s: k * s[0] ** 2 / 2)
    assert rotations(model) == ()
    system = em.build(model)
    assert any("shadow set of top_1, top_2, top_3" in line for line in system.left_out)
    run = system.simulate((0, 30), dense_output=True, **TIGHT)
    energy = 2.0**2 * INERTIA[0] / 2 + k * np.tan(0.3 / 4) ** 2 / 2
    assert run.success
    assert 2 < run.x[0].max() <= np.sqrt(2 * energy / k) * (1 + 1e-9)
    assert np.abs(np.diff(run.x[0])).max() < 5
    angle, rate = 4 * np.arctan(run.x[0]), 4 * run.v[0] / (1 + run.x[0] ** 2)
    assert np.abs(INERTIA[0] * rate**2 / 2 + k * np.tan(angle / 4) ** 2 / 2 - energy).max() < 1e-7


def torque_about(body, s, torque):
    """Forces on the parameters of a torque in the axes of the ground."""
    return {q: sum(T * w.diff(q.diff()) for T, w in zip(torque, body.angular_velocity, strict=True)) for q in s}


INVARIANT = {
    "a torque": lambda body, s: {"forces": torque_about(body, s, (0.1, -0.2, 0.3))},
    "friction in the air": lambda body, s: {"forces": torque_about(body, s, -body.angular_velocity)},
    "an even function of the quaternion": lambda body, s: {"potential_energy": body.quaternion[1] ** 2},
    "a row": lambda body, s: {"nonholonomic_constraints": [body.angular_velocity[2]]},
    "a row by hand": lambda body, s: {"nonholonomic_constraints": [body.rotation[0, 0].diff(em.t)]},
}
VARYING = {
    "friction of the parameters": lambda body, s: {"forces": {q: -q.diff() for q in s}},
    "a spring": lambda body, s: {"potential_energy": s[1] ** 2},
    "the sign of the quaternion": lambda body, s: {"potential_energy": body.quaternion[0]},
    "a torque along the quaternion": lambda body, s: {"forces": torque_about(body, s, body.quaternion[1:, 0])},
    "a row": lambda body, s: {"nonholonomic_constraints": [s[0].diff() - s[1].diff()]},
    "a mass": lambda body, s: {"kinetic_energy": s[0].diff() ** 2},
}


@pytest.mark.parametrize(("case", "stays"), [(one, False) for one in INVARIANT] + [(one, True) for one in VARYING])
def test_what_has_the_same_motion_in_the_shadow_set(case, stays):
    tree = em.Tree()
    body = tree.body("top", joint="spherical", mass=1.0, inertia=tuple(INERTIA), center=(0.1, 0.2, 0))
    own = (VARYING if stays else INVARIANT)[case](body, tree.coordinates)
    own["kinetic_energy"] = tree.kinetic_energy + own.get("kinetic_energy", 0)
    model = em.Model(name="top", coordinates=tree.coordinates, **own)
    assert rotations(model) == (() if stays else ((0, 1, 2),))


def test_bodies_of_two_trees_with_the_same_parameters():
    """One rotation if both turn with them; none if a hinge has one of them as its angle."""
    one, other, third = em.Tree(), em.Tree(), em.Tree()
    first = one.body("one", joint="spherical", mass=1.0, inertia=(1, 1, 1))
    same = other.body("other", joint="spherical", coordinates=first.coordinates)
    hinge = third.body("hinge", joint="revolute", coordinates=first.coordinates[:1])
    for body, expected in ((same, ((0, 1, 2),)), (hinge, ())):
        model = em.Model(name="both", coordinates=one.coordinates, kinetic_energy=one.kinetic_energy,
                         potential_energy=body.position((1, 0, 1))[2])  # fmt: skip
        assert rotations(model) == expected


def random_tree(seed, joints):
    """A tree of three bodies, and the rates at its start; `joints` adds each joint to a tree and returns its rates."""
    chance = np.random.default_rng(seed)
    tree = em.Tree(gravity=tuple(chance.normal(size=3)))
    rates, above = {}, None
    for number in range(3):
        kind = "free" if number == 0 and seed % 2 else "spherical"
        own = {"mass": chance.uniform(0.5, 2), "center": chance.normal(size=3) / 10,
               "inertia": chance.uniform(0.3, 0.5, size=3) * (1, 1, 2)}  # fmt: skip
        at, slide, spin = chance.normal(size=3) / 3, chance.normal(size=3), chance.normal(size=3) / 4
        spin[2] = chance.choice([-5, 5])
        above, more = joints(tree, f"b{number}", above, kind, at, own, slide, spin)
        rates |= more
    return tree, rates


def by_parameters(tree, name, parent, kind, at, own, slide, spin):
    body = tree.body(name, parent, joint=kind, at=at, **own)
    rates = (*slide, *spin / 4) if kind == "free" else spin / 4
    return body, {q.diff(): rate for q, rate in zip(body.coordinates, rates, strict=True)}


def by_hinges(tree, name, parent, kind, at, own, slide, spin):
    """The same with hinges about z, y and x, which have other singularities."""
    rates = {}
    for axis, rate in zip("xyz", slide, strict=True) if kind == "free" else ():
        parent = tree.body(f"{name}_{axis}", parent, joint="prismatic", axis=axis, at=at)
        at, rates = (0, 0, 0), rates | {parent.coordinates[0].diff(): rate}
    for axis in "zyx":
        last = axis == "x"
        parent = tree.body(name if last else f"{name}_turn_{axis}", parent, joint="revolute", axis=axis, at=at,
                           **own if last else {})  # fmt: skip
        at, rates = (0, 0, 0), rates | {parent.coordinates[0].diff(): spin["xyz".index(axis)]}
    return parent, rates


@pytest.mark.parametrize("seed", [0, 1, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(2, 24))])
def test_random_trees_turn_as_those_with_hinges(seed):
    """Places of all bodies, over two turns of a joint and more; some only swing, which the others make up for."""
    times, runs, poses = np.linspace(0, 3, 31), [], []
    for joints in (by_parameters, by_hinges):
        tree, rates = random_tree(seed, joints)
        model = em.Model(name="turning", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                         potential_energy=tree.potential_energy, initial=rates)  # fmt: skip
        system = em.build(model, formulation="articulated_body" if seed % 3 else "lagrange")
        runs.append(system.simulate((0, 3), t_eval=times, rtol=1e-11, atol=1e-12))
        poses.append([system.pose(f"b{number}", runs[-1].x) for number in range(3)])
    assert all(run.success for run in runs)
    for (R, place), (other, there) in zip(*poses, strict=True):
        assert np.abs(R - other).max() < 1e-6
        assert np.abs(place - there).max() < 1e-6
    assert sum(np.count_nonzero(np.abs(np.diff(s)) > 0.5) for s in runs[0].x) >= 3  # changes of charts
