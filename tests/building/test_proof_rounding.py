"""The proof judges by rounding: what cancels is no fault, and what is off by little more than rounding is one."""

import logging
import random
from collections.abc import Iterator

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.compiler import generate
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, System
from eigenmotion.building.verification import ProofError, prove
from eigenmotion.building.verification.arithmetic.evaluate import Evaluation
from eigenmotion.building.verification.arithmetic.hyperdual import from_parts
from eigenmotion.building.verification.arithmetic.rounding_bounds import EPS, FACTOR, Rounded, inverse, root, rounded

from ..support.generation import FORMULATIONS, loaded, system_for
from ..support.random_mechanisms import Maker
from .hard_mechanisms import ZEROS, Hard
from .planted_errors import planted
from .test_proof import EXPRESSIONS, x, y

q, r = dynamicsymbols("q r")
k = sympy.Symbol("k")


def system(model: Model, formulation: str) -> System:
    return loaded(generate(model, Choices(formulation)), "-O0", runs=False)


# -- what cancels is no fault


def test_a_factor_that_vanishes_unexpanded_is_no_fault():
    psi, phi, s = dynamicsymbols("psi phi s")
    length, radius = sympy.symbols("length radius")
    sin, cos = sympy.sin, sympy.cos
    zero = (length * sin(psi) + radius * sin(psi) * sin(phi)) * cos(psi) - (
        length * cos(psi) + radius * sin(phi) * cos(psi)
    ) * sin(psi)
    model = Model(name="zero_factor", coordinates=[psi, phi, s], parameters={length: 0.5, radius: 0.3},
                  kinetic_energy=(psi.diff() ** 2 + phi.diff() ** 2 + s.diff() ** 2) / 2,
                  nonholonomic_constraints=[s.diff() + psi.diff() * zero])  # fmt: skip
    prove(model, system_for(model))


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_accelerations_that_rows_cancel_are_no_fault(formulation):
    """At rest the accelerations by the force and by the rows cancel to rounding; each alone is of size one."""
    rates = q.diff(), r.diff()
    for ratio in (0.7, 1.1, 1.6, 1.9):
        model = Model(name="held", coordinates=[q, r], forces={q: 0.7}, holonomic_constraints=[q, r + ratio * q],
                      kinetic_energy=0.2 * rates[0] ** 2 + 0.85 * (0.4 * rates[0] + rates[1]) ** 2)  # fmt: skip
        prove(model, system(model, formulation))


BY_DAY = tuple(kind + 12 * (kind % 4) for kind in range(12))
"""Each kind once, formulations in turn."""
AT_NIGHT = range(100)


