"""Blocks of M and groups of rows as users compile them, against NumPy: a root is read where it is, and nowhere else."""

import ctypes

import numpy as np
import pytest

from eigenmotion.building.toolchain import INCLUDE

from .kernels import definite, each, kernels_of, near, triangular

IN_STATE, IN_MEMORY, PREPARED_FACTORS, PREPARED_ROOT = range(4)
HOMES = ((IN_STATE, 0), (IN_STATE, 1), (IN_MEMORY, 0), (PREPARED_FACTORS, 1), (PREPARED_ROOT, 0))
"""With the mode."""


class Context(ctypes.Structure):
    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("coordinate", "scales")),
        *((name, ctypes.c_int) for name in ("home", "mode")),
        *((name, ctypes.c_void_p) for name in ("y", "c", "memory")),
        *((name, ctypes.c_int) for name in ("status", "first", "second")),
        ("size", ctypes.c_double),
    )


@pytest.fixture(scope="module", **each((1, 2, 5), by_night=()))
def compiled(request, tmp_path_factory):
    run, n = kernels_of("blocks", *request.param, tmp_path_factory.mktemp("kernels"))
    return run, n


class Block:
    """A block of n among n + 2 coordinates at random; what is not put into its arrays is NaN."""

    def __init__(self, run, n, home=IN_STATE, mode=0, seed=0):
        self.run, self.n, self.mode = run, n, mode
        self.random = np.random.default_rng([n, home, mode, seed])
        self.coordinate = self.random.permutation(n + 2)[:n].astype(np.intc)
        self.scales = 2.0 ** self.random.integers(-2, 3, n + 2)
        place = np.zeros(4, np.intc)
        length = run("places", place)
        self.C, self.s, self.L, self.r = place
        self.y, self.c, self.memory = np.full((3, length), np.nan)
        self.M, self.factors, self.roots = definite(self.random, n)
        self.eta = self.random.normal(size=n + 2)
        self.y[n + 2 : 2 * (n + 2)] = self.eta
        arrays = (self.y, self.c, self.memory)
        self.context = Context(self.coordinate.ctypes.data, self.scales.ctypes.data, home, mode,
                               *(one.ctypes.data for one in arrays))  # fmt: skip
        triangular_root = home in (IN_MEMORY, PREPARED_ROOT) or home == IN_STATE and mode == 1
        self.root = np.linalg.cholesky(self.M) if triangular_root else self.factors.T * self.roots
        array = self.c if home in (PREPARED_FACTORS, PREPARED_ROOT) else self.memory if triangular_root else self.y
        self.put(array, *(triangular(self.M) if triangular_root else (self.factors, self.roots)), triangular_root)

    def put(self, array, square, line, triangular_root):
        first, second = (self.L, self.r) if triangular_root else (self.C, self.s)
        array[first : first + self.n**2] = square.ravel()
        array[second : second + self.n] = line

    def __call__(self, name, *arguments):
        return self.run(name, ctypes.byref(self.context), *arguments)

    def square(self, array, place):
        return array[place : place + self.n**2].reshape(self.n, self.n)

    def line(self, array, place):
        return array[place : place + self.n]

    @property
    def eta_now(self):
        return self.y[self.n + 2 :][self.coordinate]

    def velocities(self):
        """v of the block and of no other coordinate, without units."""
        v = np.linalg.solve(self.root.T, self.eta[self.coordinate])
        found = np.full(self.n + 2, np.nan)
        found[self.coordinate] = self.scales[self.coordinate] * v
        return found

    def whole(self):
        """M of all coordinates in their own units; what is not of the block is NaN."""
        M = np.full((self.n + 2, self.n + 2), np.nan)
        units = self.scales[self.coordinate]
        M[np.ix_(self.coordinate, self.coordinate)] = self.M / np.outer(units, units)
        return M


def of_block(found, right):
    assert np.array_equal(np.isnan(found), np.isnan(right))
    near(found[~np.isnan(found)], right[~np.isnan(right)])


def test_homes_are_those_of_the_header():
    text = (INCLUDE / "dynamics/em_blocks.h").read_text()
    names = ("EM_IN_STATE", "EM_IN_MEMORY", "EM_PREPARED_FACTORS", "EM_PREPARED_ROOT")
    assert sorted(names, key=text.index) == list(names)


@pytest.mark.parametrize(("home", "mode"), HOMES)
def test_velocities_and_rows(compiled, home, mode):
    block = Block(*compiled, home, mode)
    v = np.full(block.n + 2, np.nan)
    block("velocity_kept", block.eta, v)
    of_block(v, block.velocities())
    v[:] = np.nan
    assert block("velocity_at", block.whole(), v) == 0
    of_block(v, block.velocities())
    A = block.random.normal(size=(block.n + 2, block.n))
    B = np.zeros_like(A)
    block("rows_of_block", A, B)
    near(B, np.linalg.solve(block.root, A.T).T)
    if home != IN_STATE or mode == 0:
        rate, (Adot, Y) = block.random.normal(size=(block.n + 2,) * 2), block.random.normal(size=(2, *A.shape))
        Mdot = block.random.normal(size=block.M.shape)
        Y, found = np.linalg.solve(block.M, A.T).T, rate.copy()
        block("add_delta_rate_of", A, Adot, Mdot, found)
        near(found, rate + Adot @ Y.T + Y @ Adot.T - Y @ Mdot @ Y.T)


