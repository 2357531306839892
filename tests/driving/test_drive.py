"""Prescribed motions against closed forms, power balances, and runs with the forces found."""

import pickle
from dataclasses import replace
from functools import cache
from importlib import import_module

import numpy as np
import pytest
import sympy
from scipy.integrate import trapezoid
from scipy.interpolate import make_interp_spline
from sympy import asin, cos, sin, sqrt
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.cli.simulation.drive import summary

from ..support.generation import system_for
from . import linkages


@cache
def built(name, **options):
    return em.build(getattr(linkages, name)() if hasattr(linkages, name) else f"models/{name}.py", **options)


def forward(system, driven, names, rtol=1e-12):
    """The motion with the forces found as cubic signals, without feedback."""
    signals = {name: em.Signal(driven.t, row, kind="cubic") for name, row in zip(names, driven.forces, strict=True)}
    start = system.project_initial_state(driven.x[:, 0], driven.v[:, 0])
    return system.simulate((driven.t[0], driven.t[-1]), x0=start.x, v0=start.v, inputs=signals, t_eval=driven.t[::100],
                           rtol=rtol, atol=1e-13)  # fmt: skip


def motions():
    """Model -> (its motors, a path of its freedoms)."""
    t = em.t
    legs = {f"platform_{k + 1}": (0.8 if k == 2 else 0.0) + 0.05 * sin((1 + 0.3 * k) * t) for k in range(6)}
    return {
        "six_bar": (("u0",), {"q1": 0.9 + 2 * t + 0.2 * sin(3 * t)}),
        "delta": (("u_a", "u_b", "u_c"),
                  {"x": 0.1 * sin(2 * t), "y": 0.05 * sin(3 * t), "z": -0.45 + 0.05 * sin(t)}),
        "stewart": (tuple(f"u{k}" for k in range(6)), legs),
    }  # fmt: skip


@pytest.mark.parametrize("name", [*motions()])
def test_a_run_with_the_forces_stays_on_the_path(name):
    """A short time; ten seconds by night."""
    seconds, (names, path) = 0.5, motions()[name]
    system = built(name)
    driven = em.drive(system, np.linspace(0.0, seconds, round(1000 * seconds) + 1), path, actuators=names)
    run = forward(system, driven, names)
    assert run.success
    assert np.abs(run.x - driven.x[:, ::100]).max() < 1e-9
    energy = run.energy
    work = trapezoid(driven.power.sum(axis=0), driven.t)
    assert abs(work - (energy[-1] - energy[0])) < 1e-5 * np.abs(driven.power).max() * seconds


def growth(system, driven, names, size=1e-8):
    """How much a deviation of the start grows until each row; infinite from where it is no longer small."""
    signals = {name: em.Signal(driven.t, row, kind="cubic") for name, row in zip(names, driven.forces, strict=True)}
    options = {"inputs": signals, "t_eval": driven.t[::100], "rtol": 1e-12, "atol": 1e-13}
    runs = []
    for factor in (1.0, 1.0 + size):
        start = system.project_initial_state(driven.x[:, 0], driven.v[:, 0] * factor)
        runs.append(system.simulate((driven.t[0], driven.t[-1]), x0=start.x, v0=start.v, **options).x)
    apart = np.maximum.accumulate(np.abs(runs[1] - runs[0]).max(axis=0))
    return np.where(apart < 1e-2, np.maximum(1.0, apart / size), np.inf)


@pytest.mark.nightly("ten thousand positions, and runs")
@pytest.mark.parametrize("name", [*motions()])
def test_ten_seconds_with_the_forces_stay_on_the_path(name):
    """To 1e-9, times the growth of a deviation, which is measured: machines that carry their platform are unstable."""
    names, path = motions()[name]
    system = built(name)
    driven = em.drive(system, np.linspace(0.0, 10.0, 10001), path, actuators=names)
    run = forward(system, driven, names)
    assert run.success
    off, grown = np.abs(run.x - driven.x[:, ::100]).max(axis=0), growth(system, driven, names)
    print(name, "stays within", off[np.isfinite(grown)].max(), "until", run.t[np.isfinite(grown)][-1])
    assert np.isfinite(grown).sum() > 20
    assert (off < 1e-9 * grown).all()


