"""The terms of the equations of motion, against SymPy's own derivatives of the energies."""

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.equations.derive import derive
from eigenmotion.codegen.graph.convert import ToSympy
from eigenmotion.codegen.graph.node_reference import NodeReference
from eigenmotion.codegen.model.statement.states import as_mechanism
from sympy import Heaviside, Max, Rational, cos, diff, exp, sin, symbols, tanh
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError, t

from ..oracles.direct import Direct
from ..support.generation import NAMES, model_of, relative

q1, q2, q3 = dynamicsymbols("q1:4")
a, b, m = symbols("a b m", positive=True)
half = Rational(1, 2)


def model(**fields):
    """Return a model of one or two coordinates with some fields given."""
    start = {"name": "probe", "coordinates": [q1, q2], "kinetic_energy": m * (q1.diff() ** 2 + q2.diff() ** 2) / 2}
    return Model(**(start | {"parameters": {a: 0.7, b: 1.3, m: 2.0}} | fields))


def derived(mechanics, name, point):
    entries = getattr(mechanics, name)
    flat = [entries] if name == "T0" else list(entries)
    arguments = [*mechanics.x, *mechanics.parameters, mechanics.time, *mechanics.v]
    if mechanics.graph:
        to_sympy = ToSympy(mechanics.graph, {symbol.name: symbol for symbol in arguments})
        flat = [
            entry.replace(lambda part: isinstance(part, NodeReference), lambda part: to_sympy(part.node))
            for entry in flat
        ]
    return np.array(sympy.lambdify(arguments, flat, cse=True)(*point), dtype=float)


@pytest.mark.parametrize("nested", [False, True])
@pytest.mark.parametrize("name", NAMES)
def test_terms_of_every_model(name, nested):
    given, random = as_mechanism(model_of(name)), np.random.default_rng(5)
    direct, mechanics = Direct(given), derive(given, nested=nested)
    for _ in range(3):
        x = np.array(given.initial_x) + random.uniform(-0.4, 0.4, given.n)
        parameters = [value * random.uniform(0.8, 1.2) for _, value in given.parameters]
        point = [*x, *parameters, random.uniform(0, 2), *random.normal(size=given.n)]
        for term in ("M", "G", "T0", "A", "b"):
            assert relative(derived(mechanics, term, point), direct(term, point), 1.0) < 1e-13, term


@pytest.mark.parametrize("name", NAMES)
def test_terms_are_free_of_velocities(name):
    mechanics = derive(as_mechanism(model_of(name)))
    terms = [*mechanics.M, *mechanics.G, mechanics.T0, mechanics.V, *mechanics.A, *mechanics.b, *mechanics.phi]
    assert not set().union(*(term.free_symbols for term in terms)) & set(mechanics.v)
    assert mechanics.M.is_symmetric()


# --- what is recognised without `simplify` ----------------------------------------------------------------------------


def test_polar_coordinates_of_a_particle_in_cartesian_velocities():
    r, theta = q1, q2
    x, y = r * cos(theta), r * sin(theta)
    mechanics = derive(model(kinetic_energy=half * m * (x.diff(t) ** 2 + y.diff(t) ** 2)))
    assert sympy.Matrix([[m, 0], [0, m * mechanics.x[0] ** 2]]) == mechanics.M


def test_a_rotation_of_axes_leaves_a_constant_mass():
    x, y = cos(3) * q1 - sin(3) * q2, sin(3) * q1 + cos(3) * q2
    mechanics = derive(model(kinetic_energy=half * m * (x.diff(t) ** 2 + y.diff(t) ** 2)))
    assert m * sympy.eye(2) == mechanics.M


def test_a_turning_frame_has_T1_and_T0_but_a_constant_mass():
    x, y = q1 * cos(a * t) - q2 * sin(a * t), q1 * sin(a * t) + q2 * cos(a * t)
    mechanics = derive(model(kinetic_energy=half * m * (x.diff(t) ** 2 + y.diff(t) ** 2)))
    x_1, x_2 = mechanics.x
    assert m * sympy.eye(2) == mechanics.M
    assert [sympy.simplify(g) for g in mechanics.G] == [-a * m * x_2, a * m * x_1]
    assert sympy.simplify(mechanics.T0 - half * m * a**2 * (x_1**2 + x_2**2)) == 0


