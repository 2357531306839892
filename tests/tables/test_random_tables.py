"""Random mechanisms with tables, first-order states and prescribed motions against SciPy's interpolants."""

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline

from ..equations import table_checks
from ..equations.mechanism_checks import Counts
from ..oracles.curves import Curve
from ..support.generation import FORMULATIONS

BY_DAY = 4
"""Seeds, one of each formulation; the others at night, and more by `make fuzz`."""
SEEDS = [*range(BY_DAY), *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(BY_DAY, 20))]


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # NumPy passes through the roots a Piecewise does not choose
@pytest.mark.parametrize("driven", [False, True], ids=["tables", "driven"])
@pytest.mark.parametrize("seed", SEEDS)
def test_motions_outputs_and_jacobians_are_those_of_scipys_curves(seed, driven):
    counts = Counts()
    kind = {"tables": not driven or seed % 2 == 0, "driven": driven}
    table_checks.check(seed, counts, [FORMULATIONS[seed % 4]], "-O0", **kind)
    assert counts.wrong == []
    assert counts.numbers > counts.states > 0


def test_a_curve_below_its_first_knot_has_terms():
    """Where a spline's first knots are there several times; the search for a piece once did not end."""
    curve = Curve(make_interp_spline(np.arange(6.0), np.arange(6.0) ** 2, k=3), "extend", "square")
    assert curve.value((0,), (-2.0,)) == pytest.approx(4.0)
    assert curve.terms((0,), (-2.0,)) == pytest.approx(4.0)
