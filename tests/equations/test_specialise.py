"""Specialisation: terms that a scene needs, and terms it does not."""

from functools import cache

import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.equations import derive as physics
from eigenmotion.codegen.equations.specialise import ALL_SAVINGS, Kind, Saving, specialise
from eigenmotion.codegen.model.statement.states import as_mechanism
from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, load_model, t

from ..support.generation import MODELS, NAMES, model_of

x, y, z = dynamicsymbols("x y z")
k, m = symbols("k m", positive=True)
half = Rational(1, 2)
derive = cache(physics.derive)


@pytest.fixture(scope="module", autouse=True)
def once():
    """Each program is made once for all tests of this file."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiler, "program", cache(compiler.program))
        yield


def scene_of(savings=ALL_SAVINGS, **fields):
    start = {"name": "probe", "coordinates": [x, y, z], "parameters": {k: 3.0, m: 2.0}}
    return specialise(derive(Model(**(start | fields))), None, savings)


def kinds(scene):
    return [(block.coordinates, block.kind.value) for block in scene.blocks]


@pytest.mark.parametrize(
    ("name", "eigenfactor", "others"),
    [
        ("dual_link", 20, 8),
        ("polar_particle", 4, 4),
        ("pendulum", 2, 2),
        ("double_pendulum", 10, 4),
        ("chain", 40, 10),
        ("elastic_pendulum", 4, 4),
        ("rotating_hoop", 2, 2),
        ("rotating_spring", 4, 4),
        ("driven_pendulum", 4, 4),
    ],
)
def test_how_many_states(name, eigenfactor, others):
    found = {f: compiler.program(model_of(name), Choices(f)).n_state for f in ("eigenfactor", "cholesky", "lagrange")}
    assert found == {"eigenfactor": eigenfactor, "cholesky": others, "lagrange": others}


def test_blocks_of_the_paper():
    scene = specialise(derive(model_of("dual_link")))
    assert kinds(scene) == [((0, 1, 2), "turning"), ((3,), "fixed")]
    assert [block.constrained for block in scene.blocks] == [True, False]
    assert scene.conserves_energy


@pytest.mark.parametrize("name", NAMES)
def test_states_follow_from_the_blocks(name):
    scene = specialise(derive(as_mechanism(model_of(name))))
    made = compiler.program(model_of(name), Choices("eigenfactor"))
    assert made.n_state == 2 * scene.n + sum(block.size**2 + block.size for block in scene.turning)
    assert sorted(c for block in scene.blocks for c in block.coordinates) == list(range(scene.n))
    parts = sorted(made.layout, key=lambda part: part.start)  # those of first-order states come last, by name
    assert [part.start for part in parts] == [sum(part.length for part in parts[:k]) for k in range(len(parts))]
    assert sum(part.length for part in parts) == made.n_state


def test_coordinates_that_M_couples_at_a_distance_share_a_block():
    T = x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2 + k * cos(x) * x.diff() * y.diff() / 10
    assert kinds(scene_of(kinetic_energy=T)) == [((0, 1), "turning"), ((2,), "fixed")]
    assert kinds(scene_of(kinetic_energy=T + y.diff() * z.diff() / 10)) == [((0, 1, 2), "turning")]


def test_blocks_of_coordinates_that_are_no_neighbours():
    T = x.diff() ** 2 + y.diff() ** 2 * (2 + sin(y)) + z.diff() ** 2 + x.diff() * z.diff() / 2
    assert kinds(scene_of(kinetic_energy=T)) == [((0, 2), "fixed"), ((1,), "single")]


def test_time_alone_makes_a_block_vary():
    T = half * m * (x.diff() ** 2 * (2 + sin(t)) + y.diff() ** 2 + z.diff() ** 2)
    assert [kind for _, kind in kinds(scene_of(kinetic_energy=T))] == ["single", "fixed", "fixed"]


@pytest.mark.parametrize(
    ("savings", "expected"),
    [
        (ALL_SAVINGS, [((0,), "fixed"), ((1,), "single"), ((2,), "fixed")]),
        (ALL_SAVINGS - {Saving.FIXED}, [((0,), "single"), ((1,), "single"), ((2,), "single")]),
        (ALL_SAVINGS - {Saving.SINGLE}, [((0,), "fixed"), ((1,), "turning"), ((2,), "fixed")]),
        (ALL_SAVINGS - {Saving.UNCOUPLED}, [((0, 1, 2), "turning")]),
        (frozenset(), [((0, 1, 2), "turning")]),
    ],
)
def test_each_saving_can_be_switched_off(savings, expected):
    T = half * m * (x.diff() ** 2 + y.diff() ** 2 * (2 + sin(x)) + z.diff() ** 2)
    assert kinds(scene_of(savings, kinetic_energy=T)) == expected


def test_what_the_paper_does_without_is_told_with_reasons():
    left_out = " | ".join(specialise(derive(model_of("dual_link"))).left_out)
    for words in ("G, Gdot", "dT0/dx", "Q:", "dM/dt", "Delta is a number", "b, bdot", "do not couple", "theta4"):
        assert words in left_out
    assert "dV/dx" not in left_out
    assert "there are no constraints" not in left_out


@pytest.mark.parametrize(
    ("fields", "gone", "kept"),
    [
        ({}, ("G, Gdot", "dT0/dx", "dV/dx", "Q:", "dM/dt", "A, B, Bdot"), ("b, bdot", "Delta is a number")),
        ({"potential_energy": k * x}, ("G, Gdot",), ("dV/dx",)),
        ({"potential_energy": k * x * sin(t)}, (), ("dV/dx", "dM/dt, dA/dt, dV/dt")),
        ({"forces": {x: -k * x.diff()}}, ("dV/dx",), ("Q:",)),
        ({"nonholonomic_constraints": [x.diff() - y.diff()]}, ("b, bdot", "Delta is a number"), ("A, B, Bdot",)),
        ({"nonholonomic_constraints": [x.diff() - 1, y.diff()]}, (), ("A, B, Bdot", "b, bdot", "Delta is a number")),
    ],
)
def test_left_out(fields, gone, kept):
    T = half * m * (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2)
    lines = " | ".join(scene_of(**({"kinetic_energy": T} | fields)).left_out)
    assert [words for words in gone if words not in lines] == []
    assert [words for words in kept if words in lines] == []


@pytest.mark.parametrize(
    ("fields", "conserves"),
    [
        ({}, True),
        ({"potential_energy": k * x**2}, True),
        ({"potential_energy": k * x * t}, False),
        ({"forces": {x: -k * x.diff()}}, False),
        ({"holonomic_constraints": [x - y]}, True),
        ({"holonomic_constraints": [x - y - sin(t)]}, False),
        ({"nonholonomic_constraints": [x.diff() - t * y.diff()]}, False),
        ({"nonholonomic_constraints": [x.diff() - x]}, False),
        ({"kinetic_energy": half * m * (x.diff() ** 2 * (2 + sin(t)) + y.diff() ** 2 + z.diff() ** 2)}, False),
        ({"kinetic_energy": half * m * ((x.diff() - k * y) ** 2 + y.diff() ** 2 + z.diff() ** 2)}, True),
    ],
)
def test_whether_a_jacobi_integral_is_conserved(fields, conserves):
    T = half * m * (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2)
    assert scene_of(**({"kinetic_energy": T} | fields)).conserves_energy is conserves


@pytest.mark.parametrize("n", [2, 3, 7])
def test_a_chain_is_one_block(n):
    scene = specialise(derive(load_model(MODELS / "chain.py", n=n)))
    assert [(block.size, block.kind) for block in scene.blocks] == [(n, Kind.TURNING)]


@pytest.mark.parametrize("name", NAMES)
def test_explain_shows_states_blocks_operations_and_reasons(name):
    text, scene = compiler.explain(model_of(name)), specialise(derive(as_mechanism(model_of(name))))
    for heading in ("State", "Blocks of the mass matrix", "Operations", "Left out"):
        assert heading in text
    assert [line for line in scene.left_out if line not in text] == []
    assert f"{scene.n} coordinates, {scene.m} constraint rows" in text
