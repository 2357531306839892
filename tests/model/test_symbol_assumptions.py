"""Assumptions on a symbol (positive, integer, ...) hold for every value it is given, wherever that is."""

import ctypes
import re
import subprocess

import numpy as np
import pytest
from eigenmotion.codegen.model.check.assumptions import ANY, allowed, declared, holds
from sympy import Symbol, sqrt
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.building.toolchain import INCLUDE, toolchain
from eigenmotion.cli import main

theta, push = dynamicsymbols("theta"), dynamicsymbols("push", nonnegative=True)
height = dynamicsymbols("height", positive=True)
l, k, teeth, free = (
    Symbol("l", positive=True),
    Symbol("k", nonnegative=True),
    Symbol("teeth", integer=True),
    Symbol("free"),
)
SOURCE = """\
from sympy import Symbol, sqrt
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model
theta, push, height = dynamicsymbols("theta"), dynamicsymbols("push", nonnegative=True), dynamicsymbols("height", positive=True)
l, k, teeth, free = Symbol("l", positive=True), Symbol("k", nonnegative=True), Symbol("teeth", integer=True), Symbol("free")
model = Model(name="declared", coordinates=[theta, height],
              kinetic_energy=l**2 * theta.diff() ** 2 / 2 + height.diff() ** 2 / 2,
              potential_energy=sqrt(l**2) * theta**2 + k * theta**4 + teeth * theta + free * height, forces={theta: push},
              parameters={l: 1.0, k: 0.0, teeth: 3.0, free: -1.0}, inputs={push: 0.0}, initial={theta: 1.0, height: 2.0})
"""  # noqa: E501


def model(**changed: object) -> em.Model:
    given = {
        "name": "declared",
        "coordinates": [theta, height],
        "kinetic_energy": l**2 * theta.diff() ** 2 / 2 + height.diff() ** 2 / 2,
        "potential_energy": sqrt(l**2) * theta**2 + k * theta**4 + teeth * theta + free * height,
        "forces": {theta: push},
        "parameters": {l: 1.0, k: 0.0, teeth: 3.0, free: -1.0},
        "inputs": {push: 0.0},
        "initial": {theta: 1.0, height: 2.0},
    }
    return em.Model(**given | changed)


@pytest.fixture(scope="module")
def system(hurried):
    return em.build(model(), formulation="lagrange")


@pytest.mark.parametrize(
    ("said", "good", "bad"),
    [
        ({"positive": True}, [1e-300, 2.0], [0.0, -0.0, -1.0]),
        ({"negative": True}, [-1.0], [0.0, 1.0]),
        ({"nonnegative": True}, [0.0, 1.0], [-1e-300]),
        ({"nonpositive": True}, [0.0, -1.0], [1e-300]),
        ({"nonzero": True}, [1.0, -1.0], [0.0]),
        ({"zero": True}, [0.0], [1.0]),
        ({"integer": True}, [0.0, -3.0, 1e300], [0.5]),
        ({"integer": True, "positive": True}, [3.0], [0.0, -3.0, 0.5]),
        ({"even": True}, [0.0, -2.0], [1.0, 0.5]),
        ({"odd": True}, [1.0, -3.0], [0.0, 2.0, 0.5]),
        ({"integer": False}, [0.5], [1.0, 2.0, 0.0]),
        ({"positive": False}, [-1.0, 0.0], []),
        ({"extended_positive": False}, [-1.0, 0.0], [1.0]),
        ({"real": True}, [0.0, -1.5], []),
        ({"finite": True}, [0.0, -1.5], []),
        ({}, [0.0, -1.5], []),
    ],
)
def test_bits_say_what_sympy_does(said, good, bad):
    bits = allowed(Symbol("x", **said))
    assert [holds(bits, value) for value in good + bad] == [True] * len(good) + [False] * len(bad)
    assert bool(declared(bits)) == (bits != ANY)


HOLDS = """\
#include "loop/em_assumptions.h"
int is_declared(int bits, double value) { return em_is_declared(bits, value) != 0; }
"""


def test_c_and_python_agree_on_what_holds(tmp_path):
    (tmp_path / "holds.c").write_text(HOLDS)
    command = (*toolchain().command, "-std=c11", "-shared", "-fPIC", f"-I{INCLUDE}", "holds.c", "-lm", "-o", "holds.so")
    subprocess.run(command, cwd=tmp_path, check=True)
    is_declared = ctypes.CDLL(str(tmp_path / "holds.so")).is_declared
    for bits in range(64):
        for value in (0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5, 1e300, -1e300, 5e-324):
            assert bool(is_declared(bits, ctypes.c_double(value))) == holds(bits, value)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        (
            {"parameters": {l: -1.0, k: 0.0, teeth: 3.0, free: 1.0}},
            r"parameters\[l\] is -1, but 'l' was declared positive",
        ),
        ({"parameters": {l: 1.0, k: -0.5, teeth: 3.0, free: 1.0}}, r"parameters\[k\].*nonnegative"),
        ({"parameters": {l: 1.0, k: 0.0, teeth: 2.5, free: 1.0}}, r"parameters\[teeth\] is 2.5.*integer"),
        ({"inputs": {push: -1.0}}, r"inputs\[push\].*nonnegative"),
        ({"initial": {height: -1.0}}, r"initial\[height\].*positive"),
        ({"initial": {}}, "'height' was declared positive, and without a value in initial it begins at 0"),
    ],
)
def test_defaults_are_refused_with_the_model(changed, words):
    with pytest.raises(em.ModelError, match=f"^Model 'declared': {words}"):
        model(**changed)


