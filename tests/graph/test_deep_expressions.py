"""Expressions that are nested deeply, or chosen from many pieces, build: Python's thousand calls are no limit."""

import sys

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.compiler import generate
from eigenmotion.codegen.graph.convert import FromSympy, ToSympy
from eigenmotion.codegen.graph.graph import Graph
from eigenmotion.codegen.model.recursion_depth import ORDINARY, with_room
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model
from eigenmotion.building.verification import prove

from ..support.generation import system_for

q = dynamicsymbols("q")


def model(force: sympy.Expr) -> Model:
    return Model(name="deep", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, forces={q: force}, initial={q: 0.9})


def pieces(count: int) -> tuple[np.ndarray, np.ndarray, list[tuple[sympy.Expr, sympy.Expr]]]:
    """A table of a spring, and (value, condition) of each of its pieces but the last."""
    at = np.linspace(-1, 1, count + 2)
    force = -at - at**3
    slope = np.diff(force) / np.diff(at)
    return at, force, [(force[i] + slope[i] * (q - at[i]), q < at[i + 1]) for i in range(count)]


def nested(count: int) -> sympy.Expr:
    """The pieces as a user's loop nests them."""
    _, force, chosen = pieces(count)
    value = sympy.Float(force[-1])
    for piece in reversed(chosen):
        value = sympy.Piecewise(piece, (value, True), evaluate=False)
    return value


def sines(count: int) -> sympy.Expr:
    value = q
    for _ in range(count):
        value = sympy.sin(value, evaluate=False)
    return value


def added(count: int) -> sympy.Expr:
    value = q
    for k in range(count):
        value = sympy.Add(sympy.sin(q * (k % 7 + 1)) / (k + 1), value, evaluate=False)
    return value


@pytest.mark.parametrize("flat", [True, False])
def test_a_force_of_many_pieces_is_right(flat):
    """It ended in a RecursionError."""
    at, force, chosen = pieces(400)
    system = system_for(model(sympy.Piecewise(*chosen, (force[-1], True)) if flat else nested(400)), "lagrange")
    for x in (-0.97, -0.3, 0.0, 0.3, 0.98):
        assert system.acceleration([x], [0.0])[0][0] == pytest.approx(np.interp(x, at, force), abs=1e-13)


def test_deep_expressions_are_right_and_proved():
    right = 0.3
    for _ in range(400):
        right = np.sin(right)
    total = 0.3 + sum(np.sin(0.3 * (k % 7 + 1)) / (k + 1) for k in range(400))
    for force, value in ((sines(400), right), (added(400), total)):
        made = model(force)
        system = system_for(made, "lagrange")
        prove(made, system)
        assert system.acceleration([0.3], [0.0])[0][0] == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize("force", [nested(300), sines(300)], ids=["pieces", "sines"])
def test_compilers_are_given_few_parentheses_in_each_other(force):
    """Clang takes 256."""
    for file in generate(model(force), Choices("eigenfactor")).files:
        signs = np.array([(c == "(") - (c == ")") for c in file.text])
        assert np.cumsum(signs).max() < 200


def test_a_chain_of_choices_comes_back_as_one():
    x = sympy.Symbol("x")
    _, _, chosen = pieces(50)
    graph = Graph(())
    given = sympy.Piecewise(*[(value.subs(q, x), condition.subs(q, x)) for value, condition in chosen], (0, True))
    back = ToSympy(graph, {"x": x})(FromSympy(graph)(given))
    assert len(back.args) == len(given.args)
    assert all(float(abs((back - given).subs(x, at))) < 1e-14 for at in np.linspace(-1.2, 1.2, 37))


def test_room_is_given_back_and_errors_come_through():
    limit = sys.getrecursionlimit()
    assert with_room(sines(ORDINARY + 40), sys.getrecursionlimit) > limit
    with pytest.raises(KeyError, match="inside"):
        with_room(sines(ORDINARY + 40), lambda: {}["inside"])
    assert sys.getrecursionlimit() == limit
