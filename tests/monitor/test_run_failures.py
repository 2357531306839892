"""Every way a run can end has a name, and says where: no NaN in rows, no wrong answer that looks right."""

import os
import signal
import threading
from functools import cache

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.render.emit import SourceFile, Sources
from sympy import Piecewise, atan, cos, log, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError, System, t
from eigenmotion.runtime import EvaluationError, StopReason
from eigenmotion.stability import CASES as EXTREME

from ..support.failing_runs import FORMULATIONS, X, Y, check_honest, plane
from ..support.generation import loaded, system_for, system_of
from .test_singular_positions import telescope

Z = dynamicsymbols("z")

pytestmark = pytest.mark.filterwarnings("ignore:.*:RuntimeWarning")

ENDS = {  # what ends near t = 1, how, and what the message names
    StopReason.STEP_SIZE_UNDERFLOW: (plane("blow_up", forces={Y: 6 * Y**2}, initial={Y: 1.0, Y.diff(): 2.0}), "'y'"),
    StopReason.NON_FINITE_STATE: (plane("undefined", forces={Y: log(1 - t)}), "'y'"),
    StopReason.SINGULAR_MASS_MATRIX: (
        plane("massless", kinetic_energy=(X.diff() ** 2 + (1 - t) * Y.diff() ** 2) / 2),
        "'y'",
    ),
    StopReason.POSITION_NOT_REACHED: (
        plane("torn", holonomic_constraints=[atan(X) - Piecewise((0, t**3 + t < 2), (3, True))]),
        "holonomic constraint row 0",
    ),
    StopReason.DEPENDENT_CONSTRAINTS: (
        plane("jumping", holonomic_constraints=[Y, X - Piecewise((0, t**3 + t < 2), (3, True))]),
        r"Constraint row \d",
    ),
}


def named(reason: StopReason, formulation: str = "eigenfactor") -> System:
    return _named(ENDS[reason][0].name, formulation)


@cache
def _named(name: str, formulation: str) -> System:
    (model,) = (model for model, _ in ENDS.values() if model.name == name)
    return system_for(model, formulation)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("reason", list(ENDS))
def test_each_reason_names_its_place(reason, formulation):
    found = named(reason, formulation).simulate((0, 2), max_steps=50_000)
    check_honest(found)
    assert found.stop is reason
    assert found.t[-1] == pytest.approx(1.0, abs=1e-6)
    assert ENDS[reason][1].replace(r"\d", "") in found.message
    for row in ("eta", "C", "s", "energy", "multipliers"):
        assert np.isfinite(found[row]).all(), row


@pytest.mark.parametrize("method", ["radau5", "radau9"])
@pytest.mark.parametrize("reason", list(ENDS))
def test_implicit_methods_end_by_name_too(reason, method):
    found = named(reason).simulate((0, 2), method=method)
    check_honest(found)
    assert found.stop in (reason, StopReason.NON_FINITE_STATE, StopReason.DEPENDENT_CONSTRAINTS)
    assert found.t[-1] < 1 + 1e-6


def test_too_many_steps_and_the_end():
    system = system_of("pendulum")
    found = system.simulate((0, 10), max_steps=5)
    assert (found.stop, found.success) == (StopReason.TOO_MANY_STEPS, False)
    assert "max_steps" in found.message
    assert system.simulate((0, 1)).stop is StopReason.FINISHED


def test_coincident_eigenvalues_name_their_coordinates():
    system = system_of("sphere")
    with pytest.raises(EvaluationError, match=r"coincide.*'p_\d' and 'p_\d'.*simulate.*cholesky") as caught:
        system.rhs(0.0, system.state())
    assert caught.value.stop is StopReason.COINCIDENT_EIGENVALUES
    assert system.simulate((0, 0.5)).success


@pytest.mark.parametrize("method", ["dop853", "radau5"])
def test_ctrl_c_keeps_what_was_computed(method):
    system = system_of("double_pendulum")
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    found = system.simulate((0, 1e7), t_eval=[0.0, 0.1], max_steps=10**12, method=method)
    assert (found.stop, found.success) == (StopReason.INTERRUPTED, False)
    check_honest(found)


SCARCE = """#include <stdlib.h>
static int granted = 8;
static void *scarce(void *p, size_t n) { return granted-- > 0 ? realloc(p, n) : NULL; }
#define realloc scarce
"""


def test_out_of_memory_keeps_what_was_computed():
    """The generated program with a realloc that gives up."""
    made = compiler.generate(plane("scarce_memory", forces={X: -X}))
    texts = [
        f.text.replace('#include "numeric/em_functions.h"', SCARCE + '#include "numeric/em_functions.h"')
        for f in made.files
    ]
    files = tuple(SourceFile(f.name, text) for f, text in zip(made.files, texts, strict=True))
    found = loaded(Sources(made.name, files)).simulate((0, 1000), x0=[1, 0])
    assert (found.stop, found.success) == (StopReason.OUT_OF_MEMORY, False)
    check_honest(found)
    assert "t_eval" in found.message


