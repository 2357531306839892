"""Roots of M as users compile them, against NumPy: L, C and s, and which of them runs."""

import ctypes

import numpy as np
import pytest

from .kernels import cases, each, kernels_of, near


@pytest.fixture(scope="module", **each())
def compiled(request, tmp_path_factory):
    return kernels_of("roots", *request.param, tmp_path_factory.mktemp("kernels"))


def test_cholesky_and_what_solves_with_it(compiled):
    run, n = compiled
    for random, M, _, _ in cases(n):
        L, r = np.zeros((n, n)), np.zeros(n)
        assert run("cholesky", M, L, r) == -1
        near(L, np.linalg.cholesky(M))
        near(r * np.diag(L), np.ones(n))
        b, X = random.normal(size=n), random.normal(size=(n, n))
        for name, matrix in (("forward", np.linalg.inv(L)), ("backward", np.linalg.inv(L).T)):
            found = b.copy()
            run(name, L, r, found)
            near(found, matrix @ b)
        found = X.copy()
        run("forward_columns", L, r, found)
        near(found, np.linalg.solve(L, X))
        found = X.copy()
        run("upper_forward_columns", L, r, found)
        near(np.triu(found), np.triu(np.linalg.solve(L, X)))
        found = b.copy()
        run("transposed", L, found)
        near(found, L.T @ b)
        assert run("cholesky", -M, L, r) == 0


def test_ldlt_and_what_solves_with_it(compiled):
    run, n = compiled
    for random, M, _, _ in cases(n):
        L, r, b = np.zeros((n, n)), np.zeros(n), random.normal(size=n)
        assert run("ldlt", M, L, r) == -1
        D, unit = np.diag(L), np.tril(L, -1) + np.eye(n)
        near((unit * D) @ unit.T, M), near(r * D, np.ones(n))
        found = b.copy()
        run("forward_unit", L, found)
        near(found, np.linalg.solve(unit, b))
        run("backward_unit", L, r, found)
        near(found, np.linalg.solve(M, b))
        assert run("ldlt", -M, L, r) == 0


def test_eigenfactors(compiled):
    run, n = compiled
    for random, M, C, s in cases(n):
        disturbed = C + 1e-3 * random.normal(size=(n, n))
        found, roots, eta = disturbed.copy(), np.zeros(n), random.normal(size=n)
        v = C.T @ eta
        run("orthonormalise", found)
        near(found @ found.T, np.eye(n))
        eta = found @ v
        assert run("refresh", M, found, roots, eta) == -1
        near(found, C), near(roots, s), near(found.T @ eta, v)
        found = disturbed.copy()
        assert run("refresh_any", M, found, roots) == -1
        near(found, C), near(roots, s)
        assert run("eigenfactors", M, found, roots) == -1
        near(roots, np.sort(s)), near(found.T * roots**2 @ found, M), near(found @ found.T, np.eye(n))
        L, r = np.ones((n, n)), np.zeros(n)
        assert run("prepare_block", M, found, roots, L, r) == -1
        near(roots, np.sort(s)), near(L, np.linalg.cholesky(M))
        Lambda, turned = M.copy(), np.eye(n)
        run("jacobi", Lambda, turned)
        near(turned @ M @ turned.T, np.diag(np.diag(Lambda)))


def test_products_and_measures(compiled):
    run, n = compiled
    for random, M, C, s in cases(n):
        X, Lambda = random.normal(size=(n, n)), np.zeros((n, n))
        run("congruence", X, M, Lambda)
        near(Lambda, X @ M @ X.T)
        Y = random.normal(size=(n, n))
        for sign in (1.0, -1.0):
            run("multiply", ctypes.c_double(sign), X, Y, Lambda)
            near(Lambda, sign * X @ Y)
            run("lower_multiply", ctypes.c_double(sign), X, Y, Lambda)
            near(np.tril(Lambda), np.tril(sign * X @ Y))
        w, v = random.normal(size=(2, n))
        run("transposed_product", X, w, v)
        near(v, X.T @ w)
        for name, matrix in (
            ("velocity_of_eta", C.T / s),
            ("force_on_eta", (C.T / s).T),
            ("eta_of_velocity", (C.T * s).T),
            ("momentum_of_eta", C.T * s),
        ):
            b = random.normal(size=n)
            found = b.copy()
            run(name, C, s, found)
            near(found, matrix @ b)
        other = s * (1.0 + 1e-3 * random.normal(size=n))
        near(
            run("factor_error", M, C, other),
            np.abs(np.outer(s, s) / np.outer(other, other) * np.eye(n) - np.eye(n)).max(),
        )
        pairs = [(i, j) for i in range(n) for j in range(i)]
        near(min((run("gap", s), 9.0)),
             min([abs(s[i] ** 2 - s[j] ** 2) / max(s[i], s[j]) ** 2 for i, j in pairs], default=9.0))  # fmt: skip
        mu = random.normal(size=(n, n))
        mu = mu + mu.T
        times = [abs(s[i] ** 2 - s[j] ** 2) / np.hypot(mu[i, i] - mu[j, j], 2 * mu[i, j]) for i, j in pairs]
        near(min(run("time_to_crossing", s, mu), 1e6), min(times, default=1e6))


def test_when_the_triangular_root_takes_over(compiled):
    """Begin and keep come first, then Delta, then gaps, then times; what took over gives back later."""
    run, _ = compiled
    keep, begin, look = 2, 8, -1

    def by_gaps(*given):
        return run("mode_by_gaps", *given[:2], *map(ctypes.c_double, given[2:]))

    def by_time(mode, *given):
        return run("mode_by_time", mode, *map(ctypes.c_double, given))

    assert [by_gaps(mode, begin, gap, 0.0) for mode in (0, 1) for gap in (5e-4, 2e-3)] == [1, 0, 1, 0]
    assert [by_gaps(mode, keep, 1e-9, 0.0) for mode in (0, 1)] == [0, 1]
    assert [by_gaps(mode, 0, 0.9, 0.07) for mode in (0, 1)] == [0, 1]
    assert [by_gaps(0, 0, gap, np.inf) for gap in (0.6, 0.4)] == [0, look]
    assert [by_time(0, 0.1, time, -1.0) for time in (0.9, 1.1)] == [1, 0]
    assert [by_time(1, 0.1, time, -1.0) for time in (1.3, 1.5)] == [1, 0]
    assert by_time(1, 5e-4, 9.0, 1.0) == 1
