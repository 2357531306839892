"""C and s refined from nearby ones as users compile it, against NumPy and mpmath: any gap, any scale."""

import mpmath
import numpy as np
import pytest

from .kernels import each, kernels_of

EPS = np.finfo(float).eps
GAPS = (1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15)
OFF = (0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.02)


@pytest.fixture(scope="module", **each((1, 2, 3, 5, 6, 7, 8, 16), by_night=()))
def compiled(request, tmp_path_factory):
    return kernels_of("refine", *request.param, tmp_path_factory.mktemp("kernels"))


def spectra(random, n):
    """Eigenvalues: apart; two closer and closer; all in a cluster; over six powers of ten."""
    apart = random.permutation(np.arange(1, n + 1) + random.uniform(-0.3, 0.3, n))
    yield apart
    for gap in GAPS if n > 1 else ():
        yield np.concatenate([apart[:-1], [apart[0] * (1 + gap)]])
        yield 1 + gap * apart
    yield 10.0 ** random.uniform(-3, 3, n)


def cases(n):
    """(random, C, M, eigenvalues): M = C^T S^2 C to rounding, in units from 1e-60 to 1e60."""
    random = np.random.default_rng(n)
    for values in spectra(random, n):
        for scale in (1e-60, 1.0, 1e60):
            C = np.ascontiguousarray(np.linalg.qr(random.normal(size=(n, n)))[0])
            M = (C.T * (scale * values)) @ C
            yield random, C, (M + M.T) / 2, scale * values


def near_by(random, C, off):
    """C turned by an angle of about `off`, and as far from being orthonormal as a step leaves it."""
    return np.ascontiguousarray(C + off * random.normal(size=C.shape) / len(C) ** 0.5)


def test_factors_to_rounding_and_near_their_predecessor(compiled):
    """C C^T = 1 and M = C^T S^2 C to rounding, wherever C began; rows that can be told apart are."""
    run, n = compiled
    for random, exact, M, values in cases(n):
        spread, closest = np.ptp(values), np.diff(np.sort(values)).min(initial=np.inf)
        told_apart = EPS * n * values.max() < 0.1 * closest
        for off in OFF:
            before, s = near_by(random, exact, off), np.zeros(n)
            C, eta = before.copy(), random.normal(size=n)
            v = np.linalg.solve(before, eta)
            assert run("refresh", M, C, s, eta) == -1
            assert np.abs(C @ C.T - np.eye(n)).max() <= 20 * n * EPS
            assert np.abs((C.T * s**2) @ C - M).max() <= 20 * n * EPS * np.abs(M).max()
            if told_apart and n * off**2 * spread < 0.1 * closest:
                assert (np.diag(C @ before.T) > 0.5).all()
            assert np.linalg.norm(C.T @ eta - v) <= (1e-13 + 10 * off) * np.linalg.norm(v)
            if off == 0.0:
                assert np.abs(np.linalg.norm(eta) / np.linalg.norm(v) - 1) <= 20 * n * EPS


def test_where_eigenvalues_are_apart_nothing_is_swept(compiled):
    """A step's error is refined away; what is not near, or too close to tell apart, is left to sweeps."""
    run, n = compiled
    random = np.random.default_rng(n)
    exact = np.ascontiguousarray(np.linalg.qr(random.normal(size=(n, n)))[0])
    values = np.arange(1.0, n + 1)
    M, found = (exact.T * values) @ exact, np.zeros(n)
    for off in (0.0, 1e-12, 1e-9, 1e-6, 1e-3):
        C = near_by(random, exact, off)
        assert run("refine", M, C, found) == 1
        assert np.abs(C - exact).max() <= 100 * n * EPS
        assert np.abs(found / values - 1).max() <= 100 * n * EPS
    assert run("refine", M, np.full((n, n), np.nan), found) == 0
    if n > 1:
        assert run("refine", M, np.ascontiguousarray(np.roll(exact, 1, axis=0) + 0.5), found) == 0
        turned = exact.copy()
        turned[:2] = np.array([[0.8, 0.6], [-0.6, 0.8]]) @ exact[:2]
        assert run("refine", (exact.T * (1 + 1e-9 * values)) @ exact, turned, found) == 0


def test_against_many_digits(compiled):
    """The eigenvalues of the very matrix of doubles, by mpmath, to rounding of the largest."""
    run, n = compiled
    random = np.random.default_rng(100 + n)
    for gap in (1e-2, 1e-8, 1e-14):
        values = np.arange(1.0, n + 1)
        if n > 1:
            values[-1] = 1 + gap
        exact = np.linalg.qr(random.normal(size=(n, n)))[0]
        M = (exact.T * values) @ exact
        M = (M + M.T) / 2
        with mpmath.workdps(40):
            right = np.sort([float(mpmath.sqrt(each)) for each in mpmath.eigsy(mpmath.matrix(M.tolist()))[0]])
        C, s = near_by(random, exact, 1e-7), np.zeros(n)
        assert run("refresh", M, C, s, np.zeros(n)) == -1
        assert np.abs(np.sort(s) - right).max() <= 20 * n * EPS * right.max()


def test_a_factor_along_rows(compiled):
    """L of any size and scale; the first pivot that is too small is named; what is above the diagonal is not read."""
    run, n = compiled
    for random, _, given, values in cases(n):
        M = given + values.max() * np.eye(n)
        lower = M + np.triu(np.full((n, n), np.nan), 1)
        L, r = np.zeros((n, n)), np.zeros(n)
        assert run("cholesky", lower, L, r) == -1
        assert np.abs(L @ L.T - M).max() <= 20 * n * EPS * np.abs(M).max()
        assert np.abs(r * np.diag(L) - 1).max() <= 4 * EPS
        bad = random.integers(n)
        spoiled = np.tril(L @ L.T - 2 * L[bad, bad] ** 2 * np.outer(np.eye(n)[bad], np.eye(n)[bad]))
        assert run("cholesky", spoiled, L, r) == bad
