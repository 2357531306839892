"""Steps that are made elsewhere: a solver that knows the motion in closed form, and goes all the way in one step."""

from collections.abc import Callable

import numpy as np
import pytest
from sympy import Rational, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, Solution, StopReason, System
from eigenmotion.arguments.options import Task
from eigenmotion.arguments.signals import Signal
from eigenmotion.running.methods import Method
from eigenmotion.running.stiff import simulate_stiff
from eigenmotion.runtime import TOLD, Run

from .generation import system_for

G = 9.81
x, z, u = dynamicsymbols("x z u")
FALLS = Model(
    name="falls", coordinates=[x, z], kinetic_energy=(x.diff() ** 2 + z.diff() ** 2) / 2,
    potential_energy=Rational(981, 100) * z, inputs={u: 0.0},
    events={"waves": sin(20 * x), "floor": Event(z, direction=-1, impact=(z, 1)), "wall": Event(x - 9, terminal=True),
            "pushed": u - 0.5, "also": Event(z, direction=-1, reset={x.diff(): -x.diff()})},
)  # fmt: skip


class Parabola:
    """A free fall, exactly; in one step to the bound."""

    nfev = njev = nlu = 0
    fails = False

    def __init__(self, fun: Callable[[float, np.ndarray], np.ndarray], t0: float, y0: np.ndarray, t_bound: float,
                 **_: object) -> None:  # fmt: skip
        self.fun, self.t, self.y, self.bound, self.status = fun, t0, y0, t_bound, "running"
        self.start = t0, y0

    def at(self, t: np.ndarray) -> np.ndarray:
        since, (x0, z0, vx, vz) = t - self.start[0], self.start[1]
        return np.array([x0 + vx * since, z0 + vz * since - G * since**2 / 2, vx + 0 * since, vz - G * since])

    def step(self) -> None:
        self.status = "failed" if self.fails else "finished"
        self.t, self.y = self.bound, self.at(self.bound)

    def dense_output(self) -> Callable[[np.ndarray], np.ndarray]:
        return self.at


class Stuck(Parabola):
    """One that finds no step."""

    fails = True


def task(x0: list[float], v0: list[float], end: float, **options: object) -> Task:
    system: System = system_for(FALLS, "lagrange")
    inputs = system.bind(options.pop("inputs", None))
    return Task(system.compiled, system.prepare(), inputs, 0.0, end, system.state(x0, v0), 1e-9, np.full(2, 1e-9), None,
                False, 0.0, np.inf, 1000, stabilise=True, least_norm=False)._replace(**options)  # fmt: skip


def told(x0: list[float], v0: list[float], end: float, solver: str = "Parabola", **options: object) -> Solution:
    method = Method("told", order=None, solver=f"{__name__}:{solver}")
    return simulate_stiff(task(x0, v0, end, **options), method)


def test_a_step_is_taken_in_parts_where_events_ask_for_it():
    """Sixty-three of them in one step, of which nine nodes tell nothing."""
    run = told([0.1, 1e3], [1.0, 0.0], 10.0)
    assert run.stop is StopReason.TERMINAL_EVENT
    assert run.t_events[0] == pytest.approx(np.pi / 20 * np.arange(1, 58) - 0.1, rel=1e-13, abs=1e-14)
    assert run.t[-1] == pytest.approx(8.9, rel=1e-14)
    assert run.x[1] == pytest.approx(1e3 - G * run.t**2 / 2, rel=1e-13)


def test_a_solver_begins_anew_where_events_act_all_of_them_at_once():
    run = told([0.1, 1.0], [1.0, 0.0], 3.0, dense=True)
    first = np.sqrt(2 / G)
    struck = first * np.array([1, 3, 5])
    assert run.t_events[1] == pytest.approx(struck, rel=1e-14)
    assert np.array_equal(run.t_events[4], run.t_events[1])
    assert run.sol(0.5)[0] == pytest.approx(0.1 + first - (0.5 - first), rel=1e-14)  # it turned back at the floor
    assert run.energy == pytest.approx(0.5 + G, rel=1e-13)
    assert np.flatnonzero(np.diff(run.t) == 0).size == 3


def test_a_jump_of_an_input_is_an_end_of_a_step():
    run = told([0.1, 1e3], [0.0, 0.0], 2.0, inputs={"u": Signal([0, 0.75, 1.25], [0.0, 1.0, 0.0], "hold")})
    assert list(run.t_events[3]) == [0.75, 1.25]
    assert {0.75, 1.25} <= set(run.t)


def test_what_a_solver_cannot_do_ends_the_run_where_it_was():
    run = told([0.1, 1.0], [1.0, 0.0], 3.0, "Stuck")
    assert (run.stop, run.success, list(run.t)) == (StopReason.STEP_SIZE_UNDERFLOW, False, [0.0])
    assert run.message.startswith("At t = 0: ")


def test_as_many_steps_as_are_allowed():
    run = told([0.1, 1.0], [1.0, 0.0], 3.0, max_steps=2)
    assert (run.stop, run.nsteps) == (StopReason.TOO_MANY_STEPS, 2)


def test_nothing_is_told_to_who_runs_by_himself():
    assert Run(task([0.1, 1.0], [1.0, 0.0], 3.0), TOLD).stop is StopReason.STEP_SIZE_UNDERFLOW
