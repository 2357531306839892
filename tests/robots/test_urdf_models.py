"""Models of URDF files against closed forms and equations of motion written by hand, integrated by SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import eigenmotion as em
from tests.support.urdf_texts import joint, link, robot

pytest.importorskip("yourdfpy", reason="URDF files are read by yourdfpy: pip install 'eigenmotion[robots]'")

G, TIGHT = 9.81, {"rtol": 1e-11, "atol": 1e-12}


@pytest.fixture
def write(tmp_path):
    """Write a URDF file and return its path."""

    def written(*elements, name="robot"):
        path = tmp_path / f"{name}.urdf"
        path.write_text(robot(*elements, name=name))
        return path

    return written


def by_scipy(rhs, x, v, t):
    """Coordinates (n, nt) of xddot = rhs(x, v)."""
    n = len(x)
    found = solve_ivp(lambda _, y: [*y[n:], *rhs(y[:n], y[n:])], (0, t[-1]), [*x, *v], t_eval=t, method="DOP853",
                      rtol=1e-12, atol=1e-13)  # fmt: skip
    return found.y[:n]


def test_a_pendulum_swings_by_its_inertia_damping_and_torque(write):
    """An inertial frame that is moved and turned, an axis of length 2, a fixed weight at the end with a known frame."""
    path = write(
        link("base", 5.0),
        link("rod", 1.2, center=(0, 0, -0.4), rpy=(0, 0, np.pi / 2), inertia=(0.03, 0, 0, 0.07, 0, 0.04)),
        link("weight", 0.5, inertia=(0.001, 0, 0, 0.002, 0, 0.001)),
        joint("hinge", "continuous", "base", "rod", xyz=(0.1, 0, 1), axis=(0, 2, 0),
              more='<dynamics damping="0.3" friction="0.1"/>'),
        joint("screw", "fixed", "rod", "weight", xyz=(0, 0, -0.9)),
        name="pendulum",
    )  # fmt: skip
    made = em.read_urdf(path)
    weight = made.bodies["weight"].position()
    (q,) = made.coordinates
    model = made.model(outputs={"x": weight[0], "z": weight[2]}, initial={q: 0.8})
    assert made.torques["hinge"] in dict(model.inputs)
    run = em.simulate(em.build(model), (0, 2), t_eval=np.linspace(0, 2, 9), inputs={"tau_hinge": 1.5}, **TIGHT)
    inertia = 0.03 + 1.2 * 0.4**2 + 0.002 + 0.5 * 0.9**2  # the inertial frame is turned: xx is about y
    x = by_scipy(lambda x, v: (1.5 - 0.3 * v - (1.2 * 0.4 + 0.5 * 0.9) * G * np.sin(x)) / inertia, [0.8], [0.0], run.t)
    assert np.abs(run.x - x).max() < 1e-9
    assert np.abs(run.outputs["x"] - (0.1 - 0.9 * np.sin(x[0]))).max() < 1e-9
    assert np.abs(run.outputs["z"] - (1 - 0.9 * np.cos(x[0]))).max() < 1e-9


def test_a_joint_without_an_axis_moves_along_x(write):
    path = write(link("rail"), link("cart", 2.0), joint("slide", "prismatic", "rail", "cart",
                 more='<limit lower="-1" upper="1" effort="1" velocity="1"/>'))  # fmt: skip
    made = em.read_urdf(path, gravity=(G, 0, 0))
    run = em.simulate(em.build(made.model()), (0, 1), inputs={"tau_slide": -2.0}, **TIGHT)
    assert run.x[0, -1] == pytest.approx((G - 1.0) / 2, rel=1e-10)


def gripper():
    """Two fingers on a wrist that turns about x; the right one is driven: right = -2 left + 0.01."""
    return (
        link("base"), link("palm", 0.8, inertia=(0.01, 0, 0, 0.01, 0, 0.01)), link("left", 0.2), link("right", 0.3),
        joint("wrist", "revolute", "base", "palm", axis=(1, 0, 0), more='<limit lower="-3" upper="3"/>'),
        joint("left-finger", "prismatic", "palm", "left", xyz=(0.1, 0, 0), axis=(0, 1, 0),
              more='<limit lower="0" upper="0.04"/><dynamics damping="0.5"/>'),
        joint("right-finger", "prismatic", "palm", "right", xyz=(0.1, 0, 0), axis=(0, 1, 0),
              more='<mimic joint="left-finger" multiplier="-2" offset="0.01"/><dynamics damping="0.7"/>'
                   '<limit lower="0" upper="0.04"/>'),
    )  # fmt: skip


@pytest.mark.parametrize("formulation", ["eigenfactor", "articulated_body"])
def test_a_driven_joint_is_eliminated_exactly(write, formulation):
    """T = (J + m1 l^2 + m2 r^2) w^2 / 2 + (m1 + k^2 m2) v^2 / 2 with r = k l + b; the dampers add with k^2."""
    made = em.read_urdf(write(*gripper(), name="gripper"), gravity=(0, 0, 0))
    assert [one.func.__name__ for one in made.coordinates] == ["wrist", "left_finger"]
    assert set(made.torques) == {"wrist", "left-finger"}
    right = made.bodies["right"].position()
    w, l = made.coordinates
    model = made.model(outputs={"y": right[1], "z": right[2]}, initial={w.diff(): 2.0, l: 0.02})
    inputs = {"tau_wrist": 0.01, "tau_left_finger": 0.4}
    system = em.build(model, formulation=formulation)
    run = em.simulate(system, (0, 1), t_eval=np.linspace(0, 1, 7), inputs=inputs, **TIGHT)

    def rhs(x, v):
        l, r = x[1], 0.01 - 2 * x[1]
        J, rate = 0.01 + 0.2 * l**2 + 0.3 * r**2, 2 * (0.2 * l - 2 * 0.3 * r) * v[1]
        push = 0.4 - (0.5 + 4 * 0.7) * v[1] + (0.2 * l - 2 * 0.3 * r) * v[0] ** 2
        return (0.01 - rate * v[0]) / J, push / (0.2 + 4 * 0.3)

    x = by_scipy(rhs, [0.0, 0.02], [2.0, 0.0], run.t)
    assert np.abs(run.x - x).max() < 1e-9
    r = 0.01 - 2 * x[1]
    assert np.abs(run.outputs["y"] - r * np.cos(x[0])).max() < 1e-9
    assert np.abs(run.outputs["z"] - r * np.sin(x[0])).max() < 1e-9


def test_a_locked_joint_holds_what_it_drives(write):
    """The finger is at 0, and the driven one at its offset 0.01: the wrist turns a body of J + m2 b^2."""
    made = em.read_urdf(write(*gripper()), locked=["left-finger"], gravity=(0, 0, -G))
    assert len(made.coordinates) == 1
    model = made.model(outputs={"y": made.bodies["right"].position()[1]})
    run = em.simulate(em.build(model), (0, 1), t_eval=np.linspace(0, 1, 7), **TIGHT)
    x = by_scipy(lambda x, v: -0.3 * 0.01 * G * np.cos(x) / (0.01 + 0.3 * 0.01**2), [0.0], [0.0], run.t)
    assert np.abs(run.x - x).max() < 1e-9
    assert np.abs(run.outputs["y"] - 0.01 * np.cos(x[0])).max() < 1e-12


def test_a_floating_base_falls_and_tumbles_by_eulers_equations(write):
    path = write(link("box", 2.0, center=(0.1, 0, 0), inertia=(1.0, 0, 0, 2.0, 0, 2.5)), name="box")
    made = em.read_urdf(path, base="floating")
    assert [one.func.__name__ for one in made.coordinates] == [f"base_{s}" for s in ("x", "y", "z", "s1", "s2", "s3")]
    R, c = made.bodies["box"].rotation, made.bodies["box"].position((0.1, 0, 0))
    outputs = {f"R{i}{j}": R[i, j] for i in range(3) for j in range(3)} | {f"c{k}": c[k] for k in range(3)}
    rates = dict(zip([q.diff() for q in made.coordinates], (1, 0, 3, 0.1, 0.25, 0), strict=True))
    run = em.simulate(em.build(made.model(outputs=outputs, initial=rates)), (0, 1), t_eval=[0.0, 0.5, 1.0], **TIGHT)
    w = 4 * np.array([0.1, 0.25, 0.0])  # at s = 0 the angular velocity is 4 sdot
    v = np.array([1.0, 0, 3]) + np.cross(w, [0.1, 0, 0])
    J = np.array([1.0, 2.0, 2.5])

    def rhs(_, y):  # a quaternion x, y, z, w and the angular velocity in the body's axes
        a, b, c, d = y[:4]
        p, q, r = y[4:]
        return [*(0.5 * np.array([d * p + b * r - c * q, d * q + c * p - a * r, d * r + a * q - b * p,
                                  -a * p - b * q - c * r])), *(-np.cross(y[4:], J * y[4:]) / J)]  # fmt: skip

    found = solve_ivp(rhs, (0, 1), [0, 0, 0, 1, *w], t_eval=run.t, rtol=1e-12, atol=1e-13, method="DOP853")
    for k, t in enumerate(run.t):
        turned = Rotation.from_quat(found.y[:4, k]).as_matrix()
        got = np.array([[run.outputs[f"R{i}{j}"][k] for j in range(3)] for i in range(3)])
        assert np.abs(got - turned).max() < 1e-9
        centre = np.array([0.1, 0, 0]) + v * t - [0, 0, G * t**2 / 2]
        assert np.abs([run.outputs[f"c{i}"][k] - centre[i] for i in range(3)]).max() < 1e-9


def parallelogram():
    """Two cranks of length 0.5 that hang down, and a coupler of length 1 between their ends."""
    return (
        link("base"), link("crank", 0.4, center=(0, 0, -0.25), inertia=(0.01, 0, 0, 0.01, 0, 0)),
        link("coupler", 0.7, center=(0.5, 0, 0), inertia=(0, 0, 0, 0.05, 0, 0.05)),
        link("rocker", 0.6, center=(0, 0, -0.3), inertia=(0.02, 0, 0, 0.02, 0, 0)),
        joint("first", "continuous", "base", "crank", axis=(0, 1, 0)),
        joint("second", "continuous", "crank", "coupler", xyz=(0, 0, -0.5), axis=(0, 1, 0)),
        joint("third", "continuous", "base", "rocker", xyz=(1, 0, 0), axis=(0, 1, 0)),
    )  # fmt: skip


def test_a_loop_is_closed_by_constraints(write):
    """A parallelogram: the coupler does not turn, and q'' = -V' / M with constant M."""
    close = {"pin": ("coupler", (1, 0, 0), "rocker", (0, 0, -0.5))}
    made = em.read_urdf(write(*parallelogram(), name="parallelogram"), close=close)
    a, b, c = made.coordinates
    model = made.model(initial={a: 0.7, b: -0.7, c: 0.7})
    run = em.simulate(em.build(model), (0, 3), t_eval=np.linspace(0, 3, 13), inputs={"tau_third": 0.2}, **TIGHT)
    M = 0.01 + 0.4 * 0.25**2 + 0.7 * 0.5**2 + 0.02 + 0.6 * 0.3**2
    weight = G * (0.4 * 0.25 + 0.7 * 0.5 + 0.6 * 0.3)
    x = by_scipy(lambda x, v: (0.2 - weight * np.sin(x)) / M, [0.7], [0.0], run.t)[0]
    assert run.success
    assert np.abs(run.x - np.array([x, -x, x])).max() < 1e-8


