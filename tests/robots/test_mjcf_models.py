"""Models of MJCF files against MuJoCo itself: places of bodies and accelerations at random states."""

import numpy as np
import pytest

import eigenmotion as em

mujoco = pytest.importorskip("mujoco", reason="MJCF files are compiled by MuJoCo: pip install 'eigenmotion[robots]'")

ARM = """
<mujoco model="two-arms">
  <compiler angle="radian"/>
  <option gravity="0.3 -0.2 -9.81"/>
  <worldbody>
    <body name="upper" pos="0.1 0.2 1" euler="0.3 -0.2 0.5">
      <joint name="swing" type="hinge" axis="1 2 0" pos="0.05 0 0.1" damping="0.3" armature="0.02" ref="0.2"
             stiffness="3" springref="0.5"/>
      <inertial pos="0 0 -0.2" mass="1.5" fullinertia="0.02 0.03 0.04 0.001 0.002 0.003"/>
      <body name="fore" pos="0 0 -0.5" euler="0.1 0.7 0">
        <joint name="elbow" type="hinge" axis="0 1 0" pos="0 0 0.02"/>
        <joint name="reach" type="slide" axis="0 0 1" pos="0.1 0 0" ref="0.1" damping="2"/>
        <inertial pos="0 0.01 -0.3" mass="0.8" diaginertia="0.01 0.012 0.004"/>
        <body name="tool" pos="0 0.1 -0.2"><geom type="sphere" size="0.05" mass="0.2"/></body>
      </body>
    </body>
    <body name="cart" pos="1 0 0"><joint type="slide" axis="1 0 0"/><geom type="box" size="0.1 0.2 0.3"/></body>
  </worldbody>
</mujoco>
"""


@pytest.fixture
def write(tmp_path):
    def written(text, name="robot.xml"):
        path = tmp_path / name
        path.write_text(text)
        return path

    return written


def reference(path, q, v, forces=None):
    """MuJoCo's data at a state, without contacts and limits."""
    m = mujoco.MjModel.from_xml_path(str(path))
    m.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT
    d = mujoco.MjData(m)
    d.qpos[:], d.qvel[:] = q, v
    if forces is not None:
        d.qfrc_applied[:] = forces
    mujoco.mj_forward(m, d)
    return m, d


def test_joints_of_all_kinds_move_as_in_mujoco(write):
    """Joints beside the origin of their body, several in one, turned bodies, springs, dampers, rotors, references."""
    path = write(ARM)
    made = em.read_mjcf(path)
    assert [one.func.__name__ for one in made.coordinates] == ["swing", "elbow", "reach", "cart_joint"]
    bodies = ("upper", "fore", "tool", "cart")
    outputs = {f"{name}_{k}": made.bodies[name].position()[k] for name in bodies for k in range(3)}
    outputs |= {f"R_{i}{j}": made.bodies["tool"].rotation[i, j] for i in range(3) for j in range(3)}
    system = em.build(made.model(outputs=outputs))
    assert system.initial[0] == pytest.approx([0.2, 0, 0.1, 0])
    chance = np.random.default_rng(3)
    for _ in range(5):
        q, v, u = chance.uniform(-1, 1, 4), chance.normal(size=4), chance.normal(size=4)
        _, d = reference(path, q, v, u)
        inputs = dict(zip(system.inputs, u, strict=True))
        a, _ = system.acceleration(q, v, inputs=inputs)
        assert np.abs(a - d.qacc).max() < 1e-11 * np.abs(d.qacc).max()
        got = em.simulate(system, (0, 1e-3), x0=q, v0=v, t_eval=[0.0]).outputs
        places = np.array([[got[f"{name}_{k}"][0] for k in range(3)] for name in bodies])
        assert np.abs(places - [d.body(name).xpos for name in bodies]).max() < 1e-13
        turned = np.array([[got[f"R_{i}{j}"][0] for j in range(3)] for i in range(3)])
        assert np.abs(turned - d.body("tool").xmat.reshape(3, 3)).max() < 1e-13


FREE = """
<mujoco><worldbody>
  <body name="box" pos="1 2 3" quat="0.8 0.2 -0.4 0.4"><freejoint name="root"/>
    <inertial pos="0.1 0 0.05" mass="2" diaginertia="0.3 0.4 0.6"/>
    <body name="arm" pos="0.2 0 0"><joint name="arm" axis="0 1 0"/><inertial pos="0 0 0.2" mass="0.5"
      diaginertia="0.01 0.02 0.03"/></body>
  </body>
</worldbody></mujoco>
"""


def spin(s):
    """W of the angular velocity W sdot in the body's axes, of modified Rodrigues parameters s (Schaub and Junkins)."""
    cross = np.array([[0, -s[2], s[1]], [s[2], 0, -s[0]], [-s[1], s[0], 0]])
    return 4 * ((1 - s @ s) * np.eye(3) - 2 * cross + 2 * np.outer(s, s)) / (1 + s @ s) ** 2


