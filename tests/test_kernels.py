"""em_linear.h and em_rank.h as users compile it, against NumPy: every kernel, every size, every compiler there is.

GCC 12 once ranked the rows of each Delta of four rows wrongly where it vectorised straight-line code for AVX-512.
"""

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

from eigenmotion.building.toolchain import INCLUDE, STANDARD, toolchain

from .generation import COMPILERS

SOURCE = Path(__file__).parent / "kernels" / "kernels.c"
SIZES = range(1, 9)
TINY = 1e-11
LEAST_NORM = 4


class Kernels:
    """The compiled functions on arrays; those that return doubles are named."""

    def __init__(self, library: Path) -> None:
        self._library = ctypes.CDLL(str(library))
        for name in ("factor_error", "gap", "time_to_crossing"):
            getattr(self._library, name).restype = ctypes.c_double

    def __call__(self, name, *arguments):
        return getattr(self._library, name)(
            *(one.ctypes.data_as(ctypes.c_void_p) if isinstance(one, np.ndarray) else one for one in arguments)
        )


@pytest.fixture(scope="module", params=[(c, n) for c in COMPILERS for n in SIZES], ids=lambda one: f"{one[0]}-{one[1]}")
def compiled(request, tmp_path_factory):
    """(kernels, n): at the default flags."""
    compiler, n = request.param
    library = tmp_path_factory.mktemp("kernels") / "kernels.so"
    flags = (*STANDARD, *toolchain(compiler).optimised, "-fPIC", "-shared", f"-DSIZE={n}", f"-I{INCLUDE}")
    subprocess.run([compiler, *flags, str(SOURCE), "-lm", "-o", str(library)], check=True)
    return Kernels(library), n


def definite(random, n):
    """A positive definite matrix, eigenvalues apart, and its eigenfactors with rows at random."""
    C = np.linalg.qr(random.normal(size=(n, n)))[0]
    s = np.sqrt(random.permutation(np.arange(1, n + 1) + random.uniform(-0.3, 0.3, n)))
    M = C.T * s**2 @ C
    return (M + M.T) / 2, np.ascontiguousarray(C), s


def cases(n, count=100):
    random = np.random.default_rng(n)
    for _ in range(count):
        yield random, *definite(random, n)


def near(found, right):
    assert np.abs(found - right).max(initial=0.0) <= TINY * max(1.0, np.abs(right).max(initial=0.0))


def triangular(M):
    L = np.linalg.cholesky(M)
    return L, 1.0 / np.diag(L)


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
        found = b.copy()
        run("transposed", L, found)
        near(found, L.T @ b)
        assert run("cholesky", -M, L, r) == 0


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
        Lambda, turned, eta = M.copy(), np.eye(n), v.copy()
        run("jacobi", Lambda, turned, eta)
        near(turned @ M @ turned.T, np.diag(np.diag(Lambda))), near(turned.T @ eta, v)


def test_products_and_measures(compiled):
    run, n = compiled
    for random, M, C, s in cases(n):
        X, Lambda = random.normal(size=(n, n)), np.zeros((n, n))
        run("congruence", X, M, Lambda)
        near(Lambda, X @ M @ X.T)
        for name, matrix in (("from_axes", C.T / s), ("to_axes", (C.T / s).T), ("onto_axes", (C.T * s).T)):
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


def ranked(Delta):
    """Pivoted elimination: the order of the rows, and what each adds."""
    D, order, pivots = Delta.copy(), list(range(len(Delta))), []
    for k in range(len(D)):
        best = max(range(k, len(D)), key=lambda i: D[order[i], order[i]])
        order[k], order[best] = order[best], order[k]
        pivots.append(D[order[k], order[k]])
        D = D - np.outer(D[:, order[k]], D[order[k]]) / pivots[-1]
    return order, np.array(pivots)


def test_ranked_rows(compiled):
    """Of 1000 definite matrices every one; the lower triangle is what is read."""
    run, n = compiled
    wrong = 0
    for random, Delta, _, _ in cases(n, 1000):
        pivot, row = np.zeros(n), np.zeros(n, np.intc)
        run("ranked_rows", np.tril(Delta) + np.triu(random.normal(size=(n, n)), 1), pivot, row)
        order, right = ranked(Delta)
        wrong += row.tolist() != order or not np.allclose(pivot, right, rtol=1e-9)
    assert wrong == 0


def test_solutions_of_delta(compiled):
    """Where its rows are independent, and where one is another's multiple or nothing at all."""
    run, n = compiled
    for random, Delta, _, _ in cases(n):
        rhs = random.normal(size=n)
        assert run("rank_of", np.tril(Delta)) == n
        assert run("vanished_row", np.tril(Delta)) == -1
        for name, flags in (("solve_delta", [0]), ("least_norm", [])):
            found = rhs.copy()
            assert run(name, np.tril(Delta), found, *flags) in (-1, 0)
            near(found, np.linalg.solve(Delta, rhs))
        if n == 1:
            continue
        B = random.normal(size=(n, n + 1))
        B[-1] = random.choice([0.0, -2.0]) * B[0]
        singular, rhs = B @ B.T, B @ random.normal(size=n + 1)
        assert run("rank_of", np.tril(singular)) == n - 1
        for name, flags in (("solve_delta", [LEAST_NORM]), ("least_norm", [])):
            found = rhs.copy()
            run(name, np.tril(singular), found, *flags)
            right = np.linalg.lstsq(singular, rhs, rcond=1e-10)[0]
            assert np.abs(found - right).max() < 1e-7 * max(1.0, np.abs(right).max())
        assert run("solve_delta", np.tril(singular), rhs.copy(), 0) == -1
