"""Eigenfactors of Delta as states, (47)-(55): their Omega (53), and what becomes of it where eigenvalues meet."""

import ctypes as ct
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.program.program import Program
from eigenmotion.codegen.render.emit import SourceFile, Sources
from scipy.linalg import expm
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Solution, System, t
from eigenmotion.runtime import StopReason

from ..support.generation import compile_into, loaded, model_of, states, system_of
from ..support.models_table import BY_NAME

EXTRAPOLATE = {"close_eigenvalues": "extrapolate", "schur": "eigenfactor"}
SOME_ROWS = ("rolling_disk",)
BEGIN = 8  # EM_BEGIN


def veering_rows() -> Model:
    """Two rows whose Delta = [[a^2, 2 gap], [2 gap, b^2]] + const, a = 1 + w/4, b = 1 - w/4: they veer at w = 0."""
    p, q, u, v, w = coordinates = dynamicsymbols("p q u v w")
    gap = symbols("gap", real=True)
    return Model(
        name="veering_rows",
        coordinates=coordinates,
        kinetic_energy=sum(x.diff() ** 2 for x in coordinates) / 2,
        potential_energy=(p**2 + 2 * q**2 + u**2 + 2 * v**2 + 4 * w**2) / 2 + u * w / 5 + v * q / 7 + w * p / 3,
        nonholonomic_constraints=[
            (1 + w / 4) * p.diff() + gap * q.diff() - u.diff() / 2,
            gap * p.diff() + (1 - w / 4) * q.diff() - v.diff() / 2,
        ],
        parameters={gap: 1e-3},
        initial={p: 0.2, q: 0.3, u: 0.7, v: -0.4, w: 1.0},
    )


def held_arm() -> Model:
    """Every kind of block: a turning one, single ones that vary, a constant one; time and units in it; two rows."""
    a, b, r, s, z = coordinates = dynamicsymbols("a b r s z")
    rate = [x.diff() for x in coordinates]
    coupled = (2 + cos(b)) * rate[0] ** 2 + (1 + cos(b)) * rate[0] * rate[1] + rate[1] ** 2
    alone = (1 + r**2 / 4) * rate[2] ** 2 + (2 + sin(t + s) / 3) * rate[3] ** 2 + 3 * rate[4] ** 2 / 2
    return Model(
        name="held_arm",
        coordinates=coordinates,
        kinetic_energy=(coupled + alone) / 2,
        potential_energy=cos(a) + cos(a + b) + r**2 + s * z / 3,
        nonholonomic_constraints=[
            sin(a) * rate[0] + rate[1] + r * rate[2] - rate[4],
            rate[0] / 2 + cos(s + t) * rate[3] + rate[4] - rate[2] * s / 5,
        ],
        scales={a: 2.0, z: 0.5},
        initial={a: 0.4, b: 0.9, r: 0.8, s: 0.3},
    )


MODELS = {"veering_rows": veering_rows, "held_arm": held_arm}


def model(name: str) -> Model:
    return MODELS[name]() if name in MODELS else model_of(name)


@cache
def system(name: str, formulation: str = "eigenfactor", **options: str) -> System:
    if name not in MODELS:
        return system_of(name, formulation, **options)
    return loaded(compiler.generate(model(name), Choices(formulation, **options)), "-O0")


# --- at an accepted step ----------------------------------------------------------------------------------------------

SETTLE = """
int settle(int flags, double t, double *y, double *memory);
int settle(int flags, double t, double *y, double *memory) {
    double c[N_PREPARED + 1];
    em_fault fault;
    int mode = 0;
    if (prepare(parameter_defaults, c, &fault)) return -1;
    return model_settle(&mode, flags, t, y, c, memory, 0.0, &fault);
}
"""


@dataclass(frozen=True)
class Settling:
    """`model_settle` of a program, and the program."""

    library: ct.CDLL
    program: Program

    def __call__(self, flags: int, time: float, y: np.ndarray, memory: np.ndarray) -> int:
        return called(self.library.settle, flags, time, y, memory)


def called(function: Callable[..., int], *arguments: np.ndarray | float | None) -> int:
    """Call a C function on arrays and numbers."""
    given = [a.ctypes.data_as(ct.c_void_p) if isinstance(a, np.ndarray) else a for a in arguments]
    return function(*(ct.c_double(a) if isinstance(a, float) else a for a in given))


