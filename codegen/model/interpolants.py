"""Conversion of interpolants to piecewise polynomials: SciPy's polynomials and splines, and linear interpolation.

SciPy objects are recognised by class name and read by attribute, so this module does not import SciPy.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from typing import Any

from .normalise import ModelError, shown
from .pieces import Axis, Pieces, is_increasing

Rows = list[list[float]]
TAKEN = (
    "CubicSpline, PchipInterpolator, Akima1DInterpolator, make_interp_spline (BSpline), PPoly or RectBivariateSpline "
    "of scipy.interpolate, (points, values), or (x, y, values)"
)


def pieces_of(interpolant: Any, outside: str, what: str) -> Pieces:
    """Return the pieces of an interpolant.

    Raises
    ------
    ModelError
        Its type is not one of TAKEN, its points do not increase, its values are not finite, or their shape does not
        match the points; says which.
    """
    kinds = {base.__name__ for base in type(interpolant).__mro__}
    if "BPoly" in kinds:
        raise ModelError(f"{what} is in Bernstein's form. Give PPoly.from_bernstein_basis of it.")
    if "PPoly" in kinds:
        return _of_polynomials(interpolant, outside, what)
    if "BSpline" in kinds:
        return _of_spline(interpolant, outside, what)
    if "RectBivariateSpline" in kinds:
        return _of_two_arguments(interpolant, outside, what)
    if isinstance(interpolant, tuple | list) and len(interpolant) in (2, 3):
        return _of_points(interpolant, outside, what)
    raise ModelError(f"{what} is {shown(interpolant)}. Give one of {TAKEN}.")


def _of_points(interpolant: Sequence[Any], outside: str, what: str) -> Pieces:
    """Return the pieces of linear interpolation between points; bilinear with two arguments."""
    *points, values = interpolant
    axes = tuple(Axis(_knots(one, f"{what}: {name}"), 2) for name, one in zip(_names(len(points)), points, strict=True))
    shape = tuple(axis.count + 1 for axis in axes)
    table = _table(values, shape, f"{what}: values")
    if len(axes) == 1:
        lines = zip(axes[0].knots, axes[0].knots[1:], table[0], table[0][1:], strict=False)
        return Pieces(axes, tuple(c for a, b, v, w in lines for c in (v, (w - v) / (b - a))), outside)
    patches = product(range(axes[0].count), range(axes[1].count))
    return Pieces(axes, tuple(c for i, j in patches for c in _bilinear(axes, table, i, j)), outside)


def _names(count: int) -> tuple[str, ...]:
    return ("points",) if count == 1 else ("x", "y")


def _bilinear(axes: tuple[Axis, ...], table: Rows, i: int, j: int) -> tuple[float, float, float, float]:
    h, k = (axis.knots[place + 1] - axis.knots[place] for axis, place in zip(axes, (i, j), strict=True))
    a, b, c, d = table[i][j], table[i][j + 1], table[i + 1][j], table[i + 1][j + 1]
    return a, (b - a) / k, (c - a) / h, ((d - c) - (b - a)) / (h * k)


def _of_polynomials(interpolant: Any, outside: str, what: str) -> Pieces:
    """Return the pieces of a PPoly, whose c has the shape (powers, descending; pieces).

    Those of length zero are left out: `PPoly.from_spline` makes them of a spline's repeated knots.
    """
    x, rows = _finite(_plain(interpolant.x), f"{what}: x"), _plain(interpolant.c)
    if not _is_table(rows) or any(isinstance(one, list) for row in rows for one in row):
        raise ModelError(f"{what} has several values at a point. Give a table of one of them.")
    table = [_finite(row, f"{what}: c") for row in rows]
    kept = [piece for piece in range(len(x) - 1) if x[piece] != x[piece + 1]]
    knots = _knots([*x[:1], *(x[piece + 1] for piece in kept)], f"{what}: x")
    coefficients = tuple(float(row[piece]) for piece in kept for row in reversed(table))
    return Pieces((Axis(knots, len(table)),), coefficients, outside)


def _of_spline(interpolant: Any, outside: str, what: str) -> Pieces:
    t, c, k = _plain(interpolant.t), _plain(interpolant.c), int(interpolant.k)
    if any(isinstance(one, list) for one in c):
        raise ModelError(f"{what} has several values at a point. Give a table of one of them.")
    spans = _spans(_finite(t, f"{what}: t"), k, len(t) - k - 1)
    local = _local(t, _finite(c, f"{what}: c"), k, spans)
    knots = (*(t[m] for m in spans), t[spans[-1] + 1])
    return Pieces((Axis(knots, k + 1),), tuple(one for piece in local for one in piece), outside)


def _of_two_arguments(interpolant: Any, outside: str, what: str) -> Pieces:
    """Return the pieces of a tensor-product spline.

    First convert along y for each coefficient along x, then along x for each power of each piece in y.
    """
    (tx, ty, flat), (kx, ky) = map(_plain, interpolant.tck), map(int, interpolant.degrees)
    flat, nx, ny = _finite(flat, f"{what}: coefficients"), len(tx) - kx - 1, len(ty) - ky - 1
    in_x, in_y = _spans(tx, kx, nx), _spans(ty, ky, ny)
    along_y = [_local(ty, flat[row * ny : (row + 1) * ny], ky, in_y) for row in range(nx)]
    powers = [
        [_local(tx, [along_y[row][j][b] for row in range(nx)], kx, in_x) for b in range(ky + 1)]
        for j in range(len(in_y))
    ]
    coefficients = tuple(
        powers[j][b][i][a] for i, j, a, b in product(range(len(in_x)), range(len(in_y)), range(kx + 1), range(ky + 1))
    )
    axes = (
        Axis(_knots([*(tx[m] for m in in_x), tx[in_x[-1] + 1]], f"{what}: x"), kx + 1),
        Axis(_knots([*(ty[m] for m in in_y), ty[in_y[-1] + 1]], f"{what}: y"), ky + 1),
    )
    return Pieces(axes, coefficients, outside)


def _spans(t: Sequence[float], k: int, count: int) -> list[int]:
    """Return the knot intervals of nonzero length."""
    return [m for m in range(k, count) if t[m] < t[m + 1]]


def _local(t: Sequence[float], c: Sequence[float], k: int, spans: Sequence[int]) -> Rows:
    """Return the Taylor coefficients of each span about its left knot t[m], by ascending powers of x - t[m]."""
    levels = [list(c)]
    for order in range(1, k + 1):
        before, degree = levels[-1], k - order + 1
        levels.append([0.0] * order + [
            degree * (before[j] - before[j - 1]) / (t[j + degree] - t[j]) if t[j + degree] > t[j] else 0.0
            for j in range(order, len(before))
        ])  # fmt: skip
    return [[_at_knot(t, level, k - order, m) / math.factorial(order) for order, level in enumerate(levels)]
            for m in spans]  # fmt: skip


def _at_knot(t: Sequence[float], c: Sequence[float], degree: int, m: int) -> float:
    """Return the value of a spline at t[m], as the limit from the right (de Boor's algorithm)."""
    x, d = t[m], [c[j] for j in range(m - degree, m + 1)]
    for level in range(1, degree + 1):
        for j in range(degree, level - 1, -1):
            low, high = t[m - degree + j], t[m + 1 + j - level]
            part = (x - low) / (high - low)
            d[j] = (1.0 - part) * d[j - 1] + part * d[j]
    return d[degree]


def _knots(points: Any, what: str) -> tuple[float, ...]:
    numbers = _finite(_plain(points), what)
    if len(numbers) < 2:
        raise ModelError(f"{what} has {len(numbers)} points. A table has at least two.")
    if not is_increasing(numbers):
        raise ModelError(f"{what} does not increase: sort the points, and keep each once.")
    return tuple(numbers)


def _table(values: Any, shape: tuple[int, ...], what: str) -> Rows:
    """Return the values as rows; those of a table of one argument are one row."""
    rows = _plain(values)
    if len(shape) == 1:
        rows = [rows]
    size = shape if len(shape) == 2 else (1, *shape)
    if not _is_table(rows) or (len(rows), *{len(row) for row in rows}) != size:
        raise ModelError(f"{what} must have the shape {shape}, one for each point.")
    return [_finite(row, what) for row in rows]


def _is_table(rows: Any) -> bool:
    return isinstance(rows, list) and bool(rows) and all(isinstance(row, list) for row in rows)


def _plain(value: Any) -> Any:
    """Convert arrays to nested lists."""
    listed = value.tolist() if hasattr(value, "tolist") else value
    return [_plain(one) for one in listed] if isinstance(listed, list | tuple) else listed


def _finite(values: Any, what: str) -> list[float]:
    if not isinstance(values, list) or any(isinstance(one, bool | list | str | complex) for one in values):
        raise ModelError(f"{what} is {shown(values)}. Give real numbers, one after the other.")
    try:
        numbers = [float(one) for one in values]
    except (TypeError, ValueError, OverflowError) as error:
        raise ModelError(f"{what} holds what is not a real number: {shown(values)}.") from error
    wrong = next((one for one in numbers if not math.isfinite(one)), None)
    if wrong is not None:
        raise ModelError(f"{what} holds {wrong}. Every number of a table is finite.")
    return numbers
