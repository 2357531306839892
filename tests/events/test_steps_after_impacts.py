"""Steps after impacts: a gap that is zero, but for rounding of either sign, shortens none."""

import pytest

from ..support.generation import FORMULATIONS, system_of


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_gap_that_is_rounding_shortens_no_step(formulation: str, method: str):
    """A ball's parabolas have no error: what is rejected is for its gap, of which rounding may be negative."""
    run = system_of("bouncing_ball", formulation).simulate((0.0, 4.0), method=method, rtol=1e-8, atol=1e-8)
    assert run.success
    assert len(run.t_events[0]) == 6
    assert run.nrejected == 0
    assert run.nsteps <= 5 * 7
