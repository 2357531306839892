"""Model: normalisation, and every mistake it names."""

import dataclasses
import os
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy
from sympy import Function, Matrix, Rational, Symbol, cos, pi, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, ModelError, load_model, multiplier, t

from ..support.models_table import ACTING, EVERY, MODELS, SCENARIOS, WITH_TESTS_OF_THEIR_OWN

theta, r = dynamicsymbols("theta r")
y1, y2, u = dynamicsymbols("y1 y2 u")
m, k, g, L = symbols("m k g L", positive=True)

ELASTIC_PENDULUM = {
    "name": "elastic_pendulum",
    "coordinates": [theta, r],
    "kinetic_energy": Rational(1, 2) * m * (r.diff() ** 2 + r**2 * theta.diff() ** 2),
    "potential_energy": Rational(1, 2) * k * (r - L) ** 2 - m * g * r * cos(theta),
    "parameters": {m: 1.0, k: 100.0, g: 9.81, L: 1.0},
    "initial": {theta: pi / 6, r: 1.2},
}


def changed(**arguments):
    return Model(**ELASTIC_PENDULUM | arguments)


def test_normalised_to_tuples():
    model = changed(forces={r: -r.diff()}, events={"top": theta}, outputs={"tension": k * (r - L)}, scales={r: 0.5})
    assert model.coordinates == (theta, r)
    assert model.forces == (0, -r.diff())
    assert model.parameters == ((m, 1.0), (k, 100.0), (g, 9.81), (L, 1.0))
    assert model.initial_x == (float(pi / 6), 1.2)
    assert model.initial_v == (0.0, 0.0)
    assert model.initial_y == ()
    assert model.scales == (1.0, 0.5)
    assert model.events == (("top", Event(theta)),)
    assert (model.n, model.h, model.m) == (2, 0, 0)
    hash(model)


def test_frozen_copied_and_pickled():
    model = changed(outputs={"a": r.diff(t, 2)}, events={"top": Event(theta, direction=1)})
    assert dataclasses.replace(model) == model
    assert pickle.loads(pickle.dumps(model)) == model
    heavier = dataclasses.replace(model, parameters={m: 2.0, k: 1.0, g: 1.0, L: 1.0})
    assert dict(heavier.parameters)[m] == 2.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        model.name = "other"


def test_expressions_are_made_exact():
    model = changed(kinetic_energy=m * (r.diff() ** 2.0 + r**2 * theta.diff() ** 2) / 2)
    assert model.kinetic_energy.has(r.diff() ** 2)
    standing = sympy.Derivative(L * r, t, evaluate=False)
    assert changed(nonholonomic_constraints=[standing]).nonholonomic_constraints == (L * r.diff(),)


def test_quasi_velocities():
    y = {y1: r * theta.diff(), y2: r.diff()}
    model = changed(
        quasi_velocities=y,
        kinetic_energy=m * (y1**2 + y2**2) / 2,
        initial={theta: 1.0, r: 2.0, y1: 3.0, y2: 4.0},
        outputs={"rate": y1.diff()},
    )
    assert sympy.expand(model.in_rates(model.kinetic_energy) - ELASTIC_PENDULUM["kinetic_energy"]) == 0
    assert sympy.expand(model.in_rates(model.outputs[0][1]) - (r * theta.diff()).diff(t)) == 0
    assert model.initial_y == (3.0, 4.0)
    assert model.initial_v == (1.5, 4.0)


def test_quasi_velocities_singular_at_the_start():
    arguments = {"quasi_velocities": {y1: r * theta.diff(), y2: r.diff()}, "initial": {y1: 1.0}}
    with pytest.raises(ModelError, match="singular at the initial"):
        _ = changed(**arguments).initial_v


def test_multiplier_is_recognised():
    model = changed(nonholonomic_constraints=[r.diff()], outputs={"force": multiplier(0) * m})
    assert model.outputs[0][1] == multiplier(0) * m
    assert multiplier(0) != multiplier(1)
    for bad in (-1, 0.5, "0"):
        with pytest.raises(ModelError, match="multiplier"):
            multiplier(bad)


