"""Constraint rows, Delta and multipliers as users compile them, against NumPy."""

import numpy as np
import pytest

from .kernels import cases, each, kernels_of, near, triangular

LEAST_NORM = 4


@pytest.fixture(scope="module", **each())
def compiled(request, tmp_path_factory):
    return kernels_of("rows", *request.param, tmp_path_factory.mktemp("kernels"))


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
        run("change_root", 0, C, s, L, pivots, found)
        near(found, eta)


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
        products = Delta.copy()
        run("products", B, A, products)
        near(products, Delta + B @ A.T)
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
