"""Benchmark of closed loops on trees of bodies: time of an acceleration, and how far the loops open in 100 s.

Five mechanisms whose loops are closed by ball joints: a gripper, a Delta robot, hanging legs with four-bar linkages, a
ring of links, and a Stewart platform. For each: nanoseconds of a right-hand side within a run by dop853, projections
included, also over the times of Pinocchio's `constraintDynamics` and `lcaba` (C++, called from Python) where it is
installed; the largest relative difference of the accelerations from those of `lcaba`; and the largest gap [m] in a
ball joint during 100 s, beside that of MuJoCo at its default settings where it is installed.

python benchmarks/loops.py [--inverse]

With `--inverse`: microseconds of a call of `System.inverse_dynamics` from Python, with as many actuators as freedoms,
and of one state of an array of a thousand; over the times of `constraintDynamics` and `lcaba`, which answer the
opposite question on the same mechanism.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from importlib import import_module
from importlib.util import find_spec
from statistics import median
from typing import Any

import numpy as np
from sympy import Matrix

import eigenmotion as em

ROUNDS, CALLS = 5, 1000
ACTUATORS = {
    "ball_gripper": ("left_crank", "right_crank"),
    "delta_robot": ("arm_a", "arm_b", "arm_c"),
    "legs": ("trunk", *(f"{side}_{joint}" for side in ("left", "right") for joint in ("hip", "thigh", "shank"))),
    "ring_of_links": tuple(f"link_{k}" for k in range(7)),
    "stewart_platform": tuple(f"piston_{k}" for k in range(6)),
}
"""As many as there are degrees of freedom."""
SECONDS = 100.0
ORIGIN = (0.0, 0.0, 0.0)
GROUND = "ground"


@dataclass
class Mechanism:
    """A tree whose bodies turn about or move along axes, given once for all tools, and its ball joints.

    bodies : name -> (parent, joint, axis, place of the joint, mass, mass centre, moments of inertia,
        angle of the joint's frame about z)
    balls : pairs of (body, point); the points of a pair are at one place
    """

    name: str
    start: dict[str, float]
    bodies: dict[str, tuple[Any, ...]] = field(default_factory=dict)
    balls: list[tuple[tuple[str, Any], tuple[str, Any]]] = field(default_factory=list)

    def add(
        self, name: str, parent: str | None, joint: str, axis: str, at: Any, mass: float, length: Any, turn: float = 0.0
    ) -> str:
        """Add a rod from its joint to `length` (3,); its joint is turned about z of the parent."""
        end = np.array(length, float)
        inertia = mass * (end @ end - end**2) / 12 + 1e-3 * mass
        self.bodies[name] = (parent, joint, axis, tuple(at), mass, tuple(end / 2), tuple(inertia), turn)
        return name

    def model(self) -> em.Model:
        """Return the model."""
        tree = em.Tree()
        for name, (parent, joint, axis, at, mass, center, inertia, turn) in self.bodies.items():
            tree.body(name, parent, joint=joint, axis=axis, at=at, mass=mass, center=center, inertia=inertia,
                      rotation=turned(turn))  # fmt: skip
        rows = [row for (a, p), (b, q) in self.balls
                for row in place(tree, a, p) - place(tree, b, q)]  # fmt: skip
        return em.Model(
            name=self.name,
            coordinates=tree.coordinates,
            kinetic_energy=tree.kinetic_energy,
            potential_energy=tree.potential_energy,
            holonomic_constraints=rows,
            initial={q: self.start[q.func.__name__] for q in tree.coordinates if q.func.__name__ in self.start},
        )


def place(tree: em.Tree, body: str, point: Any) -> Matrix:
    """Return the place of a point (3, 1)."""
    return Matrix(point) if body == GROUND else tree.bodies[body].position(point)


def gripper() -> Mechanism:
    """Two fingers, each a parallelogram, whose rockers are closed by a ball."""
    made = Mechanism("ball_gripper", {"left_crank": 0.4, "right_crank": -0.4})
    for side, sign in (("left", 1), ("right", -1)):
        crank = made.add(f"{side}_crank", None, "revolute", "x", (0, 0.03 * sign, 0), 0.1, (0, 0, 0.3))
        pad = made.add(f"{side}_pad", crank, "revolute", "x", (0, 0, 0.3), 0.1, (0, 0.1 * sign, 0))
        swing = made.add(f"{side}_swing", None, "revolute", "x", (0, 0.13 * sign, 0), 0.05, (0, 0, 0.05))
        rocker = made.add(f"{side}_rocker", swing, "revolute", "y", (0, 0, 0), 0.1, (0, 0, 0.3))
        made.balls.append(((pad, (0, 0.1 * sign, 0)), (rocker, (0, 0, 0.3))))
    return made


def delta() -> Mechanism:
    """A platform that its rods' parallelograms keep level, three arms, and three rods with two angles each."""
    made = Mechanism("delta_robot", {"platform": -0.45})
    for axis, carries in (("x", None), ("y", "x")):
        made.add(axis, carries, "prismatic", axis, ORIGIN, 0.01, ORIGIN)
    made.add("platform", "y", "prismatic", "z", ORIGIN, 0.5, (0.05, 0.05, 0))
    for k, side in enumerate("abc"):
        turn = 2 * np.pi * k / 3
        c, s = np.cos(turn), np.sin(turn)
        arm = made.add(f"arm_{side}", None, "revolute", "y", (0.2 * c, 0.2 * s, 0), 0.3, (0.3, 0, 0), turn)
        swing = made.add(f"swing_{side}", arm, "revolute", "y", (0.3, 0, 0), 0.01, ORIGIN)
        rod = made.add(f"rod_{side}", swing, "revolute", "x", ORIGIN, 0.2, (0, 0, -0.6))
        made.start |= {swing: 0.6}
        made.balls.append((("platform", (0.05 * c, 0.05 * s, 0)), (rod, (0, 0, -0.6))))
    return made


def legs() -> Mechanism:
    """A trunk that hangs, and turns, with two legs, whose feet are moved by rods as those of Cassie."""
    made = Mechanism("legs", {})
    made.add("trunk", None, "revolute", "z", ORIGIN, 10.0, (0.1, 0.1, 0.3))
    for side, sign in (("left", 1), ("right", -1)):
        hip = made.add(f"{side}_hip", "trunk", "revolute", "x", (0, 0.1 * sign, 0), 1.0, (0, 0, -0.05))
        thigh = made.add(f"{side}_thigh", hip, "revolute", "y", (0, 0, -0.05), 3.0, (0, 0, -0.4))
        shank = made.add(f"{side}_shank", thigh, "revolute", "y", (0, 0, -0.4), 1.5, (0, 0, -0.4))
        foot = made.add(f"{side}_foot", shank, "revolute", "y", (0, 0, -0.4), 0.5, (0.15, 0, 0))
        swing = made.add(f"{side}_swing", thigh, "revolute", "y", (-0.08, 0, -0.4), 0.02, ORIGIN)
        rod = made.add(f"{side}_rod", swing, "revolute", "x", ORIGIN, 0.2, (0, 0, -0.4))
        made.start |= {thigh: -0.5 * sign, shank: 0.7}
        made.balls.append(((foot, (-0.08, 0, 0)), (rod, (0, 0, -0.4))))
    return made


def ring(links: int = 10) -> Mechanism:
    """Links whose joints turn about z and y in turn; the last one ends at the ground."""
    made, last = Mechanism("ring_of_links", {}), None
    for k in range(links):
        last = made.add(f"link_{k}", last, "revolute", "zy"[k % 2], (0.3, 0, 0) if k else ORIGIN, 0.5, (0.3, 0, 0))
        made.start[last] = 4 * np.pi / links if k % 2 == 0 else 0.2
    made.balls.append(((last, (0.3, 0, 0)), (GROUND, (0, 0.1, 0))))
    return made


def stewart() -> Mechanism:
    """A platform on six legs: each a cylinder in a universal joint, and a piston with a ball joint at its end."""
    height, cylinder = 0.8, 0.4
    made, last = Mechanism("stewart_platform", {"height": height}), None
    for joint, axis in (("prismatic", "x"), ("prismatic", "y")):
        last = made.add(f"along_{axis}", last, joint, axis, ORIGIN, 0.01, ORIGIN)
    last = made.add("height", last, "prismatic", "z", ORIGIN, 0.01, ORIGIN)
    for axis in "zy":
        last = made.add(f"about_{axis}", last, "revolute", axis, ORIGIN, 0.01, ORIGIN)
    platform = made.add("about_x", last, "revolute", "x", ORIGIN, 10.0, (0.2, 0.2, 0.05))
    for k in range(6):
        low, high = (2 * np.pi * (k // 2) / 3 + sign * (-1) ** k for sign in (0.2, 0.9))
        foot, top = 0.6 * np.array([np.cos(low), np.sin(low), 0]), 0.3 * np.array([np.cos(high), np.sin(high), 0])
        leg = turned(-low) @ (top - foot + np.array([0, 0, height]))
        x, y, z = leg / np.linalg.norm(leg)
        swing = made.add(f"swing_{k}", None, "revolute", "y", foot, 0.05, ORIGIN, low)
        lower = made.add(f"cylinder_{k}", swing, "revolute", "x", ORIGIN, 1.0, (0, 0, cylinder))
        piston = made.add(f"piston_{k}", lower, "prismatic", "z", ORIGIN, 0.5, (0, 0, cylinder))
        made.start |= {swing: np.arctan2(x, z), lower: -np.arcsin(y), piston: np.linalg.norm(leg) - cylinder}
        made.balls.append(((platform, top), (piston, (0, 0, cylinder))))
    return made


def turned(angle: float) -> np.ndarray:
    """Return R (3, 3) about z."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


class Pinocchio:
    """The same mechanism in Pinocchio, at x, v (n,)."""

    def __init__(self, made: Mechanism, x: np.ndarray, v: np.ndarray) -> None:
        pin = self.pin = import_module("pinocchio")
        self.model, joints = pin.Model(), {None: 0, GROUND: 0}
        for name, (parent, joint, axis, at, mass, center, inertia, turn) in made.bodies.items():
            kind = getattr(pin, f"JointModel{joint[0].upper()}{axis.upper()}")()
            joints[name] = self.model.addJoint(joints[parent], kind, pin.SE3(turned(turn), np.array(at, float)), name)
            own = pin.Inertia(mass, np.array(center), np.diag(inertia))
            self.model.appendBodyToJoint(joints[name], own, pin.SE3.Identity())
        contacts = [
            pin.RigidConstraintModel(pin.ContactType.CONTACT_3D, self.model, joints[a], placed(pin, p), joints[b],
                                     placed(pin, q), pin.ReferenceFrame.LOCAL)
            for (a, p), (b, q) in made.balls
        ]  # fmt: skip
        self.rows = pin.StdVec_RigidConstraintModel()
        self.kept = pin.StdVec_RigidConstraintData()
        for one in contacts:
            self.rows.append(one)
            self.kept.append(one.createData())
        self.x, self.v, self.none = x, v, np.zeros(self.model.nv)
        self.data = self.model.createData()
        pin.initConstraintDynamics(self.model, self.data, self.rows, self.kept)
        self.by_lcaba = self.model.createData()
        pin.computeJointMinimalOrdering(self.model, self.by_lcaba, self.rows)
        self.proximal = pin.ProximalSettings(1e-12, 1e-6, 20)

    def constraint_dynamics(self) -> np.ndarray:
        """Return a (n,)."""
        return self.pin.constraintDynamics(self.model, self.data, self.x, self.v, self.none, self.rows, self.kept,
                                           self.proximal)  # fmt: skip

    def lcaba(self) -> np.ndarray:
        """Return a (n,)."""
        return self.pin.lcaba(self.model, self.by_lcaba, self.x, self.v, self.none, self.rows, self.kept, self.proximal)


def placed(pin: Any, point: Any) -> Any:
    """Return the placement of a point."""
    return pin.SE3(np.eye(3), np.array(point, float))


def per_call(function: Callable[[], Any]) -> float:
    """Return the nanoseconds of a call from Python."""
    start = time.perf_counter()
    for _ in range(CALLS):
        function()
    return (time.perf_counter() - start) / CALLS * 1e9


def within_a_run(system: em.System, x: np.ndarray, v: np.ndarray) -> float:
    """Return the nanoseconds of a right-hand side within a run, all of it counted."""
    start = time.perf_counter()
    run = system.simulate((0.0, 2.0), x0=x, v0=v, rtol=1e-9, method="dop853")
    return (time.perf_counter() - start) / run.nfev * 1e9


def gap(made: Mechanism, system: em.System, x: np.ndarray) -> float:
    """Return the largest distance [m] of the points of a ball joint, at x (n, k)."""

    def place(body: str, point: Any) -> np.ndarray:
        if body == GROUND:
            return np.array(point, float)[:, None]
        R, p = system.pose(body, x)
        return np.array(p + np.einsum("ijk,j->ik", R, np.array(point, float)))

    return max(float(np.linalg.norm(place(*one) - place(*other), axis=0).max()) for one, other in made.balls)


def of_mujoco(made: Mechanism, x: np.ndarray, v: np.ndarray) -> str:
    """Return the largest gap that MuJoCo leaves, in words; none where it is not installed."""
    if find_spec("mujoco") is None:
        return ""
    mujoco = import_module("mujoco")
    model = mujoco.MjModel.from_xml_string(mjcf(made))
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = x, v
    largest = 0.0
    for _ in range(round(SECONDS / model.opt.timestep)):
        mujoco.mj_step(model, data)
        if data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:
            return "; MuJoCo is unstable"
        ends = data.site_xpos.reshape(-1, 2, 3)
        largest = max(largest, float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).max()))
    return f"; MuJoCo {largest:.0e} m"


def mjcf(made: Mechanism) -> str:
    """Return the mechanism as MJCF with default settings."""
    children: dict[str | None, list[str]] = {}
    for name, (parent, *_) in made.bodies.items():
        children.setdefault(parent, []).append(name)
    sites: dict[str | None, list[str]] = {}
    for k, ends in enumerate(made.balls):
        for letter, (body, point) in zip("ab", ends, strict=True):
            own = f'<site name="{letter}{k}" pos="{words(point)}"/>'
            sites.setdefault(None if body == GROUND else body, []).append(own)

    def text(name: str) -> str:
        _, joint, axis, at, mass, center, inertia, turn = made.bodies[name]
        kind, along = {"revolute": "hinge", "prismatic": "slide"}[joint], [int(one == axis) for one in "xyz"]
        return (
            f'<body name="{name}" pos="{words(at)}" quat="{np.cos(turn / 2)!s} 0 0 {np.sin(turn / 2)!s}">'
            f'<inertial pos="{words(center)}" mass="{mass}" diaginertia="{words(inertia)}"/>'
            f'<joint type="{kind}" axis="{words(along)}"/>{"".join(sites.get(name, []))}'
            f"{''.join(map(text, children.get(name, [])))}</body>"
        )

    ties = "".join(f'<connect site1="a{k}" site2="b{k}"/>' for k in range(len(made.balls)))
    world = "".join([*sites.get(None, []), *map(text, children[None])])
    return f"<mujoco><compiler autolimits='true'/><worldbody>{world}</worldbody><equality>{ties}</equality></mujoco>"


def words(numbers: Any) -> str:
    """Return numbers separated by blanks."""
    return " ".join(str(float(one)) for one in numbers)


def report(made: Mechanism) -> None:
    """Print what a mechanism takes, and how far its loops open."""
    system = em.build(made.model(), formulation="articulated_body")
    x, _ = em.assemble(system)
    x, v = system.project_initial_state(x, np.random.default_rng(1).normal(size=system.n))
    other = Pinocchio(made, x, v) if find_spec("pinocchio") else None
    kinds: dict[str, Callable[[], float]] = {"in C": lambda: within_a_run(system, x, v)}
    if other:
        kinds |= {"constraintDynamics": lambda: per_call(other.constraint_dynamics),
                  "lcaba": lambda: per_call(other.lcaba)}  # fmt: skip
    rounds = [{name: measure() for name, measure in kinds.items()} for _ in range(ROUNDS)]
    times = {name: median(one[name] for one in rounds) for name in kinds}
    own = times["in C"]
    print(f"{made.name}: {system.n} coordinates, {system.m} rows")
    print(f"  a right-hand side {own:.0f} ns" + "".join(
        f", {own / ns:.2f} of {name}" for name, ns in times.items() if name != "in C"))  # fmt: skip
    if other:
        a, _ = system.acceleration(x, v)
        print(f"  accelerations differ from those of lcaba by {np.abs(a - other.lcaba()).max() / np.abs(a).max():.0e}")
    run = system.simulate((0.0, SECONDS), x0=x, v0=v, rtol=1e-6, method="dop853", t_eval=np.linspace(0, SECONDS, 2001))
    known = of_mujoco(made, x, v)
    print(f"  largest gap in {SECONDS:.0f} s: {gap(made, system, run.x):.0e} m"
          + known + ("" if run.success else f" ({run.message})"))  # fmt: skip


def report_inverse(made: Mechanism) -> None:
    """Print what the forces of actuators take."""
    system, actuators = em.build(made.model()), ACTUATORS[made.name]
    x, v = system.project_initial_state(em.assemble(system)[0], np.random.default_rng(1).normal(size=system.n))
    a, _ = system.acceleration(x, v)
    many = [np.repeat(one[:, None], CALLS, 1) for one in (x, v, a)]
    kinds: dict[str, Callable[[], float]] = {
        "one": lambda: per_call(lambda: system.inverse_dynamics(x, v, a, actuators=actuators)),
        "of many": lambda: timed(lambda: system.inverse_dynamics(*many, actuators=actuators)) / CALLS,
    }
    if find_spec("pinocchio"):
        other = Pinocchio(made, x, v)
        kinds |= {"constraintDynamics": lambda: per_call(other.constraint_dynamics),
                  "lcaba": lambda: per_call(other.lcaba)}  # fmt: skip
    rounds = [{name: measure() for name, measure in kinds.items()} for _ in range(ROUNDS)]
    times = {name: median(one[name] for one in rounds) for name in kinds}
    print(f"{made.name}: {system.n} coordinates, {system.m} rows, {len(actuators)} actuators")
    print(f"  one state {times['one'] / 1e3:.2f} us, one of many {times['of many'] / 1e3:.2f} us" + "".join(
        f", {times['one'] / ns:.2f} of {name}" for name, ns in times.items() if name[0] != "o"))  # fmt: skip


def timed(function: Callable[[], Any]) -> float:
    """Return the nanoseconds of one call."""
    start = time.perf_counter()
    function()
    return (time.perf_counter() - start) * 1e9


def main() -> None:
    """Print all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--inverse", action="store_true")
    for make in (gripper, delta, legs, ring, stewart):
        (report_inverse if parser.parse_args().inverse else report)(make())


if __name__ == "__main__":
    main()
