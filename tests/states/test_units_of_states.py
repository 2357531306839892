"""Linear models in any unit of a state: a state has no inertia that could give its unit."""

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for

x, y, z = dynamicsymbols("x y z")
c, u, w = symbols("c u w", positive=True)
PLANT = np.array([[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-2, 1, 0, 0, 0.7], [1, -3, 0, 0, 0], [0.4, 0, -0.5, 0, -0.6]])
"""Rates of x, y, x', y' and Z = u z, in a unit of time of 1 / w: two masses on springs, one of them with a coil."""
driven = em.Model(
    name="driven", coordinates=[x, y], kinetic_energy=c * (x.diff() ** 2 + y.diff() ** 2) / 2,
    potential_energy=c * w**2 * (2 * x**2 - 2 * x * y + 3 * y**2) / 2, forces={x: c * w**2 * 0.7 * u * z},
    states={z: (0.4 * w * x - 0.5 * x.diff() - 0.6 * w * u * z) / u}, parameters={c: 1.0, u: 1.0, w: 1.0},
)  # fmt: skip


@pytest.mark.parametrize("mass", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("unit", [1e-9, 1e-6, 1.0, 1e6, 1e9])
@pytest.mark.parametrize("rate", [1e-6, 1.0, 1e6])
def test_eigenvalues_do_not_depend_on_the_unit_of_a_state(unit: float, rate: float, mass: float):
    found = system_for(driven, "lagrange").linearize(parameters={"u": unit, "w": rate, "c": mass})
    expected = np.linalg.eigvals(PLANT)
    assert np.sort_complex(found.eigenvalues() / rate) == pytest.approx(np.sort_complex(expected), abs=1e-9)
    assert found.steady
