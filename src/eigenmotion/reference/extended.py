"""Motion in extended precision: extrapolated midpoint steps (Gragg, Bulirsch, Stoer) on the classical equations.

Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.9: T_j1 by n_j = 2, 4, 6, ... modified
midpoint steps, T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / ((n_j / n_j-k+1)^2 - 1). The numbers are np.longdouble: 64 bits
of mantissa on x86, 113 where the platform has quadruple precision, and no more than double where it has neither.
"""

from collections.abc import Callable, Sequence
from math import ceil
from typing import Any, Protocol

import numpy as np
import sympy
from numpy.typing import NDArray

from ..arguments.names import Vector
from .classical import Classical, accelerations

Extended = NDArray[np.longdouble]
Rhs = Callable[[Any, Extended], Extended]
EPSILON = float(np.finfo(np.longdouble).eps)
MOST_STEPS = 20_000


class NotReachedError(ArithmeticError):
    """The integration did not get to its end; says why."""


def extended(equations: Classical) -> Rhs:
    """Return f(t, y), y = (x, v), with every constant rounded in extended precision."""
    numbers = sorted(_inexact(equations.entries), key=sympy.default_sort_key)
    names = sympy.symbols(f"em_c:{len(numbers)}")
    named = dict(zip(numbers, names, strict=True))
    entries = [entry.xreplace(named) for entry in equations.entries]
    function = sympy.lambdify([*equations.arguments, *names], entries, modules="numpy", cse=True)
    constants = [np.longdouble(value) for _, value in equations.constants] + [_rounded(number) for number in numbers]
    n = len(equations.x)

    def rhs(time: Any, y: Extended) -> Extended:
        values = function(*y, time, *constants)
        return np.concatenate([y[n:], np.array(accelerations(*equations.split(values)), dtype=np.longdouble)])

    return rhs


def _inexact(entries: Sequence[sympy.Expr]) -> set[sympy.Expr]:
    """Return the fractions and numbers like pi that no double holds."""
    fractions = {q for entry in entries for q in entry.atoms(sympy.Rational) if q.q & (q.q - 1)}
    return fractions | {c for entry in entries for c in entry.atoms(sympy.NumberSymbol)}


def _rounded(number: sympy.Expr) -> np.longdouble:
    return np.longdouble(str(number.evalf(40)))


class Scheme(Protocol):
    """Steps with an estimate of their error, which falls with h to a power."""

    @property
    def power(self) -> int: ...

    def step(self, rhs: Rhs, time: Any, y: Extended, h: Any) -> tuple[Extended, float]:
        """Return y at time + h and the scaled error, infinite or NaN where there is no such step."""


def trajectory(rhs: Rhs, y: Vector | Extended, times: Vector, tolerance: float, columns: int = 8) -> Extended:
    """Return y (k, 2n) at increasing times (k,) by `Midpoint` steps of order 2 columns; see `followed`."""
    return followed(Midpoint(columns), rhs, y, times, tolerance)


def followed(scheme: Scheme, rhs: Rhs, y: Vector | Extended, times: Vector, tolerance: float) -> Extended:
    """Return y (k, 2n) at increasing times (k,), the first of which is the start; scaled error a step <= tolerance.

    Raises
    ------
    NotReachedError
        A step below the spacing of numbers, or too many steps.
    """
    rows = [np.array(y, dtype=np.longdouble)]
    walk = _Walk(scheme, rhs, tolerance, step=float(times[-1] - times[0]) / 64)
    for start, end in zip(times[:-1].tolist(), times[1:].tolist(), strict=True):
        rows.append(walk.advance(np.longdouble(start), np.longdouble(end), rows[-1]))
    return np.array(rows)


class _Walk:
    """Adaptive steps of fixed order."""

    def __init__(self, scheme: Scheme, rhs: Rhs, tolerance: float, step: float) -> None:
        self.scheme, self.rhs, self.tolerance, self.step, self.left = scheme, rhs, tolerance, step, MOST_STEPS

    def advance(self, time: Any, end: Any, y: Extended) -> Extended:
        while time < end:
            parts = max(1, ceil(float(end - time) / self.step))
            h = (end - time) / parts
            candidate, error = self.scheme.step(self.rhs, time, y, h)
            self._resize(float(h), float(time), error)
            if error <= self.tolerance:
                time, y = (end if parts == 1 else time + h), candidate
        return y

    def _resize(self, h: float, time: float, error: float) -> None:
        self.left -= 1
        factor = 0.8 * (self.tolerance / max(error, 1e-300)) ** (1 / self.scheme.power) if np.isfinite(error) else 0.2
        wanted = h * min(3.0, max(0.2, factor))
        # a step cut short at a row says little: the length found before stands
        self.step = max(wanted, self.step) if error <= self.tolerance and h < self.step else wanted
        if self.step < 1e-15 * max(1.0, abs(time)) or self.left < 0:
            raise NotReachedError(f"the reference stopped at t = {time:.6g} with steps of {self.step:.1e} s")


class Midpoint:
    """Extrapolated midpoint steps: `columns` of them, order 2 columns."""

    def __init__(self, columns: int) -> None:
        self.substeps = tuple(2 * (k + 1) for k in range(columns))
        self.power = 2 * columns - 1

    def step(self, rhs: Rhs, time: Any, y: Extended, h: Any) -> tuple[Extended, float]:
        """Return y at time + h and the scaled difference of the last two columns."""
        slope = rhs(time, y)
        row: list[Extended] = []
        for j, count in enumerate(self.substeps):
            above, row = row, [_midpoint(rhs, time, y, slope, h, count)]
            for k, coarse in enumerate(above):
                ratio = np.longdouble(count) / self.substeps[j - k - 1]
                row.append(row[k] + (row[k] - coarse) / (ratio * ratio - 1))
        error = np.abs(row[-1] - row[-2]) / (1 + np.abs(y))
        return row[-1], float(error.max())


def _midpoint(rhs: Rhs, time: Any, y: Extended, slope: Extended, h: Any, count: int) -> Extended:
    small = h / count
    before: Extended = y
    here: Extended = y + small * slope
    for k in range(1, count):
        after: Extended = before + 2 * small * rhs(time + k * small, here)
        before, here = here, after
    return here
