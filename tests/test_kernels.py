"""The dense algebra of the headers as users compile it, against NumPy: every function, every size, every compiler.

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


def test_velocities_and_rows(compiled):
    """m = n + 1 rows; A on the velocities xdot is B on eta, under either root of M."""
    run, n = compiled
    for random, M, C, s in cases(n, 20):
        eta, A = random.normal(size=n), random.normal(size=(n + 1, n))
        r, w, v = np.zeros(n), np.zeros(n), np.zeros(n)
        run("velocity", C, s, eta, r, w, v)
        near(r, 1 / s), near(w, eta / s), near(v, C.T @ (eta / s))
        L, pivots = triangular(M)
        for name, factors, right in (("rows_on_eta", (C, r), A @ C.T / s), ("rows_of_factors", (C, s), A @ C.T / s),
                                     ("rows_of_root", (L, pivots), A @ np.linalg.inv(L).T)):  # fmt: skip
            B = np.zeros((n + 1, n))
            run(name, *factors, A, B)
            near(B, right)
        Y = np.zeros((n + 1, n))
        run("product", A, C, Y)
        near(Y, A @ C.T)
        found = eta.copy()
        run("change_root", 1, C, s, L, pivots, found)
        near(found, L.T @ v)
        run("velocity_of_triangular", M, found)
        near(found, v)
        found = L.T @ v
        run("change_root", 0, C, s, L, pivots, found)
        near(found, eta)


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


def test_delta_block_by_block(compiled):
    run, n = compiled
    for random, _, C, s in cases(n, 20):
        B, A, A_dot = random.normal(size=(3, n + 1, n))
        C_dot, (s_dot, a, q) = random.normal(size=(n, n)), random.normal(size=(3, n))
        Delta, load = random.normal(size=(n + 1, n + 1)), random.normal(size=n + 1)
        for turning, right in ((None, B @ a), (q, B @ (a + q))):
            sums = load.copy()
            run("add_to_load", B, a, turning, sums)
            near(sums, load + right)
        less = a.copy()
        run("subtract_reactions", B, load, less)
        near(less, a - B.T @ load)
        B_dot = np.zeros((n + 1, n))
        run("row_rates", C, 1 / s, C_dot, s_dot, A, A_dot, B, B_dot)
        near(B_dot, (A_dot @ C.T + A @ C_dot.T - B * s_dot) / s)
        rows = np.sort(random.permutation(n + 1)[:n]).astype(np.intc)
        part, rate = np.zeros((n, n)), np.zeros((n, n))
        run("part_of_delta", rows, np.tril(Delta), part)
        whole = np.tril(Delta) + np.tril(Delta, -1).T
        near(part, whole[np.ix_(rows, rows)])
        run("add_to_delta_rate", rows, B, B_dot, rate)
        near(rate, (B_dot @ B.T + B @ B_dot.T)[np.ix_(rows, rows)])
        spread, back = np.zeros((n + 1, n + 1)), np.zeros((n, n))
        run("spread", rows, C, spread), run("gather", rows, spread, back)
        near(spread[np.ix_(rows, rows)], C), near(back, C)


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