def test_spherical_coordinates_of_a_particle():
    r, u, w = q1, q2, q3
    place = sympy.Matrix([r * sin(u) * cos(w), r * sin(u) * sin(w), r * cos(u)])
    velocity = place.diff(t)
    mechanics = derive(model(coordinates=[r, u, w], kinetic_energy=half * m * velocity.dot(velocity)))
    assert mechanics.M.is_diagonal()
    assert mechanics.M[0, 0] == m
    assert mechanics.M[1, 1].free_symbols == {m, mechanics.x[0]}
    assert mechanics.M[2, 2].free_symbols == {m, *mechanics.x[:2]}


def test_a_coordinate_held_in_form_only_is_put_to_a_number_where_that_is_defined():
    mechanics = derive(model(kinetic_energy=half * m * (q1.diff() ** 2 * (q1 * q2 + q1 * a) / q1 + q2.diff() ** 2)))
    assert mechanics.M[0, 0].free_symbols == {m, a, mechanics.x[1]}


@pytest.mark.parametrize(
    "factor", [Max(0, q1 - 3), Heaviside(q1 - 3), 1 + tanh(50 * (q1 - 5)), exp(-1000 * q1), sympy.floor(q1 / 5)]
)
def test_what_varies_in_one_part_of_space_only_is_not_taken_for_constant(factor):
    mechanics = derive(model(kinetic_energy=half * m * (q1.diff() ** 2 * (1 + factor) + q2.diff() ** 2)))
    assert mechanics.x[0] in mechanics.M[0, 0].free_symbols


@pytest.mark.parametrize("sign", [-1, 1])
@pytest.mark.parametrize("size", [sympy.sqrt(q1**2), sympy.sqrt((q1 - 3) ** 2) + 3, sympy.Abs(q1)])
def test_terms_that_vanish_for_one_sign_are_kept(size, sign):
    """In M, G, and rows alike."""
    factor = size - sign * q1
    T = half * m * ((1 + factor) * q1.diff() ** 2 + q2.diff() ** 2) + factor * q2.diff()
    mechanics = derive(model(kinetic_energy=T, nonholonomic_constraints=[q2.diff() + factor * q1.diff() + factor]))
    held = mechanics.x[0]
    for entry in (mechanics.M[0, 0], mechanics.G[1], mechanics.A[0, 0], mechanics.b[0]):
        assert held in entry.free_symbols


def test_a_kinetic_energy_in_pieces_is_quadratic():
    T = half * sympy.Piecewise((m * q1.diff() ** 2, q1 > a), (2 * m * q1.diff() ** 2, True)) + half * q2.diff() ** 2
    mechanics = derive(model(kinetic_energy=T))
    assert [mechanics.M[0, 0].subs({mechanics.x[0]: at, a: 1}) for at in (0, 2)] == [2 * m, m]


def test_a_kinetic_energy_in_pieces_of_velocity_is_not():
    with pytest.raises(ModelError, match="second degree"):
        model(kinetic_energy=sympy.Piecewise((q1.diff() ** 2, q1.diff() > 0), (0, True)) + q2.diff() ** 2)


def test_derivatives_with_respect_to_coordinates_are_carried_out():
    real = dynamicsymbols("r1", real=True)
    force = -sympy.Derivative(real * sympy.Abs(real), real)
    given = Model(name="probe", coordinates=[real], kinetic_energy=real.diff() ** 2 / 2, forces=[force])
    mechanics = derive(given)
    assert mechanics.Q[0].subs(mechanics.x[0], -2) == -4


def test_a_term_linear_in_a_velocity_that_cancels_is_gone():
    T = half * m * ((q1.diff() + a) ** 2 - 2 * a * q1.diff() + q2.diff() ** 2)
    mechanics = derive(model(kinetic_energy=T))
    assert mechanics.G == (0, 0)
    assert sympy.expand(mechanics.T0 - half * m * a**2) == 0


