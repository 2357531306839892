"""Coordinates without mass that constraints hold, in any unit: the same motion at the same cost."""

from functools import cache

import numpy as np
import pytest
from eigenmotion.codegen.equations.derive import derive

from eigenmotion import System

from ..support.generation import FORMULATIONS, system_for
from .quick_return_shaper import Units, closed_form, shaper

UNITS = {
    "as they are": Units(), "lengths of 1e-6": Units(length=1e6), "lengths of 1e6": Units(length=1e-6),
    "masses of 1e-6": Units(mass=1e6), "masses of 1e6": Units(mass=1e-6), "times of 1e-6": Units(time=1e6),
    "times of 1e6": Units(time=1e-6), "all of them": Units(1e-6, 1e6, 1e-3),
}  # fmt: skip
TOLERANCE = 1e-9


@cache
def compiled(formulation: str) -> System:
    return system_for(shaper(), formulation)


def run_in(units: Units, formulation: str, method: str):
    """Two turns of the crank, through 90 and 270 degrees, of what was compiled in metres."""
    x, v = (part[:, 0] for part in closed_form(np.zeros(1), units))
    return compiled(formulation).simulate(
        (0, 2 * units.time), x0=x, v0=v, parameters=units.parameters, method=method, rtol=TOLERANCE, atol=1e-30
    )


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_shaper_turns_twice_in_any_unit(formulation, method):
    steps = []
    for name, units in UNITS.items():
        found = run_in(units, formulation, method)
        assert found.success, f"{name}: {found.message}"
        steps.append(found.nsteps)
        for part, right in zip((found.x, found.v), closed_form(found.t, units), strict=True):
            size = np.abs(right).max(axis=1, keepdims=True)
            np.testing.assert_allclose(part / size, right / size, atol=300 * TOLERANCE, err_msg=name)
    assert max(steps) < 1.25 * min(steps), dict(zip(UNITS, steps, strict=True))


@pytest.mark.parametrize("length", [1e-6, 1e-3, 1e3, 1e6])
def test_a_model_written_in_any_unit_has_weights_of_that_unit(length):
    """They were those of a state half a metre beside the start."""
    units = Units(length=length)
    mechanics = derive(shaper(units))
    values = units.parameters | {"q1": 0.7, "q2": 1.2, "s": 0.3 * length}
    factored = np.array(mechanics.factored.subs({p: values[p.name] for p in (*mechanics.parameters, *mechanics.x)}))
    size = np.sqrt(factored.diagonal().astype(float))
    scaled = factored.astype(float) / size[:, None] / size
    assert np.linalg.cond(scaled) < 100


@pytest.mark.parametrize("length", [1e-3, 1.0, 1e3, 1e6])
@pytest.mark.parametrize("first", [0.0, 1e-17, -2e-31, 1e-310, 5e-324])
def test_a_start_by_eye_is_reached_where_a_row_is_met_but_for_rounding_of_others(length, first):
    """Row 2 says q1 = 0, and its own terms are as small as what the corrections of the others leave of it."""
    units = Units(length=length)
    x, v = compiled("lagrange").project_initial_state([first, 1.25, 0.316 * length], parameters=units.parameters)
    right = closed_form(np.zeros(1), units)
    np.testing.assert_allclose(x[1:], right[0][1:, 0], rtol=1e-14)
    assert abs(x[0]) < 1e-15
    np.testing.assert_allclose(v, right[1][:, 0], atol=1e-13 * max(1.0, length))
