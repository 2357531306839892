"""Branches of equilibria in contact: closed forms of where contacts open and close, and where frictions slide."""

from functools import cache

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Model, ModelError, System

from ..analysis.mechanisms_in_contact import block, ladder, leaning
from ..support.generation import system_for

z = dynamicsymbols("z")
m, g, k = symbols("m g k")


@cache
def lowered() -> System:
    """A mass on a spring above a floor, which carries it from m g = k on."""
    return system_for(
        Model(name="lowered_mass", coordinates=[z], kinetic_energy=m * z.diff() ** 2 / 2,
              potential_energy=m * g * z + k * z**2 / 2, parameters={m: 2.0, g: 5.0, k: 40.0},
              contacts={"floor": Contact(z + 1)}), "lagrange")  # fmt: skip


def ends(branch: em.Branch, name: str, at: float, words: str) -> None:
    assert not branch.success
    assert branch.special[-1].kind == "mode change"
    assert branch.special[-1].events == (name,)
    assert branch.special[-1].parameter == pytest.approx(at, abs=1e-8)
    assert branch.parameter[-1] == pytest.approx(at, abs=1e-7)
    assert words in branch.message


def test_a_contact_closes_and_opens():
    hangs = em.find_equilibrium(lowered(), {"z": -0.2})
    branch = em.follow(hangs, "g", to=30.0)
    ends(branch, "floor", 20.0, "contact 'floor' closes: its gap is zero at 20")
    assert branch.x0["z"] == pytest.approx(-branch.parameter / 20.0, abs=1e-9)
    lies = em.find_equilibrium(lowered(), {"z": -1.0}, parameters={"g": 30.0})
    branch = em.follow(lies, "g", to=10.0)
    ends(branch, "floor", 20.0, "contact 'floor' opens: its force is zero at 20")
    assert branch.x0["z"] == pytest.approx(-np.ones(len(branch.parameter)), abs=1e-12)
    assert branch.values.shape[1] == 0
    up = em.follow(lies, "g", to=50.0)
    assert up.success
    assert up.special == ()


def test_what_leans_swings_along_its_wall():
    """The lower pendulum's frequency is that on a support at rest, whatever the wall; it opens below the hinge."""
    branch = em.follow(em.find_equilibrium(leaning(), {"p": 0.4, "q": 0.3}), "wall", to=-0.3)
    ends(branch, "wall", 0.0, "contact 'wall' opens")
    assert branch.x0["p"] == pytest.approx(branch.parameter, abs=1e-10)
    assert np.abs(branch.values) == pytest.approx(np.sqrt(9.81 / 0.6), rel=1e-9)


@pytest.mark.parametrize("contact", [False, True])
def test_a_block_begins_to_slide_on_an_incline(contact):
    rest = em.find_equilibrium(block(contact))
    branch = em.follow(rest, "al", to=0.6, free=["y"] if contact else ["x'"])
    ends(branch, "rub", np.arctan(0.5), "friction 'rub' begins to slide: it is at its limit at 0.463647609")


def test_a_ladder_begins_to_slide():
    """Without friction at the wall it stands up to mu = 1 / (2 tan(p))."""
    rest = em.find_equilibrium(ladder())
    ends(
        em.follow(rest, "mu", to=0.05, free=["y", "p"]), "rub", 1 / (2 * np.tan(1.2)), "friction 'rub' begins to slide"
    )
    with pytest.raises(ModelError, match=r"ladder: the start is one of a family.*While 'rub' sticks"):
        em.follow(rest, "mu", to=0.05)


def test_modes_that_meet_at_the_start():
    with pytest.raises(ModelError, match="contact modes meet at the start: contact 'floor' touches without force"):
        em.follow(em.find_equilibrium(lowered(), {"z": -1.0}, parameters={"g": 20.0}), "g", to=30.0)
