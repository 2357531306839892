"""Derivatives of motions that stay as they are, of every model, against the exponential of the linearised equations."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import block_diag, expm

import eigenmotion as em
from eigenmotion import System
from eigenmotion.analysis.state.operating_point import operating_point as place_of

from ..support.generation import NAMES, system_of

PERIODS, GROWTH, OFF = 10, 1e4, 1e-8
"""So many of the fastest oscillation, or until something has grown by so much; then derivatives are off by this at the
most, relative to the largest."""
IDLE = 1e-6
"""Rates [1 / s] of what does not move at all, but for rounding; such a motion is looked at for ten seconds."""
QUARTER = np.pi / 2


@dataclass(frozen=True)
class Steady:
    """Where a model stays as it is, or goes on as it does.

    x0, asked : of `find_equilibrium`; without `asked` at rest, near the model's start
    turns : (a, b) -> w [rad / s], of pairs of coordinates that turn into each other about 0 as it goes on
    given : the state is x0, v0: what turns so has accelerations, and is none of `find_equilibrium`
    rtol : of the run; less where the motion is never the same, so that its own error is that of what is found
    """

    model: str
    x0: dict[str, float] = field(default_factory=dict)
    asked: dict[str, Any] = field(default_factory=dict)
    turns: dict[tuple[str, str], float] = field(default_factory=dict)
    given: bool = False
    rtol: float = 1e-9

    def found(self, system: System) -> dict[str, Any]:
        """Return x0, v0, parameters, inputs."""
        if self.given:
            x, v = system.start(self.x0, self.asked["v0"])
            return {"x0": x, "v0": v, "parameters": None, "inputs": None}
        place = em.find_equilibrium(system, self.x0, **self.asked)
        assert place.success, place.message
        x, names = place.x.copy(), list(system.coordinates)
        for (a, b), w in self.turns.items():
            x[names.index(a)], x[names.index(b)] = place.v[names.index(b)] / w, -place.v[names.index(a)] / w
        return {"x0": x, "v0": place.v, "parameters": place.parameters, "inputs": place.inputs}

    def turning(self, system: System) -> NDArray[np.float64]:
        """Return G (2 n, 2 n): e^(G t) takes the motion's start, and what is near, to where they are at t."""
        G, names = np.zeros((system.n, system.n)), list(system.coordinates)
        for (a, b), w in self.turns.items():
            G[names.index(a), names.index(b)], G[names.index(b), names.index(a)] = -w, w
        return block_diag(G, G)


def spinning(v0: dict[str, float], *free: str, **more: Any) -> dict[str, Any]:
    return {"v0": v0, "free": list(free), **more}


