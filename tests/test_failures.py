"""Every way a run can end has a name, and says where: no NaN in rows, no wrong answer that looks right."""

import os
import signal
import threading
from functools import cache

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.emit import SourceFile, Sources
from sympy import Max, Piecewise, atan, cos, log, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError, System, t
from eigenmotion.runtime import EvaluationError, StopReason
from eigenmotion.solution import Solution
from eigenmotion.summary import summary

from .generation import loaded, system_for, system_of

X, Y = dynamicsymbols("x y")
FORMULATIONS = ("eigenfactor", "cholesky", "lagrange")
METHODS = ("rk34", "dop853", "Radau", "BDF")
pytestmark = pytest.mark.filterwarnings("ignore:.*:RuntimeWarning", "ignore:.*lsoda.*:UserWarning")


def plane(name: str, **given: object) -> Model:
    """Two masses, each on a line of its own."""
    energy = (X.diff() ** 2 + Y.diff() ** 2) / 2
    return Model(**{"name": name, "coordinates": [X, Y], "kinetic_energy": energy, **given})


ENDS = {  # what ends near t = 1, how, and what the message names
    StopReason.STEP_SIZE_UNDERFLOW: (plane("blow_up", forces={Y: 6 * Y**2}, initial={Y: 1.0, Y.diff(): 2.0}), "'y'"),
    StopReason.NON_FINITE_STATE: (plane("undefined", forces={Y: log(1 - t)}), "'y'"),
    StopReason.SINGULAR_MASS_MATRIX: (
        plane("massless", kinetic_energy=(X.diff() ** 2 + (1 - t) * Y.diff() ** 2) / 2),
        "'y'",
    ),
    StopReason.POSITION_NOT_REACHED: (
        plane("torn", holonomic_constraints=[atan(X) - Piecewise((0, t < 1), (3, True))]),
        "holonomic constraint row 0",
    ),
    StopReason.DEPENDENT_CONSTRAINTS: (
        plane("jumping", holonomic_constraints=[Y, X - Piecewise((0, t < 1), (3, True))]),
        r"Constraint row \d",
    ),
}


def named(reason: StopReason, formulation: str = "eigenfactor") -> System:
    return _named(ENDS[reason][0].name, formulation)


@cache
def _named(name: str, formulation: str) -> System:
    (model,) = (model for model, _ in ENDS.values() if model.name == name)
    return system_for(model, formulation)


def check_honest(found: Solution) -> None:
    """Rows are finite, and a failure says so everywhere."""
    assert len(found.t)
    for name in ("t", "y", "x", "v"):
        assert np.isfinite(found[name]).all(), name
    assert found.success == found.stop.success == (found.status >= 0)
    assert found.message.startswith("The end" if found.stop is StopReason.FINISHED else "At t = ")


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


@pytest.mark.parametrize("method", ["Radau", "BDF", "LSODA"])
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
    with pytest.raises(EvaluationError, match=r"'p_1' and 'p_\d'.*simulate.*cholesky") as caught:
        system.rhs(0.0, system.state())
    assert caught.value.stop is StopReason.COINCIDENT_EIGENVALUES
    assert system.simulate((0, 0.5)).success


@pytest.mark.parametrize("method", ["dop853", "Radau"])
def test_ctrl_c_keeps_what_was_computed(method):
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    found = system_of("double_pendulum").simulate((0, 1e7), t_eval=[0.0, 0.1], max_steps=10**12, method=method)
    assert (found.stop, found.success) == (StopReason.INTERRUPTED, False)
    check_honest(found)


