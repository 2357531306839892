"""Tables of two arguments in right-hand sides: at very many places, against SciPy's interpolants."""

import numpy as np
import scipy.interpolate as si
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for

COUNT = 100_000
RNG = np.random.default_rng(11)
X = np.cumsum(RNG.uniform(0.05, 0.5, 16)) - 3.0
Y = np.cumsum(RNG.uniform(0.05, 0.5, 12)) + 2.0
VALUES = np.sin(X)[:, None] * np.cos(2 * Y)
SPLINES = [si.RectBivariateSpline(X, Y, VALUES, kx=kx, ky=ky) for kx, ky in ((1, 1), (2, 4), (3, 3), (5, 5))]
GRID = si.RegularGridInterpolator((X, Y), VALUES)
MAPS = [*SPLINES, (X, Y, VALUES)]


def pushed() -> em.Model:
    """Return unit masses, each of which is pushed by a map of the first two coordinates."""
    q = dynamicsymbols(f"q_1:{len(MAPS) + 1}")
    forces = {one: em.Table(chart, name=f"map_{k}")(*q[:2]) for k, (one, chart) in enumerate(zip(q, MAPS, strict=True))}
    energy = sum(one.diff() ** 2 for one in q) / 2
    return em.Model(name="pushed", coordinates=q, kinetic_energy=energy, forces=forces, initial={q[0]: -1.0, q[1]: 4.0})


def places() -> np.ndarray:
    """Return places (COUNT, 2) at random, the first ones at knots of one argument or of both."""
    x, y = RNG.uniform(X[0], X[-1], COUNT), RNG.uniform(Y[0], Y[-1], COUNT)
    x[:2000], y[1000:3000] = RNG.choice(X, 2000), RNG.choice(Y, 2000)
    return np.column_stack([x, y])


def test_forces_are_those_of_scipy_to_rounding():
    system, at = system_for(pushed(), "lagrange"), places()
    x = np.zeros((COUNT, system.n))
    x[:, :2] = at
    rest, prepared = np.zeros_like(x), system.prepare()
    force = system.compiled.acceleration_rows(rest[:, 0], x, rest, np.zeros((COUNT, 0)), prepared, False)[0]
    expected = [*(spline.ev(*at.T) for spline in SPLINES), GRID(at)]
    np.testing.assert_allclose(force, np.transpose(expected), rtol=0, atol=2e-15)  # all values are below 1.1
    rates = [system.rhs(0.0, system.state(one, rest[0], 0.0, prepared), prepared) for one in x[::100]]
    np.testing.assert_allclose(np.array(rates)[:, system.layout["v"]], force[::100], rtol=1e-15, atol=0)
