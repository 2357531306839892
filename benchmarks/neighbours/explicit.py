"""The accelerations of the linkage as expressions of SymPy, for tools that take nothing implicit."""

import sympy as sp
from four_bar import parts


def explicit(y: list) -> list:
    """Return the accelerations (3,) as expressions of SymPy, by the inverses of two matrices of two rows."""
    mass, force, rows, turning = (sp.Matrix(part) for part in parts(y[:3], y[3:], sp))
    inverse = sp.diag(_inverse(mass[:2, :2]), sp.Matrix([[1 / mass[2, 2]]]))
    multipliers = _inverse(rows * inverse * rows.T) * (rows * inverse * force + turning)
    return list(inverse * (force - rows.T * multipliers))


def _inverse(two: object) -> object:
    (a, b), (c, d) = two.tolist()
    return sp.Matrix([[d, -b], [-c, a]]) / (a * d - b * c)