def test_eigenfactors_that_drifted_are_named():
    found = telescope("eigenfactor").simulate((0, 2), stabilisation="none")
    check_honest(found)
    assert found.stop is StopReason.FACTORS_DRIFTED
    assert "'alpha'" in found.message or "'beta'" in found.message


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_constraints_that_drifted_are_named(formulation):
    """z of next to no inertia: its weight less the reaction leaves rounding, over m_z, whatever the tolerance."""

    def ended(m_z: float, rtol: float, **options: str):
        point = EXTREME["massless"].trial(m_z)
        system = system_for(EXTREME["massless"].model(m_z), formulation)
        return system.simulate((0, 2), x0=point.x0, v0=point.v0, parameters=point.parameters, rtol=rtol, atol=rtol,
                               **options)  # fmt: skip

    for method, rtol in (("dopri5", 1e-8), ("dop853", 1e-7), ("rk34", 1e-7)):
        found = ended(1e-14, rtol, method=method, stabilisation="none")
        check_honest(found)
        assert found.stop is StopReason.CONSTRAINTS_DRIFTED, method
        assert "row 0" in found.message
        assert ended(1e-6, rtol, method=method, stabilisation="none").success


def test_an_energy_without_a_value_is_named():
    found = system_for(plane("logarithm", potential_energy=log(X))).simulate((0, 1), x0=[-1, 0])
    check_honest(found)
    assert found.stop is StopReason.ENERGY_DRIFTED
    assert "log of a negative number" in found.message


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_axes_are_not_extrapolated_from_where_nothing_tells_how_they_turn(rtol):
    """Eigenvalues that coincide at the start and part: bounded runs through, as all other formulations do."""
    turning = X.diff() * Y.diff() * sin(X)
    energy = (X.diff() ** 2 + Y.diff() ** 2) * (2 + Y) / 2 + turning
    model = plane("isotropic", kinetic_energy=energy, potential_energy=(X**2 + Y**2) / 2)
    start = {"v0": [1, 0.5], "rtol": rtol, "atol": rtol}
    with pytest.raises(ModelError, match=r"isotropic: eigenvalues .* coincide at x0, among 'x', 'y'.*bounded"):
        system_for(model, close_eigenvalues="extrapolate").simulate((0, 3), **start)
    for formulation in FORMULATIONS:
        assert system_for(model, formulation).simulate((0, 3), **start).success


def test_equal_eigenvalues_that_stay_equal_may_be_extrapolated():
    """M = 1 + u u^T with u (x): two eigenvalues are 1 for ever, and their axes turn about u only as it does."""
    along = cos(Z) * X.diff() + sin(Z) * Y.diff() + Z.diff()
    energy = (X.diff() ** 2 + Y.diff() ** 2 + Z.diff() ** 2 + along**2) / 2
    model = Model(name="needle", coordinates=[X, Y, Z], kinetic_energy=energy, potential_energy=X**2, initial={})
    ends = [system_for(model, close_eigenvalues=how).simulate((0, 3), v0=[1, 0.5, 1], rtol=1e-9, atol=1e-9)
            for how in ("extrapolate", "bounded")]  # fmt: skip
    assert all(end.success for end in ends), ends
    assert np.allclose(ends[0].x[:, -1], ends[1].x[:, -1], rtol=0, atol=1e-7)


def test_every_reason_is_tested_here():
    own = {*ENDS, StopReason.TOO_MANY_STEPS, StopReason.FINISHED, StopReason.COINCIDENT_EIGENVALUES,
           StopReason.INTERRUPTED, StopReason.OUT_OF_MEMORY, StopReason.FACTORS_DRIFTED,
           StopReason.ENERGY_DRIFTED, StopReason.CONSTRAINTS_DRIFTED}  # fmt: skip
    elsewhere = {
        StopReason.TERMINAL_EVENT,
        StopReason.EVENT_UNDEFINED,
        StopReason.START_REFUSED,
        StopReason.EVENTS_PILE_UP,
        StopReason.IMPACT_UNDEFINED,
        StopReason.RESET_OFF,
        StopReason.RESET_INSIDE,
        StopReason.MODEL_JUMPS,
        StopReason.VALUE_REFUSED,
        StopReason.OUTSIDE_TABLE,
        StopReason.CONTACTS_CLASH,
    }  # in tests of events, batch, contact, friction and model
    assert own | elsewhere == set(StopReason)


# --- before the run ---------------------------------------------------------------------------------------------------


def weighed(name: str, energy: object) -> Model:
    m = symbols("m")
    return plane(name, kinetic_energy=energy(m), parameters={m: 1.0}, potential_energy=X * Y)


INERTIA = {  # the blocks that M falls into: constant, with C and s as states, one coordinate in closed form
    "constant": lambda m: X.diff() ** 2 + m * Y.diff() ** 2 + X.diff() * Y.diff() / 10,
    "turning": lambda m: X.diff() ** 2 + m * Y.diff() ** 2 + X.diff() * Y.diff() * sin(X) * m / 2,
    "single": lambda m: X.diff() ** 2 + m * (1 + X**2) * Y.diff() ** 2,
}


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("kind", list(INERTIA))
def test_a_mass_matrix_that_is_not_positive_definite_is_refused(kind, formulation):
    system = system_for(weighed(kind, INERTIA[kind]), formulation)
    assert system.simulate((0, 0.1)).success
    for value in (0.0, -1.0):
        with pytest.raises(ModelError, match=r"not positive definite at coordinate 'y'"):
            system.simulate((0, 1), parameters={"m": value})
