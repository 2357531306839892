"""Design of a sweep: n samples at every point of a grid.

The values of a member depend only on its number, so any part of a sweep can be computed again, in any order.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import prod
from zlib import crc32

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError

KINDS = {
    "normal": "normal(mean, deviation)",
    "uniform": "uniform(low, high)",
    "loguniform": "loguniform(low, high)",
    "sobol": "sobol(low, high)",
}
_BLOCK = 4096  # samples of one draw


@dataclass(frozen=True, slots=True)
class Distribution:
    """A distribution: one of KINDS with two numbers. All Sobol' variables share one sequence."""

    kind: str
    first: float
    second: float

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ModelError(f"unknown distribution {self.kind!r}; known: {', '.join(KINDS.values())}")
        if self.kind == "normal" and not self.second >= 0:
            raise ModelError(f"normal: the deviation is {self.second:g}, but must not be negative")
        if self.kind != "normal" and not self.first <= self.second:
            raise ModelError(f"{self.kind}: {self.first:g} is above {self.second:g}")
        if self.kind == "loguniform" and not self.first > 0:
            raise ModelError(f"loguniform: {self.first:g} must be above 0")

    def of(self, uniform: Vector, normal: Vector) -> Vector:
        """Return values of this distribution from numbers uniform in [0, 1), or from standard normal ones."""
        if self.kind == "normal":
            return self.first + self.second * normal
        if self.kind == "loguniform":
            return np.asarray(np.exp(np.log(self.first) + uniform * np.log(self.second / self.first)))
        return self.first + (self.second - self.first) * uniform


@dataclass(frozen=True)
class Design:
    """A grid, whose first name varies slowest, and n samples at each of its points.

    grid : name -> values; samples : name -> Distribution
    """

    grid: Mapping[str, Sequence[float]] = field(default_factory=dict)
    samples: Mapping[str, Distribution] = field(default_factory=dict)
    n: int = 1
    seed: int = 0

    @property
    def count(self) -> int:
        """The number of members."""
        return self.n * prod(map(len, self.grid.values()))

    def values(self, start: int, stop: int) -> dict[str, Vector]:
        """Return name -> values of the members start ... stop - 1."""
        members = np.arange(start, stop)
        point, sample = members // self.n, members % self.n
        columns_by_name = {}
        for name, values in reversed(list(self.grid.items())):
            point, place = np.divmod(point, len(values))
            columns_by_name[name] = np.asarray(values, dtype=np.float64)[place]
        return dict(reversed(list(columns_by_name.items()))) | self._drawn(sample)

    def _drawn(self, sample: NDArray[np.int_]) -> dict[str, Vector]:
        drawn = {name: np.empty(len(sample)) for name in self.samples}
        for block in np.unique(sample // _BLOCK).tolist() if drawn else []:
            mine = sample // _BLOCK == block
            for name, values in self._block(block).items():
                drawn[name][mine] = values[sample[mine] - block * _BLOCK]
        return drawn

    def _block(self, block: int) -> dict[str, Vector]:
        """Return name -> (_BLOCK,) random values. Each name has its own stream, independent of the other names."""
        spread = [name for name, one in self.samples.items() if one.kind == "sobol"]
        columns = dict(zip(spread, self._sobol(block, len(spread)).T, strict=True)) if spread else {}
        columns_by_name = {}
        for name, one in self.samples.items():
            random = np.random.default_rng([self.seed, crc32(name.encode()), block])
            uniform = columns[name] if name in columns else random.random(_BLOCK)
            columns_by_name[name] = one.of(uniform, random.standard_normal(_BLOCK) if one.kind == "normal" else uniform)
        return columns_by_name

    def _sobol(self, block: int, dimensions: int) -> Vector:
        engine = qmc.Sobol(dimensions, rng=np.random.default_rng(self.seed))
        if block:
            engine.fast_forward(block * _BLOCK)
        return np.asarray(engine.random(_BLOCK))
