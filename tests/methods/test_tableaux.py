"""The coefficients of `em_butcher.h` against Butcher's order conditions and SciPy's digits, and Radau's by mpmath."""

import functools
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

import mpmath
import numpy as np
import pytest
from scipy.integrate import RK45
from scipy.integrate._ivp import dop853_coefficients

from eigenmotion.arguments.methods import METHODS

from ..support.stepping import INCLUDE, PENDULUM, RUNGE_KUTTA, Array, Build, Tableau, builder

RADAU = ("radau5", "radau9")
EMBEDDED = {"rk34": (3,), "dopri5": (4,), "dop853": (5, 3)}
DENSE_ORDER = {"rk34": 3, "dopri5": 4, "dop853": 7}
"""Orders in the literature: of the embedded solutions, and of the interpolant."""


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return builder(tmp_path_factory.mktemp("mechanisms"))


Tree = tuple["Tree", ...]


def order_of(tree: Tree) -> int:
    return 1 + sum(map(order_of, tree))


@functools.cache
def trees(order: int) -> tuple[Tree, ...]:
    """All rooted trees of an order: the root's subtrees in sorted order."""

    def forests(size: int, largest: Tree | None) -> Iterator[Tree]:
        if size == 0:
            yield ()
        for part in range(1, size + 1):
            for tree in trees(part):
                if largest is None or (order_of(tree), tree) <= (order_of(largest), largest):
                    yield from ((tree, *rest) for rest in forests(size - part, tree))

    return tuple(forests(order - 1, None))


def density(tree: Tree) -> int:
    return order_of(tree) * math.prod(map(density, tree))


def elementary_weights(tree: Tree, a: Array) -> Array:
    """Phi_i: the product over subtrees of sum_j a_ij Phi_j."""
    weights = np.ones(len(a))
    for part in tree:
        weights = weights * (a @ elementary_weights(part, a))
    return weights


def order_defect(a: Array, b: Array, order: int, theta: float = 1.0) -> float:
    """max |b . Phi(tree) - theta^r / density| over all trees of at most that order (Hairer, Norsett & Wanner, II.2)."""
    return max(
        abs(float(b @ elementary_weights(tree, a)) - theta ** order_of(tree) / density(tree))
        for r in range(1, order + 1)
        for tree in trees(r)
    )


@dataclass(frozen=True, slots=True)
class Coefficients:
    table: Tableau
    c: Array
    a: Array
    e: Array
    d: Array

    @property
    def b(self) -> Array:
        row: Array = self.a[self.table.solution]
        return row


@pytest.fixture(params=RUNGE_KUTTA)
def coefficients(request: pytest.FixtureRequest, build: Build) -> tuple[str, Coefficients]:
    table = build(PENDULUM).library.tableau(METHODS[request.param].number).contents
    arrays = (np.array(getattr(table, name)) for name in "caed")
    return request.param, Coefficients(table, *arrays)


def test_counts_of_rooted_trees() -> None:
    assert [len(trees(r)) for r in range(1, 9)] == [1, 1, 2, 4, 9, 20, 48, 115]


def test_nodes_are_row_sums(coefficients: tuple[str, Coefficients]) -> None:
    _, rk = coefficients
    rows = max(rk.table.stages, rk.table.last_extra + 1)
    np.testing.assert_allclose(rk.a.sum(axis=1)[:rows], rk.c[:rows], atol=2e-14)
    assert rk.b.sum() == pytest.approx(1, abs=1e-15)
    assert rk.c[rk.table.velocity_stage] == 1


def test_order_conditions(coefficients: tuple[str, Coefficients]) -> None:
    method, rk = coefficients
    order = METHODS[method].order
    assert order == rk.table.error_order + 1
    assert order_defect(rk.a, rk.b, order) < 1e-12
    assert order_defect(rk.a, rk.b, order + 1) > 1e-6
    for row, e in zip(EMBEDDED[method], rk.e, strict=False):
        assert order_defect(rk.a, rk.b - e, row) < 1e-12
        assert order_defect(rk.a, rk.b - e, row + 1) > 1e-6