def along(expressions, t, times, order=0):
    """Derivatives of expressions in t, (count, k)."""
    table = [sympy.lambdify(t, sympy.sympify(one).diff(t, order), "numpy") for one in expressions]
    return np.array([function(times) * np.ones_like(times) for function in table])


def test_slider_crank_against_its_closed_form():
    """All coordinates, rates and second rates, and the torque from the power balance."""
    system, shown = built("slider_crank", formulation="lagrange"), import_module("eigenmotion.models.slider_crank")
    r, l, t = shown.crank_length, shown.rod_length, em.t
    theta = 0.3 + 2 * t + sin(3 * t) / 5
    phi = asin(r * sin(theta) / l)
    pose = [theta, phi, r * cos(theta) + l * cos(phi)]
    times = np.linspace(0.0, 3.0, 301)
    driven = em.drive(system, times, {"theta": theta})
    for order, found in enumerate((driven.x, driven.v, driven.a)):
        assert np.abs(found - along(pose, t, times, order)).max() < 1e-13 * 10.0**order
    model = shown.model
    energy = (model.kinetic_energy + model.potential_energy).subs(dict(zip(model.coordinates, pose, strict=True)))
    power = along([energy.doit().subs(dict(model.parameters))], t, times, 1)
    assert np.abs(driven.power - power).max() < 1e-11 * np.abs(power).max()
    assert np.abs(driven.forces * driven.v[0] - power).max() < 1e-11 * np.abs(power).max()


@pytest.mark.parametrize("mu", [0.0, 0.1])
def test_torque_of_the_quick_return_shaper_against_the_balance_of_powers(mu):
    """Drive + motor = rate of the energy + tool + friction, with the kinematics in closed form."""
    system, shown = built("quick_return_shaper"), import_module("eigenmotion.models.quick_return_shaper")
    t = em.t
    turn = 0.2 + 6 * t + sin(5 * t) / 10
    pose = [sympy.sympify(one).subs(shown.LENGTHS).subs(shown.angle, turn) for one in shown.closed_loops()]
    times = np.linspace(0.0, 0.4, 41)  # the lever stays on one branch of atan2
    driven = em.drive(system, times, {"theta": turn}, parameters={"mu": mu})
    x, v = along(pose, t, times), along(pose, t, times, 1)
    assert np.abs(driven.x - x).max() < 1e-12 * np.abs(x).max()
    assert np.abs(driven.v - v).max() < 1e-12 * np.abs(v).max()
    model = shown.model
    energy = (model.kinetic_energy + model.potential_energy).subs(dict(zip(model.coordinates, pose, strict=True)))
    rate = along([energy.doit().subs(dict(model.parameters))], t, times, 1)[0]
    others = [driven.outputs[name] for name in ("tool_power", "friction_power")]
    assert (others[1] > 0.0).all() if mu else not others[1].any()
    tool = np.array([shown.cutting.pieces.value((0,), (at,)) for at in x[11]]) * (v[11] < 0.0)
    assert np.abs(others[0] + tool * v[11]).max() <= 1e-12 * np.abs(tool * v[11]).max()
    balance = rate + others[0] + others[1] - driven.outputs["motor_power"]
    assert np.abs(driven.power[0] - balance).max() < 1e-10 * np.abs(balance).max()


def test_positions_that_rolling_leaves_open_are_integrated():
    """A skate whose heading turns at a constant rate, and whose x is prescribed, goes round a circle."""
    x, y, theta = dynamicsymbols("x y theta")
    model = em.Model(
        name="skate",
        coordinates=[x, y, theta],
        kinetic_energy=(2 * (x.diff() ** 2 + y.diff() ** 2) + theta.diff() ** 2) / 2,
        nonholonomic_constraints=[x.diff() * sin(theta) - y.diff() * cos(theta)],
    )
    times = np.linspace(0.0, 1.4, 141)
    driven = em.drive(em.build(model), times, {"x": 3 * sin(em.t), "theta": em.t}, actuators=("x", "y", "theta"))
    assert np.abs(driven.x[1] - 3 * (1 - np.cos(times))).max() < 1e-9
    assert np.abs(driven.a[1] - 3 * np.cos(times)).max() < 1e-8
    centripetal = np.array([-6 * np.sin(times), 6 * np.cos(times)])
    force = driven.forces[:2] - driven.multipliers[0] * np.array([np.sin(times), -np.cos(times)])
    assert np.abs(force - centripetal).max() < 1e-7


