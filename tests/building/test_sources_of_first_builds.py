"""The text generated for first runs: all but its derivatives, which come as something asks for them."""

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion.building.build import cached_sources, first_sources
from eigenmotion.building.lazy_units import ALL_AT_FIRST
from eigenmotion.building.request import request

from ..support.generation import model_of

BEGINS, ENDS = "#if EM_HOLDS(EM_DERIVATIVES)\n\n", "#endif\n#if EM_HOLDS(EM_MODEL)\n"


def without_derivatives(text: str) -> str:
    """All below the stamp but the section of derivatives."""
    body = text.split("\n", 3)[3]
    before, _, rest = body.partition(BEGINS)
    return before + rest.partition(ENDS)[2]


@pytest.mark.parametrize(
    "model", ["dual_link", "rolling_disk", "four_bar", "quaternion_top", "slider_crank", "bouncing_ball"]
)
def test_the_rest_is_the_same_text(model):
    asked = request(model_of(model))
    whole, first = (sources.files for sources in (asked.sources(), asked.sources(whole=False)))
    assert "#error" in first[1].text
    assert "#error" not in whole[1].text
    assert without_derivatives(first[1].text) == without_derivatives(whole[1].text)
    assert all(one.text == two.text for one, two in zip(first, whole, strict=True) if not one.name.endswith(".c"))


@pytest.mark.skipif(ALL_AT_FIRST, reason="there a first run has all")
def test_derivatives_are_generated_as_they_are_asked_for(tmp_path, monkeypatch):
    """Runs need none; a first request makes the whole text, and says nothing of that."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / "cache"))
    system = em.build(model_of("pendulum"), flags="-O0 -DASKED")  # loaded by no other test
    assert system.simulate((0.0, 0.1)).success
    assert len(list((tmp_path / "cache" / "sources").iterdir())) == 1
    assert np.array_equal(system.mass_matrix_gradient([0.3]), np.zeros((1, 1, 1)))
    assert len(list((tmp_path / "cache" / "sources").iterdir())) == 2
    asked = request(model_of("pendulum"))
    assert "state_partials" in cached_sources(asked).files[1].text
    assert "state_partials(double t" not in first_sources(asked).files[1].text