CIRCLE = 2.5 * np.tan(0.2)
AT_REST = {
    name: Steady(name)
    for name in NAMES
    if name
    not in {
        "cam_follower",
        "clock",
        "driven_pendulum",
        "drone",
        "governor",
        "heavy_top",
        "lugre_oscillator",
        "polar_particle",
        "quadruped",
        "quick_return_shaper",
        "servo_pendulums",
        "sphere",
    }
}
"""Of the others the start is not near a rest, or there is none."""
DRIVEN = {"cam_follower", "lugre_oscillator", "quick_return_shaper", "servo_pendulums"}
"""A motor, a belt or a controller leaves them nowhere at rest."""
UNDERIVED = {"quadruped"}
"""It stands on more feet than it needs, so that `load`, an output of a reaction, has no derivative."""
PLACES = AT_REST | {
    "pendulum_hangs": Steady("pendulum", {"theta": 0.1}),
    "double_pendulum_hangs": Steady("double_pendulum", {"theta1": 0.1, "theta2": 0.1}),
    "clock": Steady("clock", {"theta": 0.0}),  # within the range that friction holds, not at its end, where modes meet
    # two steps a swing, each with errors of some tolerances: ten swings, of which a ten thousandth is left at the end
    "gripper": Steady("gripper", rtol=3e-10),
    "drone": Steady("drone", dict.fromkeys(("yaw", "pitch", "roll", "sway", "heave"), 0.0)),
    # what moves with the time stays nowhere: with a pivot at rest, and on level ground, these do
    "driven_pendulum": Steady("driven_pendulum", {"x": 0.0, "y": -1.0}, {"parameters": {"a": 0.0}}),
    "sphere": Steady("sphere", {}, {"parameters": {"alpha": 0.0}}),
    "governor": Steady("governor", {"a1": 0.0, "a2": 0.0, "s": 1.0}),
    "governor_out": Steady(
        "governor", {"a1": 1.0, "a2": 1.0, "s": 0.5}, spinning({"phi": 2 * np.pi}, "a1", "a2", "s")
    ),
    "governor_in": Steady("governor", {"a1": 0.2, "a2": 0.2}, spinning({"phi": 2 * np.pi}, "a1", "a2", "s")),
    # where a top's axis is upright Euler's angles are singular: quaternions are not
    "heavy_top_slow": Steady("heavy_top", {"theta": 0.6}, spinning({"psi": 40.0}, "phi'")),
    "heavy_top_fast": Steady("heavy_top", {"theta": 0.6}, spinning({"psi": 40.0, "phi": 20.0}, "phi'")),
    "quaternion_top_sleeps": Steady(
        "quaternion_top", {"q_0": 1.0, "q_1": 0.0, "q_2": 0.0, "q_3": 0.0}, {"v0": {"q_2": 0.0, "q_3": 20.0}},
        {("q_0", "q_3"): 20.0, ("q_1", "q_2"): -20.0}, given=True, rtol=1e-11,
    ),
    # a planet at rest is infinitely far away
    "polar_particle": Steady("polar_particle", {"r": 1.0}, spinning({"theta": 1.0}, "theta'")),
    "rigid_body_stable": Steady(
        "rigid_body", {"theta": QUARTER, "phi": QUARTER}, spinning({"psi": 2.0}, "theta", "phi")
    ),
    "rigid_body_tumbles": Steady("rigid_body", {"theta": QUARTER, "phi": 0.0}, spinning({"psi": 2.0}, "theta", "phi")),
    "rotating_hoop_out": Steady("rotating_hoop", {"theta": 1.0}),
    "spatial_arm_turns": Steady("spatial_arm", {}, spinning({"q_1": 1.0}, "q_2", "q_3")),
    "rolling_disk_straight": Steady("rolling_disk", {"theta": 0.0}, spinning({"x": 3.0, "psi": 6.0}, "theta")),
    "rolling_disk_circle": Steady(
        "rolling_disk", {"theta": 0.3}, spinning({"x": 3.0, "phi": 1.0, "psi": 6.0}, "psi'", "x'",
                                                 constant=["phi", "theta", "psi"]), {("x", "y"): 1.0},
    ),
    "bicycle_straight": Steady(
        "bicycle", {}, spinning({"x": 4.6, "spin_r": 4.6 / 0.3, "spin_f": 4.6 / 0.35}, "phi", "delta", "theta")
    ),
    "chaplygin_sleigh_pulled": Steady("chaplygin_sleigh", {}, spinning({"x": 1.0}, "theta")),
    "chaplygin_sleigh_pushed": Steady("chaplygin_sleigh", {}, spinning({"x": -1.0}, "theta")),
    "snakeboard_straight": Steady("snakeboard", {"phi": 0.0}, spinning({"x": 0.5, "psi": 3.0}, "theta'")),
    "snakeboard_circle": Steady(
        "snakeboard", {"phi": 0.2}, spinning({"x": 0.5, "psi": 3.0}, "theta'", constant=["theta", "psi", "phi"]),
        {("x", "y"): CIRCLE},
    ),
}  # fmt: skip
BY_DAY = {"pendulum", "pendulum_hangs", "elastic_pendulum", "chain", "slider_crank", "heavy_top_slow", "clock",
          "quaternion_top_sleeps", "rigid_body_stable", "rolling_disk_circle"}  # fmt: skip


