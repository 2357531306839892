"""Random mechanisms with contacts, impacts, frictions, constraints, tables, resets and states, in units to be chosen.

As in `random_units`, X = c + s x are positions, V = s x' / k their rates, tau = k (t - t_0) the time, of a mechanism
whose numbers are of order one. Rows, gaps, slips and tables have units of their own: r times the number of order one.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp
from scipy.interpolate import CubicSpline
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Event, Friction, Model, t

from .random_units import InUnits

PARTS = (
    "ball", "ball_on_plate", "walls", "rubbed", "belt", "block", "cone", "ring", "skate", "tabled", "bent", "filtered",
    "gate",
)  # fmt: skip
POINTS = np.linspace(-3.0, 3.0, 13)
START_OF_Z = 0.3
LOAD = -POINTS * (1.0 + 0.3 * np.sin(2.0 * POINTS))


class Scene:
    """One to three parts, most of them joined by springs; everything follows from the seed."""

    def __init__(self, seed: int) -> None:
        self.seed, self.random = seed, np.random.default_rng(seed)
        self.X: list[sp.Symbol] = []
        self.V: list[sp.Symbol] = []
        self.x0: list[float] = []
        self.v0: list[float] = []
        self.P: dict[sp.Symbol, float] = {}
        self.T = self.U = sp.Integer(0)
        self.F: dict[int, sp.Expr] = {}
        self.gaps: dict[str, tuple] = {}
        self.slips: dict[str, tuple] = {}
        self.impacts: dict[str, tuple] = {}
        self.resets: dict[str, tuple] = {}
        self.rows: dict[str, sp.Expr] = {}
        self.rates: dict[str, sp.Expr] = {}
        self.loads: dict[str, int] = {}
        self.Z: sp.Symbol | None = None
        self.rate = sp.Integer(0)
        self.tau, self.parts = sp.Symbol("tau"), [str(p) for p in self.random.choice(PARTS, self.some(), replace=False)]
        first = []
        for part in self.parts:
            first.append(len(self.X))
            getattr(self, part)()
        for a, b in pairwise(first):
            if self.random.random() < 0.7:
                self.U += self.new("c", 0.05, 0.3) * (self.X[a] - self.X[b]) ** 2 / 2
        self.n, self.end = len(self.X), self.number(3.0, 6.0)
        self.order = self.random.permutation(self.n)

    def some(self) -> int:
        return int(self.random.integers(1, 4))

    def number(self, low: float, high: float) -> float:
        return float(self.random.uniform(low, high))

    def new(self, name: str, low: float = 0.5, high: float = 2.0) -> sp.Symbol:
        symbol = sp.Symbol(f"{name}_{len(self.P)}", positive=True)
        self.P[symbol] = self.number(low, high)
        return symbol

    def mass(self, x: float, v: float) -> tuple[sp.Symbol, sp.Symbol, sp.Symbol]:
        X, V, m = sp.Symbol(f"X{len(self.X)}"), sp.Symbol(f"V{len(self.X)}"), self.new("m")
        self.F[len(self.X)] = sp.Integer(0)
        self.X.append(X), self.V.append(V), self.x0.append(x), self.v0.append(v)
        self.T += m * V**2 / 2
        return X, V, m

    def spring(self) -> tuple[sp.Symbol, sp.Symbol, sp.Symbol]:
        X, V, m = self.mass(self.number(0.3, 1.2), self.number(-0.5, 0.5))
        self.U += self.new("k") * X**2 / 2
        return X, V, m

    def faller(self, x: float, v: float) -> sp.Symbol:
        X, _, m = self.mass(x, v)
        self.U += m * self.new("g", 1.0, 3.0) * X
        return X

    # -- parts -----------------------------------------------------------------------------------------------------

    def ball(self) -> None:
        X = self.faller(self.number(0.5, 1.5), self.number(-0.5, 0.5))
        self.gaps["floor"] = (X, self.new("e", 0.3, 0.8), self.new("r", 0.02, 0.05))

    def ball_on_plate(self) -> None:
        X = self.faller(self.number(0.5, 1.5), self.number(-0.5, 0.5))
        plate = self.new("A", 0.02, 0.1) * sp.sin(self.new("om", 2.0, 4.0) * self.tau)
        self.gaps["plate"] = (X - plate, self.new("e", 0.1, 0.6), self.new("r", 0.05, 0.1))

    def walls(self) -> None:
        X, _, _ = self.spring()
        self.impacts["wall"] = (X + self.new("b", 0.1, 0.3), self.new("e", 0.5, 0.9))

    def rubbed(self) -> None:
        _, V, _ = self.spring()
        rest = self.new("l", 0.25, 0.35) if self.random.random() < 0.5 else None
        self.slips["rub"] = ((V,), self.new("l", 0.1, 0.2), None, rest)

    def belt(self) -> None:
        _, V, _ = self.spring()
        self.slips["belt"] = ((V - self.new("w", 0.3, 0.5),), self.new("l", 0.5, 0.7), None, None)

    def block(self) -> None:
        _, V, _ = self.spring()
        Z = self.faller(float(self.random.choice([0.0, 0.2])), 0.0)
        self.gaps["ground"] = (Z, self.new("e", 0.1, 0.5), self.new("r", 0.05, 0.1))
        self.slips["drag"] = ((V,), self.new("mu", 0.1, 0.3), "ground", None)

    def cone(self) -> None:
        (_, V, _), (_, W, _) = self.spring(), self.spring()
        self.gaps["flat"] = (self.faller(0.0, 0.0), self.new("e", 0.1, 0.5), self.new("r", 0.05, 0.1))
        self.slips["slide"] = ((V, W), self.new("mu", 0.1, 0.3), "flat", None)

    def ring(self) -> None:
        angle, rate = self.number(-0.9, 0.2), self.number(-0.5, 0.5)
        X, V, _ = self.mass(np.cos(angle), -rate * np.sin(angle))
        Y, W, m = self.mass(np.sin(angle), rate * np.cos(angle))
        self.U += m * self.new("g", 1.0, 3.0) * Y
        self.rows["rod"] = X**2 + Y**2 - 1
        if self.random.random() < 0.6:
            self.slips["pivot"] = ((X * W - Y * V,), self.new("mu", 0.05, 0.2), "rod", None)

    def skate(self) -> None:
        (_, V, _), (_, W, _) = self.spring(), self.spring()
        H, _, _ = self.mass(0.5, self.number(-0.5, 0.5))
        self.v0[-3:-1] = [0.3, 0.3 * float(np.tan(0.5))]
        self.rates["edge"] = V * sp.sin(H) - W * sp.cos(H)

    def tabled(self, name: str = "smooth") -> None:
        self.mass(self.number(0.3, 1.2), self.number(-0.5, 0.5))
        self.loads[name] = len(self.X) - 1

    def bent(self) -> None:
        self.tabled("linear")

    def filtered(self) -> None:
        _, V, _ = self.spring()
        self.Z = sp.Symbol("Z")
        self.rate = -self.new("R") * self.Z - self.new("K") * V
        self.F[len(self.X) - 1] += self.new("K") * self.Z

    def gate(self) -> None:
        X, _, _ = self.spring()
        self.resets["gate"] = (X - self.new("b", 0.1, 0.2), len(self.X) - 1, self.new("a", 0.7, 0.9))

    # -- the model -------------------------------------------------------------------------------------------------

    @property
    def names(self) -> list[str]:
        """Of what derivatives are taken by."""
        q = [f"q{i}" for i in range(self.n)]
        return [*q, *(f"{name}'" for name in q), *(["z"] if self.Z is not None else []), *map(str, self.P)]

    def model(self) -> Model:
        """Return the model; units are parameters."""
        return _Writer(self).model()

    def signed(self, name: str) -> bool:
        """Whether the unit of a row may be negative."""
        return name in self.rows | self.rates | self.loads or len(self.slips.get(name, ((0, 0),))[0]) == 1


class _Writer:
    """A scene with units as parameters."""

    def __init__(self, of: Scene) -> None:
        n, self.of = of.n, of
        self.q, self.z = [dynamicsymbols(f"q{i}") for i in range(n)], dynamicsymbols("z")
        self.s, self.c = sp.symbols(f"s_:{n}", nonzero=True), sp.symbols(f"o_:{n}", real=True)
        self.k, self.e, origin, self.w = *sp.symbols("k_t e_0", positive=True), *sp.symbols("t_0 s_z", real=True)
        units = {p: sp.Symbol(f"u_{p}", positive=True) for p in of.P}
        self.values: dict[Any, float] = dict.fromkeys([*self.s, self.k, self.e, self.w, *units.values()], 1.0)
        self.values |= of.P | dict.fromkeys([*self.c, origin], 0.0)
        self.put = {p: unit * p for p, unit in units.items()} | {self.of.tau: self.k * (t - origin)}
        self.put |= {X: self.c[i] + self.s[i] * self.q[i] for i, X in enumerate(of.X)}
        self.put |= {V: self.s[i] * self.q[i].diff(t) / self.k for i, V in enumerate(of.V)}
        self.put |= {} if of.Z is None else {of.Z: self.w * self.z}

    def __call__(self, e: Any) -> sp.Expr:
        return sp.sympify(e).xreplace(self.put)

    def unit(self, name: str) -> sp.Symbol:
        symbol = sp.Symbol(f"r_{name}", **{"nonzero" if self.of.signed(name) else "positive": True})
        self.values[symbol] = 1.0
        return symbol

    def model(self) -> Model:
        of, energy = self.of, self.e
        given = {
            "kinetic_energy": self(energy * of.T), "potential_energy": self(energy * of.U), "forces": self.forces(),
            "contacts": self.contacts(), "events": self.events(),
            "holonomic_constraints": {name: self.unit(name) * self(e) for name, e in of.rows.items()},
            "nonholonomic_constraints": [self.unit(name) * self.k * self(e) for name, e in of.rates.items()],
            "states": dict.fromkeys([self.z] * (of.Z is not None), self(of.rate) * self.k / self.w),
        }  # fmt: skip
        used = set().union(*(_symbols(one) for one in given.values()))
        return Model(
            name=f"scene_{of.seed}", coordinates=[self.q[i] for i in of.order],
            parameters={p: value for p, value in self.values.items() if p in used}, **given,
        )  # fmt: skip

    def forces(self) -> dict[sp.Expr, sp.Expr]:
        F = [self(self.e * self.of.F[i]) for i in range(self.of.n)]
        for name, i in self.of.loads.items():
            table = em.Table(load(name, POINTS, LOAD), outside="extend", name=name)
            F[i] += self.e * self.unit(name) * table(self.q[i])
        return {q: s * f for q, s, f in zip(self.q, self.s, F, strict=True)}

    def contacts(self) -> dict[str, Contact | Friction]:
        of, made = self.of, dict[str, Contact | Friction]()
        for name, (gap, e, rest) in of.gaps.items():
            made[name] = Contact(self.unit(name) * self(gap), self(e), self.unit(name) * self.k * self(rest))
        for name, (slips, limit, normal, rest) in of.slips.items():
            unit = self.unit(name)
            scale = (self.e if normal is None else sp.Abs(self.unit(normal))) / sp.Abs(unit)
            slip = tuple(unit * self.k * self(one) for one in slips)
            more = {} if rest is None else {"limit_at_rest": scale * self(rest)}
            made[name] = Friction(slip if len(slip) > 1 else slip[0], scale * self(limit), normal, **more)
        return made

    def events(self) -> dict[str, Event]:
        made = {}
        for name, (gap, e) in self.of.impacts.items():
            phi = self.unit(name) * self(gap)
            made[name] = Event(phi, direction=-1, impact=(phi, self(e)))
        for name, (gate, i, part) in self.of.resets.items():
            rate = self.q[i].diff(t)
            made[name] = Event(self.unit(name) * self(gate), direction=1, reset={rate: rate * self(part)})
        return made


def load(name: str, points: np.ndarray, values: np.ndarray) -> Any:
    return CubicSpline(points, values) if name == "smooth" else (points, values)


def _symbols(one: Any) -> set[sp.Symbol]:
    """Of all expressions in what a model is given."""
    if isinstance(one, dict):
        one = [*one.keys(), *one.values()]
    if isinstance(one, Contact):
        one = [one.gap, one.restitution, one.rest]
    if isinstance(one, Friction):
        one = [*one.slips, one.limit, one.sticking]
    if isinstance(one, Event):
        one = [one.expression, *(one.impact or ()), *(value for _, value in one.reset or ())]
    if isinstance(one, str):
        return set()
    return set().union(*map(_symbols, one)) if isinstance(one, Iterable) else sp.sympify(one).free_symbols


@dataclass
class Choice(InUnits):
    """One choice of units, signs, an origin and a clock; `widest` 0: numbers are of order one."""

    of: Scene
    random: np.random.Generator
    widest: float = 6.0
    rows: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        n, random, some = self.of.n, self.random, self.widest > 0.0
        self.s = np.array([self.one() for _ in range(n)]) * (random.choice([-1.0, 1.0], n) if some else 1.0)
        self.c = some * random.choice([0.0, 1.0]) * random.uniform(-2.0, 2.0, n)
        self.k, self.energy, self.z = self.one(), self.one(), self.one()
        self.t_0 = some * float(random.choice([0.0, 1.0]) * random.uniform(-20.0, 20.0)) / self.k
        self.own = {str(p): self.one() for p in self.of.P}

    def one(self) -> float:
        return float(10 ** self.random.uniform(-self.widest, self.widest))

    def row(self, name: str) -> float:
        if name not in self.rows:
            signs = [-1.0, 1.0] if self.widest > 0.0 and self.of.signed(name) else [1.0]
            self.rows[name] = self.one() * float(self.random.choice(signs))
        return self.rows[name]

    def given(self, known: dict[str, Any], rtol: float) -> dict[str, Any]:
        """Arguments of a run; `known`: the parameters of the system. Tolerances are rtol of numbers of order one."""
        of, n, positions = self.of, self.of.n, {}
        values = {"k_t": self.k, "e_0": self.energy, "t_0": self.t_0, "s_z": self.z}
        values |= {f"s_{i}": self.s[i] for i in range(n)} | {f"o_{i}": self.c[i] for i in range(n)}
        values |= {f"u_{p}": self.own[str(p)] for p in of.P} | {str(p): v / self.own[str(p)] for p, v in of.P.items()}
        values |= {name: self.row(name[2:]) for name in known if name.startswith("r_") and name not in values}
        positions = {f"q{i}": float((of.x0[i] - self.c[i]) / self.s[i]) for i in range(n)}
        tolerances = {f"q{i}": rtol / abs(self.s[i]) * min(1.0, self.k) for i in range(n)}
        state = dict.fromkeys(["z"] * (of.Z is not None), START_OF_Z / self.z)
        return {
            "x0": positions | state, "v0": {f"q{i}": of.v0[i] * self.k / self.s[i] for i in range(n)}, "rtol": rtol,
            "atol": tolerances | dict.fromkeys(state, rtol / self.z),
            "parameters": {name: float(values[name]) for name in known if name in values} | self.loads(),
        }  # fmt: skip

    def loads(self) -> dict[str, Any]:
        """Tables of x in place of X."""
        found = {}
        for name, i in self.of.loads.items():
            way = int(np.sign(self.s[i]))
            points, values = (POINTS - self.c[i]) / self.s[i], LOAD / self.row(name)
            found[name] = load(name, points[::way], values[::way])
        return found

    def forces(self, multipliers: np.ndarray) -> np.ndarray:
        """Multipliers (m, nt) in the mechanism's own units: of constraints and gaps, rates, slips."""
        of = self.of
        names = [*of.rows, *of.gaps, *of.rates, *(name for name, (slips, *_) in of.slips.items() for _ in slips)]
        return multipliers * np.array([self.row(name) for name in names]).reshape(-1, 1) / self.energy