def test_states_along_the_motion():
    """A bristle z with zdot = v - z, whose force z acts on a mass that moves as sin t."""
    x, z = dynamicsymbols("x z")
    model = em.Model(name="bristle", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: -3 * z},
                     states={z: x.diff() - z}, initial={z: 0.25})  # fmt: skip
    times = np.linspace(0.0, 5.0, 51)
    driven = em.drive(em.build(model), times, {"x": sin(em.t)}, x0={"z": 0.5})
    held = (np.cos(times) + np.sin(times)) / 2
    assert np.abs(driven.states["z"] - held).max() < 1e-9
    assert np.abs(driven.forces[0] - (3 * held - np.sin(times))).max() < 1e-8


def test_state_that_a_reaction_changes_is_refused():
    x, y, z = dynamicsymbols("x y z")
    model = em.Model(name="worn", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                     holonomic_constraints=[y - x**2], states={z: em.multiplier(0)})  # fmt: skip
    with pytest.raises(em.ModelError, match="rate of state 'z' depends on a reaction"):
        em.drive(em.build(model), [0.0, 0.1, 0.2], {"x": em.t})


def test_state_that_an_actuator_changes_is_refused():
    """Also where the input is at its default at every time given."""
    x, z, u = dynamicsymbols("x z u")
    model = em.Model(name="act", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: u}, inputs={u: 0.0},
                     states={z: u})  # fmt: skip
    with pytest.raises(em.ModelError, match="rate of state 'z' depends on a reaction or on an actuator"):
        em.drive(em.build(model), [0.0, 1.0], {"x": em.t**3 / 6 - em.t**4 / 12}, actuators=("u",))


def test_a_mass_that_depends_on_the_time_from_one_on():
    x, y = dynamicsymbols("x y")
    model = em.Model(name="growing", coordinates=[x, y], kinetic_energy=em.t * (x.diff() ** 2 + y.diff() ** 2) / 2,
                     holonomic_constraints=[y - 2 * x])  # fmt: skip
    driven = em.drive(em.build(model), [1.0, 2.0], {"x": 2 * em.t})
    assert np.abs(driven.x[1] - [4.0, 8.0]).max() < 1e-12
    assert np.abs(driven.forces - 10.0).max() < 1e-9  # d/dt (t (2, 4)) = (2, 4), both by x: 2 + 2 * 4


def test_smooth_paths_of_functions_that_bend():
    system = built("pendulum")
    times = np.linspace(0.0, 0.5, 6)
    t = sympy.Symbol("t")
    for path in (sympy.Max(t - 0.25, 0) ** 3, (t - 0.25) ** 3 * sympy.Heaviside(em.t - 0.25),
                 (sympy.Abs(t - 0.25) + t - 0.25) ** 3 / 8):  # fmt: skip
        driven = em.drive(system, times, {"theta": path})
        assert np.abs(driven.a[0] - 6 * np.maximum(times - 0.25, 0.0)).max() < 1e-12
    assert np.abs(em.drive(system, times, {"theta": sympy.besselj(0, t)}).x[0, 0] - 1.0) < 1e-15


def test_jumps_between_two_times_and_at_the_end_of_a_table_are_found():
    system, t = built("pendulum"), em.t
    knots = np.linspace(0.0, 1.0, 11)
    held = em.Table(make_interp_spline(knots, 0.5 + 2 * knots, k=5), name="held", outside="hold")
    for path in (sympy.Piecewise((0, t < 0.4), (1, t < 0.6), (0, True)), held, sympy.asin(sin(2 * sympy.pi * t + 0.3))):
        with pytest.raises(em.ModelError, match=r"jumps|has no value, rate"):
            em.drive(system, [0.0, 1.5, 3.0], {"theta": path})


