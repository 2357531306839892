"""Right-hand sides on lanes against the same with numbers: every model, formulation, mode; and functions on lanes."""

import ctypes as ct
import math
import re
import subprocess

import mpmath
import numpy as np
import pytest
import sympy
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import FORMULATIONS, Choices
from eigenmotion.codegen.kernel.printer import IN_VECTORS
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, build, simulate
from eigenmotion.building.shared_library import compile_and_link
from eigenmotion.building.toolchain import EXTENSION_SUFFIX, INCLUDE, toolchain

from ..support.generation import NAMES, STRICT, choices_for, model_of, states, system_in, system_of

angle = dynamicsymbols("angle")

SHIM = """
#include "{name}.c"
int scalar_rhs(int mode, double t, const double *y, const double *c, const double *u, int flags, double *dy);
int scalar_rhs(int mode, double t, const double *y, const double *c, const double *u, int flags, double *dy) {{
    em_fault fault;
    return model_rhs(mode, t, y, c, u, NULL, flags, dy, &fault);
}}
int prepared(const double *parameters, double *c);
int prepared(const double *parameters, double *c) {{
    em_fault fault;
    return prepare(parameters, c, &fault) ? -1 : N_PREPARED;
}}
"""
FLAGS = (*STRICT, "-march=native", "-ffp-contract=fast", "-fno-math-errno", "-fPIC", f"-I{INCLUDE}")


class Lanes(ct.Structure):
    _fields_ = [("width", ct.c_int), ("rhs", ct.c_void_p)]


class Both:
    """The two compilations of one model."""

    def __init__(self, folder, model, choices, *flags):
        sources = compiler.generate(model, choices)
        for file in sources.files:
            (folder / file.name).write_text(file.text)
        (folder / "shim.c").write_text(SHIM.format(name=model.name))
        cc = (*toolchain().command, *FLAGS, *flags)
        for source, *more in (("shim.c", "-O0"), (f"{model.name}.c", "-O1", "-DEM_ON_LANES")):
            subprocess.run([*cc, *more, "-c", source], cwd=folder, check=True)
        subprocess.run([*cc, "-shared", "shim.o", f"{model.name}.o", "-lm", "-o", "both.so"], cwd=folder, check=True)
        library = ct.CDLL(str(folder / "both.so"))
        self.system = system_in(library, model.name)
        lanes = Lanes.in_dll(library, f"{model.name}_lanes")
        self.width, real = lanes.width, ct.c_double
        self.on_lanes = ct.CFUNCTYPE(None, ct.c_int, *[ct.c_void_p] * 4, ct.c_int, ct.c_void_p)(lanes.rhs)
        self.scalar = library.scalar_rhs
        self.scalar.argtypes = [ct.c_int, real, *[ct.c_void_p] * 3, ct.c_int, ct.c_void_p]
        self.prepared = library.prepared
        self.prepared.argtypes = [ct.c_void_p] * 2

    def prepare(self, parameters):
        given, c = np.array([*parameters.values()], float), np.empty(4096)
        return c[: self.prepared(given.ctypes.data, c.ctypes.data)]

    def compare(self, mode, t, y, c, u):
        """Return dy (count, n_state) by lanes and by numbers, and whether the latter failed."""
        count, n_state = y.shape
        dy, expected, failed = np.full(y.shape, np.nan), np.full(y.shape, np.nan), np.zeros(count, bool)
        for first in range(0, count, self.width):
            some = slice(first, first + self.width)
            given = [aligned(part[some].T) for part in (t[:, None], y, c, u)]
            out = aligned(np.empty((n_state, self.width)))
            self.on_lanes(mode, *(part.ctypes.data for part in given), 0, out.ctypes.data)
            dy[some] = out.T
        for k in range(count):
            one = [np.ascontiguousarray(part[k]) for part in (y, c, u)]
            out = np.empty(n_state)
            failed[k] = self.scalar(mode, t[k], *(part.ctypes.data for part in one), 0, out.ctypes.data)
            expected[k] = out
        return dy, expected, failed


def aligned(values):
    """Return a copy on a cache line of its own."""
    room = np.empty(values.size + 8)
    start = -room.ctypes.data % 64 // 8
    copy = room[start : start + values.size].reshape(values.shape)
    copy[...] = values
    return copy


def at_random(both, count):
    """Give t, y, c, u of different states, parameters and inputs."""
    system, random = both.system, np.random.default_rng(3)
    some = list(states(system, count))
    t = np.array([t for _, _, t in some])
    parameters = [{name: value * random.uniform(0.9, 1.1) for name, value in system.parameters.items()} for _ in some]
    y = np.array([system.state(x, v, t, parameters=p) for (x, v, t), p in zip(some, parameters, strict=True)])
    c = np.array([both.prepare(p) for p in parameters])
    return t, y, c, random.normal(size=(count, max(1, len(system.inputs))))


