"""Random mechanisms with units, signs, origins and clocks as parameters, and their motion by SciPy.

X = c + s x are the positions, V = s x' / k their rates and tau = k (t - t_0) the time of a mechanism whose numbers are
of order one; what a model's user chooses are s, c, k, t_0, the order of x, and units of energy, parameters and states.
"""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, t

KINDS = ("pendulum", "spring", "damped", "rests", "cubic", "free")


class Mechanism:
    """One mechanism; everything follows from the seed."""

    def __init__(self, seed: int) -> None:
        self.seed, self.random = seed, np.random.default_rng(seed)
        n = self.n = int(self.random.integers(1, 5))
        self.X, self.V, self.tau = sp.symbols(f"X:{n}", real=True), sp.symbols(f"V:{n}", real=True), sp.Symbol("tau")
        self.P: dict[sp.Symbol, float] = {}
        self.T = self.U = sp.Integer(0)
        self.F = [sp.Integer(0)] * n
        self.start = np.concatenate([self.random.uniform(-0.8, 0.8, n), self.random.uniform(-0.5, 0.5, n)])
        self.kinds = [str(self.random.choice(KINDS)) for _ in range(n)]
        for i, kind in enumerate(self.kinds):
            self.add(i, kind)
        for i in range(n):
            for j in range(i):
                self.couple(i, j)
        self.Z = sp.Symbol("Z") if self.random.random() < 0.4 else None
        if self.Z is not None:
            self.Zdot = -self.new("R") * self.Z - self.new("K") * self.V[0]
            self.F[0] += self.new("K") * self.Z
            self.start = np.append(self.start, 0.3)
        if self.random.random() < 0.3:
            self.F[0] += self.new("f") * sp.sin(self.new("om") * self.tau)
        self.end, self.order = float(self.random.uniform(3, 8)), self.random.permutation(n)

    def new(self, name: str, low: float = 0.5, high: float = 2.0) -> sp.Symbol:
        symbol = sp.Symbol(f"{name}_{len(self.P)}", positive=True)
        self.P[symbol] = float(self.random.uniform(low, high))
        return symbol

    def add(self, i: int, kind: str) -> None:
        X, V = self.X[i], self.V[i]
        m = self.new("m")
        self.T += m * V**2 / 2
        if kind == "pendulum":
            self.U -= m * self.new("g") * sp.cos(X)
        elif kind != "free":
            self.U += self.new("k") * X**2 / 2 + (self.new("h") * X**4 / 4 if kind == "cubic" else 0)
        if kind == "damped":
            self.F[i] -= self.new("d", 0.05, 0.3) * V
        if kind == "rests":
            self.start[[i, self.n + i]] = 0.0

    def couple(self, i: int, j: int) -> None:
        (X, Y), (V, W), chance = (self.X[i], self.X[j]), (self.V[i], self.V[j]), self.random.random()
        if "rests" in (self.kinds[i], self.kinds[j]) or chance > 0.75:
            return
        if chance < 0.35:
            self.U += self.new("c") * (X - Y) ** 2 / 2
        elif chance < 0.6:
            self.T += self.new("b", 0.05, 0.3) * sp.cos(X - Y) * V * W
        else:
            self.T += self.new("w") * Y**2 * V**2 / 2

    @property
    def names(self) -> list[str]:
        """Of what derivatives are taken by."""
        x = [f"q{i}" for i in range(self.n)]
        state = ["z"] if self.Z is not None else []
        return [*x, *(f"{name}'" for name in x), *state, *(str(p) for p in self.P)]

    def model(self) -> Model:
        """Return the model; units are parameters."""
        n, q, z = self.n, [dynamicsymbols(f"q{i}") for i in range(self.n)], dynamicsymbols("z")
        s, c = sp.symbols(f"s_:{n}", nonzero=True), sp.symbols(f"o_:{n}", real=True)
        k, energy, origin, unit = sp.symbols("k_t e_0 t_0 s_z", real=True)
        put = {X: c[i] + s[i] * q[i] for i, X in enumerate(self.X)} | {p: sp.Symbol(f"u_{p}") * p for p in self.P}
        put |= {V: s[i] * q[i].diff(t) / k for i, V in enumerate(self.V)} | {self.tau: k * (t - origin)}
        put |= {self.Z: unit * z} if self.Z is not None else {}
        T, U, *F = ((energy * e).xreplace(put) for e in (self.T, self.U, *self.F))
        forces = {x: s[i] * F[i] for i, x in enumerate(q)}
        states = {z: self.Zdot.xreplace(put) * k / unit} if self.Z is not None else {}
        used = set().union(*(sp.sympify(e).free_symbols for e in (T, U, *forces.values(), *states.values())))
        values = dict.fromkeys([*s, k, energy, unit, *(sp.Symbol(f"u_{p}") for p in self.P)], 1.0) | self.P
        values |= dict.fromkeys([*c, origin], 0.0)
        return Model(
            name=f"in_units_{self.seed}", coordinates=[q[i] for i in self.order], kinetic_energy=T, potential_energy=U,
            forces=forces, states=states, parameters={p: value for p, value in values.items() if p in used},
        )  # fmt: skip

    @cached_property
    def motion(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Times tau, (X, V) at them (2 n, 9) and its derivatives (2 n, names, 9), by the variational equations."""
        a, n, p, times = sp.symbols(f"a:{self.n}"), self.n, list(self.P), np.linspace(0.0, self.end, 9)
        L, y = self.T - self.U, [*self.X, *self.V, *([self.Z] if self.Z is not None else [])]

        def rate(e: sp.Expr) -> sp.Expr:
            pairs = zip((*self.X, *self.V), (*self.V, *a), strict=True)
            return sum((e.diff(one) * its for one, its in pairs), e.diff(self.tau))

        E = sp.Matrix([rate(L.diff(v)) - L.diff(x) - f for x, v, f in zip(self.X, self.V, self.F, strict=True)])
        zdot = sp.Matrix([self.Zdot] if self.Z is not None else [])
        parts = (E.jacobian(a), E.subs(dict.fromkeys(a, 0)), E.jacobian([*y, *p]), zdot)
        M, rest, slope, own = (sp.lambdify([*y, self.tau, *p, *a], part, "numpy") for part in parts)
        by = sp.lambdify([*y, self.tau, *p, *a], zdot.jacobian([*y, *p]) if self.Z is not None else zdot, "numpy")
        here, k = list(self.P.values()), len(y)

        def f(tau: float, w: np.ndarray) -> np.ndarray:
            state, S = w[:k], np.vstack([w[k:].reshape(k, -1), np.eye(k + len(p))[k:]])
            at = [*state, tau, *here]
            mass = M(*at, *a_zero)
            acceleration = np.linalg.solve(mass, -rest(*at, *a_zero).ravel())
            change = -np.linalg.solve(mass, slope(*at, *acceleration)) @ S
            dy, dS = [state[n : 2 * n], acceleration], [S[n : 2 * n], change]
            if self.Z is not None:
                dy, dS = [*dy, own(*at, *a_zero).ravel()], [*dS, by(*at, *a_zero) @ S]
            return np.concatenate([*dy, np.vstack(dS).ravel()])

        a_zero, S0 = [0.0] * n, np.eye(k, k + len(p)).ravel()
        run = solve_ivp(f, (0.0, self.end), [*self.start, *S0], method="DOP853", rtol=1e-12, atol=1e-13, t_eval=times)
        return times, run.y[: 2 * n], run.y[k:].reshape(k, -1, 9)[: 2 * n]


class InUnits:
    """Rows of X = c + s x and tau = k (t - t_0): `of` has n and order; z and `own` are the units of the rest."""

    of: Any
    s: np.ndarray
    c: np.ndarray
    k: float
    t_0: float
    z: float
    own: dict[str, float]

    def times(self, tau: np.ndarray) -> np.ndarray:
        return self.t_0 + tau / self.k

    def size(self, name: str) -> float:
        """One of what is named, in the mechanism's own units."""
        if name.startswith("q"):
            return float(self.s[int(name[1:].rstrip("'"))]) / (self.k if name.endswith("'") else 1.0)
        return self.z if name == "z" else self.own[name]

    @property
    def of_rows(self) -> np.ndarray:
        """(2 n, 1): the same of x and v, in the order of the model."""
        s = self.s[self.of.order]
        return np.concatenate([s, s / self.k])[:, None]

    def back(self, x: np.ndarray, v: np.ndarray, origin: float = 1.0) -> np.ndarray:
        """Return (X, V), or derivatives if the origin is 0, in the mechanism's order."""
        n, found = self.of.n, self.of_rows * np.vstack([x, v])
        found[:n] += origin * self.c[self.of.order][:, None]
        return found[np.concatenate([np.argsort(self.of.order), n + np.argsort(self.of.order)])]


@dataclass
class Units(InUnits):
    """One choice of units, signs, an origin and a clock."""

    of: Mechanism
    random: np.random.Generator
    widest: float = 6.0
    own: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        n, random = self.of.n, self.random
        self.s = self._one() ** random.choice([0, 1]) * np.array([self._one() for _ in range(n)]) ** random.choice(
            [0, 1]
        )
        self.s = self.s * random.choice([-1, 1], n)
        self.c = random.choice([0, 1]) * random.uniform(-2, 2, n)
        self.k, self.energy, self.z = self._one(), self._one(), self._one()
        self.t_0 = float(random.choice([0, 1]) * random.uniform(-20, 20)) / self.k
        self.own = {str(p): self._one() for p in self.of.P}

    def _one(self) -> float:
        return float(10 ** self.random.uniform(-self.widest, self.widest))

    def given(self, known: dict[str, float], rtol: float) -> dict:
        """Arguments of a run; `known`: the parameters of the system. Tolerances are rtol of numbers of order one."""
        of, n = self.of, self.of.n
        values = {"k_t": self.k, "e_0": self.energy, "t_0": self.t_0, "s_z": self.z}
        values |= {f"s_{i}": self.s[i] for i in range(n)} | {f"o_{i}": self.c[i] for i in range(n)}
        values |= {f"u_{p}": self.own[str(p)] for p in of.P} | {str(p): v / self.own[str(p)] for p, v in of.P.items()}
        x0 = {f"q{i}": (of.start[i] - self.c[i]) / self.s[i] for i in range(n)}
        atol = {name: rtol / abs(s) * min(1.0, self.k) for name, s in zip(x0, self.s, strict=True)}
        state = {"z": of.start[-1] / self.z} if of.Z is not None else {}
        return {"x0": x0 | state, "v0": {f"q{i}": of.start[n + i] * self.k / self.s[i] for i in range(n)}, "rtol": rtol,
                "atol": atol | ({"z": rtol / self.z} if state else {}),
                "parameters": {name: float(values[name]) for name in known}}  # fmt: skip