@pytest.mark.parametrize("block", ["day", *(pytest.param(block, marks=pytest.mark.nightly) for block in AT_NIGHT)])
def test_mechanisms_whose_expressions_cancel_are_proved(block):
    for seed in BY_DAY if block == "day" else range(20 * block, 20 * (block + 1)):
        model = Hard(seed).model()
        prove(model, system(model, FORMULATIONS[seed // 12 % 4]))


def test_what_is_rounding_everywhere_is_named(caplog):
    model = Model(name="drowned", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, parameters={k: 1.0},
                  initial={q: 1.0},
                  potential_energy=1e20 * (q * (q + k) - q**2 - q * k) + sympy.cos(q))  # fmt: skip
    with caplog.at_level(logging.INFO):
        prove(model, system_for(model, "lagrange"))
    assert "drowned: not proved: potential_energy has no value, or is all rounding" in caplog.text


# -- what is off by more is one


def least(model: Model, compiled: System, chance: random.Random) -> float | None:
    """Return the least relative error of a subexpression that is noticed; None where not even its sign is."""
    make, noticed = planted(model, chance), None
    for eps in (-2.0, *(10.0**-k for k in range(2, 14))):
        try:
            prove(make(eps), compiled, methods=())
        except ProofError:
            noticed = abs(eps)
        else:
            break
    return noticed


def noticed(seeds: range, each: int) -> Iterator[float]:
    for seed in seeds:
        model = Maker(seed).model()
        compiled = system(model, FORMULATIONS[seed % 4])
        found = (least(model, compiled, random.Random(1000 * seed + k)) for k in range(each))
        yield from (eps for eps in found if eps is not None)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("block", [0, *(pytest.param(block, marks=pytest.mark.nightly) for block in range(1, 11))])
def test_small_errors_of_subexpressions_are_noticed(block):
    """By size, only one in five was at 1e-6 of itself, and half of them at 1e-5."""
    seeds, each = (range(40 * block, 40 * (block + 1)), 6) if block else (range(8), 3)
    found = np.array(list(noticed(seeds, each)))
    assert len(found) > 2 * len(seeds)
    assert np.median(found) <= 1e-10
    assert np.mean(found <= 1e-6 * 1.01) >= 0.97


# -- bounds of rounding


def exact(expression: sympy.Expr, at: dict[sympy.Symbol, float]) -> float:
    return expression.subs({symbol: sympy.Float(value, 60) for symbol, value in at.items()}).evalf(60)


@pytest.mark.parametrize(("expression", "value"), EXPRESSIONS, ids=str)
def test_bounds_hold_and_are_near_rounding(expression, value):
    """Of a value and of its derivative, against sixty digits."""
    found = Evaluation({x: from_parts(np.array(value), 1.0), y: from_parts(np.array(0.9))})(expression)
    at = {x: value, y: 0.9}
    slope = sympy.diff(expression, x).replace(sympy.DiracDelta, lambda *_: sympy.S.Zero)
    for part, right in ((found.a, expression), (found.b, slope)):
        if part is not None and not right.has(sympy.Derivative, sympy.Subs):
            truth = exact(right, at)
            assert abs(sympy.Float(float(part.value), 60) - truth) <= 4 * float(part.bound)
            assert part.bound <= 100 * EPS * max(1.0, abs(truth))


@pytest.mark.parametrize("number", range(len(ZEROS)))
def test_bounds_of_what_vanishes_hold(number):
    expression, random_ = ZEROS[number](), np.random.default_rng(number)
    symbols = sorted(expression.atoms(AppliedUndef, sympy.Symbol), key=str)
    values = {s: from_parts(random_.uniform(-1, 1, 100), random_.uniform(-1, 1, 100)) for s in symbols}
    found = Evaluation(values)(expression)
    for part in (found.a, found.b):
        assert (np.abs(part.value) <= 2 * part.bound).all()
        assert (part.bound <= 1e-12).all()


def test_what_a_kink_decides_by_rounding_is_known_as_far_as_its_sides_agree():
    apart = Evaluation({x: from_parts(np.array([0.3, 1e8]), 1.0)})(sympy.Abs((x + 1) ** 2 - x**2 - 2 * x - 1))
    assert (np.abs(apart.a.value) <= 2 * apart.a.bound).all()
    jumps = Evaluation({x: from_parts(np.array([0.0, 1.0]), 1.0)})(sympy.Piecewise((5, x > 0), (2, True)))
    assert jumps.a.bound[0] >= 3 > 1e-3 > jumps.a.bound[1]
    edge = Evaluation({x: from_parts(np.array(0.3), 1.0)})(sympy.log((x + 1) ** 2 - x**2 - 2 * x - 1 + 1e-15))
    assert not edge.a.bound < 1.0


def test_bounds_of_matrices_hold():
    random_ = np.random.default_rng(3)
    R = random_.normal(size=(50, 4, 4)) * 10.0 ** random_.uniform(-2, 2, (50, 4, 1))
    M = R @ R.swapaxes(1, 2)
    off = Rounded(M, 1e-9 * np.abs(M))
    moved = M * (1 + 1e-9 * np.sign(random_.normal(size=M.shape)))
    moved = np.tril(moved) + np.tril(moved, -1).swapaxes(1, 2)
    for of, right in ((inverse, np.linalg.inv), (root, np.linalg.cholesky)):
        found = of(off)
        known = np.isfinite(found.bound).all(axis=(1, 2))
        assert known.sum() > 10
        assert (np.abs(found.value - right(moved))[known] <= 2 * found.bound[known]).all()
    assert np.isinf(inverse(rounded(np.ones((1, 2, 2)))).bound).all()


def test_a_difference_of_a_few_bounds_is_none():
    assert rounded(np.array(1.0)).near(1.0 + 100 * EPS)
    assert not rounded(np.array(1.0)).near(1.0 + 2 * FACTOR * EPS)


def test_a_sum_in_another_order_is_within_its_bound():
    terms = sympy.symbols("t1:200")
    random_ = np.random.default_rng(0)
    numbers = random_.normal(size=len(terms)) * 10.0 ** random_.uniform(-8, 8, len(terms))
    found = Evaluation({s: from_parts(v) for s, v in zip(terms, numbers, strict=True)})(sympy.Add(*terms)).a
    for _ in range(20):
        assert abs(random_.permutation(numbers).cumsum()[-1] - found.value) < 4 * found.bound


def test_wrong_terms_of_a_start_are_named():
    model = Model(name="right", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=q**2 / 2)
    wrong = Model(
        name="right", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=q**2 * (0.5 + 1e-11)
    )
    with pytest.raises(em.ProofError, match=r"potential_energy is off by .*, where rounding makes"):
        prove(wrong, system_for(model))