@pytest.mark.parametrize("said", [{"imaginary": True}, {"real": False}, {"infinite": True}, {"prime": True}])
def test_what_no_value_can_be_held_to_is_refused(said):
    p = Symbol("p", **said)
    with pytest.raises(em.ModelError, match="parameters contains 'p', declared"):
        em.Model(name="refused", coordinates=[theta], kinetic_energy=theta.diff() ** 2, parameters={p: 2.0})


GIVEN = [
    ({"l": -1.0}, "'l' was declared positive, and given -1"),
    ([1.0, -2.0, 3.0, 0.0], "'k' was declared nonnegative"),
    ({"teeth": 2.5}, "'teeth' was declared integer, and given 2.5"),
]


@pytest.mark.parametrize(("parameters", "words"), GIVEN)
def test_parameters_are_refused_wherever_they_are_given(system, parameters, words):
    x, v = [1.0, 2.0], [0.0, 0.0]
    doors = (
        lambda: system.prepare(parameters),
        lambda: system.simulate((0.0, 1.0), parameters=parameters),
        lambda: system.simulate((0.0, 1.0), parameters=parameters, sensitivities=["free"]),
        lambda: em.simulate_ensemble(system, (0.0, 1.0), parameters=parameters, x0={"theta": [0.1, 0.2]}),
        lambda: system.stepper(parameters=parameters),
        lambda: system.steppers(3, parameters=parameters),
        lambda: system.state(parameters=parameters),
        lambda: system.rhs(0.0, system.state(), parameters=parameters),
        lambda: system.mass_matrix(x, parameters=parameters),
        lambda: system.mass_matrix_gradient(x, parameters=parameters),
        lambda: system.acceleration(x, v, parameters=parameters),
        lambda: system.energy(x, v, parameters=parameters),
        lambda: system.project_initial_state(x, v, parameters=parameters),
        lambda: system.linearize(x, v, parameters=parameters),
        lambda: em.find_equilibrium(system, parameters=parameters),
        lambda: em.assemble(system, parameters=parameters),
    )
    for door in doors:
        with pytest.raises(ValueError, match=words) as caught:
            door()
        assert "declared" in str(caught.value).partition(":")[0]  # the model's name, here


def test_other_values_are_taken(system):
    sol = system.simulate(
        (0.0, 1.0), parameters={"l": 2.0, "k": 0.0, "teeth": -3.0, "free": -5.0}, inputs={"push": 1.0}
    )
    assert sol.success


def test_a_member_that_is_not_as_declared_fails_alone(system):
    runs = em.simulate_ensemble(system, (0.0, 1.0), parameters={"l": [1.0, -1.0, 2.0]})
    assert runs.success.tolist() == [True, False, True]
    assert runs.stop[1] is em.StopReason.START_REFUSED
    assert re.search("'l' was declared positive, and given -1", runs.message(1))
    assert np.isnan(runs.x[1]).all()
    with pytest.raises(ValueError, match="member 1 of 3: declared: 'l' was declared positive"):
        system.steppers(parameters={"l": [1.0, -1.0, 2.0]})
    steppers = system.steppers(3)
    with pytest.raises(ValueError, match=r"member 1 of 3.*'teeth' was declared integer"):
        steppers.reset(parameters={"teeth": [1.0, 1.5, 2.0]})


def test_starts_and_inputs_are_as_declared(system):
    starts = (
        lambda: system.simulate((0.0, 1.0), x0={"height": -1.0}),
        lambda: system.simulate((0.0, 1.0), x0=[1.0, 0.0]),
        lambda: system.stepper(x0={"height": -1.0}),
        lambda: system.steppers(2, x0={"height": -1.0}),
    )
    for start in starts:
        with pytest.raises(ValueError, match="'height' was declared positive"):
            start()
    assert em.simulate_ensemble(system, (0.0, 1.0), x0={"height": [1.0, -1.0]}).success.tolist() == [True, False]
    held = em.Signal([0.0, 1.0, 2.0], [1.0, -1.0, 1.0])
    for given in ({"push": -1.0}, {"push": held}, {"push": ([0.0, 1.0], [0.0, -2.0])}):
        with pytest.raises(ValueError, match="'push' was declared nonnegative"):
            system.simulate((0.0, 1.0), inputs=given)
    with pytest.raises(ValueError, match="'push' was declared nonnegative"):
        em.simulate_ensemble(system, (0.0, 1.0), inputs={"push": np.array([0.0, -1.0])})
    with pytest.raises(ValueError, match="'push' was declared nonnegative"):
        system.acceleration([1.0, 2.0], [0.0, 0.0], inputs={"push": -1.0})


@pytest.fixture
def file(scene):
    scene.write_text(SOURCE)
    return scene


@pytest.mark.parametrize(
    "command",
    [["run", "scene.py", "--set", "l=-1"], ["equilibrium", "scene.py", "--set", "l=-1"],
     ["linearize", "scene.py", "--at", "l=-1"],
     ["sweep", "scene.py", "--set", "l=-1", "--sweep", "theta=1,2", "-o", "runs.csv"]],
)  # fmt: skip
def test_the_command_line_refuses_by_name(file, capsys, command):
    assert main([*command, "--formulation", "lagrange"]) == 2
    assert "'l' was declared positive, and given -1" in capsys.readouterr().err


def test_a_swept_value_is_its_runs_failure(file, capsys):
    assert main(["sweep", "scene.py", "--formulation", "lagrange", "--sweep", "l=1,-1", "-o", "runs.csv"]) == 0
    assert "1 start refused  (run 1)" in capsys.readouterr().out