def apart(system, y):
    """Whether the eigenvalues carried are: where two meet Omega is rounding over rounding (32)."""
    s = np.sort(y[:, system.layout["s"]] if "s" in system.layout else y[:, :1], axis=1)
    return (np.diff(s, axis=1) > 1e-6 * s[:, 1:]).all(axis=1)


BY_DAY = {"chain", "four_bar", "quaternion_top", "rotating_hoop", "sphere"}
"""Blocks and rows, holonomic and not, a singular M, time; of the others the eigenfactor form (mode 1: cholesky)."""


@pytest.mark.parametrize(
    ("name", "formulation"),
    [pytest.param(name, form, marks=() if name in BY_DAY and form != "cholesky"
                  else pytest.mark.nightly) for name in NAMES for form in FORMULATIONS],
)  # fmt: skip
def test_lanes_are_the_scalar_right_hand_side(name, formulation, tmp_path):
    if "friction is proportional to norms of multipliers" in compiler.explain(model_of(name)):
        pytest.skip("multipliers that friction depends on are solved for one state at a time")
    both = Both(tmp_path, model_of(name), choices_for(name, formulation))
    t, y, c, u = at_random(both, 16)
    for mode in (0, 1) if formulation == "eigenfactor" else (0,):
        dy, expected, failed = both.compare(mode, t, y, c, u)
        assert not failed.all()
        good = ~failed & np.isfinite(expected).all(axis=1)
        if formulation == "eigenfactor" and mode == 0:
            good &= apart(both.system, y)
        size = np.abs(expected[good]).max(axis=1, keepdims=True)
        assert not np.isfinite(dy[failed]).all(axis=1).any()
        assert (np.abs(dy[good] - expected[good]) <= 1e-12 * size).all()


# --- functions --------------------------------------------------------------------------------------------------------

FUNCTIONS = """
#define EM_ON_LANES
#include "numeric/em_functions.h"
enum { COUNT = %d };
void pair(const double *a, double *s, double *c);
void pair(const double *a, double *s, double *c) {
    for (int i = 0; i < COUNT; i += EM_LANES) {
        const real value = *(const real *)(a + i);
        *(real *)(s + i) = %s(value);
        *(real *)(c + i) = %s(value);
    }
}
"""


def angles():
    random = np.random.default_rng(5)
    near = [math.nextafter(k * math.pi / 2, way) for k in range(-200, 200) for way in (-math.inf, math.inf)]
    far = [math.nextafter(k * math.pi / 2, 0.0) for k in random.integers(1, 600000, 400)]
    spread = [*random.uniform(-8, 8, 2000), *random.uniform(-9.9e5, 9.9e5, 2000)]
    small = [0.0, -0.0, *(10.0 ** random.uniform(-300, 0, 200)), *[1.0] * 6]
    return aligned(np.array([*near, *far, *spread, *small]))


WIDTHS = pytest.mark.parametrize("flags", [["-march=native", "-ffp-contract=fast"], ["-mavx", "-ffp-contract=off"], []])