def test_rows_of_holonomic_constraints():
    mechanics = derive(model(holonomic_constraints=[q1**2 + q2**2 - a**2 * (1 + b * t)]))
    x_1, x_2 = mechanics.x
    assert list(mechanics.A) == [2 * x_1, 2 * x_2]
    assert sympy.expand(mechanics.b[0] + a**2 * b) == 0
    assert len(mechanics.phi) == 1


def test_holonomic_rows_come_first():
    rows = {"nonholonomic_constraints": [q1.diff() - t * q2.diff() + 3], "holonomic_constraints": [q1 * q2]}
    mechanics = derive(model(**rows))
    assert list(mechanics.A) == [mechanics.x[1], mechanics.x[0], 1, -mechanics.time]
    assert mechanics.b == (0, 3)


def test_gradient_of_the_mass_matrix():
    mechanics = derive(model(kinetic_energy=half * m * (q1.diff() ** 2 * (2 + sin(q2 * t)) + q2.diff() ** 2)))
    x_2, time = mechanics.x[1], mechanics.time
    assert mechanics.mass_matrix_gradient()[1][0, 0] == diff(m * (2 + sin(x_2 * time)), x_2)


def test_quasi_velocities_become_rates():
    w1, w2 = dynamicsymbols("w1 w2")
    transformation = {w1: q1.diff() * cos(q2) + q2.diff(), w2: q2.diff()}
    mechanics = derive(model(kinetic_energy=half * (w1**2 + w2**2), quasi_velocities=transformation))
    c = cos(mechanics.x[1])
    assert sympy.simplify(mechanics.M - sympy.Matrix([[c**2, c], [c, 2]])) == sympy.zeros(2)


# --- mistakes ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"kinetic_energy": q1.diff() ** 3 + q2.diff() ** 2}, ("probe", "kinetic", "second degree")),
        ({"kinetic_energy": sympy.sqrt(1 + q1.diff() ** 2)}, ("probe", "kinetic", "second degree")),
        ({"kinetic_energy": q1.diff() ** 2 * sin(q2.diff())}, ("probe", "kinetic")),
        ({"nonholonomic_constraints": [q1.diff() * q2.diff()]}, ("probe", "nonholonomic_constraints[0]", "linear")),
        ({"nonholonomic_constraints": [q1.diff(), q2.diff() ** 2]}, ("probe", "nonholonomic_constraints[1]", "linear")),
        ({"nonholonomic_constraints": [q1 - q2]}, ("probe", "holonomic_constraints", "no velocity")),
        ({"holonomic_constraints": [q1.diff()]}, ("probe", "nonholonomic_constraints")),
        ({"holonomic_constraints": [a - 1]}, ("probe", "no coordinate")),
        ({"potential_energy": symbols("stray") * q1}, ("probe", "stray", "parameters")),
        ({"potential_energy": symbols("m") * q1}, ("probe", "'m'", "same object")),
        ({"potential_energy": q3}, ("probe", "q3", "coordinates")),
        ({"forces": {q1: sympy.Function("friction")(q1.diff())}}, ("probe", "friction")),
        ({"forces": {q1: sympy.gamma(q1)}}, ("probe", "gamma")),
        ({"potential_energy": sympy.besselj(0, q1)}, ("probe", "besselj")),
        ({"potential_energy": (sympy.Float("1e200") * (q1 + q2)) ** 2}, ("probe", "double", "units")),
        ({"potential_energy": (1e200 * q1) ** 3}, ("probe", "double", "units")),
        ({"nonholonomic_constraints": [(q1.diff() ** 2 + q1.diff() * q2.diff()) / q1.diff()]}, ("probe", "at rest")),
    ],
)
def test_mistakes_name_model_symbol_and_remedy(fields, words):
    with pytest.raises(ModelError) as caught:
        derive(model(**fields))
    assert [word for word in words if word not in str(caught.value)] == []


@pytest.mark.parametrize("name", ["em", "eigenmotion", "em_stepper", "class", "2d", "a b", "ä", ""])
def test_names_that_no_file_or_symbol_may_have(name):
    with pytest.raises(ModelError, match="Model"):
        model(name=name)
