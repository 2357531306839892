"""Comparison of robots from files with Pinocchio and MuJoCo: mass matrix, inverse and forward dynamics.

python benchmarks/robots.py [FOLDER or FILE ...] [--states 100] [--base floating] [--poses]

Each URDF (against Pinocchio) and MJCF file (against MuJoCo) is read, and its equations are evaluated at random states.
A line has the coordinates, the time to read, and the largest error of M, of inverse and of forward dynamics, each
relative to the largest entry, that of forward dynamics also to the condition of M with a unit diagonal. Without
arguments: the files of example-robot-data. Pinocchio is the package `pin`. With --poses each robot is built, too, and
the places and Jacobians of all its links are compared with Pinocchio's.
"""

import argparse
import logging
import math
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import sympy
from eigenmotion.codegen.bodies.expansion import Expansion
from eigenmotion.codegen.bodies.scalar import Scalar
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.graph.store import Kind

import eigenmotion as em


class Equations:
    """The equations of a robot's bodies as nodes, evaluated at many states at once."""

    def __init__(self, robot: em.Robot) -> None:
        self.q = robot.coordinates
        self.n, self.graph = len(self.q), Graph()
        nodes = {q: self.graph.symbol(f"q{k}") for k, q in enumerate(self.q)}
        nodes |= {q.diff(): self.graph.symbol(f"v{k}") for k, q in enumerate(self.q)}
        quantity = robot.tree.kinetic_energy.quantity
        dynamics = Expansion(self.graph).dynamics(quantity.bodies, nodes)
        gravity = dynamics.links.scalars(robot.tree.gravity)
        a, u = ([Scalar(self.graph, self.graph.symbol(f"{x}{k}")) for k in range(self.n)] for x in "au")
        self.M = [entry.node for row in dynamics.mass_matrix for entry in row]
        self.torques = [entry.node for entry in dynamics.inverse_dynamics(a, gravity)]
        self.accelerations = [entry.node for entry in dynamics.accelerations(u, gravity)]

    def values(self, roots: list[int], states: dict[str, np.ndarray]) -> np.ndarray:
        """Return (number of roots, number of states)."""
        count = next(iter(states.values())).shape[1]
        at = {f"{x}{k}": row for x, rows in states.items() for k, row in enumerate(rows)}
        known: dict[int, np.ndarray | float] = {}
        for node in self.graph.reachable(roots):
            kind, operands = self.graph.records[node]
            if kind is Kind.NUMBER:
                known[node] = float(operands[0])
            elif kind is Kind.SYMBOL:
                known[node] = at[operands[0]]
            elif kind is Kind.SUM:
                known[node] = sum(float(factor) * known[child] for child, factor in operands)
            elif kind is Kind.PRODUCT:
                known[node] = math.prod(known[child] ** float(power) for child, power in operands)
            else:
                known[node] = getattr(np, operands[0])(known[operands[1]])
        return np.array([np.broadcast_to(known[root], count) for root in roots])


def random_states(n: int, count: int) -> dict[str, np.ndarray]:
    """Return positions, rates, accelerations and forces (n, count)."""
    chance = np.random.default_rng(1)
    return {"q": chance.uniform(-0.5, 0.5, (n, count)), "v": chance.normal(size=(n, count)),
            "a": chance.normal(size=(n, count)), "u": 10 * chance.normal(size=(n, count))}  # fmt: skip


def worst(got: np.ndarray, expected: np.ndarray) -> float:
    """Return the largest error relative to the largest entry."""
    return float(np.abs(got - expected).max() / max(np.abs(expected).max(), 1e-300))


def condition(M: np.ndarray) -> float:
    """Return the condition of a matrix scaled to a unit diagonal."""
    scale = 1 / np.sqrt(np.diag(M))
    return float(np.linalg.cond(M * np.outer(scale, scale)))


# -- orientation by modified Rodrigues parameters ----------------------------------------------------------------------


def skew(s: np.ndarray) -> np.ndarray:
    return np.array([[0, -s[2], s[1]], [s[2], 0, -s[0]], [-s[1], s[0], 0]])


def spin(s: np.ndarray) -> np.ndarray:
    """Return W (3, 3): the angular velocity in the body's axes is W sdot."""
    return 4 * ((1 - s @ s) * np.eye(3) - 2 * skew(s) + 2 * np.outer(s, s)) / (1 + s @ s) ** 2


def quaternion(s: np.ndarray) -> np.ndarray:
    """Return (x, y, z, w)."""
    return np.array([*(2 * s), 1 - s @ s]) / (1 + s @ s)


