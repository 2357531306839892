"""The stepper is compiled while kernels are written: of the text that the model's file says to it."""

from pathlib import Path

import pytest
from sympy import Piecewise, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.building.request import request
from eigenmotion.building.toolchain import toolchain

PENDULUM = Path(__file__).parents[1] / "models" / "pendulum.py"


@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
@pytest.mark.parametrize("name", ["pendulum", "four_bar", "chain"])
def test_the_stepper_that_is_compiled_ahead_is_the_models(name, formulation):
    """Before kernels are written, of the same text: else it would be compiled twice."""
    told = []
    sources = request(PENDULUM.with_stem(name), formulation=formulation).sources(ahead=told.append)
    ahead, whole = (toolchain().preprocess_unit(text, "stepper") for text in (*told, sources.files[1].text))
    assert ahead == whole


def test_what_is_counted_with_the_kernels_is_not_compiled_ahead():
    """Constants of a model that acts; times at which a condition changes."""
    told = []
    request(PENDULUM.with_stem("bouncing_ball")).sources(ahead=told.append)
    m, g = symbols("m g")
    (q,) = dynamicsymbols("q:1")
    kicked = em.Model(
        name="kicked",
        coordinates=[q],
        kinetic_energy=m * q.diff() ** 2 / 2,
        potential_energy=-g * q * Piecewise((1, em.t < 1), (0, True)),
        parameters={m: 1.0, g: 1.0},
    )
    request(kicked).sources(ahead=told.append)
    assert told == []
