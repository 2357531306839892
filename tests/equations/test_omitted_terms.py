"""Omitted terms change no number: each saving switched off, and all terms present but zero."""

from dataclasses import replace

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.codegen.equations.specialise import ALL_SAVINGS, Saving

from eigenmotion import Model, System, t

from ..support.generation import model_of, relative, states, system_for, system_of
from ..support.kinematics import acceleration

MODELS = ("dual_link", "polar_particle", "chaplygin_sleigh", "slider_crank", "rotating_hoop")
SETS = {saving.name.lower(): ALL_SAVINGS - {saving} for saving in Saving} | {
    "everything": frozenset(Saving) - ALL_SAVINGS
}
LIMIT = 1e-12


def compare(full: System, lean: System) -> None:
    """Accelerations by way of the right-hand sides, M, energies, multipliers at random states, and a short run."""
    for x, v, time in states(lean, 5):
        found, right = (reached(system, x, v, time) for system in (full, lean))
        assert relative(found, right) < LIMIT
        assert relative(full.mass_matrix(x, time), lean.mass_matrix(x, time)) < 1e-14
        assert full.energy(x, v, time) == pytest.approx(lean.energy(x, v, time), rel=1e-13, abs=1e-14)
        multipliers = (system.acceleration(x, v, time)[1] for system in (full, lean))
        assert relative(*multipliers, 1e-2) < LIMIT
    runs = [system.simulate((0, 0.5), rtol=1e-12, atol=1e-13) for system in (full, lean)]
    assert all(run.success for run in runs)
    assert relative(runs[0].x[:, -1], runs[1].x[:, -1], 1.0) < 1e-11
    assert relative(runs[0].v[:, -1], runs[1].v[:, -1], 1.0) < 1e-11


def reached(system: System, x: np.ndarray, v: np.ndarray, time: float) -> np.ndarray:
    y = system.state(x, v, time)
    return acceleration(system, time, y, system.rhs(time, y))


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("off", SETS)
def test_each_saving_switched_off(name, off):
    full, lean = system_for(model_of(name), savings=SETS[off]), system_of(name)
    assert full.n_state >= lean.n_state
    compare(full, lean)


@pytest.mark.parametrize("name", ["dual_link", "polar_particle"])
@pytest.mark.parametrize("formulation", [name for name in FORMULATIONS if name != "eigenfactor"])
def test_all_savings_switched_off_in_the_other_formulations(name, formulation):
    compare(system_for(model_of(name), formulation, frozenset()), system_of(name, formulation))


def test_savings_save_states():
    counts = {off: system_for(model_of("dual_link"), savings=savings).n_state for off, savings in SETS.items()}
    assert system_of("dual_link").n_state == 20
    assert counts == {"uncoupled": 28, "fixed": 20, "single": 20, "everything": 28}


# --- all terms present, but zero --------------------------------------------------------------------------------------

nought = sympy.Symbol("nought", real=True)


def with_everything(model: Model) -> Model:
    """The model with T1, T0, and the time in M, V, A and b, each multiplied by a parameter that is 0."""
    x, v = model.coordinates, model.rates
    far = sum(sympy.sin(c + t + k) for k, c in enumerate(x))
    T = model.kinetic_energy + nought * (far * sum(v) + far * sum(v) ** 2 + far**2)
    return replace(
        model,
        kinetic_energy=T,
        potential_energy=model.potential_energy + nought * far,
        forces=[Q + nought * far * sum(v) for Q in model.forces],
        nonholonomic_constraints=[row + nought * far * (1 + sum(v)) for row in model.nonholonomic_constraints],
        holonomic_constraints=[phi + nought * far for phi in model.holonomic_constraints],
        parameters=[*model.parameters, (nought, 0.0)],
    )


@pytest.mark.parametrize("name", ["dual_link", "polar_particle", "slider_crank", "chaplygin_sleigh"])
@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
def test_terms_that_are_present_but_zero(name, formulation):
    full, lean = system_for(with_everything(model_of(name)), formulation), system_of(name, formulation)
    assert len(full.left_out) < len(lean.left_out)
    compare(full, lean)


@pytest.mark.parametrize("name", ["dual_link", "slider_crank"])
def test_terms_that_are_present_and_not_zero_do_change_the_motion(name):
    """So that the test above compares something."""
    full = system_for(with_everything(model_of(name)))
    x, v, time = next(states(full, 1))
    changed = full.acceleration(x, v, time, {"nought": 0.1})[0]
    assert relative(changed, full.acceleration(x, v, time)[0]) > 1e-3
