"""Benchmark of robots from files: seconds from a file to its motion, and nanoseconds of an acceleration.

python benchmarks/robot_times.py [FILE.urdf[:floating] ...]

For each URDF file: seconds to read it, to build it with an empty cache and to run its first second, the same again;
then, in rounds, the nanoseconds of an acceleration within a run in C, in a run of an ensemble (per trajectory; runs of
0.5 s and of 5 s), and as a call from Python, each also over the time of Pinocchio's `aba` (C++, called from Python) of
the same file; and those of a call of `System.inverse_dynamics`, over those of `rnea`. Without arguments: a UR5, a
Panda, an ANYmal and a Talos of example-robot-data, if that is there.
"""

from __future__ import annotations

import argparse
import logging
import os
import tempfile
import time
from collections.abc import Callable
from importlib import import_module
from importlib.metadata import PackageNotFoundError, distribution
from importlib.util import find_spec
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

import eigenmotion as em

FILES = (
    "ur_description/urdf/ur5_robot.urdf",
    "panda_description/urdf/panda.urdf",
    "anymal_b_simple_description/robots/anymal.urdf:floating",
    "talos_data/robots/talos_reduced.urdf:floating",
)
ROUNDS, CALLS = 5, 2000


def seconds(action: Callable[[], Any]) -> tuple[float, Any]:
    """Return the seconds of a call, and its result."""
    start = time.perf_counter()
    result = action()
    return time.perf_counter() - start, result


def processor_seconds(action: Callable[[], Any]) -> tuple[float, Any]:
    """Return the processor time of a call, which other processes do not change much, and its result."""
    start = time.process_time()
    result = action()
    return time.process_time() - start, result


def per_call(function: Callable[[], Any]) -> float:
    """Return the nanoseconds of a call from Python."""
    return processor_seconds(lambda: [function() for _ in range(CALLS)])[0] / CALLS * 1e9


def pendulum() -> em.Model:
    """Return the smallest tree: what all models share is compiled with it."""
    tree = em.Tree()
    tree.body("rod", joint="revolute", axis="y", mass=1.0, center=(0, 0, -0.5))
    return em.Model(name="rod", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy)  # fmt: skip


def to_motion(file: Path, base: str) -> tuple[str, em.System]:
    """Return seconds to read, build, run a second, in words, and the system."""
    reading, model = seconds(lambda: em.load_urdf(file, base=base))
    building, system = seconds(lambda: em.build(model, formulation="articulated_body"))
    running, run = seconds(lambda: system.simulate((0.0, 1.0), rtol=1e-6))
    return f"{reading:.2f} + {building:.2f} + {running:.2f} = {reading + building + running:.2f} s" + (
        "" if run.success else f" ({run.message})"
    ), system


def within_a_run(system: em.System) -> float:
    """Return the nanoseconds of a right-hand side within a run, all of it counted."""
    v0 = np.full(system.n, 0.5)  # so that a floating robot, too, needs many steps
    time_of_run, run = processor_seconds(lambda: system.simulate((0.0, 5.0), v0=v0, rtol=1e-9, method="dop853"))
    return time_of_run / run.nfev * 1e9


def in_an_ensemble(system: em.System, span: float, members: int = 64) -> float:
    """Return the nanoseconds of a right-hand side of one member of short or long runs, on one thread."""
    q = system.coordinates[-1]
    starts, v0 = {q: np.linspace(0.01, 0.02, members)}, np.full(system.n, 0.5)
    time_of_all, runs = processor_seconds(
        lambda: em.simulate_ensemble(system, (0.0, span), x0=starts, v0=v0, rtol=1e-8, method="dop853", workers=1)
    )
    return time_of_all / runs.nfev.sum() * 1e9


class Pinocchio:
    """`aba` of a file, at a position away from zero."""

    def __init__(self, file: Path, base: str) -> None:
        self.pin = import_module("pinocchio")
        joint = (self.pin.JointModelFreeFlyer(),) if base == "floating" else ()
        self.model = self.pin.buildModelFromUrdf(str(file), *joint)
        self.data, self.q = self.model.createData(), self.pin.neutral(self.model)
        self.v = np.full(self.model.nv, 0.1)

    def __call__(self) -> None:
        self.pin.aba(self.model, self.data, self.q, self.v, self.v)

    def rnea(self) -> None:
        """Inverse dynamics."""
        self.pin.rnea(self.model, self.data, self.q, self.v, self.v)


def timed(system: em.System, reference: Pinocchio | None) -> str:
    """Return the medians of all rounds, in words."""
    x, v = np.full(system.n, 0.1), np.full(system.n, 0.1)
    kinds: dict[str, Callable[[], float]] = {
        "in C": lambda: within_a_run(system),
        "in lanes": lambda: in_an_ensemble(system, 0.5),
        "in lanes, 5 s": lambda: in_an_ensemble(system, 5.0),
        "from Python": lambda: per_call(lambda: system.acceleration(x, v)),
        "inverse": lambda: per_call(lambda: system.inverse_dynamics(x, v, v)),
    }
    if reference:
        kinds |= {"aba": lambda: per_call(reference), "rnea": lambda: per_call(reference.rnea)}
    rounds = [{name: measure() for name, measure in kinds.items()} for _ in range(ROUNDS)]
    times = {name: median(one[name] for one in rounds) for name in kinds}
    units = {name: times.get("rnea" if name in ("inverse", "rnea") else "aba") for name in times}
    return ", ".join(f"{name} {ns:.0f} ns" + (f" ({ns / unit:.2f})" if (unit := units[name]) else "")
                     for name, ns in times.items())  # fmt: skip


def report(file: Path, base: str) -> None:
    """Print what a file takes."""
    with tempfile.TemporaryDirectory() as cache:
        os.environ["EIGENMOTION_CACHE"] = cache
        em.build(pendulum(), formulation="articulated_body")
        first, _ = to_motion(file, base)
        again, system = to_motion(file, base)
        print(f"{file.name}, {base} base, {system.n} coordinates\n  cold   {first}\n  again  {again}", flush=True)
        print(f"  {timed(system, Pinocchio(file, base) if find_spec('pinocchio') else None)}", flush=True)


def files() -> list[str]:
    """Return the files of example-robot-data, wherever its wheel has put them."""
    try:
        all_files = {str(file): file.locate() for file in distribution("example-robot-data").files or ()}
    except PackageNotFoundError:
        return []
    ends = [name.partition(":") for name in FILES]
    return [f"{path}{colon}{base}" for end, colon, base in ends
            for name, path in all_files.items() if name.endswith(f"/{end}")]  # fmt: skip


def main() -> None:
    """Print all."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("files", nargs="*", help="FILE.urdf, or FILE.urdf:floating")
    logging.disable(logging.WARNING)
    for name in parser.parse_args().files or files():
        path, _, base = name.partition(":")
        report(Path(path), base or "fixed")


if __name__ == "__main__":
    main()