def on_lanes(place, given, names, flags):
    """Two functions, by their names in C, of all that is given."""
    given = given[: len(given) // 8 * 8]
    (place / "pair.c").write_text(FUNCTIONS % (len(given), *names))
    command = [*toolchain().command, *STRICT, "-O2", *flags, "-fPIC", "-shared", f"-I{INCLUDE}", "pair.c", "-lm"]
    done = subprocess.run([*command, "-o", "pair.so"], cwd=place, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    values = [aligned(np.zeros(len(given))) for _ in names]
    ct.CDLL(str(place / "pair.so")).pair(*(ct.c_void_p(part.ctypes.data) for part in (given, *values)))
    return zip(given, *values, strict=True)


@WIDTHS
def test_sines_within_two_units_in_the_last_place(tmp_path, flags):
    """Whatever the width, with fused multiply-add and without."""
    with mpmath.workdps(60):
        for angle, *values in on_lanes(tmp_path, angles(), ("em_sin", "em_cos"), flags):
            for value, true in zip(values, (mpmath.sin(angle), mpmath.cos(angle)), strict=True):
                assert abs(mpmath.mpf(value) - true) <= 2 * math.ulp(float(true)) + 1e-26, angle


def exponents():
    random = np.random.default_rng(6)
    near = [math.nextafter(k * math.log(2) / 2, way) for k in range(-200, 200) for way in (-math.inf, math.inf)]
    steps = [math.nextafter(2.0**k * root, way) for k in (-1, 0, 1) for root in (1, 2**0.5) for way in (0, 9)]
    spread = [*random.uniform(-745, 709.7, 400), *(10.0 ** random.uniform(-320, 308, 400)), 5e-324, 1.7e308, *[1.0] * 8]
    return aligned(np.array([*near, *steps, *spread]))


@WIDTHS
def test_exp_and_log_within_two_units_in_the_last_place(tmp_path, flags):
    with mpmath.workdps(60):
        for given, *values in on_lanes(tmp_path, exponents(), ("exp", "log"), flags):
            assert (given < 0) == math.isnan(values[1])
            for value, function in zip(values, (mpmath.exp, mpmath.log), strict=True):
                true = function(mpmath.mpf(float(given))) if function is mpmath.exp or given > 0 else 0
                if abs(true) < 1.7e308 and not math.isnan(value):
                    assert abs(mpmath.mpf(float(value)) - true) <= 2 * math.ulp(float(true)), given


def test_exp_and_log_where_they_end(tmp_path):
    given = aligned(np.array([0.0, -0.0, math.inf, -math.inf, math.nan, 1e4, -1e4, -1.0]))
    found = np.array([values for _, *values in on_lanes(tmp_path, given, ("exp", "log"), [])])
    with np.errstate(all="ignore"):
        np.testing.assert_allclose(found, np.transpose([np.exp(given), np.log(given)]), rtol=1e-15)


# --- runs -------------------------------------------------------------------------------------------------------------


def test_what_users_build_has_lanes(tmp_path):
    """The strong symbol with its numbers, not the weak one without: a run would be right with either."""
    for file in compiler.generate(model_of("pendulum"), Choices()).files:
        (tmp_path / file.name).write_text(file.text)
    compile_and_link(tmp_path, "pendulum", toolchain(flags="-O0"))
    command = ["nm", f"pendulum{EXTENSION_SUFFIX}"]
    said = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert [line.split()[1] for line in said.stdout.splitlines() if line.endswith(" pendulum_lanes")] == ["d"]


BY_NIGHT = [pytest.param(formulation, "", marks=pytest.mark.nightly) for formulation in FORMULATIONS[1:]]


@pytest.mark.parametrize(("formulation", "flags"), [("eigenfactor", ""), ("inverse", None), *BY_NIGHT])
def test_a_run_is_the_same_on_lanes_and_without(formulation, flags):
    """To rounding: what users build has lanes, what is compiled in a hurry has none. By day one at users' flags."""
    lanes = build(model_of("dual_link"), formulation=formulation, flags=flags)
    numbers = system_of("dual_link", formulation)
    runs = [simulate(system, (0.0, 10.0), method="ra15", rtol=1e-9, atol=1e-9) for system in (lanes, numbers)]
    assert all(run.success for run in runs)
    np.testing.assert_allclose(runs[0].x[:, -1], runs[1].x[:, -1], atol=1e-9)
    assert abs(runs[0].nfev - runs[1].nfev) <= 0.05 * runs[1].nfev


def test_auto_takes_steps_by_nodes_where_they_pay():
    """At tight tolerances and on lanes; the solution says which method ran."""
    lanes, numbers = build(model_of("dual_link")), system_of("dual_link", "eigenfactor")
    wide = lanes.compiled.lanes >= 4
    assert lanes.compiled.lanes == toolchain().lanes
    assert numbers.compiled.lanes == 0
    for system, rtol, expected in ((lanes, 1e-10, "ra15"), (lanes, 1e-3, "dop853"), (numbers, 1e-10, "dop853")):
        found = simulate(system, (0.0, 1.0), method="Auto", rtol=rtol)
        assert found.method == (expected if wide else "dop853")
        same = simulate(system, (0.0, 1.0), method=found.method, rtol=rtol)
        np.testing.assert_array_equal(found.y, same.y)
    assert simulate(lanes, (0.0, 1.0), method="radau5").method == "radau5"


# --- what is said of them ---------------------------------------------------------------------------------------------


def test_what_goes_lane_by_lane_is_what_the_header_says():
    header = (INCLUDE / "numeric/em_lane_functions.h").read_text()
    by_lane = set(re.findall(r"^EM_BY_(?:TWO_)?LANES?\((\w+)\)", header, re.MULTILINE))
    assert {"tan", "cosh", "atan2"} < by_lane
    assert not by_lane & IN_VECTORS


def test_explain_names_what_goes_lane_by_lane():
    x = angle
    curve = Model(name="curve", coordinates=[x], kinetic_energy=(1 + sympy.exp(2 * x)) * x.diff() ** 2 / 2,
                  potential_energy=sympy.sin(x) + sympy.tanh(x))  # fmt: skip
    assert "lane by lane: tanh" in compiler.explain(curve, Choices("lagrange")).replace("cosh, ", "")
    assert "nothing goes lane by lane" in compiler.explain(model_of("dual_link"))
    assert "none: " in compiler.explain(model_of("dual_link"), Choices(close_eigenvalues="extrapolate"))
