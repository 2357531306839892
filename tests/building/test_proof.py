"""A build proves itself: planted faults are found before anything is kept, and what is right passes."""

import logging
import re
import shutil
import sys
from dataclasses import replace
from itertools import pairwise
from unittest.mock import patch

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.calculus.identity_test import Zeros
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.compiler import generate
from eigenmotion.codegen.graph import convert
from eigenmotion.codegen.graph.coefficients import exact
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.graph.store import Kind
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import t
from eigenmotion.building.build import compiled
from eigenmotion.building.toolchain import INCLUDE, Toolchain, toolchain
from eigenmotion.building.verification import ProofError, prove
from eigenmotion.building.verification.arithmetic.evaluate import Evaluation
from eigenmotion.building.verification.arithmetic.hyperdual import FUNCTIONS, RELATIONS, from_parts
from eigenmotion.stability.models.degenerate import quaternion_body

from ..equations.test_random_mechanisms import SHAPES, mechanism
from ..support.generation import FORMULATIONS, NAMES, loaded, model_of, system_for, system_of

q, r = dynamicsymbols("q r")
qd, rd = q.diff(), r.diff()
k = sympy.Symbol("k")


@pytest.fixture
def own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path))
    return tmp_path


def two(kinetic_energy, name="two", **more):
    return em.Model(name=name, coordinates=[q, r], kinetic_energy=kinetic_energy, parameters={k: 1.0},
                    initial={q: 0.7, r: 0.3}, **more)  # fmt: skip


# -- what is right passes


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", NAMES)
def test_the_models_are_proved(name, formulation):
    prove(model_of(name), system_of(name, formulation))


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_start_where_something_bends_is_proved(formulation):
    """What judged the first steps took the slope of M before the start for that behind it, and refused them."""
    M = sympy.Piecewise((1 + q - k, q > k), (1, True))
    model = em.Model(name="bends", coordinates=[q], kinetic_energy=M * qd**2 / 2, potential_energy=q**2,
                     parameters={k: 0.7}, initial={q: 0.7, qd: 1.0})  # fmt: skip
    prove(model, system_for(model, formulation))


@pytest.mark.parametrize("turn", [0.9, 1.25, 3.0])
def test_a_start_whose_rotation_changes_to_its_shadow_set_is_proved(turn):
    """The end of the first steps was compared in the other set of modified Rodrigues parameters, and refused."""
    tree = em.Tree()
    tree.body("ball", joint="spherical", mass=2.0, center=(0, 0, -0.3), inertia=(0.1, 0.2, 0.3))
    model = em.Model(
        name="turned_far",
        coordinates=tree.coordinates,
        kinetic_energy=tree.kinetic_energy,
        potential_energy=tree.potential_energy,
        initial={tree.coordinates[0]: turn, tree.coordinates[1]: 0.1, tree.coordinates[2].diff(): 0.2},
    )
    prove(model, system_for(model, "lagrange"))


@pytest.mark.parametrize("value", [0.1, 0.7, 1.3, 5.0])
@pytest.mark.parametrize("force", [sympy.exp(k * t) - 1, 1 + k * t - sympy.cos(k * t), sympy.sqrt(1 + k * t) - 1])
def test_a_start_at_rest_under_a_force_that_grows_from_rounding_is_proved(force, value):
    """Without an absolute tolerance steps were so short there that rounding of the force was the motion."""
    model = em.Model(
        name="sets_in", coordinates=[q], kinetic_energy=qd**2 / 2, forces={q: force}, parameters={k: value}
    )
    prove(model, system_for(model, "lagrange"))