def test_dead_centres_are_named():
    system = built("slider_crank", formulation="lagrange")
    times = np.linspace(0.0, 1.0, 101)
    with pytest.raises(em.ModelError, match=r"dead centre at t = 0\.[45]\d*: there x does not determine theta"):
        em.drive(system, times, {"x": 1.0 + 0.6 * em.t})  # the crank is stretched at x = 1.3, t = 0.5
    theta = 1.0 - 2 * em.t  # a path of the slider through its dead centre, which a crank could make
    x = 0.3 * cos(theta) + sqrt(1 - (0.3 * sin(theta)) ** 2)
    with pytest.raises(em.ModelError, match=r"dead centre at t = 0\.[45]"):
        em.drive(system, times, {"x": x})
    inside = em.drive(system, times[:45], {"x": x})
    assert np.abs(inside.x[0] - (1.0 - 2 * times[:45])).max() < 1e-9


def test_the_branch_of_the_start_is_kept():
    """With the rods folded the other way, the same path of the slider turns the crank backwards."""
    system = built("slider_crank", formulation="lagrange")
    times = np.linspace(0.0, 0.4, 41)
    x = 1.1 + em.t / 10
    up, down = (em.drive(system, times, {"x": x}, x0={"theta": s, "phi": 0.3 * s}) for s in (1.0, -1.0))
    assert np.abs(up.x[:2] + down.x[:2]).max() < 1e-12
    assert (up.x[0] > 0).all()


def test_start_at_which_all_coordinates_are_zero():
    """A correction of rounding is no sign that the loop stays open where x = 0 is its size."""
    grip = em.drive(built("gripper", formulation="lagrange"), [0.0, 0.1], {"left_pad": 0.1 * em.t})
    assert abs(grip.x[:, 0]).max() < 1e-17
    assert grip.x[list(grip.coordinates).index("left_pad"), 1] == pytest.approx(0.01)


def test_mistakes_are_named():
    system = built("four_bar", formulation="lagrange")
    times = [0.0, 0.1, 0.2]
    smooth = em.Signal(times, [0.5, 0.6, 0.8], kind="cubic")
    for motion, words in (
        ({}, "Give a mapping"),
        ({"q9": 1.0}, "q9"),
        ({"q1": 1.0, "q2": 0.5}, "1 degree of freedom, and 2 coordinates are prescribed"),
        ({"q1": (times, times)}, "make_interp_spline"),
        ({"q1": em.Signal(times, times)}, "no continuous velocity"),
        ({"q1": lambda t: t}, "make_interp_spline"),
        ({"q1": em.Table((times, [0.5, 0.6, 0.8]))}, "velocity of the path of 'q1' jumps at t = 0.1"),
        ({"q1": dynamicsymbols("w")}, "w"),
        ({"q1": sympy.Symbol("w") * em.t}, "has w in it"),
        ({"q1": sqrt(em.t - 0.1)}, "no value"),
        ({"q1": float("nan")}, "finite"),
        (
            {"q1": sympy.Piecewise((0.5, em.t < 0.13), (em.t + 0.37, True))},
            "velocity of the path of 'q1' jumps between",
        ),
        ({"q1": 0.5 + sympy.floor(em.t + 0.83)}, "no rates that can be evaluated"),
    ):
        with pytest.raises(em.ModelError, match=words):
            em.drive(system, times, motion)
    with pytest.raises(em.ModelError, match="times reach"):
        em.drive(system, [0.0, 0.3], {"q1": smooth})
    for wrong in ([], [0.0, 0.0], [0.0, np.inf], [[0.0, 1.0]]):
        with pytest.raises(em.ModelError, match="times"):
            em.drive(system, wrong, {"q1": 0.5 + em.t})
    with pytest.raises(em.ModelError, match="has 2 degrees of freedom, and 1 coordinate is prescribed"):
        em.drive(built("furuta_pendulum"), times, {"phi": em.t})
    paths = {"phi": em.t, "theta": 0.1}
    with pytest.raises(em.ModelError, match=r"input 'u' is sampled on \[0, 0.1\], and times reach beyond"):
        em.drive(built("furuta_pendulum"), times, paths, inputs={"u": ([0.0, 0.1], [1.0, 2.0])})
    with pytest.raises(em.ModelError, match="a controller has no values outside a run"):
        em.drive(built("furuta_pendulum"), times, paths, inputs={"u": em.Sampled(lambda t, x, v: 0.0, 0.1)})