def test_out_of_memory_keeps_what_was_computed():
    """The generated program with a realloc that gives up."""
    limited = '#include <stdlib.h>\nstatic int granted = 8;\nstatic void *scarce(void *p, size_t n);\n' \
        "static void *scarce(void *p, size_t n) { return granted-- > 0 ? realloc(p, n) : NULL; }\n" \
        "#define realloc scarce\n"  # fmt: skip
    made = compiler.generate(plane("scarce_memory", forces={X: -X}))
    texts = [f.text.replace('#include "em_linear.h"', limited + '#include "em_linear.h"') for f in made.files]
    files = tuple(SourceFile(f.name, text) for f, text in zip(made.files, texts, strict=True))
    found = loaded(Sources(made.name, files)).simulate((0, 1000), x0=[1, 0])
    assert (found.stop, found.success) == (StopReason.OUT_OF_MEMORY, False)
    check_honest(found)
    assert "t_eval" in found.message


def test_every_reason_is_tested_here():
    tested = {*ENDS, StopReason.TOO_MANY_STEPS, StopReason.FINISHED, StopReason.COINCIDENT_EIGENVALUES}
    elsewhere = {StopReason.TERMINAL_EVENT}  # test_outputs_events
    assert tested | elsewhere | {StopReason.INTERRUPTED, StopReason.OUT_OF_MEMORY} == set(StopReason)


# --- dependent rows ---------------------------------------------------------------------------------------------------

Q = dynamicsymbols("q:4")
M_TURNING = (
    (2 + sin(Q[1])) * Q[0].diff() ** 2 + Q[0].diff() * Q[1].diff() * cos(Q[2]) + 3 * Q[1].diff() ** 2
    + 2 * Q[2].diff() ** 2 + Q[3].diff() ** 2 + Q[2].diff() * Q[3].diff()
) / 2  # fmt: skip
ROWS = [Q[0] - Q[1] + Q[2] ** 2 / 2, Q[1] + 2 * Q[3]]
REDUNDANT = {
    "doubled": [ROWS[0], 2 * ROWS[0], ROWS[1]],
    "combined": [ROWS[0], ROWS[1], 3 * ROWS[0] - ROWS[1]],
    "in_micrometres": [ROWS[0], ROWS[1] / 10**6, ROWS[0] + ROWS[1]],
    "vanishing": [ROWS[0], sin(Q[0]) ** 2 + cos(Q[0]) ** 2 - 1, ROWS[1]],
    "on_the_constraints_only": [ROWS[0], ROWS[1], ROWS[0] * (2 + Q[0] + Q[3])],
}


@cache
def redundant(name: str, formulation: str = "eigenfactor") -> System:
    rows = REDUNDANT.get(name, ROWS)
    potential = 5 * Q[0] ** 2 + Q[1] * Q[2] + 3 * Q[3] ** 2
    model = Model(
        name=name, coordinates=Q, kinetic_energy=M_TURNING, potential_energy=potential, holonomic_constraints=rows,
        initial={Q[0]: 0.6, Q[1]: 0.6, Q[3]: -0.3, Q[0].diff(): 1.0, Q[1].diff(): 1.0, Q[3].diff(): -0.5},
    )  # fmt: skip
    return system_for(model, formulation)


@pytest.mark.parametrize("name", list(REDUNDANT))
def test_dependent_rows_are_refused_with_the_way_out(name):
    found = redundant(name).simulate((0, 1))
    check_honest(found)
    assert found.stop is StopReason.DEPENDENT_CONSTRAINTS
    assert found.t.size == 1
    assert "least_norm" in found.message
    row = 1 if name in ("doubled", "vanishing") else 2
    assert f"Constraint row {row} " in found.message
    assert "dependent constraints" in summary(redundant(name), found, 0.1)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", list(REDUNDANT))
def test_least_norm_gives_the_motion_of_the_independent_rows(name, formulation):
    at = np.linspace(0, 2, 9)
    options = {"t_eval": at, "rtol": 1e-10, "atol": 1e-10}
    right = redundant("independent", formulation).simulate((0, 2), **options)
    found = redundant(name, formulation).simulate((0, 2), dependent_constraints="least_norm", **options)
    assert found.success, found.message
    np.testing.assert_allclose(found.x, right.x, atol=1e-8)
    assert np.abs(found.position_residual).max() < 1e-12
    force = [redundant("independent").pfaffian(x)[0].T @ m for x, m in zip(right.x.T, right.multipliers.T, strict=True)]
    same = [redundant(name).pfaffian(x)[0].T @ m for x, m in zip(found.x.T, found.multipliers.T, strict=True)]
    np.testing.assert_allclose(same, force, atol=1e-6)


