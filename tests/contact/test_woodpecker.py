"""Glocker's woodpecker: the oracle against what is published, the package against the oracle."""

from functools import cache

import numpy as np
import pytest

from eigenmotion.stability.expectation.woodpecker import ROWS
from eigenmotion.stability.models.contacts import woodpecker

from ..oracles import woodpecker as published
from ..oracles.hybrid import Leg, legs, rows
from ..support.generation import system_for

END = 0.45
"""[s]: three periods, from where the sleeve has jammed."""


@cache
def motion(law: str = "newton") -> list[Leg]:
    return list(legs(published.mechanism(law), *published.start(), END / published.TIME, 0.004))


def what(leg: Leg) -> str:
    """Name a leg by the contacts that are closed in it, and how they rub."""
    names = ("beak", "lower", "upper")
    ways = {
        leg.mode.held[k]: way
        for k, way in enumerate(w for w in leg.mode.ways if not (isinstance(w, str) and w == "free"))
    }
    held = [f"{names[leg.closed[k]]} {'sticks' if isinstance(ways[k], str) else 'slides'}" for k in leg.mode.held]
    return ", ".join(held) or "free"


def test_the_oracle_is_the_published_mechanism():
    M, K, *_ = published.matrices()
    frequencies = np.sqrt(np.abs(np.linalg.eigvals(np.linalg.solve(M, K)))) / (2 * np.pi)
    assert frequencies.max() == pytest.approx(published.FREQUENCY, abs=0.005)
    M = published.mechanism()
    hangs = np.array([0.0, -0.6 / 5.8, -0.2216])  # where it may rest, jammed
    force = M.f - M.K @ hangs
    assert force[2] == pytest.approx(0.0, abs=1e-3 * np.abs(M.f[2]))


def test_the_oracle_goes_through_the_published_events():
    """Slides, lets go; the upper edge strikes, the beak, the upper edge; lets go; the lower edge strikes, jams."""
    names = [what(leg) for leg in motion()]
    cycle = ["lower sticks", "lower slides", "free", "free", "free", "upper slides", "free"]
    assert names[: len(cycle)] == cycle
    assert names[len(cycle) :][:3] in (
        ["free", "lower slides", "lower sticks"],
        ["lower slides", "lower sticks", "lower slides"],
    )
    jams = [leg.t * published.TIME for leg in motion() if what(leg) == "lower sticks"]
    assert np.diff(jams[1:]) == pytest.approx(published.PERIOD, rel=0.01)
    lowest = min(
        leg.at(leg.t + s)[2] for leg in motion()[1:] if what(leg) == "lower sticks" for s in np.linspace(0, 4, 400)
    )
    assert lowest == pytest.approx(published.LOWEST, abs=0.005)


def test_both_laws_agree_where_one_contact_strikes_at_a_time():
    times = np.linspace(0.0, 10.0, 50)
    assert rows(motion("poisson"), times) == pytest.approx(rows(motion(), times), abs=1e-9)


def test_rows_of_the_stability_matrix_are_the_oracles():
    found = rows(motion(), ROWS[:, 0] / published.TIME)
    q, v = found[:, :3] * published.UNITS, found[:, 3:] * published.UNITS / published.TIME
    assert np.abs(np.hstack([q, v]) - ROWS[:, 1:]).max() < 1e-10


@pytest.mark.parametrize("method", ["dop853", "radau9"])
def test_the_package_pecks_as_the_oracle_does(method):
    times = np.linspace(0.0, END, 91)[1:] - 1e-4
    run = system_for(woodpecker(), "lagrange").simulate(
        (0.0, END), method=method, t_eval=times, rtol=1e-10, atol={"y": 1e-13, "phi_M": 1e-11, "phi_S": 1e-11}
    )
    assert run.success, run.message
    right = rows(motion(), times / published.TIME)
    q, v = right[:, :3] * published.UNITS, right[:, 3:] * published.UNITS / published.TIME
    assert np.abs(run.x.T - q).max() < 1e-7
    assert np.abs(run.v.T - v).max() < 1e-5