@pytest.mark.parametrize("name", ["lambda", "int", "class", "double"])
def test_keywords_are_allowed_as_names_of_symbols(name):
    coordinate, parameter = dynamicsymbols(name), Symbol(name + "_", positive=True)
    model = Model(
        name="keywords",
        coordinates=[coordinate],
        kinetic_energy=parameter * coordinate.diff() ** 2,
        parameters={parameter: 1},
    )
    assert model.n == 1


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"name": "elastic pendulum"}, ["elastic pendulum", "letters, digits and underscores"]),
        ({"name": "for"}, ["'for'", "keyword"]),
        ({"name": 3}, ["3"]),
        ({"coordinates": []}, ["coordinates is empty"]),
        ({"coordinates": {theta, r}}, ["list or tuple"]),
        ({"coordinates": [theta, m]}, ["contains m", "dynamicsymbols('m')"]),
        ({"coordinates": [theta, Function("r")(Symbol("s"))]}, ["r(s)", "not a function of time"]),
        ({"coordinates": [theta, r, theta]}, ["'theta'", "named twice"]),
        ({"parameters": {m: 1, k: 1, g: 1}}, ["potential_energy", "'L'", "Add it to parameters"]),
        ({"parameters": {Symbol("m"): 1, k: 1, g: 1, L: 1}}, ["'m'", "different symbol", "same object"]),
        ({"parameters": {m: 1, k: 1, g: 1, L: 1, Symbol("m"): 2}}, ["two different symbols", "'m'"]),
        ({"parameters": {m: 1, k: 1, g: 1, L: 1, Symbol("theta"): 2}}, ["'theta'", "Rename"]),
        ({"parameters": {m: 1, k: 1, g: 1, L: 1, Symbol("t"): 2}}, ["'t'", "like the time"]),
        ({"coordinates": [theta, r, dynamicsymbols("t")]}, ["'t'", "like the time"]),
        ({"parameters": {m: float("nan"), k: 1, g: 1, L: 1}}, ["parameters[m]", "finite"]),
        ({"parameters": {m: k, k: 1, g: 1, L: 1}}, ["parameters[m]", "real number"]),
        ({"parameters": {m: 1, k: sympy.I, g: 1, L: 1}}, ["parameters[k]", "real number"]),
        ({"parameters": 3}, ["parameters", "mapping"]),
        ({"parameters": {r: 1}}, ["not a Symbol"]),
        ({"initial": {theta: float("inf")}}, ["initial[theta]", "finite"]),
        ({"initial": {dynamicsymbols("thet"): 1}}, ["thet", "Did you mean 'theta'?"]),
        ({"initial": {r.diff(t, 2): 1}}, ["neither a coordinate nor a rate"]),
        ({"initial": {"theta": 1}}, ["'theta'", "Give the model's own symbol, not its name"]),
        ({"initial": [(r, 1.0), (r, 2.0)]}, ["initial", "two entries for 'r'"]),
        ({"kinetic_energy": "m"}, ["kinetic_energy", "not a SymPy expression"]),
        ({"kinetic_energy": Matrix([m])}, ["not a scalar"]),
        ({"kinetic_energy": True}, ["not a scalar"]),
        ({"kinetic_energy": m / (m - m)}, ["infinite or undefined"]),
        ({"kinetic_energy": sympy.I * m}, ["imaginary"]),
        ({"kinetic_energy": m * r.diff() ** 3}, ["second degree", "r'"]),
        ({"kinetic_energy": m * r.diff() ** 2 * theta.diff() ** 2}, ["second degree", "theta'"]),
        ({"kinetic_energy": sqrt(r.diff())}, ["second degree", "r'"]),
        ({"kinetic_energy": m * theta.diff() ** 2 + sqrt(1 + r.diff() ** 2)}, ["second degree", "r'"]),
        ({"kinetic_energy": sin(theta.diff())}, ["second degree", "theta'"]),
        ({"kinetic_energy": m * r.diff() ** 2}, ["rate of 'theta'", "singular"]),
        ({"kinetic_energy": m * r.diff() ** 2 * dynamicsymbols("thta")}, ["'thta'", "Did you mean 'theta'?"]),
        ({"kinetic_energy": m * (r.diff() ** 2 + u * theta.diff() ** 2), "inputs": {u: 0}}, ["input 'u'", "forces"]),
        ({"potential_energy": k * r.diff()}, ["velocity r'", "kinetic_energy or forces"]),
        ({"potential_energy": k * r.diff(t, 2)}, ["r''", "higher order"]),
        ({"potential_energy": Symbol("t", real=True)}, ["not the time", "eigenmotion.t"]),
        ({"potential_energy": Function("f")(r)}, ["f(r(t))", "not declared", "Write it out"]),
        ({"potential_energy": sympy.Integral(sin(m), (m, 0, r))}, ["Integral(sin(m), (m, 0, r(t)))", ".doit()"]),
        ({"potential_energy": sympy.Sum(r**m, (m, 1, 3))}, ["Sum(r(t)**m, (m, 1, 3))", ".doit()"]),
        ({"forces": [1]}, ["1 entries for 2 coordinates"]),
        ({"forces": {dynamicsymbols("rr"): 1}}, ["rr(t)", "not a coordinate"]),
        ({"forces": {"theta": 1}}, ["'theta'", "not a coordinate. Give the model's own symbol"]),  # not: mean 'theta'?
        ({"scales": {Symbol("theta"): 2}}, ["theta", "not a coordinate. Give the model's own symbol"]),
        ({"forces": [u.diff(), 0], "inputs": {u: 0}}, ["rate of the input 'u'"]),
        ({"forces": [r.diff(t, 2), 0]}, ["higher order"]),
        ({"holonomic_constraints": [r.diff()]}, ["holonomic_constraints[0]", "nonholonomic_constraints"]),
        ({"holonomic_constraints": [m - 1]}, ["contains no coordinate"]),
        ({"nonholonomic_constraints": [r - L]}, ["contains no velocity", "holonomic_constraints"]),
        ({"nonholonomic_constraints": [r.diff() ** 2]}, ["nonholonomic_constraints[0]", "not linear"]),
        ({"nonholonomic_constraints": [sin(r.diff())]}, ["not linear"]),
        ({"nonholonomic_constraints": [r.diff() * theta.diff()]}, ["not linear"]),
        ({"nonholonomic_constraints": r.diff()}, ["list or tuple", "the order counts"]),
        ({"quasi_velocities": {y1: r.diff()}}, ["1 entries for 2 coordinates"]),
        ({"quasi_velocities": {y1: r.diff(), y2: 2 * r.diff()}}, ["not independent"]),
        ({"quasi_velocities": {y1: r.diff(), y2: theta.diff() + 1}}, ["y2", "not linear"]),
        ({"quasi_velocities": {y1: r.diff(), y2: theta.diff() ** 2}}, ["y2", "not linear"]),
        ({"quasi_velocities": {y1: r.diff(), y2: theta.diff()}, "initial": {y1: 1, r.diff(): 1}}, ["one of the two"]),
        ({"outputs": {"f": multiplier(0)}}, ["multiplier(0)", "0 constraint rows"]),
        ({"outputs": {"f": r.diff(t, 3)}}, ["higher order"]),
        ({"outputs": {"": r}}, ["outputs", "Name it"]),
        ({"events": {"a": multiplier(0)}}, ["Only outputs"]),
        ({"events": {"a": 1 / (r - r)}}, ["events[a]", "infinite"]),
        ({"scales": {r: 0}}, ["scales[r]", "positive"]),
        ({"scales": [1.0]}, ["1 entries for 2 coordinates"]),
    ],
)
def test_mistakes_are_named(arguments, words):
    with pytest.raises(ModelError) as caught:
        changed(**arguments)
    message = str(caught.value)
    assert message.startswith(f"Model {arguments.get('name', 'elastic_pendulum')!r}: ")
    for word in words:
        assert word in message


