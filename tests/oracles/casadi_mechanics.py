"""Equations of motion written in CasADi, from energies and constraints, by its own differentiation.

Lagrange's equations M a + A^T lambda = f with A a + gamma = 0 are solved as one linear system.
"""

from collections.abc import Callable
from typing import Any

import casadi as ca


def double_pendulum(x: Any, v: Any, p: Any) -> tuple[Any, Any]:
    """T - V and no constraints, of models/double_pendulum.py."""
    m1, m2, l1, l2, g = ca.vertsplit(p)
    first = l1 * ca.vertcat(ca.sin(x[0]), -ca.cos(x[0]))
    second = first + l2 * ca.vertcat(ca.sin(x[1]), -ca.cos(x[1]))
    v1, v2 = ca.jtimes(first, x, v), ca.jtimes(second, x, v)
    return (m1 * ca.sumsqr(v1) + m2 * ca.sumsqr(v2)) / 2 - g * (m1 * first[1] + m2 * second[1]), ca.SX(0, 1)


def four_bar(x: Any, v: Any, p: Any) -> tuple[Any, Any]:
    """T - V and the loop, of models/four_bar.py."""
    a, b, c, d, density, g = ca.vertsplit(p)
    crank, coupler, rocker = (r * ca.vertcat(ca.cos(q), ca.sin(q)) for r, q in zip((a, b, c), ca.vertsplit(x)))  # noqa: B905
    feet, bars = (ca.SX(2, 1), crank, ca.vertcat(d, 0)), (crank, coupler, rocker)
    lagrangian = ca.SX(0)
    for k in range(3):
        middle, length = feet[k] + bars[k] / 2, (a, b, c)[k]
        speed = ca.jtimes(middle, x, v)
        energy = (ca.sumsqr(speed) + length**2 / 12 * v[k] ** 2) / 2
        lagrangian += density * length * (energy - g * middle[1])
    return lagrangian, crank + coupler - rocker - ca.vertcat(d, 0)


def acceleration(of: Callable[[Any, Any, Any], tuple[Any, Any]], n: int, n_parameters: int) -> Any:
    """A CasADi Function (x, v, p) -> (a, multipliers) of a Lagrangian and constraints."""
    x, v, p = ca.SX.sym("x", n), ca.SX.sym("v", n), ca.SX.sym("p", n_parameters)
    lagrangian, phi = of(x, v, p)
    momentum = ca.gradient(lagrangian, v)
    M, force = ca.jacobian(momentum, v), ca.gradient(lagrangian, x) - ca.jtimes(momentum, x, v)
    A = ca.jacobian(phi, x)
    m = phi.numel()
    gamma = ca.jtimes(A @ v, x, v)
    whole = ca.vertcat(ca.horzcat(M, A.T), ca.horzcat(A, ca.SX(m, m)))
    found = ca.solve(whole, ca.vertcat(force, -gamma))
    return ca.Function("acceleration", [x, v, p], [found[:n], found[n:]], ["x", "v", "p"], ["a", "multipliers"])
