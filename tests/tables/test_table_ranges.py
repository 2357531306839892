"""Ends of a table's range: runs that come to one or start beyond it, and builds that are proved there."""

import numpy as np
import pytest
import scipy.interpolate as si
from sympy import sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import StopReason

from ..support.generation import system_for

x, y = dynamicsymbols("x y")
METHODS = ("dop853", "dopri5", "ra15", "radau9")


def pushed(table: em.Table, argument) -> em.System:
    return system_for(em.Model(name="pushed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                               forces={x: table(argument)}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
def test_a_step_longer_than_the_range_does_not_end_the_run_at_its_other_end(method):
    """A start at the lower end, and a first attempt that goes beyond the upper one."""
    table = em.Table(si.CubicSpline([0.0, 1.0, 2.0], [0.0, 0.0, 0.0]), name="none")
    run = pushed(table, em.t).simulate((0.0, 3.0), v0=[1.0], method=method, first_step=2.9)
    assert run.stop is StopReason.OUTSIDE_TABLE
    assert "table 'none' at 2" in run.message
    assert run.x[0, -1] == pytest.approx(2.0, rel=1e-12)
    backwards = pushed(table, x).simulate((0.0, -3.0), x0=[2.0], v0=[1.0], method=method, first_step=2.9)
    assert "table 'none' at" in backwards.message
    assert backwards.t[-1] == pytest.approx(-2.0, rel=1e-12)


def masses() -> em.System:
    table = em.Table(([0.0, 1.0, 2.0], [1.0, 1.1, 2.0]), name="load")
    return system_for(em.Model(
        name="loads", coordinates=[x, y],
        kinetic_energy=table(x) * (x.diff() ** 2 + y.diff() ** 2 + x.diff() * y.diff() * sin(y)), initial={x: 1.0},
    ), "eigenfactor")  # fmt: skip


def cam() -> em.System:
    """Built with the proof: its random states leave the table's range."""
    table = em.Table(([0.0, 1.0, 2.0], [1.0, 1.1, 2.0]), name="load")
    return em.build(em.Model(name="cam", coordinates=[x, y], kinetic_energy=x.diff() ** 2 + y.diff() ** 2,
                             holonomic_constraints={"cam": y - table(x)}, initial={x: 0.5, y: 1.05}))  # fmt: skip


@pytest.mark.parametrize("made", [masses, cam])
def test_a_start_beyond_the_range_names_the_table(made):
    """It might as well be called singular, or off its constraint by nan."""
    system = made()
    asked = (
        lambda: system.simulate((0, 1), x0=[3.0, 1.0]),
        lambda: system.acceleration([3.0, 1.0], [0.0, 0.0]),
        lambda: system.linearize([3.0, 1.0], [0.0, 0.0]),
        lambda: system.project_initial_state([3.0, 1.0], [0.0, 0.0]),
        lambda: system.stepper(x0=[3.0, 1.0]),
        lambda: system.rhs(0.0, np.concatenate([[3.0, 1.0], system.state([1.0, 1.1], [0.0, 0.0])[2:]])),
    )
    for ask in asked:
        with pytest.raises((em.ModelError, em.EvaluationError), match="table 'load' at 3"):
            ask()
    runs = em.simulate_ensemble(system, (0, 0.1), x0={"x": [0.5, 3.0], "y": [1.05, 1.0]})
    assert runs.success.tolist() == [True, False]
    assert "table 'load' at 3" in runs.message(1)


def test_an_output_beyond_the_range_is_no_number_and_the_run_goes_on():
    table = em.Table(([0.0, 1.0], [0.0, 1.0]), name="load")
    system = system_for(em.Model(name="shown", coordinates=[x], kinetic_energy=x.diff() ** 2,
                                 outputs={"load": table(x)}), "lagrange")  # fmt: skip
    run = system.simulate((0, 2), v0=[1.0], t_eval=[0.5, 1.5])
    assert run.success
    assert run.outputs["load"] == pytest.approx([0.5, np.nan], nan_ok=True)
