"""Random bodies on feet: at rest, sliding, about to strike, on ground that moves; all numbers of the order of one."""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from ..oracles.feet import Body, Foot, Ground, State, axes, point, turned

KINDS = ("rest", "moving", "strike")
FLAVOURS = {
    "rest": ("flat", "jaws", "wild", "inside"),
    "moving": ("flat", "jaws", "wild", "inside"),
    "strike": ("flat", "inside"),
}
"""Gaps are zero exactly, exactly, but for rounding, or inside by less than a tolerance: such are on the surface."""
INSIDE = 1e-12


@dataclass(frozen=True)
class Shape:
    """What is compiled: so many contacts, frictions on the first of them (lines, or cones), and brakes of their own."""

    contacts: int
    rubs: int = 0
    brakes: int = 0
    planar: bool = True
    cone: bool = False
    law: str = "newton"
    unequal: bool = False

    @property
    def name(self) -> str:
        words = ("planar" if self.planar else "spatial", f"c{self.contacts}", f"r{self.rubs}", f"b{self.brakes}")
        return "_".join([*words, *(w for w in ("cone", "unequal") if getattr(self, w)), self.law[0]])

    @property
    def ways(self) -> int:
        """Slips of one friction."""
        return 2 if self.cone else 1


@dataclass(frozen=True)
class Case:
    """A body and where it starts: x (3,), angles (3,), velocities u (6,); units of length, mass, time to run it in."""

    shape: Shape
    kind: str
    flavour: str
    body: Body
    x: np.ndarray
    angles: np.ndarray
    u: np.ndarray
    units: tuple[float, float, float]

    @property
    def state(self) -> State:
        return State(self.x, turned(self.angles), self.u)

    @property
    def rates(self) -> np.ndarray:
        """Of the angles."""
        return np.linalg.solve(axes(self.angles), self.u[3:])


def drawn(shape: Shape, seed: int) -> Case:
    """Return one of the cases of a shape."""
    random = np.random.default_rng([seed, shape.contacts, shape.rubs, shape.brakes, shape.planar, shape.cone])
    kind = KINDS[seed % 3]
    flavour = str(random.choice(FLAVOURS[kind]))
    units = tuple(10.0 ** random.uniform(-3, 3, 3)) if random.uniform() < 0.5 else (1.0, 1.0, 1.0)
    inside = INSIDE if flavour == "inside" else 0.0
    start = flat if flavour == "flat" else jaws if flavour == "jaws" else partial(wild, inside=inside)
    body, x, angles, u = start(shape, kind, random)
    return Case(shape, kind, flavour, body, x, angles, u, units)


def numbers(shape: Shape, random: np.random.Generator) -> dict[str, object]:
    """Mass, moments, forces."""
    force, torque = random.normal(size=3), random.normal(size=3) * random.choice([0.0, 0.5, 1.5])
    force[1 if shape.planar else 2] = -random.uniform(0.5, 2.0) if random.uniform() < 0.8 else random.normal()
    if shape.planar:
        force[2] = torque[0] = torque[1] = 0.0
    J = random.uniform(1.0, 1.8, 3) * random.choice([0.05, 0.3, 1.0])
    return {
        "m": random.uniform(0.3, 3.0), "J": J, "force": force, "torque": torque, "planar": shape.planar,
        "rest": 1e-6, "law": shape.law,
    }  # fmt: skip


def foot(shape: Shape, k: int, at: np.ndarray, ground: Ground, random: np.random.Generator) -> Foot:
    mu = random.uniform(0.05, 1.0) * random.choice([1.0, 1.0, 4.0])
    more = random.uniform(1.0, 1.6) if shape.unequal else 1.0
    e = random.choice([0.0, 1.0, random.uniform()])
    return Foot(at, ground, mu, mu * more, float(e), presses=k < shape.contacts)


def tangents(shape: Shape, normal: np.ndarray, random: np.random.Generator, k: int) -> np.ndarray:
    """Directions (d, 3) in which foot k rubs; for a line either way round."""
    if not (k < shape.rubs or k >= shape.contacts):
        return np.zeros((0, 3))
    if shape.planar:
        return np.array([[normal[1], -normal[0], 0.0]]) * random.choice([-1.0, 1.0])
    first = np.cross(normal, random.normal(size=3))
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(normal, first)])[: shape.ways]


def still(shape: Shape, normal: np.ndarray, random: np.random.Generator, k: int) -> Ground:
    along = tangents(shape, normal, random, k)
    return Ground(normal, along, belt=np.zeros(len(along)), pull=np.zeros(len(along)))