def test_event_directions():
    assert Event(r, direction=-1, terminal=True).terminal
    with pytest.raises(ModelError, match="direction"):
        Event(r, direction=2)


def test_degree_is_decided_after_cancellation():
    difference = r.diff() ** 3 / (1 + r.diff()) + r.diff() ** 2 / (1 + r.diff())
    with pytest.raises(ModelError, match="second degree"):
        changed(kinetic_energy=m * (theta.diff() ** 2 + difference))
    cancelling = (r.diff() ** 2 + 1) ** 2 - r.diff() ** 4
    assert changed(kinetic_energy=m * (theta.diff() ** 2 + cancelling)).n == 2


def test_canonical_text_tells_models_apart():
    model = changed()
    assert model.canonical() == changed().canonical()
    others = [
        changed(name="other"),
        changed(coordinates=[r, theta]),
        changed(initial={}),
        changed(parameters={m: 1.0, k: 100.0, g: 9.81, L: 1.5}),
        changed(scales={r: 2}),
        changed(outputs={"r": r}),
        changed(events={"r": r}),
        changed(events={"r": Event(r, terminal=True)}),
        changed(forces={r: 1}),
        changed(potential_energy=k * r),
    ]
    texts = {model.canonical(), *(other.canonical() for other in others)}
    assert len(texts) == len(others) + 1


