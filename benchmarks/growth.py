"""Benchmark of scaling with n: up to which n each formulation is competitive, for a plane chain and a spatial arm.

For each n: states, operations and nanoseconds of one right-hand side, right-hand sides and time of a run to a given
error with dop853, and seconds from the model to the imported module. Errors are the largest along the run, compared
with a run at 1e-13 of another formulation; the span is short enough that a perturbation of the start hardly grows (its
growth is printed too). It prints the tables of docs/report.md, section "Growth with the number of coordinates".
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import numpy as np
from common.counted import timer
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.codegen.model import ModelError

from eigenmotion import Model, System, load_model
from eigenmotion.building.errors import BuildError
from eigenmotion.building.lazy_units import whole
from eigenmotion.building.operation_count import operations_in
from eigenmotion.building.request import request
from eigenmotion.building.shared_library import compile_and_link, load
from eigenmotion.building.toolchain import EXTENSION_SUFFIX, toolchain
from eigenmotion.reference.motion import Reference
from eigenmotion.report.measure import Budget, Judge, Measurement, measure
from eigenmotion.report.recommend import Curve, curves
from eigenmotion.report.solvers import OUR_TOLERANCES, Problem, Track, explicit_solvers

MODELS = Path(__file__).parents[1] / "models"
OTHER = {"lagrange": "cholesky"}
"""The formulation whose run is the reference for errors; lagrange for formulations not listed."""
ERROR, TIGHT, TOLERANCES = 1e-6, 1e-13, OUR_TOLERANCES[:15]
ROWS, ROUNDS, PERTURBATION = 41, 7, 1e-7
PATIENCE = 60.0
"""[s] A formulation whose build takes longer is not built for larger n."""
WORTH = 1.5
"""A formulation is competitive if it takes at most this multiple of the fastest one's time."""


@dataclass(frozen=True)
class Case:
    """A model of n links, the values of n, and the span of the run [s]."""

    file: str
    sizes: tuple[int, ...]
    t_end: float


CASES = (Case("chain", (2, 3, 4, 6, 8, 12, 16, 32), 2.0), Case("spatial_arm", (2, 3, 4, 5, 6, 8, 10), 1.0))


@dataclass(frozen=True)
class Program:
    """A built formulation of a model.

    built : seconds of the build
    operations : of one right-hand side; None if they could not be counted
    nanoseconds : calls -> time of one right-hand side
    """

    system: System
    built: float
    operations: int | None
    nanoseconds: Callable[[int], float]


@dataclass(frozen=True)
class Judges:
    """The judges of each formulation's runs, which compare them with the run of another formulation."""

    by_formulation: Mapping[str, Judge]

    @property
    def reference(self) -> Reference:
        return next(iter(self.by_formulation.values())).reference

    def __call__(self, blank: Measurement, motion: Track) -> Measurement:
        return self.by_formulation[blank.formulation](blank, motion)


def program(model: Model, formulation: str, folder: Path) -> Program:
    """Generate, compile and load a model without the cache; the timer is linked with the same library."""
    start = time.perf_counter()
    sources = request(model, formulation=formulation).sources()
    work = folder / f"{model.name}_{formulation}"
    work.mkdir()
    for file in sources.files:
        (work / file.name).write_text(file.text)
    compile_and_link(work, model.name, toolchain(), whole())
    system = load(work / f"{model.name}{EXTENSION_SUFFIX}")
    built = time.perf_counter() - start
    return Program(system, built, counted(model.name, work), timer(model.name, work))


def counted(name: str, work: Path) -> int | None:
    try:
        return operations_in(name, work)
    except BuildError as error:
        print(f"operations of {work.name} could not be counted: {str(error).splitlines()[0]}", file=sys.stderr)
        return None


def alone(programs: Mapping[str, Program]) -> dict[str, float]:
    """Return the nanoseconds of one right-hand side, called from C: medians of interleaved rounds."""
    calls = {name: 1 + int(2e7 / one.nanoseconds(200)) for name, one in programs.items()}
    rounds = [{name: one.nanoseconds(calls[name]) for name, one in programs.items()} for _ in range(ROUNDS)]
    return {name: median(each[name] for each in rounds) for name in programs}


def tight(system: System, times: np.ndarray, **start: np.ndarray) -> np.ndarray:
    """Return x, v (k, 2n) of a run that is much more accurate than those compared with it."""
    run = system.simulate((0.0, times[-1]), rtol=TIGHT, atol=TIGHT, t_eval=times, **start)
    return np.concatenate([run.x, run.v]).T


def judges(programs: Mapping[str, Program], times: np.ndarray) -> Judges:
    rows = {name: tight(one.system, times) for name, one in programs.items()}
    by_name = {}
    for name, one in programs.items():
        x, v = np.split(rows[OTHER.get(name, "lagrange")], 2, axis=1)
        by_name[name] = Judge(Reference(times, x, v, np.zeros(len(times)), "a tight run"), one.system)
    return Judges(by_name)


