"""Accelerations out of a right-hand side: the map y -> v differentiated along dy by its own formula, in NumPy."""

from collections.abc import Callable, Mapping

import numpy as np

from eigenmotion import System

Values = Mapping[str, float] | None


def factored(system: System, x: np.ndarray, time: float, parameters: Values = None) -> np.ndarray:
    """Return what is factored (n, n): M, or M + A^T W A."""
    return system.compiled.factored_matrix(time, x, system.prepare(parameters))


def factored_gradient(system: System, x: np.ndarray, time: float, parameters: Values = None) -> np.ndarray:
    """Return its gradient (n, n, n)."""
    return system.compiled.factored_gradient(time, x, system.prepare(parameters))


def acceleration(system: System, time: float, y: np.ndarray, dy: np.ndarray, parameters: Values = None) -> np.ndarray:
    """Return xddot (n,) for x = y[:n], by blocks of M.

    eigenfactor   v = C^T S^-1 eta   xddot = Cdot^T S^-1 eta - C^T S^-2 Sdot eta + C^T S^-1 etadot
    cholesky      v = L^-T eta       xddot = L^-T (etadot - Ldot^T v), with coordinates in the order of the root
    """
    if "v" in system.layout:
        return dy[system.layout["v"]]
    x, v = y[: system.n], dy[: system.n]
    M, rate = factored(system, x, time, parameters), mass_rate(system, time, x, v, parameters)
    if system.formulation == "cholesky":
        order = root_order(system, time, x, parameters)
        L, rate = np.linalg.cholesky(M[np.ix_(order, order)]), rate[np.ix_(order, order)]
        inner = np.linalg.solve(L, np.linalg.solve(L, rate).T)
        L_rate = L @ (np.tril(inner) - np.diag(np.diag(inner)) / 2)
        a = np.empty(system.n)
        a[order] = np.linalg.solve(L.T, dy[system.layout["eta"]][order] - L_rate.T @ v[order])
        return a
    result = linear_part(system, time, y, dy[system.layout["eta"]], parameters)
    for block, C, s, C_dot, s_dot in carried(system, y, dy):
        eta = y[system.layout["eta"]][list(block)]
        units = system.scales[list(block)]
        result[list(block)] += units * (C_dot.T @ (eta / s) - C.T @ (s_dot * eta / s**2))
    for (k,) in (block for block in system.blocks if len(block) == 1 and block[0] not in system.compiled.carried):
        result[k] -= rate[k, k] / (2 * M[k, k]) * v[k]
    return result


def root_matrix(system: System, time: float, x: np.ndarray, parameters: Values = None) -> np.ndarray:
    """Return R (n, n) of eta = R v: its columns are eta of states in which one coordinate moves."""
    states = [system.state(x, v, time, parameters) for v in np.eye(system.n)]
    return np.array([y[system.layout["eta"]] for y in states]).T


def root_order(system: System, time: float, x: np.ndarray, parameters: Values = None) -> list[int]:
    """Return the coordinates in an order in which R is upper triangular, at x and beside it."""
    uses = sum(np.abs(root_matrix(system, time, x + s * (1 + np.arange(system.n)), parameters)) for s in (0, 1e-3)) > 0
    left, order = [*range(system.n)], []
    while left:
        order.append(next(k for k in reversed(left) if not any(uses[k, other] for other in left if other != k)))
        left.remove(order[-1])
    return order[::-1]


def linear_part(system: System, time: float, y: np.ndarray, eta: np.ndarray, parameters: Values) -> np.ndarray:
    """Return v of the state with another eta: for a given y it is linear in it."""
    other = y.copy()
    other[system.layout["eta"]] = eta
    return np.array(system.rhs(time, other, parameters)[: system.n])


def carried(system: System, y: np.ndarray, dy: np.ndarray):
    """Give block, C, s, Cdot, sdot of each block whose eigenfactors the state carries."""
    if "s" not in system.layout:
        return
    C, s = system.layout["C"].start, system.layout["s"].start
    for block in (block for block in system.blocks if block[0] in system.compiled.carried):
        n = len(block)
        yield block, y[C : C + n * n].reshape(n, n), y[s : s + n], dy[C : C + n * n].reshape(n, n), dy[s : s + n]
        C, s = C + n * n, s + n


def mass_rate(system: System, time: float, x: np.ndarray, v: np.ndarray, parameters: Values = None) -> np.ndarray:
    """Return Mdot (n, n): the gradient along v, and the explicit part by differences of order 8."""
    explicit = slope(lambda h: factored(system, x, time + h, parameters))
    return np.tensordot(v, factored_gradient(system, x, time, parameters), axes=1) + explicit


def slope(function: Callable[[float], np.ndarray], size: float = 0.0) -> np.ndarray:
    """Return d/dh of a function of h at 0, by central differences of order 8; size: how fast what it moves moves."""
    h = 1e-2 / (1 + size)
    weights = np.array([4 / 5, -1 / 5, 4 / 105, -1 / 280]) / h
    return sum(w * (function(k * h) - function(-k * h)) for k, w in enumerate(weights, 1))
