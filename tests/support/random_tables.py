"""Random mechanisms with tables, and with motions prescribed by signals: see `TableMaker`.

What a seed makes is made twice: with tables and inputs, as a user writes it, and with SciPy's interpolants in their
places, as functions of SymPy (`oracles.curves`), which the package knows nothing of.
"""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import scipy.interpolate as si
import sympy
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Signal, Table, t

from ..oracles.curves import Curve
from .random_mechanisms import Expr, Maker

OUTSIDE = ("refuse", "hold", "extend", "periodic")
MOST_TABLES = 6


def points(random: np.random.Generator, count: int, reach: float) -> np.ndarray:
    """Return increasing numbers from about -reach to reach, their distances of sizes up to ten times each other's."""
    gaps = random.uniform(0.1, 1.0, count - 1)
    return reach * (2 * np.concatenate([[0.0], np.cumsum(gaps)]) / gaps.sum() - 1) * random.uniform(0.8, 1.25)


def of_one(random: np.random.Generator, x: np.ndarray, values: np.ndarray) -> Any:
    """Return an interpolant of one argument of any kind that a table takes."""
    kind = random.integers(10)
    if kind < 5:
        return si.make_interp_spline(x, values, k=kind + 1)
    if kind == 5:
        return si.PPoly(random.normal(size=(3, len(x) - 1)) * np.ptp(values) / np.ptp(x) ** [[2], [1], [0]], x)
    made = (si.CubicSpline, si.PchipInterpolator, si.Akima1DInterpolator, lambda x, values: (x, values))
    return made[kind - 6](x, values)


def of_two(random: np.random.Generator, x: np.ndarray, y: np.ndarray, values: np.ndarray) -> Any:
    """Return an interpolant of two arguments."""
    if random.random() < 0.3:
        return x, y, values
    kx, ky = random.integers(1, 6, 2)
    return si.RectBivariateSpline(x, y, values, kx=kx, ky=ky)