def settling(name: str, folder: Path) -> Settling:
    sources = compiler.generate(model(name), Choices(**EXTRAPOLATE))
    files = [replace(f, text=f.text + SETTLE) if f.name.endswith(".c") else f for f in sources.files]
    compile_into(folder, Sources(sources.name, tuple(files)), ())
    program = compiler.program(model(name), Choices(**EXTRAPOLATE))
    return Settling(ct.CDLL(str(folder / f"{sources.name}.so")), program)


def delta_factors(system: System, y: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """C (size, size) and s (size) of the only group of rows, of a state or a rate."""
    return y[system.layout["C_delta"]].reshape(size, size), y[system.layout["s_delta"]]


@pytest.mark.parametrize("name", [*SOME_ROWS, *(pytest.param(one, marks=pytest.mark.nightly) for one in MODELS)])
def test_what_a_step_remembers_is_the_published_omega(name, tmp_path):
    """(53) by way of d/dt A M^-1 A^T, without Bdot, against -C_Ddot C_D^T of the right-hand side."""
    settle, reference = settling(name, tmp_path), system(name, **EXTRAPOLATE)
    (group,) = settle.program.row_groups
    for x, v, time in states(reference, 5):
        y, memory = reference.state(x, v, time), np.zeros(settle.program.n_memory)
        C, _ = delta_factors(reference, y, group.size)
        C_dot, _ = delta_factors(reference, reference.rhs(time, y), group.size)
        assert settle(BEGIN, time, y, memory) == 0
        kept = memory[group.kept :][: 2 * group.size**2].reshape(2, group.size, group.size)
        np.testing.assert_allclose(kept[0], -C_dot @ C.T, rtol=1e-10, atol=1e-10)
        np.testing.assert_array_equal(kept[1], 0.0)


def test_a_sweep_follows_a_step_that_extrapolated(tmp_path):
    """And no other, without stabilisation."""
    settle, reference = settling("veering_rows", tmp_path), system("veering_rows", **EXTRAPOLATE)
    right = reference.state()
    turned = right.copy()
    turn = expm(1e-3 * np.array([[0.0, 1.0], [-1.0, 0.0]]))
    turned[reference.layout["C_delta"]] = (turn @ delta_factors(reference, right, 2)[0]).ravel()
    for noted in (0.0, 1.0):
        y, memory = turned.copy(), np.zeros(settle.program.n_memory)
        memory[settle.program.extrapolated] = noted
        assert settle(0, 0.1, y, memory) == noted
        np.testing.assert_allclose(y, right if noted else turned, rtol=1e-14, atol=1e-14)
        assert memory[settle.program.extrapolated] == 0.0
        assert memory[settle.program.extrapolated + 1] == 0.1


CONTINUATION = """
#include "dynamics/em_close_eigenvalues.h"
int omega(const double *s, const double *mu, const double *kept, double since, double *Omega);
int omega(const double *s, const double *mu, const double *kept, double since, double *Omega) {
    return em_omega(3, s, mu, kept, since, Omega);
}
void remember(const double *s, const double *mu, double elapsed, double *kept);
void remember(const double *s, const double *mu, double elapsed, double *kept) {
    em_remember_omega(3, s, mu, elapsed, kept);
}
"""


def test_omega_goes_on_linearly_where_eigenvalues_are_close(tmp_path):
    """From the difference quotient of the last two steps; 0 where there were none; (32) wherever they are apart."""
    compile_into(tmp_path, Sources("omega", (SourceFile("omega.c", CONTINUATION),)), ())
    library = ct.CDLL(str(tmp_path / "omega.so"))
    apart, close = np.array([1.0, 2.0, 3.0]), np.array([1.0, 2.0, 2.0 + 1e-7])
    first, second = (np.array([[9.0, 3, 8], [3, 9, rate], [8, rate, 9]]) for rate in (5.0, 7.0))
    kept, omega = np.zeros((2, 3, 3)), np.empty((3, 3))
    assert called(library.omega, close, first, kept, 0.0, omega) == 1
    assert omega[2, 1] == 0.0
    called(library.remember, apart, first, 0.0, kept)
    np.testing.assert_allclose(kept[0], [[0, 1, 1], [-1, 0, 1], [-1, -1, 0]], rtol=1e-15)
    called(library.remember, apart, second, 0.5, kept)
    rate = (7 - 5) / 5 / 0.5
    np.testing.assert_allclose(kept[1], rate * np.array([[0, 0, 0], [0, 0, 1], [0, -1, 0]]), rtol=1e-14, atol=1e-15)
    assert called(library.omega, close, first, kept, 0.25, omega) == 1
    assert omega[2, 1] == pytest.approx(-7 / 5 - 0.25 * rate, rel=1e-14)
    assert omega[1, 0] == pytest.approx(-1.0, rel=1e-14)
    assert called(library.omega, close, first, None, 0.25, omega) == 0
    assert omega[2, 1] == pytest.approx(5 / ((2 - close[2]) * (2 + close[2])), rel=1e-14)


# --- a run ------------------------------------------------------------------------------------------------------------


def error(found: Solution, right: Solution) -> float:
    assert right.sol is not None
    return float(np.abs(found.x - right.sol(found.t)[: len(found.x)]).max())


@cache
def exactly(name: str, t_end: float, gap: float | None = None) -> Solution:
    """By a formulation in which nothing can be close, much tighter."""
    parameters = None if gap is None else {"gap": gap}
    return system(name, "lagrange").simulate(
        (0, t_end), parameters=parameters, rtol=1e-13, atol=1e-13, dense_output=True
    )


@pytest.mark.parametrize("stabilisation", ["project", "none"])
@pytest.mark.parametrize(
    "name",
    [*SOME_ROWS, *(pytest.param(name, marks=pytest.mark.nightly) for name in ("four_bar", "slider_crank")), "held_arm"],
)
def test_where_eigenvalues_stay_apart_it_is_as_good_as_a_factor_of_delta(name, stabilisation):
    t_end = BY_NAME[name].t_end if name in BY_NAME else 4.0
    right, errors = exactly(name, t_end), {}
    for schur in ("factor", "eigenfactor"):
        carrying = system(name, close_eigenvalues="extrapolate", schur=schur)
        assert (carrying.close_eigenvalues, carrying.schur) == ("extrapolate", schur)
        assert ("C_delta" in carrying.layout) is (schur == "eigenfactor")
        found = carrying.simulate((0, t_end), rtol=1e-9, atol=1e-9, stabilisation=stabilisation)
        assert found.success, found.message
        assert found.n_bounded == 0
        errors[schur] = error(found, right)
    assert errors["eigenfactor"] < 10 * max(errors["factor"], 1e-9)  # an error below the tolerance is luck


GAPS = (0.0, 1e-12, 1e-9, 1e-8, 1e-7, 2e-7, 1e-6, 1e-4, 1e-2)


@pytest.mark.parametrize("gap", GAPS)
@pytest.mark.parametrize("rtol", [1e-6, 1e-10])
@pytest.mark.parametrize("stabilisation", ["project", "none"])
def test_where_they_meet_the_outcome_is_right_or_named(gap, rtol, stabilisation):
    """Omega of a near miss jumps where extrapolation begins: a step may get no further, and says so.

    With projection what a wrong Delta does to the multipliers is taken out again: it points across the constraints.
    Without, it adds up, as all drift does. In tolerances, as the factor's own error may be less by luck.
    """
    right, options = exactly("veering_rows", 10.0, gap), {"rtol": rtol, "atol": rtol, "parameters": {"gap": gap}}
    runs = [
        system("veering_rows", **choice).simulate((0, 10), stabilisation=stabilisation, **options)
        for choice in ({"schur": "factor"}, EXTRAPOLATE)
    ]
    crossings = np.count_nonzero(np.diff(np.sign(runs[0].x[4])))
    assert crossings == 6
    assert runs[0].success
    assert runs[1].success or runs[1].stop is StopReason.STEP_SIZE_UNDERFLOW, runs[1].message
    allowed = 3 if stabilisation == "project" else 100
    assert error(runs[1], right) < allowed * max(error(runs[0], right), rtol)
    assert runs[1].success or rtol < 1e-6


def test_where_rows_alone_carry_eigenfactors_the_triangular_root_takes_over():
    """No block of M turns: all that changes is which factor of Delta counts."""
    alone = system("veering_rows", schur="eigenfactor")
    assert "C" not in alone.layout
    found = alone.simulate((0, 10), parameters={"gap": 0.0}, rtol=1e-9, atol=1e-9, dense_output=True)
    assert found.success, found.message
    assert found.n_bounded > 0
    assert error(found, exactly("veering_rows", 10.0, 0.0)) < 1e-7
