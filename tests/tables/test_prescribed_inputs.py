"""Inputs in constraints: signals that prescribe a motion."""

import pickle

import numpy as np
import pytest
import sympy
from scipy.interpolate import CubicSpline, PchipInterpolator, make_interp_spline
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import multiplier

from ..support.generation import system_for

q, y, path, speed, force = dynamicsymbols("q y path speed force")
TIMES = np.linspace(0.0, 10.0, 2001)
ROWS = np.linspace(0.0, 10.0, 101)


def motion(times, order=0):
    """A motion of a crank, or a derivative of it."""
    phase = order * np.pi / 2
    return np.sin(times + phase) + 0.1 * 3**order * np.sin(3 * times + phase)


def signal(size=1.0):
    return em.Signal(make_interp_spline(TIMES, size * motion(TIMES), k=5))


def driven() -> em.Model:
    """A crank with an inertia that varies, driven, and a mass that is pushed."""
    return em.Model(
        name="driven", coordinates=[q, y], kinetic_energy=q.diff() ** 2 / 2 * (2 + sympy.cos(q)) + y.diff() ** 2 / 2,
        potential_energy=9.81 * sympy.sin(q), holonomic_constraints={"drive": q - path}, forces={y: force},
        inputs={path: 0.0, force: 0.0},
        outputs={"torque": -multiplier("drive"), "rate": path.diff(), "acceleration": path.diff().diff()},
    )  # fmt: skip


def torque(place, rate, acceleration):
    """By hand: d/dt of (2 + cos q) q', less the half of -sin q q'^2, and the weight's."""
    return (2 + np.cos(place)) * acceleration - np.sin(place) * rate**2 / 2 + 9.81 * np.cos(place)


@pytest.fixture(scope="module", params=["eigenfactor", "lagrange"])
def system(request):
    return system_for(driven(), request.param)


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_a_signal_drives_a_joint(system, method):
    found = system.simulate(
        (0, 10), t_eval=ROWS, rtol=1e-9, atol=1e-9, method=method, inputs={"path": signal(), "force": 0.5},
        v0={"q": motion(0, 1)},
    )  # fmt: skip
    assert found.success
    np.testing.assert_allclose(found.x[0], motion(ROWS), rtol=0, atol=1e-11)
    np.testing.assert_allclose(found.x[1], ROWS**2 / 4, rtol=0, atol=1e-8)
    right = torque(motion(ROWS), motion(ROWS, 1), motion(ROWS, 2))
    np.testing.assert_allclose(found.outputs["torque"], right, rtol=0, atol=1e-7)
    np.testing.assert_allclose(found.outputs["rate"], motion(ROWS, 1), rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.outputs["acceleration"], motion(ROWS, 2), rtol=0, atol=1e-7)


def test_the_default_is_a_joint_that_is_held(system):
    assert system.prescribed == ("path",)
    assert list(system.inputs) == ["force"]
    found = system.simulate((0, 5))
    assert np.abs(found.x[0]).max() < 1e-14
    moved = system.simulate((0, 5), inputs={path: 0.3}, x0={"q": 0.3})
    np.testing.assert_allclose(moved.x[0], 0.3, rtol=1e-14)


def test_knots_of_a_rough_signal_are_ends_of_steps(system):
    """The acceleration of Pchip's curve jumps at its knots, where the drive's torque does."""
    knots = np.linspace(0.0, 4.0, 9)
    curve = PchipInterpolator(knots, motion(knots))
    found = system.simulate((0, 4), t_eval=np.linspace(0, 4, 81)[1:-1], rtol=1e-9, inputs={"path": curve},
                            v0={"q": float(curve(0.0, 1))}, method="dop853")  # fmt: skip
    assert found.success
    inner = np.array([all(abs(t - knots) > 1e-9) for t in found.t])
    right = torque(*(curve(found.t, order) for order in range(3)))
    np.testing.assert_allclose(found.outputs["torque"][inner], right[inner], rtol=0, atol=1e-8)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (em.Signal(TIMES, motion(TIMES)), r"'path' of driven prescribes.* velocity jumps at t = 0\.005.*kind='cubic'"),
        ((TIMES, motion(TIMES)), r"velocity jumps at t = 0\.005"),
        (em.Signal(TIMES, motion(TIMES), kind="hold"), "kind 'hold' jumps, as no joint can"),
        (make_interp_spline(TIMES, motion(TIMES), k=1), r"velocity jumps at t = 0\.005"),
        (np.sin, "this is a function.*make_interp_spline"),
        (em.Sampled(lambda t, x, v: 0.0, 0.1), "a controller holds its values"),
        ("far", "a number or a signal is needed"),
        (em.Signal([0.0, 1.0, 2.0], [0.0, 1.0, 0.0], kind="cubic"), r"sampled on \[0, 2\].*t_span \(0, 10\)"),
    ],
)
def test_what_no_joint_can_do_is_refused_with_the_remedy(system, given, words):
    with pytest.raises(em.ModelError, match=words):
        system.simulate((0, 10), inputs={"path": given}, v0={"q": motion(0, 1)})


