"""Benchmark of steppers: overhead besides right-hand sides, from Python and in C; worst case of fixed-step methods.

First: 1,000 steps of 10 ms of the Furuta pendulum under a controller in Python, which is timed separately. The overhead
is the time of the steps minus that of as many right-hand sides in C. It can be negative, because a compiler can
optimise a right-hand side together with a step. The motion is compared with that of one run with the same input values.
Then the microseconds of each of a million steps of 1 ms in C (common/control.c): median, 99.9th percentile and maximum,
and the right-hand sides of a step. The maximum occurs when the system interrupts the process.

Last: K environments advanced by 10 ms in one call (`System.steppers`) in one thread, compared with a Python loop over K
single steppers: environments advanced per second of processor time, each with its own start and torque.
"""

from __future__ import annotations

import subprocess
import tempfile
import time
from collections.abc import Callable
from math import cos, sin
from pathlib import Path
from typing import Any

import numpy as np
from common.plain import compiled, generated, right_hand_side
from common.timing import spread

import eigenmotion as em
from eigenmotion.arguments.methods import FIXED

MODELS = Path(__file__).parents[1] / "models"
ROUNDS, COUNT, PERIOD, TOLERANCE = 31, 1000, 0.01, 1e-9
GAINS = np.array([0.083, 1.036, 0.057, 0.105])  # of a linear-quadratic regulator about upright
MILLION = 1_000_000
ENVIRONMENTS = 4096  # the least number of environments advanced between two readings of the clock
STEPPED = (("furuta_pendulum", "lagrange"), ("furuta_pendulum", "eigenfactor"), ("dual_link", "eigenfactor"))


def controller(t: float, x: np.ndarray, v: np.ndarray) -> float:
    """Return the torque that stabilises the rod upright while the arm swings to and fro."""
    return float(GAINS[0] * (x[0] - sin(t)) + GAINS[1] * x[1] + GAINS[2] * (v[0] - cos(t)) + GAINS[3] * v[1])


def controlled(system: em.System, method: str) -> tuple[em.Stepper, list[float], list[np.ndarray], float, float]:
    """Return the stepper at the end, inputs and x of each step, and the seconds of advancing and of the whole loop."""
    stepper = system.stepper(rtol=TOLERANCE, atol=TOLERANCE, method=method)
    applied, on_the_way, advancing, clock = [], [], 0.0, time.perf_counter
    begin = clock()
    for k in range(1, COUNT + 1):
        inputs = {"u": controller(stepper.t, x := stepper.x, stepper.v)}
        on_the_way.append(x)
        start = clock()
        stepper.advance(k * PERIOD, inputs)
        advancing += clock() - start
        applied.append(inputs["u"])
    return stepper, applied, on_the_way, advancing, clock() - begin


def off(system: em.System, applied: list[float], on_the_way: list[np.ndarray], method: str) -> float:
    """Return the largest difference of x from one run with the same inputs."""
    times = np.arange(COUNT) * PERIOD
    run = system.simulate(
        (0.0, COUNT * PERIOD), inputs={"u": em.Signal(times, applied, "hold")}, rtol=TOLERANCE, atol=TOLERANCE,
        method=method, t_eval=times,
    )  # fmt: skip
    return float(np.abs(run.x.T - np.array(on_the_way)).max())


def show_controlled(formulation: str, method: str, folder: Path) -> None:
    model = em.load_model(MODELS / "furuta_pendulum.py")
    system = em.build(model, formulation=formulation)
    rhs = right_hand_side(model, formulation, folder / f"rhs {formulation} {method}")
    advance, besides, whole = [], [], []
    for _ in range(ROUNDS):
        nanoseconds = rhs(200_000)
        stepper, applied, on_the_way, advancing, total = controlled(system, method)
        advance.append(advancing / COUNT)
        besides.append(advance[-1] - 1e-9 * nanoseconds * stepper.nfev / COUNT)
        whole.append(total / COUNT)
    print(f"furuta_pendulum, {formulation}, {method}: {stepper.nfev / COUNT:.1f} right-hand sides a step of {PERIOD} s")
    print(f"  advance            {spread(np.array(advance), 1e-6)} us a step")
    print(f"  besides them       {spread(np.array(besides), 1e-6)} us a step")
    print(f"  with controller    {spread(np.array(whole), 1e-6)} us a step")
    print(f"  off one run by     {off(system, applied, on_the_way, method):.1e}")


def show_fixed(name: str, formulation: str, folder: Path) -> None:
    model = em.load_model(MODELS / f"{name}.py")
    work = generated(model, folder / f"fixed {name} {formulation}", formulation=formulation)
    program = compiled(work, model.name, (f"{model.name}.c",), "control.c")
    for method, about in FIXED.items():
        result = subprocess.run([program, str(about.number), str(MILLION)], capture_output=True, text=True, check=True)
        rhs, median, late, most = map(float, result.stdout.split())
        print(f"  {name}, {formulation}, {method:<9} {rhs:3g}  {median:6.3f}  {late:6.3f}  {most:8.3f}")


def rate(advance: Callable[[int], None], done: int, count: int) -> float:
    """Return the number of environments advanced per second of processor time: the largest of ROUNDS."""
    times, most = max(1, ENVIRONMENTS // count), 0.0
    for _ in range(ROUNDS):
        begin = time.process_time()
        for k in range(done + 1, done + times + 1):
            advance(k)
        most, done = max(most, count * times / (time.process_time() - begin)), done + times
    return most


def show_many(system: em.System, count: int, **options: Any) -> None:
    """Print the rate of `count` environments in one call and in a loop, each with its own start and torque."""
    angles, torques = np.linspace(-3.0, 3.0, count), np.linspace(-0.01, 0.01, count)[:, None]
    many = system.steppers(count, x0={"phi": angles}, workers=1, **options)
    single = [system.stepper(x0={"phi": angle}, **options) for angle in angles]

    def as_one(k: int) -> None:
        many.advance(k * PERIOD, torques)

    def in_a_loop(k: int) -> None:
        for stepper, torque in zip(single, torques[:, 0].tolist(), strict=True):
            stepper.advance(k * PERIOD, {"u": torque})

    for k in range(1, 51):
        as_one(k)
        in_a_loop(k)
    off = max(float(np.abs(many.x[k] - stepper.x).max()) for k, stepper in enumerate(single))
    one, loop = rate(as_one, 50, count), rate(in_a_loop, 50, count)
    rates = f"{one / 1e3:9.0f} {loop / 1e3:9.0f}  {one / loop:5.1f}"
    print(f"  {options['method']:<8} {count:5} {rates}  {many.lanes}  {off:.0e}")


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for formulation, method in (("lagrange", "dop853"), ("lagrange", "dopri5"), ("eigenfactor", "dop853")):
            show_controlled(formulation, method, Path(folder))
        print("steps of 1 ms of fixed-step methods: right-hand sides; microseconds: median, 99.9th percentile, most")
        for name, formulation in STEPPED:
            show_fixed(name, formulation, Path(folder))
    print("K furuta_pendulums by 10 ms: thousands a second as one, in a loop, ratio; lanes; apart after 0.5 s")
    system = em.build(MODELS / "furuta_pendulum.py", formulation="lagrange")
    for options in ({"method": "rk4", "step": 0.005}, {"method": "dop853", "rtol": 1e-6}):
        for count in (1, 64, 1024):
            show_many(system, count, **options)


if __name__ == "__main__":
    main()