def span(values: NDArray[np.complex128]) -> float:
    """Return for how long to look at a motion with such eigenvalues."""
    growth, swing = values.real.max(initial=0.0), np.abs(values.imag).max(initial=0.0)
    fastest = swing if swing > IDLE else np.abs(values).max(initial=0.0)
    end = 2 * np.pi * PERIODS / fastest if fastest > IDLE else 10.0
    return min(end, np.log(GROWTH) / growth) if growth > IDLE else end


def off_the_exponential(steady: Steady) -> tuple[float, float]:
    """Return by how much derivatives by the whole start are off at the end, and the largest of them.

    In axes that turn with the motion its equations of variation are those at the start, A - G, and their exponential,
    of directions along which the constraints stay satisfied, is turned back: e^(G t) Z e^(Z' (A - G) Z t) Z'.
    """
    system = system_of(steady.model, "lagrange")
    given, G = steady.found(system), steady.turning(system)
    linear = system.linearize(given["x0"], given["v0"], 0.0, given["parameters"], given["inputs"])
    assert linear.steady or steady.turns
    end, Z = span(linear.eigenvalues()), linear.Z
    names = [*system.coordinates, *(f"{one}'" for one in system.coordinates)]
    run = system.simulate((0.0, end), **given, rtol=steady.rtol, atol=1e-3 * steady.rtol, sensitivities=names)
    assert run.success, run.message
    begin, found = (np.array([np.concatenate([one.dx[:, row], one.dv[:, row]]) for one in run.sensitivity.values()]).T
                    for row in (0, -1))  # fmt: skip
    right = expm(end * G) @ Z @ expm(end * Z.T @ (linear.full.A - G) @ Z) @ Z.T @ begin
    return float(np.abs(found - right).max()), float(np.abs(right).max())


def test_no_model_is_left_out():
    assert {one.model for one in PLACES.values()} | DRIVEN | UNDERIVED == set(NAMES)


@pytest.mark.parametrize("place", [
    name if name in BY_DAY else pytest.param(name, marks=pytest.mark.nightly) for name in PLACES
])  # fmt: skip
def test_derivatives_are_the_exponential_of_the_linear_motion(place):
    off, largest = off_the_exponential(PLACES[place])
    assert off <= OFF * largest


@pytest.mark.parametrize("place", [
    name if name in {"snakeboard_circle", "pendulum_hangs"} else pytest.param(name, marks=pytest.mark.nightly)
    for name in ("pendulum_hangs", "elastic_pendulum", "snakeboard", "snakeboard_circle", "rolling_disk_circle",
                 "rigid_body_tumbles", "bicycle")
])  # fmt: skip
def test_by_parameters_they_are_that_of_the_linear_motion_pushed(place):
    """With a column more: d/dt (z, 1) = [[A - G, b], [0, 0]] (z, 1), b = (0, da/dp). Most of these are nothing but
    rounding: what stays has parameters that do not count. A run may
    swing within its tolerances about where it rests, and a swing's time changes: so these are tight."""
    steady = PLACES[place]
    system = system_of(steady.model, "lagrange")
    given, G = steady.found(system), steady.turning(system)
    at = place_of(system, given["x0"], given["v0"], 0.0, given["parameters"], given["inputs"])
    end = span(system.linearize(at.x, at.v, 0.0, given["parameters"], given["inputs"]).eigenvalues())
    names, n = list(system.parameters), system.n
    first = 2 * n + len(system.inputs)
    run = system.simulate((0.0, end), **given, rtol=1e-11, atol=1e-12, sensitivities=names)
    for k, name in enumerate(names):
        begin, found = (np.concatenate([run.sensitivity[name].dx[:, row], run.sensitivity[name].dv[:, row]])
                        for row in (0, -1))  # fmt: skip
        pushed = np.zeros((2 * n + 1, 2 * n + 1))
        pushed[:-1, :-1], pushed[n:-1, -1] = at.jacobian - G, at.motion[2][:, first + k]
        right = expm(end * G) @ (expm(end * pushed) @ np.append(begin, 1.0))[:-1]
        assert np.abs(found - right).max() <= OFF * max(np.abs(right).max(), 1.0)
