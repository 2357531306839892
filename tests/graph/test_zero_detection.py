"""Zero detection: expressions that vanish identically, and some that only seem to."""

import pytest
import sympy
from eigenmotion.codegen.calculus.identity_test import Zeros
from eigenmotion.codegen.equations.derive import derive
from sympy import Rational, cos, exp, log, sin, sqrt, symbols, tan
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from .expressions import p, x, y, z

u, w = symbols("u w")


@pytest.mark.parametrize(
    "zero",
    [
        sympy.Add(sin(2 * x), -2 * sin(x) * cos(x)),
        sympy.Add(cos(x + y), -cos(x) * cos(y), sin(x) * sin(y)),
        (x + y) ** 2 - x**2 - 2 * x * y - y**2,
        sqrt(x**2 + 2 * x * y + y**2) ** 3 - (x + y) ** 2 * sqrt(x**2 + 2 * x * y + y**2),
        p * (x * y + x * z) / x - p * y - p * z,
    ],
)
def test_what_vanishes_is_seen(bench, zero):
    assert Zeros(bench.graph)(bench.node(zero))


@pytest.mark.parametrize(
    "alive",
    [
        sympy.Float(1e-30) * x,
        1 + sympy.Float(1e-9) * sin(x) - cos(y) ** 2 - sin(y) ** 2,
        sqrt(x**2 + 2 * x * y + y**2) - x - y,
        sympy.Max(0, x - 3),
        sympy.Piecewise((x, x > 5), (0, True)),
        sympy.Heaviside(x - 2),
        exp(-1000 * x),
        1 - sympy.tanh(50 * (x - 5)) ** 2,
        sin(x) - x + x**3 / 6,
    ],
)
def test_what_only_seems_to_vanish_is_kept(bench, alive):
    """Also what is zero, or below rounding, in one part of space only."""
    assert not Zeros(bench.graph)(bench.node(alive))


def test_undefined_is_not_zero(bench):
    assert not Zeros(bench.graph)(bench.node(sympy.acosh(x - 9)))


@pytest.mark.parametrize(
    "alive",
    [
        sqrt(u**2) - u,
        sqrt(u**2) / u - 1,
        1 + sqrt((u - 3) ** 2) / (u - 3),
        sqrt((u - 1000) ** 2) + u - 1000,
        (u**3) ** Rational(1, 3) - u,
        sqrt(u * w) - sqrt(u) * sqrt(w),
        sqrt(u**2 * w**2) - u * w,
        sqrt(2 + 2 * cos(u)) - 2 * cos(u / 2),
        (sqrt(u**2) + u) * (sqrt(w**2) - w),
        sympy.asin(sin(u)) - u,
        sympy.atan(tan(u)) - u,
        sympy.atan(u) + sympy.atan(1 / u) - sympy.pi.evalf() / 2,
        log(u**2) - 2 * log(u),
    ],
)
def test_what_vanishes_for_some_signs_only_is_kept(bench, alive):
    assert not Zeros(bench.graph)(bench.node(alive))


def test_parameters_declared_positive_count_as_such(bench):
    root = bench.node(sqrt(u * w**2) - sqrt(u) * w)
    assert not Zeros(bench.graph)(root)
    assert not Zeros(bench.graph, {"u": 1})(root)
    assert Zeros(bench.graph, {"u": 1, "w": 1})(root)


A, B = dynamicsymbols("A B")
l, r = symbols("l r")


def inertia(factor, at):
    """M_BB of T = 1/2 factor B'^2 + 1/2 A'^2, where A, B, l and r are these."""
    T = (factor * B.diff() ** 2 + A.diff() ** 2) / 2
    M = derive(em.Model(name="one", coordinates=[A, B], kinetic_energy=T, parameters={l: 0.5, r: 0.3})).M
    return float(M[1, 1].subs({symbol: at[symbol.name] for symbol in M.free_symbols}))


@pytest.mark.parametrize("zero", [
    (l * sin(A) + r * sin(A) * sin(B)) * cos(A) - (l * cos(A) + r * sin(B) * cos(A)) * sin(A),
    (l + r * cos(A)) ** 2 + (r * sin(A)) ** 2 - l**2 - 2 * l * r * cos(A) - r**2,
], ids=str)  # fmt: skip
def test_beside_a_root_of_rounding_nothing_counts_as_rounding(zero):
    """Half of the digits of such a root are rounding; all of 2 + root was taken for it, and M was 0."""
    assert inertia(2 + sqrt(zero**2), {"A": 0.3, "B": 0.4, "l": 0.5, "r": 0.3}) == pytest.approx(2)


def test_what_turns_within_a_millionth_varies():
    """M was taken for constant, with the value it has far off."""
    factor = (1 + sympy.Float(1.01e12) * A**2) / (1 + sympy.Float(1e12) * A**2)
    assert inertia(factor, {"A": 0.0}) == pytest.approx(1)
