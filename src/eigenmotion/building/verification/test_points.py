"""Test points of a build: states, times, inputs and parameters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...runtime import CompiledModel, EvaluationError
from ...system.system import System

SIZES = (1.0, 1.0, 0.3, 3.0, 10.0)
"""Approximate sizes of x and v. Each state is used with both signs, so that all signs occur."""

_NUMBERS, _FEWEST = 1100, 5
"""Points times coordinates, above which points are left out; number of points that are kept."""


@dataclass(frozen=True, slots=True)
class Points:
    """k points: t (k,), x and v (k, n), u (k, n_inputs), p (k, n_parameters)."""

    t: Vector
    x: Vector
    v: Vector
    u: Vector
    p: Vector

    def described(self, number: int, system: System) -> str:
        """Return one point as text, in the model's names."""
        values = [("t", self.t[number])]
        values += zip(system.compiled.coordinates, self.x[number], strict=True)
        values += zip((f"{name}'" for name in system.compiled.coordinates), self.v[number], strict=True)
        values += zip(system.inputs, self.u[number], strict=True)
        changed = self.p[number] != system.compiled.parameter_defaults
        values += [(name, p) for name, p, new in zip(system.parameters, self.p[number], changed, strict=True) if new]
        return ", ".join(f"{name} = {value:.6g}" for name, value in values)


def draw(system: System, attempt: int) -> Points:
    """Draw random points: states of several sizes with both signs, states near the start, and the start itself.

    Points of later attempts are closer to the start. Some points have other parameters than the defaults.
    """
    random = np.random.default_rng(attempt)
    c = system.compiled
    n, start = c.n, np.concatenate([c.initial_x, c.initial_v])
    own = np.where(start == 0.0, 1.0, np.abs(start))
    far = _both_signs(random, np.array([*(np.full(2 * n, size) for size in SIZES), own]) * 0.3**attempt)
    z = np.concatenate([[start], far, _nearby(random, start, 0.3 * 0.1**attempt, 4)])
    z = z[_kept(n, len(z))]
    k = len(z)
    u = _nearby(random, c.input_defaults, 1.0, k)
    p = np.tile(c.parameter_defaults, (k, 1))
    other = [1, 1 + k // 3, k - 2, k - 1] if k < len(far) else [1, 1 + len(far) // 2, k - 2, k - 1]
    p[other] = _nearby(random, c.parameter_defaults, 0.2, len(other))
    modes = [parameter for _, holds, slides, *_ in c.switches for parameter in (holds, slides) if parameter >= 0]
    idle = [idles for _, _, _, _, idles, *_ in c.switches]
    p[:, modes], p[:, [*idle, *(place for place, _ in c.tables.values())]] = random.integers(0, 2, (k, len(modes))), 0.0
    t = np.where(np.arange(k) == 0, 0.0, random.uniform(-2.0, 2.0, k))
    for row in p:
        _keep_declared(c, row)
    return Points(t, *map(np.ascontiguousarray, (z[:, :n], z[:, n:], u, p)))


def _kept(n: int, k: int) -> list[int]:
    """Return the numbers of the points that are used: of many coordinates fewer, since each gives more equations."""
    step = -(-k // max(_FEWEST, _NUMBERS // n))
    return list(range(k)) if step == 1 else [0, *range(1, k, step)]


def _keep_declared(model: CompiledModel, p: Vector) -> None:
    """Change the sign of values that contradict the assumptions of their parameter, or reset them to the default."""
    for k, own in enumerate(model.parameter_defaults.tolist() if any(model.declared) else ()):
        p[k] = next(value for value in (p[k], -p[k], own) if _may_be(model, k, value))


def _may_be(model: CompiledModel, k: int, value: float) -> bool:
    alone = np.array(model.parameter_defaults)
    alone[k] = value
    try:
        model.check_parameters(alone)
    except EvaluationError:
        return bool(value == model.parameter_defaults[k])
    return True


def _both_signs(random: np.random.Generator, sizes: Vector) -> Vector:
    """Return random numbers of about these sizes, and their negatives."""
    half = sizes * np.exp(random.normal(0.0, 0.5, sizes.shape)) * random.choice([-1.0, 1.0], sizes.shape)
    return np.concatenate([half, -half])


def _nearby(random: np.random.Generator, numbers: Vector, distance: float, count: int) -> Vector:
    """Return numbers changed by up to `distance` times their size; zeros are changed by up to `distance`."""
    size = np.where(numbers == 0.0, 1.0, np.abs(numbers))
    return np.asarray(numbers + distance * size * random.uniform(-1.0, 1.0, (count, len(numbers))))
