"""Benchmark of method="auto": its time over that of the quickest method at the same error, for 30 models.

Each model is run by "auto" at two tolerances, and by every method at tolerances from 1e-3 to 1e-11. The time that a
method needs for the error of "auto" is interpolated between its runs. Errors are the largest of x at 101 rows relative
to 1 + |x|, compared with a run at 1e-12 or 1e-13. Times are those of the thread, the least of several interleaved runs.

Usage: python benchmarks/automatic_choice.py [NAME ...]
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from importlib import import_module
from itertools import pairwise
from math import exp, inf, log
from time import thread_time
from typing import Any

import numpy as np
from common.timing import interleaved
from stiff import driven, governor, relaxation
from sympy import Integer, Rational, cos, sin, symbols, tanh
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Signal, Solution, build, t
from eigenmotion.arguments.methods import METHODS
from eigenmotion.stability.models.smooth import elastic_link

TOLERANCES = tuple(10.0**-k for k in range(3, 12))
AUTOMATIC = (1e-6, 1e-9)
GOOD, BAD = 1.5, 3.0
MOST_STEPS = 100_000
SAMPLE, ROUNDS = 2e-3, 4


def arm(segments: int = 10, stiffness: float = 2000.0, damping: float = 5.0) -> Model:
    """Return a flexible arm that falls: point masses on links, with springs and dampers in the joints."""
    theta = dynamicsymbols(f"theta_1:{segments + 1}")
    m, l, k, d, g = symbols("m l k d g", positive=True)
    x = y = T = V = Integer(0)
    bends = [angle - before for angle, before in zip(theta, (Integer(0), *theta[:-1]), strict=True)]
    for angle in theta:
        x, y = x + l * cos(angle), y - l * sin(angle)
        T += Rational(1, 2) * m * (x.diff(t) ** 2 + y.diff(t) ** 2)
        V += m * g * y
    moments = [-d * bend.diff(t) for bend in bends]
    forces = {angle: moments[i] - (moments[i + 1] if i + 1 < segments else 0) for i, angle in enumerate(theta)}
    return Model(
        name=f"flexible_arm_{segments}", coordinates=list(theta), kinetic_energy=T,
        potential_energy=V + k * sum(bend**2 for bend in bends) / 2, forces=forces,
        parameters={m: 0.1, l: 0.1, k: stiffness, d: damping, g: 9.81}, initial=dict.fromkeys(theta, 0.0),
    )  # fmt: skip


def bumper() -> Model:
    """Return a mass that flies for a second and then lands on a bumper of strong damping, where it stays."""
    x = dynamicsymbols("x")
    m, g, k, d, w = symbols("m g k d w", positive=True)
    touches = (1 - tanh(x / w)) / 2
    return Model(
        name="bumper", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, potential_energy=m * g * x,
        forces={x: touches * (-k * x - d * x.diff())},
        parameters={m: 1.0, g: 9.81, k: 1e4, d: 1e5, w: 1e-2}, initial={x: 5.0},
    )  # fmt: skip


def brake() -> Model:
    """Return a driven pendulum whose strong damper acts in the first half of the run only."""
    x = dynamicsymbols("x")
    d, T, w = symbols("d T w", positive=True)
    return Model(
        name="released_brake", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=-cos(x),
        forces={x: -d * x.diff() * (1 - tanh((t - T) / w)) / 2 + sin(t)},
        parameters={d: 1e4, T: 20.0, w: 0.1}, initial={x: 1.0},
    )  # fmt: skip


@dataclass(frozen=True)
class Scene:
    """A model, how it is built and run, and whether the reference is a run by a stiff method."""

    name: str
    model: Callable[[], Model]
    t_end: float
    stiff: bool = False
    options: Mapping[str, Any] = field(default_factory=dict)
    formulation: str = "eigenfactor"


def _shipped(name: str) -> Model:
    model = import_module(f"eigenmotion.models.{name}").model
    return model if isinstance(model, Model) else model()


def _of(name: str, t_end: float, **more: Any) -> Scene:
    return Scene(name, partial(_shipped, name), t_end, **more)


_STIFF = {"stiff": True, "formulation": "lagrange"}
_TORQUE = np.linspace(0.0, 10.0, 1001)
SCENES = (
    _of("pendulum", 10.0), _of("double_pendulum", 5.0), _of("dual_link", 5.0), _of("elastic_pendulum", 10.0),
    _of("four_bar", 5.0), _of("furuta_pendulum", 5.0), _of("heavy_top", 5.0), _of("polar_particle", 5.0),
    _of("rigid_body", 10.0), _of("rolling_disk", 5.0), _of("rotating_hoop", 10.0), _of("rotating_spring", 10.0),
    _of("slider_crank", 5.0), _of("chaplygin_sleigh", 5.0), _of("snakeboard", 5.0), _of("driven_pendulum", 5.0),
    _of("veering", 10.0), _of("governor", 5.0, stiff=True), _of("cart_pendulums", 3.0), _of("chain", 2.0),
    _of("quick_return_shaper", 5.0), _of("lugre_oscillator", 5.0), _of("bicycle", 2.0),
    Scene("flexible_arm", arm, 3.0, **_STIFF),
    Scene("softer_arm", partial(arm, 6, 20.0, 0.02), 3.0, **_STIFF),
    Scene("elastic_link", elastic_link, 2.0, options={"parameters": {"k": 1e6, "d": 1e4}, "x0": {"q": 0.01}}, **_STIFF),
    Scene("stiff_governor", governor, 4.0, **_STIFF),
    Scene("relaxation", relaxation, 2000.0, **_STIFF),
    Scene("bumper", bumper, 5.0, **_STIFF),
    Scene("released_brake", brake, 60.0, **_STIFF),
)  # fmt: skip
EXTRA = (
    Scene("driven_link", driven, 10.0, options={"inputs": {"u": Signal(_TORQUE, np.sin(_TORQUE), "linear")}}, **_STIFF),
)
"""Scenes that are run if they are named."""


@dataclass(frozen=True)
class Point:
    """A run: its largest error and its time [s]."""

    error: float
    seconds: float


def measured(scene: Scene) -> tuple[dict[str, list[Point]], dict[float, tuple[Point, Solution]]]:
    """Return the runs by each method; and tolerance -> that by "auto", and its solution."""
    system = build(scene.model(), formulation=scene.formulation)
    options = {"max_steps": MOST_STEPS, **scene.options}
    rows = np.linspace(0.0, scene.t_end, 101)

    def run(method: str, rtol: float, **more: Any) -> Solution:
        return system.simulate((0.0, scene.t_end), method=method, rtol=rtol, atol=rtol, **options, **more)

    exact = run("radau9" if scene.stiff else "dop853", 1e-12 if scene.stiff else 1e-13, t_eval=rows).x

    def error(solution: Solution) -> float:
        if not solution.success or solution.x.shape != exact.shape:
            return inf
        return float((abs(solution.x - exact) / (1 + abs(exact))).max())

    calls: dict[tuple[str, float], Callable[[], Solution]] = {}
    for method in METHODS:
        calls |= {(method, rtol): partial(run, method, rtol) for rtol in TOLERANCES}
    for rtol in AUTOMATIC:
        calls["auto", rtol] = partial(run, "auto", rtol)
    errors = {key: error(run(*key, t_eval=rows)) for key in calls}
    timed = {key: call for key, call in calls.items() if errors[key] < inf}
    seconds = times_of(timed)
    curves = {name: [Point(errors[name, rtol], seconds[name, rtol]) for rtol in TOLERANCES if (name, rtol) in seconds]
              for name in METHODS}  # fmt: skip
    own = {rtol: (Point(errors["auto", rtol], seconds["auto", rtol]), run("auto", rtol)) for rtol in AUTOMATIC}
    return curves, own


def times_of(calls: Mapping[tuple[str, float], Callable[[], Solution]]) -> dict[tuple[str, float], float]:
    """Return the thread's time of each call [s], the least of several; short calls are repeated to fill a sample."""
    counts = {}
    for key, call in calls.items():
        call()
        start = thread_time()
        call()
        counts[key] = max(1, int(SAMPLE / max(thread_time() - start, 1e-6)))

    def repeated(key: tuple[str, float]) -> None:
        for _ in range(counts[key]):
            calls[key]()

    seconds = interleaved({key: partial(repeated, key) for key in calls}, ROUNDS, thread_time)  # type: ignore[arg-type]
    return {key: float(times.min()) / counts[key] for key, times in seconds.items()}