def test_a_start_beside_the_path_names_a_start_on_it(system):
    with pytest.raises(em.ModelError, match=r"constraint drive.*project_initial_state\(.*inputs=inputs\)"):
        system.simulate((0, 1), inputs={"path": signal()})
    near = system.project_initial_state(inputs={"path": signal()})
    np.testing.assert_allclose(near.v, [motion(0, 1), 0.0], rtol=0, atol=1e-9)
    assert system.simulate((0, 1), inputs={"path": signal()}, v0=near.v).success


def test_a_rate_may_bend_and_not_jump():
    """A speed in a nonholonomic row: its first derivative is the acceleration."""
    model = em.Model(
        name="driven_rate", coordinates=[q], kinetic_energy=q.diff() ** 2, inputs={speed: 0.0},
        nonholonomic_constraints={"drive": [q.diff() - speed]}, outputs={"force": -multiplier("drive")},
    )  # fmt: skip
    system = system_for(model, "eigenfactor")
    ramp = em.Signal([0.0, 1.0, 3.0], [0.0, 2.0, 2.0])
    found = system.simulate((0, 3), inputs={"speed": ramp}, t_eval=[0.5, 2.0, 3.0], rtol=1e-9)
    np.testing.assert_allclose(found.x[0], [0.25, 3.0, 5.0], rtol=1e-9)
    np.testing.assert_allclose(found.outputs["force"], [4.0, 0.0, 0.0], rtol=0, atol=1e-9)
    with pytest.raises(em.ModelError, match="kind 'hold' jumps"):
        system.simulate((0, 3), inputs={"speed": em.Signal([0.0, 1.0, 3.0], [0.0, 2.0, 2.0], kind="hold")})


def test_a_table_that_is_shaken_carries_and_throws_its_ball():
    """An input in the gap of a contact: the force is m (g + a), and the ball leaves where that would pull."""
    model = em.Model(
        name="shaken", coordinates=[y], kinetic_energy=y.diff() ** 2 / 2, potential_energy=9.81 * y,
        inputs={path: 0.0}, contacts={"table": em.Contact(y - path, 0.0)},
    )  # fmt: skip
    system = system_for(model, "eigenfactor")
    times = np.linspace(0.0, 1.0, 1001)
    rise = 0.2 - 0.2 * np.cos(8 * times)  # its acceleration is 12.8 cos(8 t)
    leaves = np.arccos(-9.81 / 12.8) / 8
    found = system.simulate((0, 0.4), inputs={"path": make_interp_spline(times, rise, k=5)}, rtol=1e-9, atol=1e-11,
                            t_eval=np.linspace(0, 0.4, 81))  # fmt: skip
    assert found.success
    place, rate = 0.2 - 0.2 * np.cos(8 * leaves), 1.6 * np.sin(8 * leaves)
    after = found.t - leaves
    right = np.where(after < 0, 0.2 - 0.2 * np.cos(8 * found.t), place + rate * after - 9.81 * after**2 / 2)
    np.testing.assert_allclose(found.x[0], right, rtol=0, atol=1e-8)
    assert np.any(after > 0.05)


def test_each_member_has_its_own_path(system):
    paths = [signal(size) for size in (1.0, 2.0, -1.0)]
    rates = np.array([1.0, 2.0, -1.0]) * motion(0, 1)
    many = em.simulate_ensemble(system, (0, 3), inputs={"path": paths}, v0={"q": rates}, rtol=1e-9)
    for k, (one, rate) in enumerate(zip(paths, rates, strict=True)):
        single = system.simulate((0, 3), inputs={"path": one}, v0={"q": rate}, rtol=1e-9, method="dop853")
        np.testing.assert_allclose(many.x[k, :, -1], single.x[:, -1], rtol=0, atol=1e-9)