@pytest.mark.parametrize("width", [1e-2, 1e-4, 1e-6])
@pytest.mark.parametrize("force", [2, 2 * sympy.sin(0.7 * t)])
@pytest.mark.parametrize("formulation", ["lagrange", "eigenfactor"])
def test_a_start_at_rest_that_steep_friction_holds_back_is_proved(force, width, formulation):
    """Two steps move less than the absolute tolerance of a method that iterates."""
    x, e = dynamicsymbols("x"), sympy.Symbol("e", positive=True)
    em.build(em.Model(
        name="held_back", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
        forces={x: force - sympy.Rational(4, 5) * sympy.tanh(x.diff() / e)}, parameters={e: width},
    ), formulation=formulation)  # fmt: skip


def test_a_body_that_stands_on_its_head_is_proved():
    prove(quaternion_body(), system_for(quaternion_body(), "lagrange"))


@pytest.mark.parametrize("options", [{"close_eigenvalues": "extrapolate"}, {"schur": "eigenfactor"}], ids=str)
@pytest.mark.parametrize("name", ["rolling_disk", "dual_link", "four_bar"])
def test_options_are_proved(name, options):
    prove(model_of(name), system_of(name, **options))


@pytest.mark.parametrize("number", range(len(SHAPES)))
def test_random_mechanisms_are_proved(number):
    prove(mechanism(number).model(), system_for(mechanism(number).model(), FORMULATIONS[number % 4]))


@pytest.mark.parametrize(("length", "mass", "time"), [(1e-6, 1.0, 1.0), (1.0, 1e6, 1e-6), (1e6, 1e-6, 1e3)])
def test_units_raise_no_alarm(length, mass, time):
    stiffness, weight = 1e12 * mass / time**2, 9.81 * mass * length / time**2
    model = two(
        mass * ((qd**2 + rd**2) + (q / length) ** 2 * qd * rd / (1 + (q / length) ** 2)) / 2,
        potential_energy=stiffness * (q - r) ** 2 / 2 + weight * sympy.sin(q / length),
        holonomic_constraints=[q**2 + r**2 - length**2],
        scales={q: length, r: length},
    )
    prove(model, system_for(model))


def test_a_kink_at_the_start_is_no_evidence():
    model = em.Model(name="kink", coordinates=[q], kinetic_energy=(1 + abs(q)) * qd**2, forces=[-sympy.sign(qd)])
    prove(model, system_for(model))


@pytest.mark.nightly
def test_units_compiled_apart_are_proved(monkeypatch, own_cache):
    """Outputs and accelerations need not round alike: friction in joints amplifies the difference of multipliers."""
    compile_unit = Toolchain.compile_unit

    def hurried(tools, folder, stem, unit):
        apart = Toolchain(tools.command, (*tools.flags, "-O1")) if unit == "aside" else tools
        return compile_unit(apart, folder, stem, unit)

    monkeypatch.setattr(Toolchain, "compile_unit", hurried)
    assert em.build(model_of("quick_return_shaper")).name == "quick_return_shaper"


def test_places_without_values_are_no_evidence():
    model = em.Model(name="shy", coordinates=[q], kinetic_energy=qd**2, potential_energy=sympy.log(q) + sympy.sqrt(q),
                     initial={q: 1e-3})  # fmt: skip
    prove(model, system_for(model))


def test_what_has_no_value_anywhere_is_said(caplog):
    model = em.Model(name="nowhere", coordinates=[q], kinetic_energy=sympy.sqrt(-1 - q**2) * qd**2)
    with caplog.at_level(logging.WARNING):
        prove(model, system_for(model))
    assert "nowhere: not proved" in caplog.text


# -- planted faults of the generator


def test_a_lost_coefficient_is_found(own_cache):
    """sqrt(S)^2 with S = 4 + q^2 comes without the 1/4 that stood before it."""
    right = Graph._scaled

    def careless(graph, node, factor):
        lost = factor == exact(1, 4) and graph.records[node].kind is Kind.SUM
        return node if lost else right(graph, node, factor)

    model = two(k * (sympy.sqrt(1 + q**2 / 4) * qd + rd) ** 2 / 2 + rd**2 + qd**2 / 2)
    with patch.object(Graph, "_scaled", careless), pytest.raises(ProofError, match=r"two: .*d2T / dq' dq'.* q = 0\.7"):
        em.build(model, flags="-O0")
    assert not list((own_cache / "binaries").glob("*"))