def seconds_at(points: Sequence[Point], error: float) -> float:
    """Return the time to an error, interpolated on the runs that no other beats; inf: it is not reached."""
    best = inf
    front = [p for p in points if not any(q.error <= p.error and q.seconds < p.seconds for q in points)]
    front.sort(key=lambda point: point.error)
    for one, other in pairwise([*front, Point(inf, 0.0)]):
        if one.error <= error < other.error:
            if other.error == inf:
                return one.seconds
            part = log(error / one.error) / log(other.error / one.error) if one.error > 0 else 0.0
            best = min(best, exp((1 - part) * log(one.seconds) + part * log(other.seconds)))
    return best


def line(scene: Scene, curves: Mapping[str, Sequence[Point]], rtol: float, own: tuple[Point, Solution]) -> float:
    """Print one line of the table; return the ratio of "auto"."""
    auto, solution = own
    least, name = min((seconds_at(points, auto.error), name) for name, points in curves.items())
    used = [name for _, name in solution.methods] or [solution.method]
    shown = ", ".join(used[:4]) + ("" if len(used) < 5 else f" ... ({len(used)})")
    ratio = auto.seconds / least if least < inf else float("nan")
    print(f"{scene.name:<22}{rtol:<9.0e}{auto.error:<10.1e}{1e3 * auto.seconds:>9.3f}{ratio:>8.2f}  {name:<9}{shown}",
          flush=True)  # fmt: skip
    return ratio


def main(names: Sequence[str]) -> None:
    """Print the table and its summary."""
    print(f"{'model':<22}{'rtol':<9}{'error':<10}{'ms':>9}{'ratio':>8}  {'best':<9}auto")
    worst = {}
    for scene in (*SCENES, *EXTRA):
        if scene.name not in names if names else scene in EXTRA:
            continue
        curves, own = measured(scene)
        worst[scene.name] = [line(scene, curves, rtol, own[rtol]) for rtol in AUTOMATIC]
    for k, rtol in enumerate(AUTOMATIC):
        ratios = np.array([both[k] for both in worst.values()])
        print(f"\nat {rtol:.0e}: within {GOOD} of the quickest method for {(ratios <= GOOD).sum()} of {len(ratios)} "
              f"models, over {BAD} for {(ratios > BAD).sum()}; median {np.median(ratios):.2f}, "
              f"largest {ratios.max():.2f}")  # fmt: skip


if __name__ == "__main__":
    main(sys.argv[1:])