@pytest.mark.parametrize("name", ["doubled", "combined", "in_micrometres", "vanishing"])
def test_multipliers_of_least_norm_are_those_of_numpy(name):
    system, random = redundant(name), np.random.default_rng(4)
    for _ in range(10):
        x = random.normal(size=4)
        x, v = system.project_initial_state(x, random.normal(size=4), dependent_constraints="least_norm")
        a, found = system.acceleration(x, v, dependent_constraints="least_norm")
        A = system.pfaffian(x)[0]
        force = redundant("independent").pfaffian(x)[0].T @ redundant("independent").acceleration(x, v)[1]
        right = np.linalg.pinv(A.T, rcond=1e-9) @ force  # the least multipliers with that force
        np.testing.assert_allclose(found, right, rtol=1e-7, atol=1e-9 * max(1, np.abs(right).max()))
        np.testing.assert_allclose(a, redundant("independent").acceleration(x, v)[0], atol=1e-8)


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-12])
def test_rows_that_depend_on_the_constraints_only_at_any_tolerance(rtol):
    system = redundant("on_the_constraints_only")
    found = system.simulate((0, 2), rtol=rtol, atol=rtol, dependent_constraints="least_norm")
    right = redundant("independent").simulate((0, 2), rtol=1e-12, atol=1e-12)
    check_honest(found)
    assert found.success, found.message
    np.testing.assert_allclose(found.x[:, -1], right.x[:, -1], atol=max(100 * rtol, 1e-9))


def test_rows_that_contradict_each_other_are_named():
    rows = [X.diff() - 1, 2 * X.diff() - 2 - Max(0, t - 1)]
    system = system_for(plane("torn_apart", nonholonomic_constraints=rows, initial={X.diff(): 1.0}))
    found = system.simulate((0, 2), dependent_constraints="least_norm")
    check_honest(found)
    assert found.stop is StopReason.DEPENDENT_CONSTRAINTS
    assert found.t[-1] == pytest.approx(1.0, abs=1e-9)
    assert "row 1 (counted from 0) contradicts" in found.message


# --- singular positions -----------------------------------------------------------------------------------------------


def dead_centre() -> Model:
    """A slider-crank with rod and crank of one length: at a right angle the slider may go on or stay."""
    theta, phi, x = dynamicsymbols("theta phi x")
    start = 1.0
    return Model(
        name="dead_centre",
        coordinates=[theta, phi, x],
        kinetic_energy=theta.diff() ** 2 / 6 + phi.diff() ** 2 / 10 + x.diff() ** 2 / 2,
        holonomic_constraints=[x - cos(theta) / 2 - cos(phi) / 2, (sin(theta) - sin(phi)) / 2],
        initial={theta: start, phi: start, x: np.cos(start), theta.diff(): 1.0, phi.diff(): 1.0, x.diff(): -np.sin(start)},
    )  # fmt: skip


def flat() -> Model:
    """A four-bar linkage with equal opposite bars: flat, it may go on as a parallelogram or cross over."""
    q1, q2, q3 = dynamicsymbols("q1:4")
    a = 0.4
    return Model(
        name="flat",
        coordinates=[q1, q2, q3],
        kinetic_energy=q1.diff() ** 2 + q2.diff() ** 2 / 3 + q3.diff() ** 2 / 2 + sin(q1 - q2) * q1.diff() * q2.diff() / 5,
        holonomic_constraints=[
            a * cos(q1) + cos(q2) - a * cos(q3) - 1,
            a * sin(q1) + sin(q2) - a * sin(q3),
        ],
        initial={q1: 2.0, q3: 2.0, q1.diff(): -3.0, q3.diff(): -3.0},
    )