@pytest.mark.parametrize("place", ["M", "A"])
def test_zeros_judged_at_positive_points_are_found(own_cache, place):
    right, f = Zeros.__call__, (sympy.sqrt(q**2) - q) / 2

    def hasty(zeros, node):
        records = zeros.graph.records
        names = [records[n].operands[0] for n in zeros.graph.reachable([node]) if records[n].kind is Kind.SYMBOL]
        expression = convert.ToSympy(zeros.graph, {name: sympy.Symbol(name, positive=True) for name in names})(node)
        return right(zeros, node) or sympy.simplify(expression) == 0

    models = {"M": two(((1 + f) * qd**2 + rd**2) / 2), "A": two(qd**2 + rd**2, nonholonomic_constraints=[rd + f * qd])}
    named = {"M": "kinetic_energy", "A": r"nonholonomic_constraints\[0\]"}
    with patch.object(Zeros, "__call__", hasty), pytest.raises(ProofError, match=rf"{named[place]}.* q = -"):
        em.build(models[place], flags="-O0")
    assert not list((own_cache / "binaries").glob("*"))


# -- planted miscompiles: the C text, changed in one place of one function

EIGENFACTOR = (
    ("mass_matrix", "M[5] = ", "M[5] = 1.00001*"),
    ("mass_matrix", "M[9] = M[6] = ", "M[9] = M[6] = -"),
    ("pfaffian", "A[1] = ", "A[1] = -"),
    ("energy", "e[3] = 0.5*", "e[3] = 0.50001*"),
    ("motion_bias", "gamma[0] = ", "gamma[0] = -"),
    ("motion_bias", "bias[1] = ", "bias[1] = 1e-4 + "),
    ("eigenfactor_motion", "f1[1] = ", "f1[1] = 1.0001*"),
    ("eigenfactor_motion", "A1[0][1] = ", "A1[0][0] = "),
    ("eigenfactor_motion", "Mdot1[0][0] = ", "Mdot1[0][0] = 1.0001*"),
    ("rhs_eigenfactor", "C1_dot, s1_dot);\n", "C1_dot, s1_dot); C1_dot[1] = -C1_dot[1];\n"),
    ("rhs_eigenfactor", "C1_dot, s1_dot);\n", "C1_dot, s1_dot); s1_dot[0] *= 2.0;\n"),
    ("rhs_eigenfactor", "a1, q1);\n", "a1, q1); a1[1] = -a1[1];\n"),
    ("rhs_eigenfactor", "B1[0], lambda, a1);\n", "B1[0], lambda, a1); a1[0] += 2.0*B1[0][0]*lambda[0];\n"),
)
OTHERS = tuple((f"{stage}_motion", "f1[1] = ", "f1[1] = 1.0001*") for stage in ("triangular", "lagrange", "inverse"))


def changed(model, function, old, new, formulation="eigenfactor"):
    """Return generated sources in which one function has another text."""
    sources = generate(model, Choices(formulation))
    files = []
    for file in sources.files:
        head = re.search(rf" {function}\([^;{{]*\n{{", file.text)  # of the definition
        before, start, rest = file.text.partition(head[0] if head else f" {function}(")
        body, end, after = rest.partition("\n}\n")
        assert not start or body.count(old) == 1
        files.append(replace(file, text=before + start + body.replace(old, new) + end + after))
    assert files != list(sources.files)
    return replace(sources, files=tuple(files))


@pytest.mark.parametrize(("function", "old", "new"), EIGENFACTOR + OTHERS)
def test_a_miscompile_is_found(function, old, new):
    model = model_of("dual_link")
    stage = function.removesuffix("_motion")
    formulation = {"triangular": "cholesky", "lagrange": "lagrange", "inverse": "inverse"}.get(stage, "eigenfactor")
    faulty = loaded(changed(model, function, old, new, formulation), "-O0")
    with pytest.raises(ProofError, match=r"dual_link: what was compiled is not the model: .* theta1 = "):
        prove(model, faulty)