def test_steppers_derivatives_and_linear_models_follow_it(system):
    given = {"path": signal()}
    stepper = system.stepper(inputs=given, v0={"q": motion(0, 1)})
    stepper.advance(1.5, inputs={"force": 1.0})
    np.testing.assert_allclose(stepper.x, [motion(1.5), 1.5**2 / 2], rtol=0, atol=1e-6)
    a, lam = system.acceleration([motion(1.0), 0.0], [motion(1.0, 1), 0.0], 1.0, inputs=given)
    np.testing.assert_allclose(a[0], motion(1.0, 2), rtol=0, atol=1e-7)
    np.testing.assert_allclose(-lam[0], torque(motion(1.0), motion(1.0, 1), motion(1.0, 2)), rtol=0, atol=1e-6)
    prepared = system.prepare()
    again, _ = system.acceleration([motion(1.0), 0.0], [motion(1.0, 1), 0.0], 1.0, parameters=prepared, inputs=given)
    np.testing.assert_allclose(again, a, rtol=0, atol=0)
    assert system.linearize([0.3, 0.0], [0.0, 0.0], inputs={"path": 0.3}).B.shape[1] == 1


def test_sensitivities_name_the_curve_whose_acceleration_jumps_and_a_smoother_one(system):
    given = {"t_span": (0, 2), "sensitivities": ["force"], "v0": {"q": motion(0, 1)}, "rtol": 1e-9}
    knots = np.linspace(0.0, 4.0, 9)
    rough = PchipInterpolator(knots, motion(knots))
    with pytest.raises(em.ModelError, match=r"jumps at about t = 0\.5.*\(path\), give it a smoother one, CubicSpline"):
        system.simulate(**given | {"v0": {"q": float(rough(0.0, 1))}}, inputs={"path": rough})
    ends = ((1, motion(0, 1)), (1, motion(10.0, 1)))
    found = system.simulate(**given, inputs={"path": CubicSpline(TIMES, motion(TIMES), bc_type=ends)})
    np.testing.assert_allclose(found.sensitivity["force"].dx[:, -1], [0.0, 2.0], rtol=0, atol=1e-8)


def test_a_model_travels_with_its_prescribed_input():
    model = driven()
    again = pickle.loads(pickle.dumps(model))
    assert again.prescribed == ("path",)
    assert again.canonical() == model.canonical()
    as_table = em.Model(
        name="driven",
        coordinates=[q],
        kinetic_energy=q.diff() ** 2,
        holonomic_constraints=[q - em.Table(([0.0, 1.0], [0.0, 0.0]), outside="hold", name="path")(em.t)],
    )
    as_input = em.Model(name="driven", coordinates=[q], kinetic_energy=q.diff() ** 2, inputs={path: 0.0},
                        holonomic_constraints=[q - path])  # fmt: skip
    assert as_table.prescribed == ()
    assert as_table.canonical() != as_input.canonical()


def test_an_assumption_on_it_is_refused():
    positive = sympy.Function("path", positive=True)(em.t)
    with pytest.raises(em.ModelError, match="declared positive, which prescribes a motion"):
        em.Model(name="driven", coordinates=[q], kinetic_energy=q.diff() ** 2, inputs={positive: 1.0},
                 holonomic_constraints=[q - positive])  # fmt: skip


def test_interpolants_are_inputs_of_forces():
    model = em.Model(name="pushed", coordinates=[y], kinetic_energy=y.diff() ** 2 / 2, forces={y: force},
                     inputs={force: 0.0})  # fmt: skip
    system = system_for(model, "eigenfactor")
    cubic = CubicSpline(TIMES, motion(TIMES))
    ends = [system.simulate((0, 5), inputs={"force": one}, rtol=1e-10).x[0, -1]
            for one in (cubic, em.Signal(cubic), em.Signal(TIMES, motion(TIMES), kind="cubic"))]  # fmt: skip
    assert ends[0] == ends[1] == ends[2]
    right = 5 + 0.5 / 3 - np.sin(5) - 0.1 / 9 * np.sin(15)
    np.testing.assert_allclose(ends[0], right, rtol=0, atol=1e-7)
    curve = PchipInterpolator([0.0, 1.0, 2.0], [0.0, 1.0, 0.0])
    bent = system.simulate((0, 2), inputs={"force": curve}, rtol=1e-10)
    np.testing.assert_allclose(bent.v[0, -1], float(curve.integrate(0.0, 2.0)), rtol=0, atol=1e-9)
    with pytest.raises(em.ModelError, match="input 'force': a signal of degree 5"):
        system.simulate((0, 5), inputs={"force": make_interp_spline(TIMES, motion(TIMES), k=5)})
    with pytest.raises(em.ModelError, match=r"input 'force': an interpolant that jumps.*t = 0\.005"):
        system.simulate((0, 5), inputs={"force": make_interp_spline(TIMES, motion(TIMES), k=1)})