def test_a_free_joint_moves_as_in_mujoco(write):
    """From the place of the file; rates of rotation follow by W sdot, and their rates by a difference."""
    path = write(FREE)
    made = em.read_mjcf(path)
    system = em.build(made.model())
    x, _ = system.initial
    assert x[:3] == pytest.approx([1, 2, 3])
    assert x[3:6] == pytest.approx(np.array([0.2, -0.4, 0.4]) / (1 + 0.8))
    chance = np.random.default_rng(5)
    x[6], v = 0.7, chance.normal(size=7)
    s, rate = x[3:6], v[3:6]
    quat = np.array([1 - s @ s, *(2 * s)]) / (1 + s @ s)
    w = spin(s) @ rate
    _, d = reference(path, [*x[:3], *quat, x[6]], [*v[:3], *w, v[6]])
    a, _ = system.acceleration(x, v)
    h = 1e-5
    turning = (spin(s + h * rate) - spin(s - h * rate)) @ rate / (2 * h)
    got = np.array([*a[:3], *(spin(s) @ a[3:6] + turning), a[6]])
    assert np.abs(got - d.qacc).max() < 1e-8 * np.abs(d.qacc).max()


COUPLED = """
<mujoco><option gravity="1 0 -9.81"/><worldbody>
  <body name="a"><joint name="a" axis="0 1 0" ref="20"/><inertial pos="0.1 0 -0.2" mass="1" diaginertia="0.1 0.1 0.1"/>
    <body name="b" pos="0 0 -0.5"><joint name="b" axis="0 1 0"/><inertial pos="0 0 -0.2" mass="0.4"
      diaginertia="0.02 0.02 0.02"/></body>
  </body>
</worldbody><equality>%s</equality></mujoco>
"""


def test_a_linear_constraint_of_joints_eliminates_one(write):
    """b = 0.1 - 2 (a - ref): M and forces of MuJoCo's unconstrained tree in the rate of a."""
    path = write(COUPLED % '<joint joint1="b" joint2="a" polycoef="0.1 -2 0 0 0"/>')
    made = em.read_mjcf(path)
    (q,) = made.coordinates
    assert q.func.__name__ == "a"
    system = em.build(made.model())
    ref = np.radians(20)
    for x, v in ((0.3, 1.2), (-1.0, 0.4)):
        m, d = reference(path, [x, 0.1 - 2 * (x - ref)], [v, -2 * v])
        M, B = np.zeros((2, 2)), np.array([1.0, -2.0])
        mujoco.mj_fullM(m, d, M)
        a, _ = system.acceleration([x], [v])
        assert a[0] == pytest.approx(-(B @ d.qfrc_bias) / (B @ M @ B), rel=1e-12)


def test_a_polynomial_of_joints_is_a_constraint(write):
    path = write(COUPLED % '<joint name="cam" joint1="b" joint2="a" polycoef="0.1 -2 0.5 0 0"/>')
    model = em.read_mjcf(path).model()
    (a, b), (phi,) = model.coordinates, model.holonomic_constraints
    y = 0.4 - np.radians(20)
    assert abs(float(phi.subs({a: 0.4, b: 0.1 - 2 * y + 0.5 * y**2}))) < 1e-15
    assert model.row_names == ("cam",)


SLIDER_CRANK = """
<mujoco><worldbody>
  <body name="crank" euler="0 40 0"><joint name="crank" axis="0 1 0"/>
    <inertial pos="0 0 -0.25" mass="1" diaginertia="0.02 0.02 0.001"/>
    <body name="rod" pos="0 0 -0.5" euler="0 100 0"><joint name="rod" axis="0 1 0"/>
      <inertial pos="0 0 -0.25" mass="0.4" diaginertia="0.01 0.01 0.001"/></body>
  </body>
  <body name="cart" pos="%r 0 0"><joint name="slide" type="slide" axis="1 0 0"/>
    <inertial pos="0 0 0" mass="0.7" diaginertia="0.01 0.01 0.01"/></body>
</worldbody><equality><connect name="pin" body1="rod" body2="cart" anchor="0 0 -0.5"/></equality></mujoco>
"""


def test_a_connection_closes_a_loop(write):
    """A slider crank with both arms of length r: the cart is at -2 r sin(angle), and the energy is kept."""
    start = float(-np.sin(np.radians(40)))
    made = em.read_mjcf(write(SLIDER_CRANK % start))
    model = made.model(outputs={"x": made.bodies["cart"].position()[0]})
    assert model.row_names == ("pin[0]", "pin[1]", "pin[2]")
    run = em.simulate(em.build(model), (0, 0.5), t_eval=np.linspace(0, 0.5, 6), rtol=1e-10)
    assert run.success
    assert np.ptp(run.x[0]) > 0.3
    assert np.abs(run.outputs["x"] + np.sin(np.radians(40) + run.x[0])).max() < 1e-9
    assert np.ptp(run.energy) < 1e-8


def test_what_is_not_used_is_said(write):
    text = FREE.replace(
        "</mujoco>",
        """<actuator><motor joint="arm"/></actuator><equality>
      <weld name="glue" body1="arm"/></equality></mujoco>""",
    )
    notes = "\n".join(em.read_mjcf(write(text)).notes)
    assert "actuators" in notes
    assert "glue" in notes


def test_mujocos_refusals_are_errors_of_models(write):
    with pytest.raises(em.ModelError, match=r"robot\.xml: MuJoCo cannot read it"):
        em.load_mjcf(write("<mujoco><worldbody><bodies/></worldbody></mujoco>"))
    with pytest.raises(em.ModelError, match="no body"):
        em.load_mjcf(write("<mujoco/>"))