def test_steps_that_a_compiler_spoilt_are_found(own_cache, tmp_path, monkeypatch):
    """The least of four pivots comes out as 0, as GCC 12.2 once had it: every run would be refused at its start."""
    shutil.copytree(INCLUDE, tmp_path / "include")
    header = tmp_path / "include" / "constraints/em_rank.h"
    right = "em_pivoted(m, Delta, 0.0, L, pivot, row);"
    assert header.read_text().count(right) == 1
    header.write_text(header.read_text().replace(right, f"{right} pivot[m - 1] = 0.0;"))
    toolchain = sys.modules["eigenmotion.building.toolchain"]
    monkeypatch.setattr(toolchain, "INCLUDE", tmp_path / "include")
    toolchain.headers.cache_clear()
    x = dynamicsymbols("x1:9")
    rows = [one**2 + other**2 - 1 for one, other in pairwise(x[::2] + x[1::2])][:4]
    model = em.Model(name="four_rows", coordinates=x, kinetic_energy=sum(one.diff() ** 2 for one in x),
                     holonomic_constraints=rows, initial=dict.fromkeys(x, 0.5**0.5))  # fmt: skip
    with pytest.raises(ProofError, match="ends at the start"):
        em.build(model, formulation="lagrange")
    toolchain.headers.cache_clear()


@pytest.mark.parametrize(("function", "old", "named"), [("position", "phi[0] = ", r"holonomic_constraints\[0\]"),
                                                  ("observe", "out[0] = ", r"outputs\[out\]"),
                                                  ("model_events", "crossing[0] = ", r"events\[event\]"),
                                                  ("draw", "p[0] = ", r"drawing\[0\]")])  # fmt: skip
def test_expressions_of_all_kinds_are_looked_at(function, old, named):
    model = two(qd**2 + rd**2, holonomic_constraints=[sympy.sin(q) + r], outputs={"out": q + em.multiplier(0)},
                events={"event": sympy.cos(q + r)}, drawing=[em.draw.Trace((sympy.cos(r), q))])  # fmt: skip
    with pytest.raises(ProofError, match=named):
        prove(model, loaded(changed(model, function, old, f"{old}1.0001*"), "-O0"))


def test_a_fault_of_inverse_dynamics_is_found():
    """Runs of a tree do not notice it: the bias has zero accelerations, of which this one is the factor."""
    tree = em.Tree()
    arm = tree.body("arm", joint="revolute", axis="y", mass=2.0, center=(0.3, 0, 0.1), inertia=(0.1, 0.2, 0.1))
    tree.body("hand", arm, joint="revolute", axis="z", at=(0.6, 0, 0), mass=1.0, center=(0.2, 0.1, 0))
    model = em.Model(name="arm", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     potential_energy=tree.potential_energy)  # fmt: skip
    sources = changed(model, "required_forces", "hand_ddot = a[1];", "hand_ddot = 1.0001*a[1];", "articulated_body")
    with pytest.raises(ProofError, match="inverse dynamics of"):
        prove(model, loaded(sources, "-O0"))


def test_dependent_rows_are_held_against_the_equations_of_motion():
    model = two(qd**2 + rd**2, potential_energy=q**2, holonomic_constraints=[q**2 + r**2 - k, 2 * (q**2 + r**2 - k)])
    prove(model, system_for(model))
    faulty = loaded(changed(model, "motion_bias", "bias[0] = ", "bias[0] = 1.0001*"), "-O0")
    with pytest.raises(ProofError, match="the equation of motion of q"):
        prove(model, faulty)


def test_nothing_of_a_faulty_module_reaches_the_cache(own_cache):
    model = model_of("pendulum")
    sources = changed(model, "mass_matrix", "M[0] = ", "M[0] = 1.0001*")
    with pytest.raises(ProofError, match="is a fault of eigenmotion or of the C compiler"):
        compiled(sources, toolchain(flags="-O0"), model)
    assert not list((own_cache / "binaries").glob("*"))