class TableMaker(Maker):
    """Makes one mechanism whose energies, forces, outputs and rates call tables; `driven`, with prescribed motions.

    plain : whether SciPy's interpolants stand where tables and inputs would
    motions : the prescribed motions: name -> curve
    """

    def __init__(self, seed: int, *, tables: bool, driven: bool, plain: bool) -> None:
        super().__init__(seed)
        self.tables, self.driven, self.plain = tables, driven, plain
        self.numbers = np.random.default_rng([seed, 7])
        self.curves: list[Curve] = []
        self.motions: dict[str, Curve] = {}
        self.signals: dict[str, Any] = {}

    # -- tables ----------------------------------------------------------------------------------------------------

    def table(self, *arguments: Expr) -> Expr:
        """Call a table; where there are many, one that there is."""
        known = [curve for curve in self.curves if len(curve.ranges) == len(arguments)]
        again = known and len(self.curves) >= MOST_TABLES
        curve = self.random.choice(known) if again else self._new(len(arguments))
        sizes = [self.reach(high - low) for low, high in curve.ranges]
        scaled = tuple(sympy.Float(size) * one for size, one in zip(sizes, arguments, strict=True))
        made = curve if self.plain else Table(curve.given, outside=curve.outside, name=curve.name)
        return made(*scaled) / sympy.Float(self._height(curve))

    def _new(self, arguments: int) -> Curve:
        random = self.numbers
        reach, size = 10.0 ** random.uniform(-6, 6, 2)
        axes = [points(random, random.integers(6, 11), reach) for _ in range(arguments)]
        values = size * random.normal(size=[len(axis) for axis in axes])
        given = of_one(random, *axes, values) if arguments == 1 else of_two(random, *axes, values)
        curve = Curve(given, OUTSIDE[random.integers(4)], f"table_{len(self.curves)}")
        self.curves.append(curve)
        return curve

    def reach(self, width: float) -> float:
        """How far an argument goes that goes from -1 to 1: some stay inside a range, and some leave it."""
        return float(f"{width * self.random.choice((0.05, 0.15, 0.3)):.3e}")

    @staticmethod
    def _height(curve: Curve) -> float:
        """The size of its values."""
        middles = [np.linspace(low, high, 7) for low, high in curve.ranges]
        grid = np.stack(np.meshgrid(*middles), axis=-1).reshape(-1, len(middles))
        return float(f"{max(abs(curve.value((0,) * len(middles), tuple(one))) for one in grid[1:-1]):.2e}") or 1.0

    def of_place(self) -> Expr:
        """A table of coordinates."""
        q, r = self.coordinate(), self.coordinate()
        return self.one_of(lambda: self.table(q), lambda: self.table(q - r / 2), lambda: self.table(sympy.sin(q)),
                           lambda: self.table(q, r), lambda: self.table(q, q * r / 4))  # fmt: skip

    def of_motion(self) -> Expr:
        """A table of anything that a force may contain."""
        q, v = self.coordinate(), self.random.choice(self.v)
        return self.one_of(self.of_place, lambda: self.table(v), lambda: self.table(t), lambda: self.table(t, v),
                           lambda: v * self.table(q), lambda: self.table(q + self.u),
                           lambda: self.table(self.a * t, q))  # fmt: skip

    def factor(self) -> Expr:
        return self.of_place() if self.tables and self.chance(0.25) else super().factor()

    # -- prescribed motions ----------------------------------------------------------------------------------------

    def path(self, name: str, *, rate: bool) -> Expr:
        """A new input that prescribes a motion, or a speed."""
        random = self.numbers
        times = (points(random, random.integers(7, 13), 3.0) + 1.5) * 1.4
        size = 10.0 ** random.uniform(-6, 6)
        values = size * random.normal(size=len(times))
        smooth = [lambda: si.make_interp_spline(times, values, k=random.integers(3, 6)),
                  lambda: si.make_interp_spline(times, values, k=2), lambda: si.CubicSpline(times, values),
                  lambda: si.PchipInterpolator(times, values),
                  lambda: si.Akima1DInterpolator(times, values)]  # fmt: skip
        rough = [lambda: si.make_interp_spline(times, values, k=1), lambda: (times, values)]
        choices = smooth + rough * rate
        given = choices[random.integers(len(choices))]()
        curve = self.motions[name] = Curve(given, "refuse", name)
        self.signals[name] = (
            given if self.chance(0.5) else Signal(*given) if isinstance(given, tuple) else Signal(given)
        )
        return (curve(t) if self.plain else dynamicsymbols(name)) / sympy.Float(size)

    def rows(self) -> tuple[list[Expr], list[Expr]]:
        holonomic, others = super().rows()
        if not self.driven:
            return holonomic, others
        free = max(self.n - len(holonomic) - len(others), 1)
        holonomic, others = holonomic[: self.n - 1], others[: max(self.n - 1 - len(holonomic[: self.n - 1]), 0)]
        for k in range(self.random.randint(1, min(free, 2))):
            if self.chance(0.6):
                holonomic = [*holonomic, self.driven_place(f"path_{k}")]
            else:
                others = [*others, self.driven_rate(f"path_{k}")]
        return holonomic, others

    def driven_place(self, name: str) -> Expr:
        path, q, r = self.path(name, rate=False), self.coordinate(), self.coordinate()
        return self.one_of(lambda: q - path, lambda: q**2 + r - path, lambda: q * (2 + sympy.cos(r)) + path,
                           lambda: q - path * sympy.cos(t), lambda: sympy.sin(q - path) + r)  # fmt: skip

    def driven_rate(self, name: str) -> Expr:
        speed = self.path(name, rate=True)
        return self.rate() - speed * self.random.choice((1, self.positive()))

    def pull(self) -> Expr:
        """A force or a part of an output that follows a prescribed motion."""
        name = self.random.choice(sorted(self.motions))
        curve = self.motions[name]
        path = (curve(t) if self.plain else dynamicsymbols(name)) / sympy.Float(self._height(curve))
        return self.factor() * self.random.choice((path, path.diff(t), path * path.diff(t)))

    # -- the whole -------------------------------------------------------------------------------------------------

    def fields(self) -> dict[str, Any]:
        made = super().fields()
        forces = dict(made["forces"])
        for q in self.q:
            for piece in self._pieces():
                forces[q] = forces.get(q, 0) + piece
        if self.tables and self.chance(0.6):
            made["potential_energy"] += self.of_place()
        outputs = dict(made["outputs"])
        for k in range(self.random.randint(1, 3)):
            one = self.of_place() if self.tables else self.coordinate() * self.random.choice(self.v)
            outputs[f"o{k}"] = one + sum(self._pieces()) + one.diff(self.coordinate())
        return made | {"forces": forces, "outputs": outputs, "states": self._states()}

    def _pieces(self) -> list[Expr]:
        makers: list[Callable[[], Expr]] = [self.of_motion] * self.tables + [self.pull] * bool(self.motions)
        return [make() for make in makers if self.chance(0.5)]

    def _states(self) -> dict[Expr, Expr]:
        z = dynamicsymbols("z")
        return {z: sum(self._pieces()) - self.k * z} if self.chance(0.4) else {}

    def model(self) -> Model:
        """Return the mechanism, its prescribed motions among the inputs."""
        fields = self.fields()
        inputs = fields["inputs"] | {dynamicsymbols(name): 0.0 for name in self.motions}
        return Model(**fields | {"inputs": inputs})

    def equations(self) -> SimpleNamespace:
        """Return what `oracles.Lagrange` reads of a model, with interpolants in place of tables and inputs."""
        fields = self.fields()
        forces = [sympy.sympify(fields["forces"].get(q, 0)) for q in self.q]
        pairs = {name: tuple(fields[name].items()) for name in ("parameters", "inputs", "quasi_velocities")}
        return SimpleNamespace(**fields | pairs | {"forces": forces})
