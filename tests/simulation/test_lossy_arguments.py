"""Arguments that would lose something on the way are refused, and a failure names what caused it."""

import numpy as np
import pytest
from eigenmotion.codegen.model import ModelError
from sympy import Rational, cos, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, System
from eigenmotion.runtime import StopReason

from ..support.generation import system_for, system_of

X, Y = dynamicsymbols("x y")


@pytest.fixture
def system() -> System:
    return system_of("double_pendulum")


@pytest.mark.parametrize("kind", [int, bool, np.uint8, complex, object])
def test_rhs_refuses_to_write_into_what_is_no_array_of_floats(system, kind):
    y, out = system.state(), np.zeros(system.n_state, kind)
    with pytest.raises(ValueError, match="out must be a writable array of floating point numbers"):
        system.rhs(0.0, y, out=out)
    frozen = np.zeros(system.n_state)
    frozen.flags.writeable = False
    for wrong in (frozen, list(y), np.zeros(system.n_state + 1)):
        with pytest.raises(ValueError, match="out must be a writable"):
            system.rhs(0.0, y, out=wrong)


@pytest.mark.parametrize("given", [None, True, 1, b"none"])
def test_a_word_is_a_string(system, given):
    for option in ("stabilisation", "method", "dependent_constraints"):
        with pytest.raises(ModelError, match=f"{option} is .*not one of the words "):
            system.simulate((0, 1), **{option: given})


def test_complex_numbers_are_refused_in_loops_too(system):
    """All other functions: test_bad_input."""
    with pytest.raises(ValueError, match=r"real number|not a number"):
        system.rhs(0.0, system.state().astype(complex))


def test_a_short_velocity_is_not_broadcast(system):
    for v in ([1.0], 1.0, np.ones(system.n + 1)):
        with pytest.raises(ModelError, match=r"v0: .*(shape|not an array)"):
            system.eta_sensitivity(np.ones(system.n), v)


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853", "radau5", "radau9"])
def test_max_steps_are_accepted_steps(system, method):
    whole = system.simulate((0, 1), method=method)
    assert whole.nsteps > 5
    assert system.simulate((0, 1), method=method, max_steps=whole.nsteps).success
    short = system.simulate((0, 1), method=method, max_steps=whole.nsteps - 1)
    assert (short.stop, short.nsteps) == (StopReason.TOO_MANY_STEPS, whole.nsteps - 1)


@pytest.mark.parametrize("method", ["rk34", "dop853", "radau5"])
def test_a_force_without_bounds_is_not_blamed_on_the_mass_matrix(method):
    u = dynamicsymbols("u")
    energy = (X.diff() ** 2 * (1 + X**2) + Y.diff() ** 2 + X.diff() * Y.diff() * cos(Y)) / 2
    pushed = system_for(Model(name="overflowing", coordinates=[X, Y], kinetic_energy=energy, forces={X: u},
                              inputs={u: 0.0}))  # fmt: skip
    with np.errstate(all="ignore"):
        found = pushed.simulate((0, 1), inputs={"u": 1e308}, method=method)
    assert found.stop is StopReason.NON_FINITE_STATE
    assert "inputs" in found.message


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
@pytest.mark.parametrize("method", ["rk34", "dop853"])
def test_a_row_of_a_coordinate_that_loses_its_inertia_is_not_blamed(method, formulation):
    energy = Rational(9, 25) * (X.diff() ** 2 + sin(X) ** 2 * Y.diff() ** 2)
    hoop = system_for(
        Model(name="hoop", coordinates=[X, Y], kinetic_energy=energy, potential_energy=-6 * cos(X),
              nonholonomic_constraints=[Y.diff() - 5], initial={X: 2.5, Y.diff(): 5}), formulation
    )  # fmt: skip
    found = hoop.simulate((0, 2), method=method)
    assert found.stop in (StopReason.FINISHED, StopReason.SINGULAR_MASS_MATRIX)
    assert found.success or "'y'" in found.message


def test_what_needs_a_system_says_so(system):
    for call in (em.find_equilibrium, em.assemble):
        with pytest.raises(
            ModelError, match=rf"{call.__name__}: system is .*, not a System\. Compile the model.*em\.build"
        ):
            call(Model(name="free", coordinates=[X], kinetic_energy=X.diff() ** 2))


def test_a_unit_is_written_to_a_file_of_its_kind(tmp_path):
    (tmp_path / "folder.fmu").mkdir()
    model = Model(name="free", coordinates=[X], kinetic_energy=X.diff() ** 2)
    for path, words in (
        (None, "path is None"),
        (tmp_path / "a.zip", r"ends in \.fmu"),
        (tmp_path / "folder.fmu", "is a folder"),
    ):
        with pytest.raises(ModelError, match=words):
            em.export_fmu(model, path)


def test_runs_of_an_ensemble_are_numbered(system):
    runs = em.simulate_ensemble(system, (0.0, 0.1), x0={system.coordinates[0]: [0.1, 0.2]})
    for ask in (runs.__getitem__, runs.message):
        for k in (2, -3):
            with pytest.raises(IndexError, match=f"run {k} of an ensemble of 2: .* from 0 to 1"):
                ask(k)
        with pytest.raises(ModelError, match="'a' of an ensemble: runs are numbered"):
            ask("a")
    assert np.array_equal(runs[-1].y, runs[1].y)


@pytest.mark.parametrize("given", ["1", None, [1.0, 2.0], 1j])
def test_a_stepper_names_what_is_no_number(given):
    stepper = system_of("furuta_pendulum").stepper()
    with pytest.raises(TypeError, match=r"t is .*, not a real number"):
        stepper.advance(given)
    (name, *_) = stepper.model.inputs
    with pytest.raises(TypeError, match=rf"input '{name}' is .*, not a real number"):
        stepper.advance(0.1, {name: given})
    stepper.advance(np.float64(0.1), {name: np.float32(0.5)})
    assert stepper.t == 0.1
