"""The robot arm, a model of a tree, against Lagrange's equations of the energies that forward kinematics give."""

from pathlib import Path

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.model.symbolic.lagrange import lagrange

import eigenmotion as em

from ..support.generation import FORMULATIONS, system_of

MODEL = em.load_model(Path(__file__).parents[2] / "models" / "robot_arm.py")
X, V = np.array([0.3, 0.9, -1.1, 0.4, 0.2, 0.1]), np.array([0.1, -0.2, 0.3, 0.4, -0.5, 0.6])


@pytest.fixture(scope="module")
def equations():
    """Lagrange's equations in plain symbols, with nested dual numbers for the derivatives of T and V."""
    terms = lagrange(MODEL)
    return terms, sympy.lambdify(terms.arguments, terms.entries, "numpy")


def test_mass_matrix_and_accelerations_are_lagranges(equations):
    terms, values = equations
    M, _, f, _ = terms.split(values(*X, *V, 0.0, *(value for _, value in terms.constants)))
    M, f = np.array(M, float), np.array(f, float)
    system = system_of("robot_arm", "articulated_body")
    assert np.abs(system.mass_matrix(X) - M).max() < 1e-13 * np.abs(M).max()
    a = np.linalg.solve(M, f)
    assert np.abs(system.acceleration(X, V)[0] - a).max() < 1e-11 * np.abs(a).max()


@pytest.mark.parametrize("formulation", [*FORMULATIONS, "articulated_body"])
def test_all_formulations_move_alike(formulation):
    systems = [system_of("robot_arm", one) for one in ("articulated_body", formulation)]
    expected, run = (em.simulate(one, (0, 1), t_eval=[0.5, 1.0], rtol=1e-10, atol=1e-11) for one in systems)
    assert np.abs(run.x - expected.x).max() < 1e-8
    assert np.abs(run.outputs["hand_z"] - expected.outputs["hand_z"]).max() < 1e-8


def test_energy_falls_as_the_dampers_take_it():
    """T + V + the work of the dampers stays; the work is Simpson's rule over rows, for the wrist slows in 0.4 ms."""
    at = np.linspace(0, 0.2, 8001)
    run = em.simulate(system_of("robot_arm", "articulated_body"), (0, 0.2), t_eval=at, rtol=1e-11, atol=1e-12)
    power = 0.5 * (run.v**2).sum(axis=0)
    work = (at[1] - at[0]) / 3 * (power[0] + 4 * power[1:-1:2].sum() + 2 * power[2:-1:2].sum() + power[-1])
    assert run.energy[-1] - run.energy[0] == pytest.approx(-work, rel=1e-7)


def test_linear_models_and_stiff_methods_take_trees():
    system = system_of("robot_arm", "articulated_body")
    down = em.simulate(system, (0, 200), rtol=1e-8).x[:, -1]
    rest = em.find_equilibrium(system, x0=down)
    assert np.abs(rest.x - down).max() < 1e-3
    values = np.linalg.eigvals(system.linearize(x=rest.x).A)
    assert (values.real < 0).all()
    runs = [
        em.simulate(system, (0, 1), t_eval=[1.0], method=method, rtol=1e-9, atol=1e-11)
        for method in ("radau9", "dop853")
    ]
    assert np.abs(runs[0].x - runs[1].x).max() < 1e-6


def test_sensitivities_of_the_payload():
    system, h = system_of("robot_arm", "articulated_body"), 1e-4
    slope = em.simulate(system, (0, 1), t_eval=[1.0], rtol=1e-10, atol=1e-12, sensitivities=["payload"])
    ends = [em.simulate(system, (0, 1), t_eval=[1.0], rtol=1e-12, atol=1e-13, parameters={"payload": 2.0 + s * h}).x
            for s in (-1, 1)]  # fmt: skip
    assert np.abs(slope.sensitivity["payload"].dx - (ends[1] - ends[0]) / (2 * h)).max() < 1e-6
