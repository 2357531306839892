"""dS/dx_k, dC/dx_k and J = d eta / dx of (23), (24) against differences of `eigh` and the rest of (22)."""

import numpy as np
import pytest
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for
from ..support.models_table import BY_NAME

NAMES = ("dual_link", "double_pendulum", "spatial_arm_3", "chain_5", "polar_particle")


def aligned(M, C):
    """Return eigenfactors of M by LAPACK with the order and signs of C."""
    values, vectors = np.linalg.eigh(M)
    rows = vectors.T
    order = [int(np.argmax(np.abs(rows @ row))) for row in C]
    signs = [np.sign(rows[place] @ row) for place, row in zip(order, C, strict=True)]
    return np.array(signs)[:, None] * rows[order], np.sqrt(values[order])


def block_differences(system, x, block, C, step=1e-5):
    """Return dC, ds of one block by fourth-order central differences."""

    def at(z):
        return aligned(system.mass_matrix(z)[np.ix_(block, block)], C)

    dC, ds = [], []
    for k in range(system.n):
        e = step * np.eye(system.n)[k]
        (a, sa), (b, sb), (c, sc), (d, sd) = at(x - 2 * e), at(x - e), at(x + e), at(x + 2 * e)
        dC.append((a - 8 * b + 8 * c - d) / (12 * step))
        ds.append((sa - 8 * sb + 8 * sc - sd) / (12 * step))
    return np.array(dC), np.array(ds)


@pytest.fixture(scope="module", params=NAMES)
def system(request):
    return system_for(BY_NAME[request.param].model())


def positions(system, count=4):
    rng = np.random.default_rng(11)
    return [system.initial[0] + rng.uniform(0.1, 0.5, system.n) for _ in range(count)]


def test_gradient_is_that_of_eigh(system):
    for x in positions(system):
        found = system.eigenfactor_gradient(x)
        for block in map(list, system.blocks):
            C = found.C[np.ix_(block, block)]
            dC, ds = block_differences(system, x, block, C)
            np.testing.assert_allclose(
                found.dC[np.ix_(range(system.n), block, block)], dC, atol=2e-7 * (1 + abs(dC).max())
            )
            np.testing.assert_allclose(found.ds[:, block], ds, atol=2e-7 * (1 + abs(ds).max()))


def test_sensitivity_closes_equation_22(system):
    """dT/dx at fixed xdot is 1/2 xdot^T M_x xdot; by way of T* = eta^T eta / 2 it is J^T eta (22)."""
    rng = np.random.default_rng(12)
    for x in positions(system):
        v = rng.normal(size=system.n)
        found = system.eigenfactor_gradient(x)
        eta = found.s * (found.C @ v)
        direct = 0.5 * np.einsum("i,kij,j->k", v, system.mass_matrix_gradient(x), v)
        np.testing.assert_allclose(system.eta_sensitivity(x, v).T @ eta, direct, atol=1e-12 * (1 + abs(direct).max()))


def test_coincident_eigenvalues_have_no_gradient():
    """M = [[2 + p, q], [q, 2 - p]]: at p = q = 0 the axes of C depend on the way there."""
    p, q = dynamicsymbols("p q")
    T = ((2 + p) * p.diff() ** 2 + 2 * q * p.diff() * q.diff() + (2 - p) * q.diff() ** 2) / 2
    system = system_for(em.Model(name="conical", coordinates=[p, q], kinetic_energy=T))
    with pytest.raises(ValueError, match="coincide"):
        system.eigenfactor_gradient([0.0, 0.0])
