"""The compass gait of Goswami et al. and its period doublings against another program: equations, strikes and map."""

from functools import cache

import numpy as np
import pytest
from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import System

from ..oracles import compass_walker
from ..support.generation import system_for


@cache
def biped() -> System:
    """Angles theta of the stance leg from the normal of the slope, phi from it to the other leg."""
    theta, phi = dynamicsymbols("theta phi")
    slope = symbols("slope")
    rates = Matrix([theta.diff(), phi.diff()])
    hip = Matrix([-sin(theta), cos(theta)])
    foot = hip - Matrix([sin(phi - theta), cos(phi - theta)])
    down = Matrix([sin(slope), -cos(slope)])
    masses = [(10, hip), (5, hip / 2), (5, (hip + foot) / 2)]

    def moment(parts: list[tuple[int, Matrix]], about: Matrix) -> object:
        arms = [(mass, at - about, at.diff(em.t)) for mass, at in parts]
        return sum(mass * (arm[0] * rate[1] - arm[1] * rate[0]) for mass, arm, rate in arms)

    before = Matrix([moment(masses, foot), moment(masses[1:2], hip)])
    after = Matrix([moment(masses, Matrix([0, 0])), moment(masses[2:], hip)])
    renamed = {theta: theta - phi, phi: -phi}
    struck = after.jacobian(rates).subs(renamed, simultaneous=True).LUsolve(before)
    reset = renamed | dict(zip(rates, struck, strict=True))
    return system_for(em.Model(
        name="goswamis_walker", coordinates=[theta, phi],
        kinetic_energy=sum(Rational(mass, 2) * at.diff(em.t).dot(at.diff(em.t)) for mass, at in masses),
        potential_energy=-Rational(981, 100) * sum(mass * down.dot(at) for mass, at in masses),
        parameters={slope: np.radians(3.0)},
        events={"strike": em.Event(phi - 2 * theta, direction=1, reset=reset)},
    ), "lagrange")  # fmt: skip


def first_gait() -> em.Cycle:
    angle, slope = 0.27, np.radians(3.0)
    return em.find_cycle(biped(), x0={"theta": angle, "phi": 2 * angle}, v0={"theta": -1.1, "phi": -0.72},
                         section="strike", parameters={"slope": slope})  # fmt: skip


def other_start(x0: dict[str, float], v0: dict[str, float], slope: float) -> np.ndarray:
    """Return (s, s', n') of the other program."""
    return np.array([x0["theta"] - slope, v0["theta"], v0["theta"] - v0["phi"]])


def test_a_gait_and_its_multipliers():
    found, slope = first_gait(), np.radians(3.0)
    assert found.success
    near = other_start(found.x0, found.v0, slope)
    start, D = compass_walker.gait(near + np.array([1e-3, -2e-3, 1e-3]), slope, 1)
    assert near == pytest.approx(start, abs=1e-10)
    assert found.period == pytest.approx(compass_walker.walked(start, slope, 1)[1], rel=1e-10)
    order = np.argsort(-np.abs(np.linalg.eigvals(D)))
    assert found.multipliers == pytest.approx(np.linalg.eigvals(D)[order], abs=1e-7)


@pytest.mark.nightly
def test_the_first_three_doublings():
    """Gaits of 1, 2 and 4 steps: the other program finds the same slopes, from starts nearby."""
    branch, steps = em.follow(first_gait(), "slope", to=np.radians(5.1)), 1
    for _ in range(3):
        assert [one.kind for one in branch.special] == ["doubling"]
        at = branch.special[0]
        near = other_start(at.x0, at.v0, at.parameter)
        slope, start = compass_walker.doubling(near + 1e-5, at.parameter - 3e-5, steps)
        assert at.parameter == pytest.approx(slope, abs=1e-9)
        assert near == pytest.approx(start, abs=1e-6)
        branch, steps = em.follow(at, to=np.radians(5.1)), 2 * steps
