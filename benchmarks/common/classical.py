"""Lagrange's equations without code generation: SymPy, `lambdify(cse=True)`, and one KKT solve in each call.

They are derived here from T, V and the constraints, independently of eigenmotion's derivation.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import sympy

from eigenmotion import Model, t

RightHandSide = Callable[[float, np.ndarray, np.ndarray], np.ndarray]


def classical(model: Model) -> RightHandSide:
    """Return the right-hand side f(t, y, p) of Lagrange's equations (11) with (8), y = (x, xdot); without Q and phi."""
    x = list(model.coordinates)
    v = [q.diff(t) for q in x]
    a = [q.diff(t, 2) for q in x]
    parameters = [symbol for symbol, _ in model.parameters]
    L = model.kinetic_energy - model.potential_energy
    residual = sympy.Matrix([L.diff(rate).diff(t) - L.diff(q) for q, rate in zip(x, v, strict=True)])
    rows = sympy.Matrix([row.diff(t) for row in model.nonholonomic_constraints])
    still = dict.fromkeys(a, 0)
    terms = [residual.jacobian(a), -residual.subs(still), rows.jacobian(a), -rows.subs(still)]
    plain = {old: sympy.Symbol(f"z{k}") for k, old in enumerate([*v, *x])}
    terms = [term.xreplace(plain) for term in terms]
    evaluate = sympy.lambdify([[plain[q] for q in x], [plain[q] for q in v], parameters], terms, cse=True)
    return _right_hand_side(evaluate, len(x), len(rows))


def _right_hand_side(evaluate: Callable[..., tuple[np.ndarray, ...]], n: int, m: int) -> RightHandSide:
    def f(_: float, y: np.ndarray, p: np.ndarray) -> np.ndarray:
        M, force, A, drift = evaluate(y[:n], y[n:], p)
        matrix = np.zeros((n + m, n + m))
        matrix[:n, :n], matrix[:n, n:], matrix[n:, :n] = M, A.T, A
        solution = np.linalg.solve(matrix, np.concatenate([force, drift]))
        return np.concatenate([y[n:], solution[:n, 0]])

    return f
