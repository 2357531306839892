"""Derivatives of the equations at any accelerations and multipliers, against SymPy's, off constraints."""

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.equations.tree import link_table
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.runtime.variations import equation_partials

from ..constraints.test_singular_mass_matrix import SINGULAR
from ..oracles import Lagrange
from ..oracles.arithmetic import compiled
from ..states.mechanisms import servo
from ..support import hand_written
from ..support.generation import model_of, system_for

LIMIT = 1e-12


def partials(system, t, x, v, a, multipliers, u=(), parameters=None):
    """D (n + m, n_arguments)."""
    return equation_partials(system.compiled, t, x, v, a, multipliers, system.prepare(parameters), u)


def by_sympy(model, t, x, v, a, multipliers):
    """D (n + m, n_arguments) of Lagrange's equations, differentiated once more by SymPy, at the model's own values."""
    oracle = Lagrange(model)
    residual, rows, A = oracle._equations()
    n, m = oracle.n, oracle.m
    factors = sympy.symbols(f"factor_:{m}")
    balance = [r + sum(factors[j] * A[j * n + k] for j in range(m)) for k, r in enumerate(residual)]
    plain = list(oracle._plain.values())
    state, inputs, time, accelerations = plain[: 2 * n], plain[2 * n : -n - 1], plain[-n - 1], plain[-n:]
    parameters = [symbol for symbol, _ in model.parameters]
    arguments = [*state, *inputs, *parameters, time]
    entries = [entry.diff(one) for entry in [*balance, *rows] for one in arguments]
    function = compiled([*arguments, *accelerations, *factors], entries, "double")
    own = [*oracle._own[0], *oracle._own[1]]
    return np.array(function(*x, *v, *own, t, *a, *multipliers), dtype=float).reshape(n + m, -1)


@pytest.mark.parametrize("name", ["dual_link", "rolling_disk", "four_bar", "driven_pendulum", *SINGULAR])
def test_models_against_sympy(name):
    """Also where M is singular, so that another matrix is factored: r is that of M."""
    model = SINGULAR[name]() if name in SINGULAR else model_of(name)
    system, random = system_for(model, "lagrange"), np.random.default_rng(4)
    assert system.compiled.augmented == (name in SINGULAR)
    x = system.initial[0] + random.uniform(-0.3, 0.3, system.n)
    v, a, multipliers = (random.normal(size=size) for size in (system.n, system.n, system.m))
    right = by_sympy(model, 0.7, x, v, a, multipliers)
    found = partials(system, 0.7, x, v, a, multipliers, system.compiled.input_defaults)
    size = np.maximum(np.abs(right).max(axis=1, keepdims=True), 1.0)
    assert (np.abs(found - right) / size).max() < LIMIT


def test_rows_of_first_order_states_are_their_rates():
    """r of a state z is zdot less its rate; its value is its velocity."""
    system = system_for(servo())
    names = [*system.coordinates[:1], *system.compiled.coordinates[1:]]
    x, v, a = np.array([0.3, 0.0, 0.0]), np.array([1.1, 0.4, -0.2]), np.array([0.7, 2.0, 3.0])
    given = dict(zip(("theta", "rate", "i", "e", "ref"), (0.3, 1.1, 0.4, -0.2, 0.9), strict=True))
    s = {name: sympy.Symbol(name) for name in given}
    J, K, R, L, kp, ki = (sympy.Symbol(name) for name in ("J", "K", "R", "L", "kp", "ki"))
    r = [J * a[0] + 3 * sympy.sin(s["theta"]) - K * s["i"],
         a[1] - (kp * (s["ref"] - s["theta"]) + ki * s["e"] - R * s["i"] - K * s["rate"]) / L,
         a[2] - (s["ref"] - s["theta"])]  # fmt: skip
    columns = [s["theta"], None, None, s["rate"], s["i"], s["e"], s["ref"], *map(sympy.Symbol, system.parameters), None]
    at = {sympy.Symbol(name): value for name, value in {**given, **system.parameters}.items()}
    right = [[0.0 if one is None else float(row.diff(one).subs(at)) for one in columns] for row in r]
    assert len(names) == 3
    assert partials(system, 0.0, x, v, a, [], [0.9]) == pytest.approx(np.array(right), abs=1e-13)


def hanging():
    """Two links of a tree, and a massless weight whose height follows the tip: M is singular."""
    tree, y = em.Tree(), dynamicsymbols("y")
    one = tree.body("one", None, joint="revolute", axis="y", mass=1.0, center=(0.2, 0, 0), inertia=(0.1, 0.2, 0.2))
    two = tree.body("two", one, joint="spherical", at=(0.5, 0, 0), mass=2.0, center=(0.3, 0, 0.1),
                    inertia=(0.1, 0.3, 0.2))  # fmt: skip
    height = two.position((0.6, 0, 0))[2]
    return em.Model(name="hanging", coordinates=[*tree.coordinates, y], kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy + 3 * y, holonomic_constraints=[y - height])  # fmt: skip


def test_singular_masses_with_trees_in_loops(monkeypatch, tmp_path):
    """As in straight-line code, off the constraints."""
    found, random = [], np.random.default_rng(6)
    n = 5
    x, v, a, factor = (random.uniform(-0.7, 0.7, size) for size in (n, n, n, 1))
    for large in (1000, 1):
        monkeypatch.setattr(link_table, "LARGE", large)
        monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / str(large)))
        system = em.build(hanging(), formulation="lagrange")
        assert system.compiled.augmented
        found.append(partials(system, 0.0, x, v, a, factor))
    assert found[1] == pytest.approx(found[0], abs=1e-12)
    assert np.abs(found[0][:, : 2 * n]).max() > 1.0


def test_models_by_hand_have_none():
    system = hand_written.bead()
    with pytest.raises(RuntimeError, match="bead was written by hand and has no derivatives of its equations"):
        partials(system, 0.0, np.zeros(system.n), np.zeros(system.n), np.zeros(system.n), np.zeros(system.m), [0.0])