def test_what_was_not_proved_does_not_serve_what_must_be(own_cache):
    model, tools = model_of("pendulum"), toolchain(flags="-O0")
    sources = changed(model, "mass_matrix", "M[0] = ", "M[0] = 1.0001*")
    compiled(sources, tools)
    with pytest.raises(ProofError):
        compiled(sources, tools, model)


# -- hyper-dual numbers

x, y = sympy.symbols("x y", real=True)
OF_ONE = [(function(x), 0.4) for function in convert.FUNCTIONS if function not in
          (sympy.atan2, sympy.Min, sympy.Max, sympy.acosh)]  # fmt: skip
EXPRESSIONS = [
    *OF_ONE, (sympy.acosh(x), 1.7), (sympy.atan2(y, x), -0.8), (sympy.atan2(x, y), 0.8), (sympy.Min(x, y, 3), 0.4),
    (sympy.Max(x, y**2), -0.4), (x**y, 0.7), (x**3, -0.4), (2**x, 0.4), (x**sympy.Rational(-5, 2), 0.3),
    (sympy.Piecewise((sympy.sin(x), sympy.And(x > 0, sympy.Not(y > 3))), (x**2 * y, x < -1), (y, True)), -2.0),
    (sympy.Piecewise((x**3, sympy.Or(sympy.ITE(x > 0, y > 0, y < 0), x > 9)), (0, True)), 1.2),
]  # fmt: skip


@pytest.mark.parametrize(("expression", "at"), EXPRESSIONS, ids=str)
def test_hyper_dual_numbers_know_two_derivatives(expression, at):
    """Along v = (1, 2) and w = (3, 5), against SymPy's derivatives in thirty digits."""
    other, v, w = 0.9, (1.0, 2.0), (3.0, 5.0)
    values = {x: from_parts(np.array(at), v[0], w[0]), y: from_parts(np.array(other), v[1], w[1])}
    found = Evaluation(values)(expression)
    along = [lambda e, u=u: u[0] * sympy.diff(e, x) + u[1] * sympy.diff(e, y) for u in (v, w)]
    right = [expression, along[0](expression), along[1](expression), along[1](along[0](expression))]
    here = {x: sympy.Float(at, 30), y: sympy.Float(other, 30)}
    steady = sympy.DiracDelta, sympy.Derivative, sympy.Subs  # of steps, away from them
    wanted = [
        float(value.replace(lambda e: isinstance(e, steady), lambda *_: 0).subs(here).evalf(30)) for value in right
    ]
    parts = [0.0 if part is None else float(part.value) for part in (found.a, found.b, found.c, found.f)]
    assert parts == pytest.approx(wanted, rel=1e-14, abs=1e-14)


def test_every_function_that_can_be_compiled_can_be_proved():
    assert {function.__name__ for function in convert.FUNCTIONS} == set(FUNCTIONS)
    assert {relation.__name__ for relation in convert.RELATIONS} == {*RELATIONS, "And", "Or", "Not"}


def test_a_function_without_a_counterpart_is_named_and_the_rest_is_proved(caplog):
    model = two(qd**2 + rd**2, potential_energy=sympy.erf(q) + r)
    faulty = loaded(changed(model, "mass_matrix", "M[0] = ", "M[0] = 1.0001*"), "-O0")
    fewer = {name: function for name, function in FUNCTIONS.items() if name != "erf"}
    with patch("eigenmotion.building.verification.arithmetic.evaluate.FUNCTIONS", fewer), caplog.at_level(logging.INFO):
        prove(model, system_for(model))
        assert "two: not proved where erf stands" in caplog.text
        assert "the equation of motion of q" in caplog.text
        with pytest.raises(ProofError, match="d2T / dq' dq'"):
            prove(model, faulty)