def test_what_is_saved_and_copied(tmp_path):
    system = built("four_bar", formulation="lagrange")
    driven = em.drive(system, np.linspace(0.0, 1.0, 11), {"q1": 0.5 + em.t}, actuators=("q1", "q3"))
    driven.save(tmp_path / "a.npz")
    driven.save(tmp_path / "a.csv")
    with np.load(tmp_path / "a.npz") as arrays:
        for name in ("x", "v", "a", "forces", "power", "multipliers"):
            assert np.array_equal(arrays[name], getattr(driven, name))
        assert list(arrays["actuators"]) == ["q1", "q3"]
    table = np.genfromtxt(tmp_path / "a.csv", delimiter=",", names=True, deletechars="")
    for k, name in enumerate(driven.actuators):
        assert np.array_equal(table[f"force_{name}"], driven.forces[k])
        assert np.array_equal(table[f"power_{name}"], driven.power[k])
    assert np.array_equal(table["q2''"], driven.a[1])
    copy = pickle.loads(pickle.dumps(driven))
    assert np.array_equal(copy.forces, driven.forces)
    assert np.array_equal(copy.drawing.numbers, driven.drawing.numbers)
    with pytest.raises(em.ModelError, match="known endings"):
        driven.save(tmp_path / "a.txt")
    assert driven.to_csv() == (tmp_path / "a.csv").read_text()
    with pytest.raises(em.ModelError, match="cannot be written"):  # it was an OSError
        driven.save(tmp_path / "a.csv" / "b.csv")


def test_pictures():
    pytest.importorskip("matplotlib")
    system = built("four_bar", formulation="lagrange")
    driven = em.drive(system, np.linspace(0.0, 1.0, 11), {"q1": 0.5 + em.t + em.t**2})
    figure = driven.plot()
    assert [axes.get_ylabel() for axes in figure.axes if axes.get_ylabel()][:3] == [
        "coordinates",
        "forces",
        "power",
    ]
    speed, force = figure.axes[-1].get_lines()[0].get_data()
    assert np.array_equal(speed, driven.v[0])
    assert np.array_equal(force, driven.forces[0])
    assert [axes.get_ylabel() for axes in driven.plot("q2", "lambda0").axes if axes.get_ylabel()][:2] == [
        "$q_{2}$",
        "$\\lambda_{0}$",
    ]
    with pytest.raises(em.ModelError, match="unknown column 'q9'"):
        driven.plot("q9")
    driven.animate(fps=5)._draw_was_started = True  # matplotlib warns of animations that nobody shows


def test_units_of_forces_stand_in_pictures_tables_and_words(tmp_path):
    """Energy over the coordinate's unit; of an input its own; none where the model does not say that of energy."""
    pytest.importorskip("matplotlib")
    x, q, u = dynamicsymbols("x q u")
    units = {x: "mm", q: "rad", u: "N mm", "energy": "mJ"}
    model = em.Model(name="in_mm", coordinates=[x, q], kinetic_energy=(x.diff() ** 2 + q.diff() ** 2) / 2,
                     forces={q: u}, inputs={u: 0.0}, units=units)  # fmt: skip
    times, paths = np.linspace(0.0, 1.0, 5), {"x": em.t**2, "q": em.t}
    driven = em.drive(system_for(model, "lagrange"), times, paths)
    assert [axes.get_ylabel() for axes in driven.plot().axes] == [
        "coordinates [mm]", "coordinates [rad]", "forces [mJ/mm]", "forces [mJ/rad]", "power [mJ/s]", "forces",
    ]  # fmt: skip
    driven.save(tmp_path / "a.csv")
    names = (tmp_path / "a.csv").read_text().splitlines()[0].split(",")
    assert {"force_x [mJ/mm]", "force_q [mJ/rad]", "power_q [mJ/s]", "x' [mm/s]", "u [N mm]"} <= set(names)
    by_input = em.drive(system_for(model, "lagrange"), times, paths, actuators=("x", "u"))
    assert "2 mJ/mm" in summary(by_input)
    assert "0 N mm" in summary(by_input)
    bare = em.drive(system_for(replace(model, units={}), "lagrange"), times, paths)
    assert "[" not in summary(bare) + "".join(axes.get_ylabel() for axes in bare.plot().axes)
    assert "t = 0 ... 1 in" in summary(bare)
