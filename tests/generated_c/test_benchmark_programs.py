"""What benchmarks measure: C written by hand for the stepper as it is now, and programs around generated C."""

import sys
from pathlib import Path

import numpy as np
import pytest
from eigenmotion.models import dual_link, pendulum, veering

import eigenmotion as em

sys.path.append(str(Path(__file__).parents[2] / "benchmarks"))
from common.plain import Runner, compiled, generated
from gauges import with_thresholds

HURRIED = "-O1"
MOST_STEPS = 45
"""Of five seconds; the paced gauge takes half as many again where it forgets its pace."""
GAUGES = {
    "wide": ["-DDELTA=3.0"],
    "on axes": ["-DDELTA=1.0", "-DDIAGONALISED=1"],
    "paced": ["-DDELTA=0.0", "-DPACED=0.5"],
}


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize("gap", [0.1, 1.0])
def test_the_smooth_gauge_moves_as_lagrange_does(gauge, gap, tmp_path):
    exact = em.build(veering.model, formulation="lagrange").simulate(
        (0.0, 5.0), parameters={"gap": gap}, rtol=1e-12, atol=1e-12, dense_output=True
    )
    by_hand = Runner.by_hand("veering", "smooth_gauge.c", tmp_path / gauge, *GAUGES[gauge], HURRIED)
    found = by_hand.outcome(5.0, 1e-9, gap)
    assert found.status == 0
    assert 5 < found.nsteps < MOST_STEPS
    assert np.abs(found.x - exact.sol(found.t)[:2].T).max() < 1e-6


@pytest.mark.parametrize("main", ["run.c", "right_hand_side.c", "control.c"])
def test_programs_around_generated_c_compile(main, tmp_path):
    work = generated(pendulum.model, tmp_path / "generated")
    assert compiled(work, "pendulum", ("pendulum.c",), main, HURRIED).exists()


def test_other_thresholds_take_effect(tmp_path):
    generated(dual_link.model, tmp_path / "as it is")
    as_it_is = Runner(compiled(tmp_path / "as it is", "dual_link", ("dual_link.c",), "run.c", HURRIED))
    others = with_thresholds(dual_link.model, tmp_path / "other", 1.0, 1.4, 0.9)
    shares = [one.n_bounded / one.nsteps for one in (way.outcome(2.0, 1e-9) for way in (as_it_is, others))]
    assert shares[0] < 0.5 < shares[1]
