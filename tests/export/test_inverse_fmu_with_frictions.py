"""Units of inverse dynamics of mechanisms with frictions: in both directions, from rest, at rest, at reversals."""

from dataclasses import replace

import numpy as np
import pytest
from sympy import cos, lambdify, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError

from ..support.fmu_slaves import Unit
from ..support.generation import MODELS, system_for

validation = pytest.importorskip("fmpy.validation")
pytestmark = pytest.mark.usefixtures("hurried")


def spelled(names, x, v, a):
    """Inputs by name."""
    orders = zip(("{}", "der({})", "der(der({}))"), (x, v, a), strict=True)
    return {text.format(name): value for text, values in orders for name, value in zip(names, values, strict=True)}


def exported(folder, model, **options):
    """A unit of a model, and the system that it is compared with; the file is valid."""
    path = em.export_fmu(model, folder / "unit.fmu", formulation="lagrange", **options)
    assert validation.validate_fmu(str(path)) == []
    return Unit(path, folder / "a"), system_for(model, "lagrange")


def servo():
    """Two joints with dry friction along lines, each with a motor, and a mass that couples them."""
    q, p, u, w = dynamicsymbols("q p u w")
    T = q.diff() ** 2 + p.diff() ** 2 + q.diff() * p.diff() * cos(q - p)
    rubs = {"first": em.Friction(q.diff(), limit=0.7), "second": em.Friction(p.diff() - q.diff(), limit=symbols("f"))}
    return em.Model(name="servo", coordinates=[q, p], kinetic_energy=T, potential_energy=9 * cos(q) + 4 * cos(p),
                    forces={q: u, p: w}, inputs={u: 0.0, w: 0.0}, contacts=rubs,
                    parameters={symbols("f"): 0.3})  # fmt: skip


def puck():
    """A mass of 2 on a plane with a friction cone."""
    x, y = dynamicsymbols("x y")
    return em.Model(name="puck", coordinates=[x, y], kinetic_energy=x.diff() ** 2 + y.diff() ** 2,
                    contacts={"floor": em.Friction((x.diff(), y.diff()), limit=0.5)})  # fmt: skip


def sliders():
    """Two masses on a bar, dry friction at one, and the current of a motor as a state."""
    x, y, i = dynamicsymbols("x y i")
    return em.Model(name="sliders", coordinates=[x, y], kinetic_energy=x.diff() ** 2 + 3 * y.diff() ** 2 / 2,
                    states={i: (1 - 2 * i - x.diff()) / 5}, forces={x: 7 * i},
                    holonomic_constraints={"bar": x - 2 * y}, contacts={"guide": em.Friction(x.diff(), limit=0.4)},
                    outputs={"limit": em.multiplier("bar")})  # fmt: skip


def worn():
    """A crank in a bearing whose friction is 0.03 times the norm of its reaction."""
    q, x, y = dynamicsymbols("q x y")
    pin = {"pin": [x - cos(q) / 2, y - sin(q) / 2]}
    return em.Model(name="worn", coordinates=[q, x, y], potential_energy=2 * 9.81 * y,
                    kinetic_energy=(q.diff() ** 2 / 10 + 2 * (x.diff() ** 2 + y.diff() ** 2)) / 2,
                    holonomic_constraints=pin, initial={q: 0.3, x: cos(0.3) / 2, y: sin(0.3) / 2},
                    contacts={"bearing": em.Friction(q.diff(), limit=0.03, normal="pin")})  # fmt: skip