def flat(shape: Shape, kind: str, random: np.random.Generator) -> tuple[Body, np.ndarray, np.ndarray, np.ndarray]:
    """All feet on one plane that rests, under a body that rests, slides and spins on it, drops flat or rocks."""
    up = np.eye(3)[1 if shape.planar else 2]
    height, count = random.uniform(0.0, 1.0), shape.contacts + shape.brakes
    across = random.uniform(-1.0, 1.0, (count, 3))
    if random.uniform() < 0.3 and shape.planar:
        across[: shape.contacts, 0] = np.resize([-0.5, 0.5, 0.0, 1.0], shape.contacts)
    at = across * (1 - up) * ([1, 0, 0] if shape.planar else [1, 1, 0]) - height * up
    feet = tuple(
        foot(shape, k, at[k], replace(still(shape, up, random, k), level=-height), random) for k in range(count)
    )
    u = np.zeros(6)
    if kind != "rest":
        u[0] = random.normal()
    if kind == "moving" and not shape.planar:
        u[1], u[5] = random.normal(size=2) * random.choice([0.0, 1.0])
    if kind == "strike":
        u += falling(shape, at, random)
    return Body(feet=feet, **numbers(shape, random)), np.zeros(3), np.zeros(3), u  # type: ignore[arg-type]


def falling(shape: Shape, at: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Velocities that drop it flat, or turn it about its first foot so that another comes down."""
    up, turn = (1, 5) if shape.planar else (2, 4)
    u = np.zeros(6)
    if random.uniform() < 0.5 or shape.contacts < 2:
        u[up] = -random.uniform(0.2, 2.0)
        return u
    sign = -np.sign(at[1, 0] - at[0, 0]) * (1 if shape.planar else -1)
    u[turn] = sign * random.uniform(0.2, 2.0)
    u[:3] = -np.cross(u[3:], at[0])
    return u


def jaws(shape: Shape, kind: str, random: np.random.Generator) -> tuple[Body, np.ndarray, np.ndarray, np.ndarray]:
    """Feet pressed from opposite sides by walls that rest or run along them."""
    count = shape.contacts + shape.brakes
    feet = []
    for k in range(count):
        side = -1.0 if k % 2 else 1.0
        at = np.array([-side * 0.5, *random.choice([-0.5, 0.0, 0.5], 2)]) * ([1, 1, 0] if shape.planar else 1)
        ground = still(shape, side * np.eye(3)[0], random, k)
        moves = random.normal(size=len(ground.along)) * (kind == "moving") * (random.uniform() < 0.5)
        feet.append(foot(shape, k, at, replace(ground, level=-0.5, belt=moves), random))
    return Body(feet=tuple(feet), **numbers(shape, random)), np.zeros(3), np.zeros(3), np.zeros(6)  # type: ignore[arg-type]


def wild(
    shape: Shape, kind: str, random: np.random.Generator, inside: float
) -> tuple[Body, np.ndarray, np.ndarray, np.ndarray]:
    """Each foot on ground of its own, which moves so that gaps and slips have the rates they should."""
    angles, u = random.uniform(-0.3, 0.3, 3), random.normal(size=6)
    x = random.normal(size=3)
    if shape.planar:
        angles[:2], u[2:5], x[2] = 0.0, 0.0, 0.0
    s, feet = State(x, turned(angles), u), []
    for k in range(shape.contacts + shape.brakes):
        normal = random.normal(size=3) * ([1, 1, 0] if shape.planar else 1) + 1.5 * np.eye(3)[1 if shape.planar else 2]
        normal /= np.linalg.norm(normal)
        at = random.uniform(-1, 1, 3) * ([1, 1, 0] if shape.planar else 1)
        feet.append(placed(foot(shape, k, at, still(shape, normal, random, k), random), s, kind, random, inside))
    return Body(feet=tuple(feet), **numbers(shape, random)), x, angles, u  # type: ignore[arg-type]


def placed(foot: Foot, s: State, kind: str, random: np.random.Generator, inside: float) -> Foot:
    """Return the foot on ground where it is closed or far, held, parting or approaching, sticking or sliding."""
    found, d = point(foot, s), len(foot.ground.along)
    far = 1.0 if random.uniform() < 0.15 and foot.presses else 0.0
    rate = wanted_rate(kind, random)
    slides = random.uniform() < {"rest": 0.0, "moving": 0.6, "strike": 0.7}[kind]
    slip = random.uniform(0.2, 2.0, d) * random.choice([-1, 1], d) * slides
    ground = replace(
        foot.ground, level=found.gap - far + inside, rate=found.rate - rate, belt=found.slip - slip,
        lift=random.normal() * random.choice([0.0, 1.0]), pull=random.normal(size=d) * random.choice([0.0, 1.0]),
    )  # fmt: skip
    return replace(foot, ground=ground)


def wanted_rate(kind: str, random: np.random.Generator) -> float:
    chance, size = random.uniform(), random.uniform(0.2, 2.0)
    if kind == "strike":
        return -size if chance < 0.5 else (0.0 if chance < 0.85 else size)
    return size if chance < 0.1 else 0.0
