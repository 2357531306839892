"""The same motion at the same cost, wherever the origin is, and in whatever units, signs, order and time.

What is held constant: the tolerance on each coordinate and velocity, in the frame's units. So runs in other units of
length, mass and row differ by rounding only. A moved origin changes |x| and with it rtol |x|: there, and everywhere
but in other units of time, rtol is nearly nothing and atol decides. The tolerance on a velocity is the number of its
coordinate, which another unit of time makes another tolerance: there atol is nearly nothing, and the first step, at
rest still a matter of atol, is given.
"""

from dataclasses import replace
from functools import cache, cached_property

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.equations.derive import derive

from eigenmotion import Model, ModelError, System

from ..support.generation import FORMULATIONS, choices_for, loaded
from ..support.models_table import BY_NAME, SCENARIOS, Scenario
from .frames import Frame, Run, framed, reordered, seen_from

ORIGINS = (1.0, -0.7, 1.3, 0.4, -1.1)
TOLERANCE, TIMED = (1e-12, 1e-8), (1e-6, 1e-11)  # rtol, atol
NEAR = (0.8, 0.9, 1.1, 1.25)
"""Times a tolerance. One run alone may be off by luck less than what is known of its motion: andrews by 2, 5, 78 and 2
times 1e-6 at 1, 0.9, 1.1 and 1.2 times that of `TIMED`."""
FIRST_STEP = 1e-3
FRAMES = {
    "origins": Frame(origins=ORIGINS),
    "far origins": Frame(origins=10 * np.array(ORIGINS)),
    "small unit of length": Frame(units=1e-6),
    "large unit of length": Frame(units=1e6),
    "small unit of energy": Frame(energy=1e-6),
    "large unit of energy": Frame(energy=1e6),
    "units of rows": Frame(rows=(1e6, 1e-6)),
    "negated": Frame(units=-1.0),
    "some negated": Frame(units=(-1.0, 1.0)),
    "later clock": Frame(clock=64.0),
    "earlier clock": Frame(clock=-0.7),
    "units of each": Frame(units=(1e6, 1e-6, 1e-3)),
}
OTHER_TIMES = {Frame(time=1e-6): 1e-14, Frame(time=1e-3): 1e-11, Frame(time=1e3): 1e-11, Frame(time=1e6): 1e-9}
"""-> atol: above the rounding of velocities that are 0, below rtol of those that are not."""
MEASURED_FROM = {"four_bars_2": {"p1": "q1", "p2": "q1"}}
"""Coordinates that stay at 0, measured from one that does not. A velocity that is 0 is held to atol alone, which
another unit of time makes another tolerance: the couplers of parallelograms were most of the cost, whatever rtol."""
AT_THE_START = {
    "rolling_disk": {"theta": 0.5},
    "furuta_pendulum": {"phi": 0.5, "theta": 0.5},
    "chain_5": {f"theta_{k}": 0.5 for k in range(1, 6)},
}
"""Rates at the start, where a model's own would make another case of another frame. The disk's are those of a steady
motion: a velocity that stays at 0 is off by what atol lets it, which another unit of time changes; and of the
triangular roots of M that of one order of coordinates makes all that is integrated constant, that of another nothing,
which is three times the cost. The chain's and the pendulum's are all 0: first steps, an eighth of the chain's, are a
matter of atol alone; and what they are off grows with the pendulum, which begins upright."""
MOVING = {"origins", "far origins", "units of each"}
AUGMENTED = {"quaternion_top": MOVING, "jansen": MOVING | {"small unit of length", "large unit of length"}}
"""The weights W of M + A^T W A are of the start that a model has when it is compiled, and numbers there: in frames that
move that start its coordinates' numbers are others, and the model is written down and compiled there."""
QUICK = {scene.name: FORMULATIONS[k % len(FORMULATIONS)] for k, scene in enumerate(SCENARIOS)} | {"jansen": "lagrange"}
"""One formulation a model; all of them are the nightly sweep. Jansen's leg is too large for an inverse."""


def measured_from_others(model: Model, others: dict[str, str]) -> Model:
    """A model whose coordinates x are x + other from here on. No forces act on any of them."""
    by_name = {x.name: x for x in model.coordinates}
    start = dict(zip(by_name, model.initial_x, strict=True))
    moved = {by_name[x]: by_name[x] + by_name[other] for x, other in others.items()}
    there = moved | {x.diff(): y.diff() for x, y in moved.items()}
    initial = {by_name[x]: start[x] - start[other] for x, other in others.items()}
    terms = {name: getattr(model, name).xreplace(there) for name in ("kinetic_energy", "potential_energy")}
    rows = [phi.xreplace(there) for phi in model.holonomic_constraints]
    return replace(model, **terms, holonomic_constraints=rows, initial=dict(model.initial) | initial)