def spin_rate(s: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Return Wdot (3, 3), by the product rule."""
    d, d_rate = 1 + s @ s, 2 * s @ rate
    numerator = (1 - s @ s) * np.eye(3) - 2 * skew(s) + 2 * np.outer(s, s)
    change = -d_rate * np.eye(3) - 2 * skew(rate) + 2 * (np.outer(rate, s) + np.outer(s, rate))
    return 4 * (change / d**2 - 2 * d_rate * numerator / d**3)


# -- Pinocchio ---------------------------------------------------------------------------------------------------------


class Pinocchio:
    """A URDF file as Pinocchio reads it; rates of its coordinates are B xdot, with joints that others drive in B."""

    def __init__(self, file: Path, robot: em.Robot, floating: bool) -> None:
        import pinocchio  # noqa: PLC0415

        self.pin, self.robot = pinocchio, robot
        joint = (pinocchio.JointModelFreeFlyer(),) if floating else ()
        self.m = pinocchio.buildModelFromUrdf(str(file), *joint)
        self.m.gravity.linear[:] = [float(entry) for entry in robot.tree.gravity]
        self.d = self.m.createData()
        place = {q: k for k, q in enumerate(robot.coordinates)}
        self.rows = []
        for j in range(2 if floating else 1, self.m.njoints):
            position = robot.positions[self.m.names[j]]
            (q,) = position.atoms(sympy.Function)
            ratio = float(position.diff(q))
            self.rows.append((self.m.joints[j], place[q], ratio, float(position.subs(q, 0))))
        self.floating, self.driven = floating, self.m.nv > len(robot.coordinates)

    def placed(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return Pinocchio's q, and B."""
        pin, m = self.pin, self.m
        q, B = pin.neutral(m), np.zeros((m.nv, len(x)))
        for joint, k, ratio, offset in self.rows:
            angle = ratio * x[k] + offset
            q[joint.idx_q : joint.idx_q + joint.nq] = angle if joint.nq == 1 else (math.cos(angle), math.sin(angle))
            B[joint.idx_v, k] = ratio
        if self.floating:
            q[:3], q[3:7] = x[:3], quaternion(x[3:6])
            B[:3, :3], B[3:6, 3:6] = pin.Quaternion(q[3:7]).toRotationMatrix().T, spin(x[3:6])
        return q, B

    def link(self, name: str, x: np.ndarray, point: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return R, p of a link, and the Jacobian (6, n) of a point of it."""
        pin, m, d = self.pin, self.m, self.d
        q, B = self.placed(x)
        frame = m.getFrameId(name, pin.FrameType.BODY)
        J = pin.computeFrameJacobian(m, d, q, frame, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED)
        at = pin.updateFramePlacement(m, d, frame)
        J[:3] -= skew(at.rotation @ point) @ J[3:]
        return at.rotation, at.translation, J @ B

    def reference(self, x: np.ndarray, v: np.ndarray, a: np.ndarray, u: np.ndarray):
        """Return M, torques at a, accelerations under u."""
        pin, m, d, rest = self.pin, self.m, self.d, np.zeros(self.m.nv)
        q, B = self.placed(x)
        if self.floating:
            R = B[:3, :3].T
            rest[:3] = -np.cross(B[3:6, 3:6] @ v[3:6], R.T @ v[:3])
            rest[3:6] = spin_rate(x[3:6], v[3:6]) @ v[3:6]
        M = pin.crba(m, d, q)
        M = B.T @ (np.triu(M) + np.triu(M, 1).T) @ B
        torques = B.T @ pin.rnea(m, d, q, B @ v, B @ a + rest)
        if not self.driven:
            given = np.linalg.solve(B.T, u)
            return M, torques, np.linalg.solve(B, pin.aba(m, d, q, B @ v, given) - rest)
        return M, torques, np.linalg.solve(M, u - B.T @ pin.rnea(m, d, q, B @ v, rest))


# -- MuJoCo ------------------------------------------------------------------------------------------------------------


class MuJoCo:
    """An MJCF file as MuJoCo reads it, without contacts, limits and constraints; joints of one coordinate only."""

    def __init__(self, file: Path) -> None:
        import mujoco  # noqa: PLC0415

        self.mj, self.m = mujoco, mujoco.MjModel.from_xml_path(str(file))
        if any(kind < 2 for kind in self.m.jnt_type):
            raise em.ModelError("joints of several coordinates are not compared")
        if self.m.neq:
            raise em.ModelError("equality constraints are not compared")
        self.m.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT | mujoco.mjtDisableBit.mjDSBL_ACTUATION
        self.m.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_SPRING | mujoco.mjtDisableBit.mjDSBL_DAMPER
        self.m.dof_armature[:] = 0.0
        self.d = mujoco.MjData(self.m)

    def reference(self, x: np.ndarray, v: np.ndarray, a: np.ndarray, u: np.ndarray):
        """Return M, torques at a, accelerations under u."""
        mj, m, d = self.mj, self.m, self.d
        d.qpos[:], d.qvel[:], d.qfrc_applied[:] = x, v, u
        mj.mj_forward(m, d)
        M = np.zeros((m.nv, m.nv))
        mj.mj_fullM(m, d, M)
        accelerations = d.qacc.copy()
        return M, M @ a + d.qfrc_bias, accelerations


def links_compared(robot: em.Robot, oracle: Pinocchio, x: np.ndarray) -> str:
    """Return the largest errors of R, p and J of all links at positions (n, k), relative to the largest entry or 1."""
    start = time.perf_counter()
    system, errors = em.build(robot.model(), formulation="articulated_body"), np.zeros(3)
    built, point = time.perf_counter() - start, np.array([0.1, -0.2, 0.3])
    for name in system.bodies:
        poses, J = system.pose(name, x), system.jacobian_of(name, point, x)
        for k in range(x.shape[1]):
            got = *(one[..., k] for one in poses), J[..., k]
            for which, (one, other) in enumerate(zip(got, oracle.link(name, x[:, k], point), strict=True)):
                errors[which] = max(errors[which], np.abs(one - other).max() / max(1.0, np.abs(other).max()))
    return f"  built {built:4.1f} s  R {errors[0]:.1e}  p {errors[1]:.1e}  J {errors[2]:.1e}"


def compared(file: Path, count: int, floating: bool, poses: bool) -> str:
    """Return a line on a file."""
    start = time.perf_counter()
    mjcf = file.suffix == ".xml"
    robot = em.read_mjcf(file) if mjcf else em.read_urdf(file, base="floating" if floating else "fixed")
    read = time.perf_counter() - start
    oracle = MuJoCo(file) if mjcf else Pinocchio(file, robot, floating)
    ours = Equations(robot)
    made = time.perf_counter() - start - read
    states = random_states(ours.n, count)
    M, torques, accelerations = (ours.values(roots, states) for roots in (ours.M, ours.torques, ours.accelerations))
    errors = np.zeros(4)
    for k in range(count):
        reference = oracle.reference(*(states[x][:, k] for x in "qvau"))
        got = M[:, k].reshape(ours.n, ours.n), torques[:, k], accelerations[:, k]
        one = [worst(*pair) for pair in zip(got, reference, strict=True)]
        errors = np.maximum(errors, [*one, one[2] / condition(reference[0])])
    words = f"n {ours.n:3}  read {read:5.2f} s  nodes {made:5.2f} s  M {errors[0]:.1e}  inverse {errors[1]:.1e}"
    words += f"  forward {errors[2]:.1e} ({errors[3]:.1e} of the condition)"
    return words + links_compared(robot, oracle, states["q"][:, :5]) if poses and not mjcf else words


def example_robots() -> list[Path]:
    """Return the files of example-robot-data."""
    if find_spec("pinocchio") is None:
        sys.exit("comparison needs pinocchio: pip install pin example-robot-data")
    folders = [Path(place) / "cmeel.prefix/share/example-robot-data/robots" for place in sys.path]
    return sorted(file for folder in folders if folder.is_dir() for file in folder.rglob("*.urdf"))


def main() -> None:
    """Print a line for each file, and how many were read."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("paths", nargs="*", type=Path)
    options.add_argument("--states", type=int, default=100)
    options.add_argument("--base", choices=["fixed", "floating"], default="fixed")
    options.add_argument("--poses", action="store_true")
    given = options.parse_args()
    logging.getLogger("eigenmotion").setLevel(logging.ERROR)
    files = [file for path in given.paths for file in (sorted(path.rglob("*.urdf")) if path.is_dir() else [path])]
    files = files or example_robots()
    read = 0
    for file in files:
        try:
            words = compared(file, given.states, given.base == "floating", given.poses)
            read += 1
        except em.ModelError as error:
            words = f"refused: {error}"
        except ZeroDivisionError:
            words = "not compared: a joint moves no mass"
        except Exception as error:  # the oracle's own
            words = f"not compared: {type(error).__name__}: {error}"
        print(f"{file.name:40} {words}", flush=True)
    print(f"{read} of {len(files)} files compared")


if __name__ == "__main__":
    main()
