"""Equilibria, trim and closed loops, against closed forms; and what cannot be satisfied, said."""

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError
from eigenmotion.runtime import EvaluationError

from ..support.generation import system_for, system_of
from .test_linearize import cart, top


def test_a_load_on_a_spring():
    system = system_of("elastic_pendulum", "lagrange")
    p = system.parameters
    found = em.find_equilibrium(system, {"theta": 0.3})
    assert found.success
    np.testing.assert_allclose(found.x, [0.0, p["L"] + p["m"] * p["g"] / p["k"]], rtol=1e-14)
    assert found.message == "at rest"


def test_parameters_and_inputs_can_be_solved_for():
    """What stiffness holds the load at 1.2, and what force a cart that moves at 2."""
    system = system_of("elastic_pendulum", "lagrange")
    found = em.find_equilibrium(system, {"theta": 0.0, "r": 1.2}, free=["k"])
    assert found.parameters["k"] == pytest.approx(9.81 / 0.2, rel=1e-13)
    assert all(words in found._repr_html_() for words in ("k = 49.05", "r = 1.2, rate 0", found.message))
    moving = em.find_equilibrium(system_for(cart(), "lagrange"), v0={"x": 2.0}, free=["u"])
    assert moving.success
    assert moving.inputs == pytest.approx({"u": 0.6})


def test_units_make_no_difference():
    system = system_of("elastic_pendulum", "lagrange")
    for length in (1e-6, 1e6):
        given = {"L": length, "g": 9.81 * length}
        found = em.find_equilibrium(system, {"theta": 0.3, "r": 1.2 * length}, parameters=given)
        np.testing.assert_allclose(found.x / [1, length], [0.0, 1.0981], rtol=1e-13)