def test_factors_of_a_constant_block(compiled):
    block = Block(*compiled)
    assert block("prepare", block.M) == 0
    C, s = block.square(block.c, block.C), block.line(block.c, block.s)
    near(C.T * s**2 @ C, block.M)
    near(block.square(block.c, block.L), np.linalg.cholesky(block.M))
    assert block("prepare", -block.M) == -1
    assert block.context.first == block.coordinate[0]


@pytest.mark.parametrize("mode", [0, 1])
def test_accepted_steps_settle_the_factors(compiled, mode):
    """C and s become those of M; eta turns with C, but not under the triangular root, which is kept."""
    block = Block(*compiled, IN_STATE, mode)
    disturbed = block.factors + 1e-4 * block.random.normal(size=block.M.shape)
    disturbed = np.linalg.qr(disturbed.T)[0].T
    disturbed *= np.sign((disturbed * block.factors).sum(axis=1))[:, None]
    block.put(block.y, disturbed, block.roots, False)
    before = block.eta_now.copy()
    assert block("settle_factors", block.M) == 0
    near(block.square(block.y, block.C), block.factors)
    near(block.line(block.y, block.s), block.roots)
    near(block.eta_now, before if mode else block.factors @ disturbed.T @ before)
    if mode:
        near(block.square(block.memory, block.L)[np.tril_indices(block.n)],
             np.linalg.cholesky(block.M)[np.tril_indices(block.n)])  # fmt: skip
    assert block("settle_factors", -block.M) == -1
    assert block.context.first in block.coordinate


@pytest.mark.parametrize("mode", [0, 1])
def test_both_roots_have_the_same_velocities(compiled, mode):
    block = Block(*compiled, IN_STATE, 1 - mode)
    block.put(block.y, block.factors, block.roots, False)
    v, other = np.full((2, block.n + 2), np.nan)
    block("velocity_kept", block.eta, v)
    published = block.y.copy()
    block("publish_block", v, published)
    near((block.factors.T / block.roots) @ published[block.n + 2 :][block.coordinate],
         v[block.coordinate] / block.scales[block.coordinate])  # fmt: skip
    block.context.mode = mode
    assert block("change_mode", block.M) == 0
    block("velocity_kept", block.y[block.n + 2 :], other)
    of_block(other, v)


def test_roots_are_kept(compiled):
    block = Block(*compiled)
    assert block("keep_root", block.M) == 0
    L, r = triangular(block.M)
    near(np.tril(block.square(block.memory, block.L)), L)
    near(block.line(block.memory, block.r), r)
    assert block("keep_root", -block.M) == -1
    assert block.context.first == block.coordinate[0]


def test_what_is_measured_of_a_block(compiled):
    block = Block(*compiled)
    part = np.zeros_like(block.M)
    block("part", block.whole(), part)
    near(part, block.M)
    Mdot = block.random.normal(size=block.M.shape)
    Mdot += Mdot.T
    mu = block.factors @ Mdot @ block.factors.T
    block("remember_block", Mdot)
    gaps = block.roots**2 - block.roots[:, None] ** 2 + np.eye(block.n)
    near(block.square(block.memory, block.L), mu / gaps * (1 - np.eye(block.n)))
    times = [abs(gaps[i, j]) / np.hypot(mu[i, i] - mu[j, j], 2 * mu[i, j])
             for i in range(block.n) for j in range(i)]  # fmt: skip
    near(min(block("time_of_block", Mdot), 1e6), min(times, default=1e6))
    first = np.array([-1], np.intc)
    assert block("worst_factors", block.whole(), first) < 1e-11
    block.line(block.y, block.s)[-1] *= 1.25
    near(block("worst_factors", block.whole(), first), 1 - 1 / 1.25**2)
    assert first[0] == block.coordinate[0]


def test_groups_of_rows(compiled):
    block = Block(*compiled)
    Delta, rate = np.full((2, block.n + 2, block.n + 2), np.nan)
    rows = np.ix_(*(np.sort(block.coordinate),) * 2)
    block.coordinate.sort()
    Delta[rows] = block.M
    assert block("settle_group", Delta) == 0
    near(block.square(block.y, block.C), block.factors), near(block.line(block.y, block.s), block.roots)
    Delta_dot = block.random.normal(size=block.M.shape)
    Delta_dot += Delta_dot.T
    rate[rows] = Delta_dot
    block("remember_group", rate)
    beta, gaps = block.factors @ Delta_dot @ block.factors.T, block.roots**2 - block.roots[:, None] ** 2
    near(block.square(block.memory, block.L), beta / (gaps + np.eye(block.n)) * (1 - np.eye(block.n)))
    assert block("begin_group", Delta) == 0
    near(block.line(block.y, block.s), np.sort(block.roots))
    Delta[rows] *= -1.0
    for name in ("settle_group", "begin_group"):
        assert block(name, Delta) == -1
        assert block.context.first in block.coordinate


def test_equal_eigenvalues_are_named(compiled):
    block = Block(*compiled)
    assert block("coincident_block") == block("coincident_group") == 0
    if block.n == 1:
        return
    block.line(block.y, block.s)[-1] = block.roots[0]
    assert block("coincident_block") == -1
    assert (block.context.first, block.context.second) == (block.coordinate[0], block.coordinate[-1])
    assert block("coincident_group") == -1
    assert (block.context.first, block.context.second) == (-1, block.coordinate[0])