def test_joints_of_a_servo(tmp_path):
    """By motors, at random motions; joints also rest, begin to move and stay at rest, together or one by one."""
    unit, system = exported(tmp_path, servo(), inverse_dynamics=["u", "w"])
    unit.begin(f=0.45)
    draws, seen = np.random.default_rng(3), set()
    for k in range(60):
        x, v, a = draws.normal(size=(3, 2))
        v *= (1.0, 0.0, (0.0, 1.0), v[0] / v)[k % 4]  # the last: the second friction rests
        a *= (1.0, 0.0, (0.0, 1.0), a[0] / a)[k // 4 % 4]
        unit.set(**spelled(["q", "p"], x, v, a))
        found = unit.get("u", "w")
        expected = system.inverse_dynamics(x, v, a, actuators=["u", "w"], parameters={"f": 0.45}).forces
        assert found == pytest.approx(expected, rel=1e-12, abs=1e-12)
        slip = [np.sign(w or b) for w, b in ((v[0], a[0]), (v[1] - v[0], a[1] - a[0]))]
        seen.add(tuple(slip))
    assert seen >= {(a, b) for a in (-1.0, 0.0, 1.0) for b in (-1.0, 0.0, 1.0)} - {(0.0, 0.0)}


def test_friction_by_hand(tmp_path):
    """Of the block, at both speeds, as it begins to move, at rest, and at the reversal of a swing."""
    unit = Unit(
        em.export_fmu(MODELS / "block_on_incline.py", tmp_path / "b.fmu", inverse_dynamics=["s"]), tmp_path / "a"
    )
    unit.begin(mu=0.3, friction_stuck=1.0)  # the mode is that of the motion, not that of parameters
    weight, limit = 9.81 * np.sin(0.4), 0.3 * 9.81 * np.cos(0.4)
    for v, a, side in ((2.0, 1.0, 1), (-2.0, 1.0, -1), (0.0, 1.0, 1), (0.0, -1.0, -1), (0.0, 0.0, 0), (1e-9, -1.0, 1)):
        unit.set(**spelled(["s"], [0.2], [v], [a]))
        assert unit.get("force(s)") == pytest.approx([a + weight + side * limit], rel=1e-13)
    for k, t in enumerate(np.linspace(0.0, np.pi, 41)):
        unit.set(**spelled(["s"], [np.cos(t)], [-np.sin(t) if k % 40 else 0.0], [-np.cos(t)]))
        unit.step(t, 0.01)
        side = 1 if k == 40 else -1
        assert unit.get("force(s)") == pytest.approx([-np.cos(t) + weight + side * limit], rel=1e-12)


@pytest.mark.parametrize("speed", [(3.0, 4.0), (-3.0, 4.0), (0.0, -4.0), (0.0, 0.0)])
def test_cones(tmp_path, speed):
    unit, system = exported(tmp_path, puck(), inverse_dynamics=["x", "y"])
    unit.begin()
    v = np.array(speed)
    for rate in ((0.0, 0.0), (5.0, 1.0), (-2.0, 1.0), (0.0, 3.0)):
        a = np.array(rate)
        unit.set(**spelled(["x", "y"], [0.3, -0.2], v, a))
        along = v if v.any() else a
        friction = 0.5 * along / np.linalg.norm(along) if along.any() else np.zeros(2)
        found = unit.get("force(x)", "force(y)")
        assert found == pytest.approx(2 * a + friction, rel=1e-13)
        assert found == pytest.approx(system.inverse_dynamics([0.3, -0.2], v, a).forces, rel=1e-14)


def test_frictions_beside_a_loop_and_a_state(tmp_path):
    """By hand: x feels a mass of 2 + 3/4; the other coordinate follows."""
    unit, _ = exported(tmp_path, sliders(), inverse_dynamics=["x"])
    unit.begin(i=0.3)
    for v, a, side in ((1.0, 0.5, 1), (-1.0, 3.0, -1), (0.0, 2.0, 1), (0.0, -2.0, -1), (0.0, 0.0, 0)):
        unit.set(i=0.3, **spelled(["x"], [0.2], [v], [a]))
        assert unit.get("force(x)") == pytest.approx([2.75 * a + 0.4 * side - 7 * 0.3], rel=1e-13)
        assert unit.get("y", "der(y)", "der(der(y))") == pytest.approx([0.1, v / 2, a / 2], abs=1e-15)


@pytest.mark.parametrize(("speed", "side"), [(3.0, 1), (-3.0, -1), (0.0, 1)])
def test_friction_with_the_reaction_of_a_bearing(tmp_path, speed, side):
    """By the two balances of forces."""
    unit, _ = exported(tmp_path, worn(), inverse_dynamics=["q"])
    unit.set(**spelled(["q"], [0.7], [speed], [5.0]))
    unit.begin()
    e, n = np.array([np.cos(0.7), np.sin(0.7)]), np.array([-np.sin(0.7), np.cos(0.7)])
    pull = 2 * (0.5 * 5.0 * n - 0.5 * speed**2 * e) + np.array([0.0, 2 * 9.81])
    torque = 0.1 * 5.0 + 0.5 * pull @ n + side * 0.03 * np.linalg.norm(pull)
    assert unit.get("force(q)") == pytest.approx([torque], rel=1e-12)


def test_a_shaper_turns_back_and_forth(tmp_path):
    """Friction in eight joints, proportional to their reactions, as the crank swings through two reversals."""
    shown = em.load_model(MODELS / "quick_return_shaper.py")  # its table and an output are both called cutting
    model = replace(shown, outputs={name: of for name, of in dict(shown.outputs).items() if name != "cutting"})
    path = em.export_fmu(model, tmp_path / "unit.fmu", inverse_dynamics=["theta"])
    assert validation.validate_fmu(str(path)) == []
    turn = 0.2 + sin(4 * em.t)
    times = np.linspace(0.0, 1.5, 61)
    orders = [lambdify(em.t, turn.diff(em.t, k)) for k in range(3)]
    unit, found = Unit(path, tmp_path / "a"), []
    names = ("friction_power", "force_front", "force_ram_pin", "x5")
    for before, t in zip((0.0, *times), times, strict=False):
        unit.set(**spelled(["theta"], *([float(at(t))] for at in orders)))
        if not found:
            unit.begin()
        unit.step(before, t - before)
        found.append(unit.get("force(theta)", *names))
    driven = em.drive(system_for(model), times, {"theta": turn})
    expected = np.vstack([driven.forces, *(driven.outputs[name] for name in names[:3]), driven.x[11]]).T
    assert (np.abs(found - expected).max(axis=0) < 1e-12 * np.abs(expected).max(axis=0)).all()
    rate = orders[1](times)
    assert (rate > 0.1).any()
    assert (rate < -0.1).any()
    assert (np.array(found)[:, 1] > 0.0).all()


def test_contacts_are_refused_by_name(tmp_path):
    h = dynamicsymbols("h")
    model = em.Model(name="falls", coordinates=[h], kinetic_energy=h.diff() ** 2 / 2,
                     contacts={"rub": em.Friction(h.diff(), limit=1.0), "ground": em.Contact(h)})  # fmt: skip
    with pytest.raises(ModelError, match=r"has no contacts, and 'ground' is one"):
        em.export_fmu(model, tmp_path / "unit.fmu", formulation="lagrange", inverse_dynamics=["h"])