def test_where_there_is_none():
    x = dynamicsymbols("x")
    F = symbols("F", positive=True)
    pushed = em.Model(name="pushed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces=[F], parameters={F: 2.0})
    found = em.find_equilibrium(system_for(pushed, "lagrange"))
    assert not found.success
    assert "x'' = 2" in found.message
    assert not em.find_equilibrium(system_of("driven_pendulum", "lagrange")).success


def test_a_state_passed_through_is_none():
    found = em.find_equilibrium(system_of("pendulum", "lagrange"), {"theta": 0.1}, v0=[1.0])
    assert not found.success
    assert "for an instant only" in found.message


def test_from_where_the_gradient_vanishes():
    """A level pendulum: |a| is largest there, and Newton's method knows no way."""
    system = system_of("pendulum", "lagrange")
    for angle in (np.pi / 2, -np.pi / 2):
        found = em.find_equilibrium(system, [angle])
        assert found.success
        np.testing.assert_allclose(np.sin(found.x), 0.0, atol=1e-15)


@pytest.mark.parametrize("wrong", [{"free": ["q"]}, {"free": []}, {"free": "theta"}, {"free": [0]}, {"constant": ["l"]},
                                   {"x0": {"q": 1.0}}, {"v0": [1.0, 2.0]}, {"parameters": {"m": float("nan")}},
                                   {"inputs": {"u": 1.0}}, {"t": None}])  # fmt: skip
def test_mistakes_of_equilibria_have_names(wrong):
    with pytest.raises(ModelError):
        em.find_equilibrium(system_of("pendulum", "lagrange"), **wrong)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", ["pendulum", "four_bar"])
@pytest.mark.parametrize("angle", [1e13, 1e16, -1e150, 1e300])
def test_an_angle_that_nobody_knows_is_no_rest(name, angle):
    """Small beside |slope| |x| are accelerations of any size there, up to those of a fall."""
    system = system_of(name, "lagrange")
    found = em.find_equilibrium(system, np.full(system.n, angle))
    assert not found.success
    assert "begin nearer to 0" in found.message


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", ["pendulum", "four_bar", "slider_crank"])
@pytest.mark.parametrize("angle", [1e308, -1.7e308])
def test_a_search_that_begins_beyond_all_numbers_is_refused(name, angle):
    system = system_of(name, "lagrange")
    with pytest.raises(ModelError, match=r"not finite where the search begins; .* = 1"):
        em.find_equilibrium(system, np.full(system.n, angle))


@pytest.mark.parametrize("angle", [5e-324, -1e-310, 1e9, -1e9])
def test_rest_is_found_as_near_as_numbers_can_tell(angle):
    found = em.find_equilibrium(system_of("pendulum", "lagrange"), [angle])
    assert found.success
    assert abs(np.sin(found.x[0])) <= max(np.spacing(abs(found.x[0])), 1e-308)


def test_a_length_much_shorter_than_the_guess_is_not_nothing():
    found = em.find_equilibrium(system_of("elastic_pendulum", "lagrange"), {"theta": 0.0, "r": 1e12})
    assert found.success
    assert found.x[1] == pytest.approx(1.0981, rel=1e-12)


# --- closed loops -----------------------------------------------------------------------------------------------------


def loop(x):
    a, b, c, d = 0.4, 1.0, 0.8, 1.0
    q1, q2, q3 = x
    return [a * np.cos(q1) + b * np.cos(q2) - c * np.cos(q3) - d, a * np.sin(q1) + b * np.sin(q2) - c * np.sin(q3)]


@pytest.mark.parametrize("crank", [0.2, 1.0, 2.5, 4.0, 6.0])
def test_a_loop_is_closed_on_either_branch_and_its_rate_kept(crank):
    system, seen = system_of("four_bar", "lagrange"), set()
    for guess in ([0.5, 1.5], [-0.8, -1.8]):
        found = em.assemble(system, [crank, *guess], {"q1": 3.0}, keep=["q1"])
        x, v = found
        assert x[0] == crank
        assert v[0] == 3.0
        np.testing.assert_allclose(loop(x), 0.0, atol=1e-14)
        ahead, behind = (np.array(loop(x + step * v)) for step in (1e-6, -1e-6))
        np.testing.assert_allclose((ahead - behind) / 2e-6, 0.0, atol=1e-8)
        assert found.same_branch == ("model's start" in found.message)
        np.testing.assert_allclose(found.x - found.dx, [crank, *guess])
        seen.add(found.branch)
    assert seen == {-1, 1}


def test_a_loop_that_cannot_be_closed():
    with pytest.raises(ModelError, match=r"cannot be closed: tried .* row 0 by"):
        em.assemble(system_of("four_bar", "lagrange"), parameters={"b": 5.0})
    with pytest.raises(ModelError, match=r"they are off, row 0 by -?0\.\d+\. Look"):  # row 1 can be met
        em.assemble(system_of("four_bar", "lagrange"), [0.0, 0.0, 0.0], keep=["q1", "q2", "q3"])
    with pytest.raises(ModelError, match="with q1, q2, q3 kept"):
        em.assemble(system_of("four_bar", "lagrange"), [1.0, 1.0, 1.0], keep=["q1", "q2", "q3"])
    with pytest.raises(ModelError, match=r"\(q1, q2\) contradict"):
        em.assemble(system_of("four_bar", "lagrange"), v0={"q1": 1.0, "q2": 1.0})
    with pytest.raises(ModelError, match="'q7'"):
        em.assemble(system_of("four_bar", "lagrange"), keep=["q7"])


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(("x0", "v0", "why"), [
    ([1e16, 1e16, 1.0], None, "is so large that"), ([1e308, 0.25, 1.13], None, "is so large that"),
    ([1e150] * 3, [1.0] * 3, "is so large that"), ([-1.7e308] * 3, None, "is so large that|cannot be closed"),
    (None, [-1.7e308] * 3, "contradict the constraints, row 0 by nan|not finite at 'theta'"),
])  # fmt: skip
def test_loops_of_numbers_that_nobody_knows_are_refused(x0, v0, why):
    """phi is off by no more than rounding there, which is as much as the loop is long."""
    system = system_of("slider_crank", "lagrange")
    with pytest.raises(ModelError, match=why):
        em.assemble(system, x0, v0)
    x, v = (start if given is None else given for given, start in zip((x0, v0), system.initial, strict=True))
    with pytest.raises((ModelError, EvaluationError), match=f"{why}|did not bring"):
        system.project_initial_state(x, v)


def test_an_implicit_method_says_what_is_not_finite():
    system = system_of("slider_crank", "lagrange")
    run = system.simulate((0.0, 0.1), v0=[-1.7e308] * 3, method="radau9")
    assert "not finite at coordinate 'theta'" in run.message


def test_a_spin_that_is_asked_for_stays():
    """The projection takes from the spin what the others do not have; assemble does not."""
    system = system_of("rolling_disk", "lagrange")
    _, v = em.assemble(system, {"phi": 0.5}, {"psi": 3.0, "phi": 0.1})
    assert v[4] == 3.0
    assert v[2] == 0.1
    A, b = system.pfaffian(system.start({"phi": 0.5})[0])
    np.testing.assert_allclose(A @ v + b, 0.0, atol=1e-15)


def test_without_constraints_nothing_moves():
    x, v = em.assemble(top(), [0.1, 0.2, 0.3], [1.0, 2.0, 3.0])
    np.testing.assert_array_equal([*x, *v], [0.1, 0.2, 0.3, 1.0, 2.0, 3.0])