def moving(scene: Scenario) -> Model:
    """The model, with a start from which every velocity varies."""
    model = scene.model()
    if scene.name in MEASURED_FROM:
        model = measured_from_others(model, MEASURED_FROM[scene.name])
    rates = {x.diff(): value for x in model.coordinates
             if (value := AT_THE_START.get(scene.name, {}).get(x.name)) is not None}  # fmt: skip
    return replace(model, initial=dict(model.initial) | rates) if rates else model


@cache
def system_in_frames(name: str, formulation: str) -> System:
    return loaded(compiler.generate(framed(moving(BY_NAME[name])), choices_for(name, formulation)), "-O0")


@cache
def system_written_in(frame: str, name: str, formulation: str) -> System:
    model = seen_from(moving(BY_NAME[name]), FRAMES[frame])
    return loaded(compiler.generate(model, choices_for(name, formulation)), "-O0")


def span_of(scene: Scenario) -> float:
    return min(scene.t_end, 2.0)


def differences(system: System, scene: Scenario, frames: dict[str, Frame], method: str = "dop853") -> list[str]:
    """Say which frames change the motion by more than its error, or its cost by more than a quarter."""
    span, tolerance = span_of(scene), TOLERANCE if method == "dop853" else (1e-10, 1e-6)

    def one(frame: str) -> System:
        anew = frame in AUGMENTED.get(scene.name, ())
        return system_written_in(frame, scene.name, system.formulation) if anew else system

    known = Known(system, span, tolerance, method=method)
    runs = {name: frame.run(one(name), span, *tolerance, initial=system.initial, method=method)
            for name, frame in frames.items()}  # fmt: skip
    return [f"{name}: {words}" for name, run in runs.items() if (words := compared(run, known))]


class Known:
    """A run as it is, and how well the motion is known by it, or, asked again, by those at tolerances nearby."""

    def __init__(self, system: System, span: float, tolerance: tuple[float, float], **given) -> None:
        self.run = Frame().run(system, span, *tolerance, **given)
        self._exact = Frame().run(system, span, 1e-13, 1e-13).x
        self._anew = lambda times: Frame().run(system, span, *(times * np.array(tolerance)), **given).x

    def error(self, x: np.ndarray) -> float:
        return np.abs(x - self._exact).max()

    @cached_property
    def errors(self) -> list[float]:
        return [self.error(self.run.x), *(self.error(self._anew(times)) for times in NEAR)]

    def is_within(self, moved: float) -> bool:
        return moved <= 10 * self.error(self.run.x) + 1e-12 or moved <= 10 * max(self.errors) + 1e-12


def compared(run: Run, known: Known) -> str:
    cost, moved = run.solution.nfev / known.run.solution.nfev, np.abs(run.x - known.run.x).max()
    if not run.solution.success:
        return run.solution.message
    if abs(cost - 1) <= 0.25 and known.is_within(moved):
        return ""
    return f"{cost:.3g} times the cost, {moved:.1e} from the motion, which is known to {known.error(known.run.x):.1e}"


def frames_for(formulation: str) -> dict[str, Frame]:
    """All frames; but of eigenfactors only those in which what is factored has the same eigenvalues, and (32) gaps.

    Units of its own each change them (see `scales`).
    """
    changing = {"units of each"}
    return {frame: FRAMES[frame] for frame in FRAMES if formulation != "eigenfactor" or frame not in changing}


@pytest.mark.parametrize(("name", "formulation"), QUICK.items())
def test_another_frame_is_the_same_motion_at_the_same_cost(name, formulation):
    system = system_in_frames(name, formulation)
    assert not differences(system, BY_NAME[name], frames_for(formulation))


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau5"])
@pytest.mark.parametrize("name", ["pendulum", "four_bar"])
def test_the_first_step_from_rest_knows_no_origin(name, method):
    """Where every coordinate starts at 0, its size says nothing of the motion's: the first step was 1e-6 s there."""
    system = system_in_frames(name, QUICK[name])
    frames = [Frame(), Frame(origins=system.initial[0]), *FRAMES.values()]
    given = {"initial": system.initial, "method": method, "max_steps": 1}
    moving = [frame for frame in frames if QUICK[name] != "eigenfactor" or frame is not FRAMES["units of each"]]
    first = [np.ptp(frame.run(system, 2.0, *TOLERANCE, **given).solution.t) for frame in moving]
    np.testing.assert_allclose(first, first[0], rtol=0.02)
    assert first[0] > 1e-4