def test_stops_and_friction_are_for_whoever_asks(write):
    path = write(link("rail"), link("cart", 2.0), joint("slide", "prismatic", "rail", "cart", axis=(0, 0, 1),
                 more='<limit lower="-0.5" upper="7"/><dynamics friction="4"/>'))  # fmt: skip
    made = em.read_urdf(path)
    free = em.simulate(em.build(made.model()), (0, 0.4), **TIGHT)
    assert free.x[0, -1] == pytest.approx(-G * 0.08, rel=1e-9)
    assert any("friction" in note for note in made.notes)
    assert any("limits of positions" in note for note in made.notes)
    stops = made.stops()
    assert set(stops) == {"slide_lower", "slide_upper"}
    held = made.model(contacts={**stops, **made.frictions()})
    run = em.simulate(em.build(held), (0, 2), **TIGHT)
    assert run.x[0, -1] == pytest.approx(-0.5, abs=1e-9)
    early = em.simulate(em.build(held), (0, 0.2), **TIGHT)
    assert early.x[0, -1] == pytest.approx(-(G - 4 / 2) * 0.02, rel=1e-9)


def test_inertial_parameters_have_the_values_of_the_file(write):
    """The same motion, with a fixed tool; ten parameters of each link that moves and has a mass."""
    path = write(
        link("base", 5.0),
        link("upper-arm", 1.2, center=(0.1, 0.2, -0.4), inertia=(0.05, 0.01, 0, 0.07, 0.002, 0.04)),
        link("fore", 0.9, center=(0, 0.1, -0.3), rpy=(0.3, 0, 0.2), inertia=(0.03, 0, 0.001, 0.04, 0, 0.02)),
        link("tool", 0.5, inertia=(0.001, 0, 0, 0.002, 0, 0.001)),
        joint("hinge", "continuous", "base", "upper-arm", axis=(0, 1, 0)),
        joint("elbow", "continuous", "upper-arm", "fore", xyz=(0, 0, -0.9), axis=(1, 0, 0)),
        joint("screw", "fixed", "fore", "tool", xyz=(0, 0.1, -0.4)),
    )  # fmt: skip
    plain, symbolic = (em.build(em.load_urdf(path, inertial_parameters=one)) for one in (False, True))
    assert len(symbolic.parameters) == 30
    assert symbolic.parameters["my_upper_arm"] == pytest.approx(0.24)
    assert symbolic.parameters["Ixx_tool"] == 0.001
    x, v = np.array([0.4, -0.7]), np.array([1.1, 0.6])
    assert symbolic.mass_matrix(x) == pytest.approx(plain.mass_matrix(x), rel=1e-13)
    assert symbolic.acceleration(x, v)[0] == pytest.approx(plain.acceleration(x, v)[0], rel=1e-12)
    lighter = symbolic.mass_matrix(x, parameters={"m_tool": 0.0, "Ixx_tool": 0, "Iyy_tool": 0, "Izz_tool": 0})
    assert lighter[1, 1] == pytest.approx(plain.mass_matrix(x)[1, 1] - 0.001 - 0.5 * (0.1**2 + 0.4**2))


def test_units_are_those_of_the_format(write):
    path = write(link("base", 1.0), link("rod", 1.2, center=(0, 0, -0.4)), link("slide", 0.5),
                 joint("pin", "continuous", "base", "rod", axis=(0, 1, 0)),
                 joint("rail", "prismatic", "rod", "slide", axis=(0, 0, 1)))  # fmt: skip
    made = em.read_urdf(path, base="floating")
    units = dict(made.model(units={made.coordinates[-1]: "mm", "time": "s"}).units)
    assert {units[f"base_{axis}"] for axis in "xyz"} == {"m"}
    assert (units["pin"], units["tau_pin"], units["rail"], units["tau_rail"]) == ("rad", "N m", "mm", "N")
    assert (units["energy"], units["length"]) == ("J", "m")
    assert "base_s1" not in units
