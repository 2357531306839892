"""`Model.equations()`: matrices that say what the compiled model computes, without anything in common."""

from functools import cache
from importlib.util import find_spec

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.model.tree.functions import BodyFunction
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import model_of, system_of

NAMES = (
    "dual_link", "driven_pendulum", "rotating_spring",
    *(pytest.param(name, marks=pytest.mark.nightly) for name in ("rolling_disk", "slider_crank", "rigid_body")),
)  # fmt: skip


@cache
def equations_of(name):
    return model_of(name).equations()


def numbers(model, part, system, x, v, time):
    """Return one of the matrices in numbers."""
    at = dict(model.parameters)
    at |= dict(zip((q.diff(em.t) for q in model.coordinates), v, strict=True))
    part = part.xreplace(at).xreplace(dict(zip(model.coordinates, x, strict=True))).xreplace({em.t: time})
    return np.array(part.evalf(17).tolist(), dtype=float).reshape(part.shape)


@pytest.mark.parametrize("name", NAMES)
def test_they_are_those_that_are_compiled(name):
    model, system, equations = model_of(name), system_of(name), equations_of(name)
    rng = np.random.default_rng(7)
    x, v, time = rng.uniform(0.2, 1.0, system.n), rng.uniform(-1, 1, system.n), 0.3
    M, bias, A, b, gamma = (numbers(model, part, system, x, v, time) for part in
                            (equations.M, equations.bias, equations.A, equations.b, equations.gamma))  # fmt: skip
    right_A, right_b = system.pfaffian(x, time)
    assert pytest.approx(system.mass_matrix(x, time), rel=1e-12, abs=1e-13) == M
    assert pytest.approx(right_A, rel=1e-12, abs=1e-13) == A
    assert b[:, 0] == pytest.approx(right_b, rel=1e-12, abs=1e-13)
    a, multipliers = system.acceleration(x, v, time)
    scale = 1.0 + np.abs(bias).max()
    assert M @ a + A.T @ multipliers == pytest.approx(bias[:, 0], abs=1e-11 * scale)
    assert A @ a == pytest.approx(-gamma[:, 0], abs=1e-11 * scale)


def test_the_source_makes_the_same_matrices():
    S, E = Symbol("S", positive=True), Symbol("a b")
    q, lam = dynamicsymbols("q lambda")
    model = em.Model(
        name="awkward_names", coordinates=[q, lam], parameters={S: 1.0, E: 2.0},
        kinetic_energy=S * q.diff() ** 2 / 3 + (1.5 + sympy.sin(q)) * lam.diff() ** 2,
        potential_energy=E * sympy.pi * q,
        holonomic_constraints=[q - sympy.Rational(1, 3) * lam**2],
    )  # fmt: skip
    made: dict[str, object] = {}
    exec(model.equations().source(), made)
    for name, part in model.equations().parts.items():
        assert sympy.Matrix(part) == made[name]


def test_free_models_have_no_rows():
    equations = model_of("pendulum").equations()
    assert (equations.A.shape, equations.b.shape, equations.gamma.shape) == ((0, 1), (0, 1), (0, 1))
    assert list(equations.parts) == ["M", "bias"]
    m, l, g = (symbol for symbol, _ in model_of("pendulum").parameters)
    (theta,) = equations.x
    assert equations.M[0] == m * l**2
    assert equations.bias[0] == -g * l * m * sympy.sin(theta)
    assert r"M \ddot{x} &= h" in equations.latex()
    assert "lambda" not in equations.latex()


def test_notebooks_show_them():
    text = equations_of("dual_link")._repr_latex_()
    assert model_of("pendulum")._repr_latex_() == model_of("pendulum").equations()._repr_latex_()
    assert text.startswith("$$")
    assert r"A \ddot{x} + \gamma &= 0" in text
    assert r"\dot{\theta}_{1}" in text


def test_notebooks_show_systems_and_solutions():
    system = system_of("dual_link")
    shown = system._repr_html_()
    assert "{theta1, theta2, theta3}" in shown
    assert all(line in shown for line in ("y[0:4]", "K1 = 1", system.left_out[0]))
    run = system.simulate((0, 0.1))
    runs = em.simulate_ensemble(system, (0.0, 0.1), parameters={"K1": [1.0, 2.0]})
    assert all(words in runs._repr_html_() for words in ("2 runs, 0 failed", "K1: 1 ... 2"))
    shown = run._repr_html_()
    assert run.cost in shown
    assert "data:image/png;base64," in shown or find_spec("matplotlib") is None


def test_functions_of_bodies_are_left_as_they_are(monkeypatch):
    """Expressions in dozens of opaque functions were factored for minutes, and came out as they were."""
    monkeypatch.setattr(sympy, "trigsimp", lambda expression: pytest.fail(f"{expression} is simplified"))
    tree = em.Tree(gravity=(0, 0, -9.81))
    rod = {"joint": "revolute", "axis": "y", "mass": 1.0, "center": (0, 0, -0.5)}
    tree.body("lower", tree.body("upper", **rod), at=(0, 0, -1), **rod)
    found = em.Model(name="two", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     potential_energy=tree.potential_energy).equations()  # fmt: skip
    assert found.M.shape == (2, 2)
    assert all(entry.atoms(BodyFunction) for entry in found.M)