PRINT_CANONICAL = """
import sys, eigenmotion
for path in sys.argv[1:]:
    print(eigenmotion.load_model(path).canonical())
"""


def test_canonical_text_does_not_depend_on_the_hash_seed():
    """This process has a seed of its own; `test_deterministic_text` asks for more of them at night."""
    paths = [MODELS / f"{name}.py" for name in ("dual_link", "spatial_arm", "sphere")]
    here = "".join(f"{load_model(path).canonical()}\n" for path in paths)
    command = [sys.executable, "-c", PRINT_CANONICAL, *map(str, paths)]
    given = os.environ | {"PYTHONHASHSEED": "2"}
    assert subprocess.run(command, env=given, check=True, capture_output=True, text=True).stdout == here


def test_every_model_file_is_in_the_table():
    files = {file.stem for file in MODELS.glob("*.py")} - {"__init__"}
    assert files == {scenario.file for scenario in SCENARIOS} | {*ACTING, *WITH_TESTS_OF_THEIR_OWN}


@EVERY
def test_model_files_have_their_name_and_a_drawing(scenario):
    assert scenario.model().name == scenario.name
    assert np.isfinite(scenario.model().initial_v).all()
    docstring = Path(scenario.path).read_text().split('"""')[1]
    assert "::" in docstring
    assert "Oracle" in docstring
    assert "Coordinate" in docstring


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        (sympy.Abs(r).diff(t), sympy.sign(r) * r.diff()),
        ((r * sympy.Abs(r)).diff(t) ** 2, (2 * sympy.Abs(r) * r.diff()) ** 2),
        (sympy.Abs(r * theta).diff(t), sympy.sign(r * theta) * (r * theta).diff(t)),
        (sympy.Abs(r).diff(r) * r.diff(), sympy.sign(r) * r.diff()),
        (sympy.sign(r).diff(t) * theta, 0),
        (sympy.conjugate(r) * sympy.re(theta) + sympy.im(r), r * theta),
    ],
)
def test_coordinates_are_real_whatever_sympy_takes_them_for(written, meant):
    """In numbers of both signs: |r| sign(r) is r, which SymPy does not see."""
    ours = changed(forces={r: written}).forces[1]
    for values in ((0.7, 0.3, -1.1, 2.0), (-0.7, 0.3, 1.1, -2.0)):
        point = dict(zip((r.diff(), theta.diff(), r, theta), values, strict=True))
        assert float((ours - meant).xreplace(point)) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        (sympy.Mod(r, L), r - L * sympy.floor(r / L)),
        (2 * sympy.frac(r), 2 * r - 2 * sympy.floor(r)),
        (sympy.cot(r) + sympy.sec(r) * sympy.csc(r), 1 / sympy.tan(r) + 1 / (sympy.cos(r) * sin(r))),
        (sympy.coth(r) + sympy.sech(sympy.csch(r)), 1 / sympy.tanh(r) + 1 / sympy.cosh(1 / sympy.sinh(r))),
        (sympy.erfc(r), 1 - sympy.erf(r)),
    ],
)
def test_functions_that_c_has_not_are_written_in_those_it_has(written, meant):
    assert changed(potential_energy=written).potential_energy == meant
    values = {r: Rational(13, 10), L: Rational(1, 2)}
    assert float(written.subs(values)) == pytest.approx(float(meant.subs(values)), rel=1e-14)


@pytest.mark.parametrize("other", [t - 0.1, 2 * t, sympy.Integer(0), t - Symbol("delay")])
def test_a_coordinate_at_another_time_is_a_delay_and_no_other_symbol(other):
    x = dynamicsymbols("x")
    given = {"name": "delayed", "coordinates": [x], "kinetic_energy": x.diff() ** 2}
    words = r"Model 'delayed': forces\[x\] contains x\(.*\), the coordinate 'x' at another time than now. Delays"
    with pytest.raises(ModelError, match=words):
        Model(**given, forces={x: -x.func(other)})
    with pytest.raises(ModelError, match=r"Delays are not taken in expressions: .*Sampled\(delay=\)"):
        Model(**given, forces={x: -x.func(other).diff(t)} if other.has(t) and other != 2 * t else {x: x.func(other)})