def test_weights_know_units_of_coordinates_that_start_at_0():
    """Two numbers of the quaternion do. They were taken to be of order 1, in whatever unit."""
    model = seen_from(moving(BY_NAME["quaternion_top"]), FRAMES["units of each"])
    mechanics = derive(model)
    values = {symbol.name: value for symbol, value in model.parameters}
    values |= zip((x.name for x in mechanics.x), model.initial_x, strict=True)
    symbols = (*mechanics.parameters, *mechanics.x, mechanics.time)
    M = np.array(mechanics.factored.subs({s: values.get(s.name, 0.0) for s in symbols}).tolist(), dtype=float)
    size = np.sqrt(M.diagonal())
    assert np.linalg.cond(M / size[:, None] / size) < 100


def test_weights_far_from_their_start_are_named():
    """Coordinates in units of each for a model that was compiled with others."""
    system = system_in_frames("quaternion_top", QUICK["quaternion_top"])
    with pytest.raises(ModelError, match=r"not even along the constraints.*weights of the constraints"):
        FRAMES["units of each"].run(system, 0.1, *TOLERANCE)


def differences_in_time(system: System, scene: Scenario) -> list[str]:
    known = Known(system, scene.t_end, TIMED, first_step=FIRST_STEP)
    runs = {frame.time: frame.run(system, scene.t_end, TIMED[0], least, first_step=FIRST_STEP / frame.time)
            for frame, least in OTHER_TIMES.items()}  # fmt: skip
    return [f"unit of time {time:g}: {words}" for time, run in runs.items() if (words := compared(run, known))]


@pytest.mark.parametrize("name", ["dual_link", "pendulum"])
def test_another_unit_of_time_is_the_same_motion_at_the_same_cost(name):
    assert not differences_in_time(system_in_frames(name, QUICK[name]), BY_NAME[name])


@pytest.mark.parametrize("method", ["radau5", "radau9"])
@pytest.mark.parametrize("name", ["driven_pendulum", "dual_link"])
def test_implicit_methods_see_no_frame_either(name, method):
    system, scene = system_in_frames(name, QUICK[name]), BY_NAME[name]
    frames = {name: frame for name, frame in FRAMES.items() if name in ("origins", "units of each", "units of rows")}
    assert not differences(system, scene, frames, method)


def test_the_order_of_coordinates_is_no_matter():
    assert not differences_in_order(BY_NAME["four_bar"], "cholesky")


def differences_in_order(scene: Scenario, formulation: str) -> str:
    one, other = (loaded(compiler.generate(framed(model), choices_for(scene.name, formulation)), "-O0")
                  for model in (moving(scene), reordered(moving(scene))))  # fmt: skip
    span = span_of(scene)
    run = Frame().run(other, span, *TOLERANCE)
    found = compared(Run(run.solution, run.x[::-1], run.v[::-1]), Known(one, span, TOLERANCE))
    if not found or formulation != "cholesky":
        return found
    cost = cost_at_equal_error(one, other, span)
    return "" if abs(cost - 1) <= 0.25 else f"{found}; {cost:.3g} times the cost at equal error"


def cost_at_equal_error(one: System, other: System, span: float) -> float:
    """Cost over cost of systems with their coordinates in opposite orders, by lines through the logarithms of both.

    The triangular root of M is another matrix in another order, and eta = L^T v other numbers: at one tolerance a step
    may be shorter there, and its error less. What neither tolerance nor luck should change is the cost of an error.
    """
    exact = Frame().run(one, span, 1e-13, 1e-13).x
    runs = [[Frame().run(system, span, TOLERANCE[0], atol) for atol in 10.0 ** np.arange(-10, -3)]
            for system in (one, other)]  # fmt: skip
    cost = np.log([[run.solution.nfev for run in row] for row in runs])
    error = np.log([[np.abs(run.x[::sign] - exact).max() for run in row]
                    for row, sign in zip(runs, (1, -1), strict=True)])  # fmt: skip
    off = error - error.mean(axis=1, keepdims=True)
    slope = (off * cost).sum() / (off * off).sum()
    by_cost, by_error = np.diff(cost.mean(axis=1)), np.diff(error.mean(axis=1))
    return float(np.exp(by_cost - slope * by_error)[0])


# --- the whole sweep: make nightly -----------------------------------------------------------------------------------


@pytest.mark.nightly
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("scene", SCENARIOS, ids=lambda scene: scene.name)
def test_every_model_in_every_frame(scene, formulation):
    system = system_in_frames(scene.name, formulation)
    found = differences(system, scene, frames_for(formulation))
    assert not found + differences_in_time(system, scene)


@pytest.mark.nightly
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("scene", SCENARIOS, ids=lambda scene: scene.name)
def test_every_model_in_another_order(scene, formulation):
    assert not differences_in_order(scene, formulation)


@pytest.mark.nightly
@pytest.mark.parametrize("method", ["radau5", "radau9"])
@pytest.mark.parametrize("scene", SCENARIOS, ids=lambda scene: scene.name)
def test_every_model_in_every_frame_by_implicit_methods(scene, method):
    assert not differences(system_in_frames(scene.name, "lagrange"), scene, FRAMES, method)
