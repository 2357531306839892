"""Rates of the roots of M and Delta, as users compile them, against NumPy."""

import ctypes

import numpy as np
import pytest

from .kernels import cases, each, kernels_of, near, triangular


@pytest.fixture(scope="module", **each())
def compiled(request, tmp_path_factory):
    return kernels_of("rates", *request.param, tmp_path_factory.mktemp("kernels"))


def test_rates_of_eigenfactors(compiled):
    run, n = compiled
    for random, Delta, C, s in cases(n):
        mu = random.normal(size=(n, n))
        mu = mu + mu.T
        differences = s[None, :] ** 2 - s[:, None] ** 2 + np.eye(n)
        right = mu / differences * (1.0 - np.eye(n))
        Omega, kept = np.ones((n, n)), np.zeros((2, n, n))
        run("omega", s, mu, Omega)
        near(Omega, right)
        run("remember_omega", s, mu, ctypes.c_double(0.0), kept)
        near(kept, np.array([right, 0.0 * right]))
        rows = random.permutation(n).astype(np.intc)
        C_dot, s_dot, loads = np.zeros((n, n)), np.zeros(n), random.normal(size=n)
        found = loads.copy()
        run("delta_rates", rows, C, s, C.T @ mu @ C, C_dot, s_dot, found)
        (
            near(C_dot, -right @ C),
            near(s_dot, np.diag(mu) / (2 * s)),
            near(found[rows], np.linalg.solve(Delta, loads[rows])),
        )
        Adot, Y, rate = (random.normal(size=(n, n)) for _ in range(3))
        found = rate.copy()
        run("add_delta_rate", Adot, Y, mu, found)
        near(found, rate + Adot @ Y.T + Y @ Adot.T - Y @ mu @ Y.T)


def test_rates_of_roots(compiled):
    """The rates of C^T S and L, whose products with themselves are Mdot, and what they make of quasi-velocities."""
    run, n = compiled
    for random, M, C, s in cases(n, 20):
        Mdot, (eta, f) = random.normal(size=(n, n)), random.normal(size=(2, n))
        Mdot += Mdot.T
        mu, Omega, C_dot, s_dot, r = C @ Mdot @ C.T, np.ones((n, n)), np.zeros((n, n)), np.zeros(n), 1 / s
        run("omega_apart", s, mu, Omega)
        near(Omega, mu / (s**2 - s[:, None] ** 2 + np.eye(n)) * (1 - np.eye(n)))
        run("factor_rates", C, r, mu, Omega, C_dot, s_dot)
        root, rate = C.T * s, C_dot.T * s + C.T * s_dot
        near(rate @ root.T + root @ rate.T, Mdot)
        a, q = np.zeros(n), np.zeros(n)
        run("turning_push", C, s, r, Omega, s_dot, eta, eta / s, f, a, q)
        near(a, (C @ f - Omega @ (s * eta) - s_dot * eta) / s)
        inverse_rate = -np.linalg.solve(root, rate) @ np.linalg.inv(root)
        near(np.linalg.inv(root).T @ q, inverse_rate.T @ eta)
        L, pivots = triangular(M)
        inner = np.tril(np.linalg.solve(L, np.linalg.solve(L, Mdot).T))
        Phi = inner - np.diag(np.diag(inner)) / 2
        near(L @ Phi @ L.T + L @ Phi.T @ L.T, Mdot)
        run("triangular_push", L, pivots, Mdot.copy(), eta, f, a, q)
        near(a, np.linalg.solve(L, f) - Phi @ eta), near(q, -Phi.T @ eta)