def growth(system: System, times: np.ndarray) -> float:
    """Return the largest factor by which a perturbation of the start grows."""
    shift = PERTURBATION * np.random.default_rng(0).choice((-1.0, 1.0), (2, system.n))
    x0, v0 = system.initial
    apart = tight(system, times, x0=x0 + shift[0], v0=v0 + shift[1]) - tight(system, times)
    return float(np.abs(apart[:, : system.n]).max() / PERTURBATION)


def runs(programs: Mapping[str, Program], t_end: float) -> dict[str, Curve]:
    """Return the error, right-hand sides and time of runs over the tolerances, interleaved."""
    solvers = [s for one in programs.values() for s in explicit_solvers(one.system, Problem(t_end, {}), TOLERANCES)]
    chosen = [solver for solver in solvers if solver.method == "dop853"]
    times = np.linspace(0.0, t_end, ROWS)
    measured = measure(chosen, judges(programs, times), Budget(rounds=ROUNDS), lambda _done, _what: None)
    return {curve.formulation: curve for curve in curves(measured)}


def built(model: Model, names: Sequence[str], folder: Path, left_out: dict[str, str]) -> dict[str, Program]:
    """Build the formulations; record in `left_out` those that cannot be built, or are too slow to build."""
    programs = {}
    for name in names:
        try:
            programs[name] = program(model, name, folder)
        except ModelError as error:
            left_out[name] = f"from n = {model.n}: {str(error).partition(';')[0].partition(': ')[2]}"
        else:
            if programs[name].built > PATIENCE:
                left_out[name] = f"above n = {model.n}, which took {programs[name].built:.0f} s to build"
    return programs


def cells(numbers: Mapping[str, float | None], form: str) -> str:
    """Format a number for each formulation, in the order of FORMULATIONS."""
    return " / ".join("-" if numbers.get(name) is None else form.format(numbers[name]) for name in FORMULATIONS)


def row(n: int, programs: Mapping[str, Program], t_end: float) -> dict[str, float | None]:
    """Print a line of the table; return the seconds to ERROR."""
    curve_of = runs(programs, t_end)
    reached = {name: curve.reaching(ERROR) for name, curve in curve_of.items()}
    seconds = {name: curve.seconds_at(ERROR) for name, curve in curve_of.items()}
    parts = (
        str(n),
        cells({name: one.system.n_state for name, one in programs.items()}, "{}"),
        cells({name: one.operations for name, one in programs.items()}, "{}"),
        cells(alone(programs), "{:.0f}"),
        cells({name: points[0].nfev if points else None for name, points in reached.items()}, "{}"),
        cells({name: s and 1e3 * s for name, s in seconds.items()}, "{:.3g}"),
        cells({name: one.built for name, one in programs.items()}, "{:.1f}"),
        f"{growth(programs['lagrange'].system, np.linspace(0.0, t_end, ROWS)):.2g}",
    )
    print(f"| {' | '.join(parts)} |", flush=True)
    return seconds


def conclude(by_n: Mapping[int, Mapping[str, float | None]], left_out: Mapping[str, str]) -> None:
    """Print for which n each formulation is the fastest, and for which it is competitive."""
    times = {n: {name: s for name, s in seconds.items() if s is not None} for n, seconds in by_n.items()}
    quickest = {n: min(seconds, key=seconds.get) for n, seconds in times.items() if seconds}
    print()
    for name in FORMULATIONS:
        first = [n for n, best in quickest.items() if best == name]
        near = [n for n, best in quickest.items() if times[n].get(name, np.inf) <= WORTH * times[n][best]]
        print(f"- `{name}`: {listed('quickest', first)}; {listed(f'within {WORTH:g} times the quickest', near)}"
              + (f"; left out {left_out[name]}" if name in left_out else ""))  # fmt: skip


def listed(what: str, sizes: Sequence[int]) -> str:
    return f"{what} at n = {', '.join(map(str, sizes))}" if sizes else f"nowhere {what}"


def table(case: Case, most: int) -> None:
    print(f"\n`{case.file}`, {case.t_end:g} s; each cell: {' / '.join(FORMULATIONS)}\n")
    to = f"to {ERROR:g}"
    head = ("n", "states", "operations", "ns", f"right-hand sides {to}", f"ms {to}", "s to build", "growth")
    print(f"| {' | '.join(head)} |\n|{' --- |' * len(head)}")
    left_out: dict[str, str] = {}
    by_n = {}
    for n in (size for size in case.sizes if size <= most):
        with tempfile.TemporaryDirectory() as folder:
            names = [name for name in FORMULATIONS if name not in left_out]
            model = load_model(MODELS / f"{case.file}.py", n=n)
            by_n[n] = row(n, built(model, names, Path(folder), left_out), case.t_end)
    conclude(by_n, left_out)


def main() -> None:
    options = argparse.ArgumentParser(description="Up to which n each formulation is worth using.")
    options.add_argument("models", nargs="*", help="chain, spatial_arm; both if none is named")
    options.add_argument("--most", type=int, default=10**9, help="the largest n")
    arguments = options.parse_args()
    for case in CASES:
        if not arguments.models or case.file in arguments.models:
            table(case, arguments.most)


if __name__ == "__main__":
    main()