@pytest.mark.parametrize("theta", [0.3, 0.8])
def test_order_conditions_of_the_interpolant(coefficients: tuple[str, Coefficients], theta: float) -> None:
    method, rk = coefficients
    first, last = np.eye(16)[0], np.eye(16)[rk.table.solution]
    rows = [rk.b, first - rk.b, 2 * rk.b - first - last, *rk.d[: rk.table.corrections]]
    weights = np.zeros(16)
    for j in reversed(range(len(rows))):
        weights = (weights + rows[j]) * (theta if j % 2 == 0 else 1 - theta)
    order = DENSE_ORDER[method]
    assert order_defect(rk.a, weights, order, theta) < 1e-12
    assert order_defect(rk.a, weights, order + 1, theta) > 1e-7


def test_methods_whose_dense_output_takes_right_hand_sides_say_so(coefficients: tuple[str, Coefficients]) -> None:
    """Of stages after the last, or at the end of a step that was settled: ensembles count on it."""
    method, rk = coefficients
    assert METHODS[method].dense_calls == (rk.table.last_extra > 0 or rk.table.solution >= rk.table.stages)


def test_every_digit_is_that_of_scipy(build: Build) -> None:
    tables = [build(PENDULUM).library.tableau(method).contents for method in (1, 2)]
    five, eight = (Coefficients(table, *(np.array(getattr(table, name)) for name in "caed")) for table in tables)
    np.testing.assert_array_equal(five.a[:6, :5], RK45.A)
    np.testing.assert_array_equal(five.b[:6], RK45.B)
    np.testing.assert_array_equal(five.e[0, :7], RK45.E)
    np.testing.assert_allclose(five.d[0, :7], RK45.P[:, 3], rtol=1e-15)
    np.testing.assert_array_equal(eight.a, dop853_coefficients.A)
    np.testing.assert_array_equal(eight.c, dop853_coefficients.C)
    np.testing.assert_array_equal(eight.e[:, :13], [dop853_coefficients.E5, dop853_coefficients.E3])
    np.testing.assert_array_equal(eight.d, dop853_coefficients.D)


# --- Radau IIA: em_radau_iia.h, against Radau's polynomials by mpmath ---


@functools.cache
def stated(method: str) -> dict[str, np.ndarray]:
    """Field -> numbers, as em_radau_iia.h states them."""
    text = (INCLUDE / "tableaux/em_radau_iia.h").read_text(encoding="utf-8")
    body = text.partition(f"EM_{method.upper()}_TABLEAU = {{")[2].partition("\n};")[0]
    found = re.findall(r"\.(\w+) = (.*?),\n(?=    \.|\Z)", body + ",\n", re.DOTALL)
    return {name: np.array(eval(value.rstrip(",").replace("{", "[").replace("}", "]"))) for name, value in found}


@pytest.mark.parametrize("method", RADAU)
def test_nodes_are_radau_s_and_stages_collocate(method):
    t, s = stated(method), int(stated(method)["stages"])
    c, a = t["c"], t["a"]
    assert METHODS[method].order == 2 * s - 1
    for node in c:
        assert abs(mpmath.legendre(s, 2 * node - 1) - mpmath.legendre(s - 1, 2 * node - 1)) < 1e-14
    for k in range(1, s + 1):  # C(s)
        np.testing.assert_allclose(a @ c ** (k - 1), c**k / k, atol=2e-16 * s)
    for k in range(1, 2 * s):  # B(2 s - 1), with the last row as weights
        assert a[-1] @ c ** (k - 1) == pytest.approx(1 / k, abs=1e-15)
    assert abs(a[-1] @ c ** (2 * s - 1) - 1 / (2 * s)) > 1e-6


@pytest.mark.parametrize("method", RADAU)
def test_transformation_error_and_polynomial(method):
    t, s = stated(method), int(stated(method)["stages"])
    mu, to, back = (t[name] @ [1, 1j] for name in ("mu", "to", "from"))
    inverse = np.real(np.einsum("pi,p,pj->ij", back, mu, to))
    np.testing.assert_allclose(inverse @ t["a"], np.eye(s), atol=1e-13)
    np.testing.assert_allclose(np.real(back.T @ to), np.eye(s), atol=1e-14)
    assert mu[0].imag == 0 < mu[0].real
    weights, gamma = t["e"] + t["a"][-1], 1 / mu[0].real
    for k in range(1, s + 1):
        assert weights @ t["c"] ** (k - 1) + gamma * (k == 1) == pytest.approx(1 / k, abs=1e-14)
    powers = t["c"][:, None] ** np.arange(1, s + 1)
    np.testing.assert_allclose(powers @ t["powers"], np.eye(s), atol=1e-13)
