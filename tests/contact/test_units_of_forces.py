"""Forces that hold a mode end it at the same time, whatever the units of gaps, slips and forces are."""

import numpy as np
import pytest
from sympy import Rational, cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for

x, y = dynamicsymbols("x y")
unit, push = symbols("unit push", positive=True)

carried = em.Model(
    name="carried", coordinates=[x], kinetic_energy=push * x.diff() ** 2 / 2, potential_energy=push * x**2 / 2,
    contacts={"belt": em.Friction(unit * (x.diff() - 1), limit=push / unit * Rational(3, 4))},
    parameters={unit: 1.0, push: 1.0}, initial={x.diff(): 1.0},
)  # fmt: skip
pressed = em.Model(
    name="pressed", coordinates=[x], kinetic_energy=push * x.diff() ** 2 / 2, forces=[-push * cos(em.t)],
    contacts={"floor": em.Contact(unit * (x - 1))}, parameters={unit: 1.0, push: 1.0}, initial={x: 1.0},
)  # fmt: skip
pulled = em.Model(
    name="pulled", coordinates=[x, y], kinetic_energy=push * (x.diff() ** 2 + y.diff() ** 2) / 2,
    forces=[push * em.t * Rational(3, 5), push * em.t * Rational(4, 5)], parameters={unit: 1.0, push: 1.0},
    contacts={"pad": em.Friction((unit * x.diff(), unit * y.diff()), limit=push / unit * Rational(3, 4))},
)  # fmt: skip
UNITS = [(10.0**p, 10.0**q) for p in (-12, -6, 0, 6, 12) for q in (-6, 0, 6)]


@pytest.mark.parametrize(("model", "right"), [(carried, 0.75), (pressed, np.pi / 2), (pulled, 0.75)],
                         ids=lambda one: getattr(one, "name", None))  # fmt: skip
@pytest.mark.parametrize(("of_row", "of_force"), UNITS)
def test_a_force_lets_go_where_it_reaches_its_limit(model, right, of_row, of_force):
    """A spring's force t has grown to 3/4; the load -cos t changes its sign; a force (3, 4) t / 5 has grown to 3/4."""
    run = system_for(model, "lagrange").simulate(
        (0.0, 2.0), parameters={"unit": of_row, "push": of_force}, rtol=1e-9, atol=1e-9
    )
    assert run.success, run.message
    assert run.t_events[0][:1] == pytest.approx([right], rel=1e-7)
