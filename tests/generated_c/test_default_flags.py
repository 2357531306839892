"""Code compiled at the default flags, as users run it: compilers have rearranged such code wrongly.

What it is made of is in `test_kernels_*`.
"""

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import COMPILERS, MODELS, NAMES, system_for, system_of


def held_chain(m: int, doubled: bool = False) -> em.Model:
    """A planar chain of 2 m unit links, of which every second joint moves on a horizontal line; perhaps one twice."""
    q, g = dynamicsymbols(f"theta1:{2 * m + 1}"), symbols("g", positive=True)
    x = y = T = V = 0
    rows = []
    for k, angle in enumerate(q):
        x, y = x + sin(angle), y - cos(angle)
        T, V = T + (x.diff(em.t) ** 2 + y.diff(em.t) ** 2) / 2, V + g * y
        rows += [y.diff(em.t)] if k % 2 else []
    if doubled:
        rows[-1] = 2 * rows[0]
    return em.Model(
        name=f"held_{m}{'_doubled' if doubled else ''}",
        coordinates=q,
        kinetic_energy=T,
        potential_energy=V,
        parameters={g: 9.81},
        nonholonomic_constraints=rows,
        initial={angle: 0.4 + 0.1 * k for k, angle in enumerate(q)},
    )


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("m", [4, *(pytest.param(m, marks=pytest.mark.nightly) for m in (2, 3, 5))])
def test_many_rows_beside_many_coordinates(m, compiler):
    """What compilers pack into vectors: by day with one of them, and with Clang in `test_right_hand_side_on_lanes`.

    At each step's end C_delta, s_delta are those of A M^-1 A^T, also in the order in which GCC 12 once mixed them up.
    """
    system = em.build(held_chain(m), schur="eigenfactor", compiler=compiler, flags="")
    run = same_run(system, system_for(held_chain(m), schur="eigenfactor"), 0.2)
    for x, y in zip(run.x.T, run.y.T, strict=True):
        A, _ = system.pfaffian(x)
        Delta = A @ np.linalg.solve(system.mass_matrix(x), A.T)
        C, s = y[system.layout["C_delta"]].reshape(m, m), y[system.layout["s_delta"]]
        assert np.abs(C.T * s**2 @ C - Delta).max() < 1e-13


def test_rows_of_twelve_numbers_on_the_stack():
    """GCC 12 took them for aligned, and the process ended."""
    model = held_chain(6, doubled=True)
    system = em.build(model, formulation="lagrange", flags="")
    options = {"rtol": 1e-9, "dependent_constraints": "least_norm"}
    quick, plain = (one.simulate((0.0, 0.2), **options) for one in (system, system_for(model, formulation="lagrange")))
    assert quick.success, quick.message
    assert np.abs(quick.x[:, -1] - plain.x[:, -1]).max() < 1e-8


@pytest.mark.nightly
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("name", NAMES)
def test_runs_are_those_of_code_that_is_hardly_optimised(name, compiler):
    quick = em.build(MODELS / f"{name}.py", compiler=compiler, flags="")
    same_run(quick, system_of(name), 0.5, TOLERANCES.get(name, 1e-10))


TOLERANCES = {"quick_return_shaper": 1e-13}
"""For models whose forces have kinks within steps (a guide whose load changes its side). Rounding changes the steps
there, so two runs differ by their errors, which have to be below the limit of the comparison."""


def same_run(quick: em.System, plain: em.System, t_end: float, tolerance: float = 1e-10) -> em.Solution:
    """Return the run of the former, which is that of the latter."""
    runs = [system.simulate((0.0, t_end), rtol=tolerance, atol=tolerance) for system in (quick, plain)]
    assert all(run.success for run in runs), runs[0].message
    scale = 1.0 + np.abs(runs[1].x[:, -1]).max()
    assert np.abs(runs[0].x[:, -1] - runs[1].x[:, -1]).max() < 1e-10 * scale
    assert runs[0].factor_residual.max() < 1e-13
    return runs[0]