def cone() -> Model:
    """One row that vanishes at a point: x^2 = y^2, two lines that cross."""
    potential = (X + Y) / 8  # along the lines: the force across vanishes with the row
    return plane("cone", holonomic_constraints=[X**2 - Y**2], potential_energy=potential,
                 initial={X: -1.0, Y: -1.0, X.diff(): 1.0, Y.diff(): 1.0})  # fmt: skip


SINGULAR = {"dead_centre": dead_centre, "flat": flat, "cone": cone}


@cache
def singular(name: str, formulation: str) -> System:
    return system_for(SINGULAR[name](), formulation)


def branch(name: str, x: np.ndarray) -> np.ndarray:
    """What vanishes on the branch that a smooth motion stays on."""
    if name == "cone":
        return x[0] - x[1]
    return x[0] - x[1] if name == "dead_centre" else x[0] - x[2]


@pytest.mark.parametrize("stabilisation", ["project", "none"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", list(SINGULAR))
def test_a_singular_position_is_passed_rightly_or_named(name, formulation, stabilisation):
    system, ends = singular(name, formulation), set()
    for method in ("rk34", "dopri5", "dop853"):
        for rtol in (1e-4, 1e-6, 1e-9, 1e-12):
            options = {"rtol": rtol, "atol": rtol, "stabilisation": stabilisation, "max_steps": 20_000}
            found = system.simulate((0, 2), method=method, **options)
            check_honest(found)
            ends.add(found.stop)
            assert np.ptp(found.energy) < 1e5 * max(rtol, 1e-12), (method, rtol, found.message)
            if found.success:
                assert np.abs(branch(name, found.x)).max() < 1e3 * max(rtol, 1e-12), (method, rtol)
            else:
                assert "row" in found.message or found.stop is StopReason.TOO_MANY_STEPS
    allowed = {StopReason.FINISHED, StopReason.DEPENDENT_CONSTRAINTS, StopReason.POSITION_NOT_REACHED,
               StopReason.TOO_MANY_STEPS}  # fmt: skip
    assert ends <= allowed


@pytest.mark.parametrize("method", ["Radau", "BDF", "LSODA"])
@pytest.mark.parametrize("name", list(SINGULAR))
def test_a_singular_position_in_implicit_methods(name, method):
    for rtol in (1e-4, 1e-8):
        found = singular(name, "lagrange").simulate((0, 2), method=method, rtol=rtol, atol=rtol)
        check_honest(found)
        if found.success:
            assert np.abs(branch(name, found.x)).max() < 1e-3
        else:
            assert found.stop in (StopReason.DEPENDENT_CONSTRAINTS, StopReason.POSITION_NOT_REACHED)


@pytest.mark.parametrize(("name", "x0", "row"), [("cone", [0, 0], 0), ("flat", [0, 0, 0], 0), ("dead_centre", [np.pi / 2] * 2 + [0], 1)])  # fmt: skip
def test_a_start_in_a_singular_position_is_named(name, x0, row):
    for formulation in FORMULATIONS:
        found = singular(name, formulation).simulate((0, 1), x0=x0, v0=np.zeros(len(x0)))
        check_honest(found)
        assert found.stop is StopReason.DEPENDENT_CONSTRAINTS
        assert f"row {row} " in found.message


# --- rank of the mass matrix ------------------------------------------------------------------------------------------


@cache
def telescope(formulation: str) -> System:
    """A double pendulum whose outer link shrinks through zero at t = 1, where its angle has no inertia left."""
    a, b = dynamicsymbols("alpha beta")
    length = 1 - t
    velocity = [(sin(a) + length * sin(b)).diff(t), (cos(a) + length * cos(b)).diff(t)]
    energy = a.diff() ** 2 / 4 + sum(v**2 for v in velocity) / 2
    start = {a: 0.3, b: 0.8, b.diff(): 0.5}
    return system_for(Model(name="telescope", coordinates=[a, b], kinetic_energy=energy, initial=start), formulation)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("method", METHODS)
def test_a_link_that_shrinks_through_zero_is_named(method, formulation):
    found = telescope(formulation).simulate((0, 2), method=method, max_steps=20_000)
    check_honest(found)
    assert found.stop in (StopReason.SINGULAR_MASS_MATRIX, StopReason.STEP_SIZE_UNDERFLOW, StopReason.TOO_MANY_STEPS)
    assert found.t[-1] < 1 + 1e-9
    if found.stop is StopReason.SINGULAR_MASS_MATRIX:
        assert "'beta'" in found.message


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("method", METHODS)
def test_gimbal_lock_is_passed_rightly_or_named(method, formulation):
    """Turning about body axis 1 straight through theta = 0, where two Euler angles are one."""
    system = system_of("rigid_body", formulation)
    found = system.simulate((0, 2), x0=[0, 0.5, 0], v0=[0, -1, 0], method=method, rtol=1e-8, max_steps=20_000)
    check_honest(found)
    np.testing.assert_allclose(found.x, [0 * found.t, 0.5 - found.t, 0 * found.t], atol=1e-5)
    allowed = (StopReason.FINISHED, StopReason.SINGULAR_MASS_MATRIX, StopReason.STEP_SIZE_UNDERFLOW)
    assert found.stop in allowed


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_close_by_gimbal_lock_the_motion_is_right(formulation):
    """theta comes as near as 1e-4; Euler's equations do not know of it."""
    system = system_of("rigid_body", formulation)
    v0 = {"omega_1": -1.0, "omega_2": 2e-4, "omega_3": 0.1}
    found = system.simulate((0, 2), x0=[0, 0.5, 0.1], v0=v0, rtol=1e-10, atol=1e-10)
    check_honest(found)
    if found.success:
        plain = system_of("rigid_body", "cholesky").simulate((0, 2), x0=[0, 0.5, 0.1], v0=v0, rtol=1e-12, atol=1e-12)
        for name, rate in found.quasi_velocities.items():
            assert rate[-1] == pytest.approx(plain.quasi_velocities[name][-1], abs=1e-6)
    else:
        assert found.stop in (StopReason.SINGULAR_MASS_MATRIX, StopReason.STEP_SIZE_UNDERFLOW)


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


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"v0": {"q1": 1.0}}, r"v0 does not satisfy A v \+ b = 0 in constraint row \d by -?\d.*project_initial_state.*v0 = \["),
        ({"x0": {"q1": 1.0}}, r"x0 is off holonomic constraint row \d by -?0\.\d.*project_initial_state.*x0 = \["),
        ({"parameters": {"density": 0.0}}, "not positive definite at coordinate 'q1'"),
        ({"x0": {"q1": np.nan}}, "'q1' is not a finite number"),
    ],
)
def test_a_start_that_cannot_be_is_refused_before_the_run(options, words):
    with pytest.raises(ModelError, match=words):
        system_of("four_bar").simulate((0, 1), **options)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"kinetic_energy": X.diff() ** 2 + Y.diff() ** 3}, "second degree.*y"),
        ({"kinetic_energy": X.diff() ** 2 + sqrt(1 + Y.diff() ** 2)}, "second degree.*y"),
        ({"kinetic_energy": X.diff() ** 2}, "rate of 'y'.*singular"),
        ({"nonholonomic_constraints": [X.diff() * Y.diff()]}, r"nonholonomic_constraints\[0\] is not linear"),
        ({"potential_energy": symbols("k") * X}, "'k', which is not declared"),
    ],
)
def test_models_that_are_none_are_refused_by_name(given, words):
    with pytest.raises(ModelError, match=words):
        plane("wrong", **given)
