"""Ways to turn C where eigenvalues come close, in the real stepper: right-hand sides, error and run time.

On `models/veering.py`, ten passages, dop853, everything in C. Beside what eigenmotion generates stands a gauge that
turns smoothly, Omega_ij = mu_ij g / (g^2 + delta^2) with Lambda = C M C^T = L L^T in every right-hand side, written by
hand (common/smooth_gauge.c); and `bounded` with other thresholds. Prints the tables of docs/theory.md, "Close
eigenvalues".
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from common.plain import Runner, compiled, generated
from eigenmotion.models import dual_link, veering
from veering import GAPS, TOLERANCES, choices, exactly

import eigenmotion as em
from eigenmotion.building.toolchain import INCLUDE

GENERATED = {
    "cholesky": {"formulation": "cholesky"},
    "bounded": {},
    "extrapolate": {"close_eigenvalues": "extrapolate"},
}
SMOOTH = {
    "smooth 3": ("-DDELTA=3.0",),
    "smooth 1": ("-DDELTA=1.0",),
    "smooth 0.3": ("-DDELTA=0.3",),
    "smooth 0.1": ("-DDELTA=0.1",),
    "smooth 1, on axes": ("-DDELTA=1.0", "-DDIAGONALISED=1"),
    "smooth, paced": ("-DDELTA=0.0", "-DPACED=0.5"),
}
HEADER = "em_takeover.h"
THRESHOLDS = ((1.0, 1.4, 0.2), (1.0, 1.4, 0.4), (1.0, 1.4, 0.9), (0.5, 0.7, 0.5), (0.5, 1.0, 0.9))
"""Others than those of the header: EM_NEAR, EM_FAR, EM_APART."""
APART = 1.0
"""A gap at which no two eigenvalues are close: what a gauge costs where it is not needed."""
LADDER = tuple(10.0 ** -(k / 2) for k in range(8, 25))
"""Tolerances 1e-4 ... 1e-12, from which the time at an error is read."""
ERRORS = (1e-5, 1e-7, 1e-9)
ROUNDS, LONG_ENOUGH = 15, 1.5e6
"""Interleaved rounds; nanoseconds that one timing should take."""


@dataclass(frozen=True, slots=True)
class Found:
    """One way at one gap and tolerance. nanoseconds: of a run, beside lagrange's in the same rounds."""

    nfev: int
    error: float
    n_bounded: float
    nanoseconds: float


Measured = dict[tuple[float, float], dict[str, Found]]
"""By gap and tolerance, then by name."""


# --- the ways ---------------------------------------------------------------------------------------------------------


def with_thresholds(model: em.Model, work: Path, near: float, far: float, apart: float) -> Runner:
    """Compile `bounded` with other numbers than the header's."""
    generated(model, work)
    shutil.copytree(INCLUDE, work, dirs_exist_ok=True)  # headers find each other where they are themselves
    lines = (INCLUDE / HEADER).read_text().splitlines()
    for name, value in (("EM_NEAR", near), ("EM_FAR", far), ("EM_APART", apart)):
        (at,) = (k for k, line in enumerate(lines) if line.startswith(f"#define {name} "))
        lines[at] = f"#define {name} {value}"
    (work / HEADER).write_text("\n".join(lines) + "\n")
    return Runner(compiled(work, model.name, (f"{model.name}.c",), "run.c"))


def of_generator(model: em.Model, folder: Path) -> dict[str, Runner]:
    """Compile what eigenmotion generates, lagrange among it, and `bounded` with each of the other thresholds."""
    options = GENERATED | {"lagrange": {"formulation": "lagrange"}}
    made = {name: Runner.of_model(model, folder / f"{model.name} {name}", **one) for name, one in options.items()}
    return made | {str(one): with_thresholds(model, folder / f"{model.name} {one}", *one) for one in THRESHOLDS}


def by_hand(folder: Path) -> dict[str, Runner]:
    return {name: Runner.by_hand("veering", "smooth_gauge.c", folder / name, *flags) for name, flags in SMOOTH.items()}


# --- what is measured -------------------------------------------------------------------------------------------------


def timed(ways: Mapping[str, Runner], *at: float) -> dict[str, float]:
    """Return nanoseconds a run: the median over the rounds of its ratio to lagrange's, times lagrange's median."""
    runs = {name: max(1, int(LONG_ENOUGH / way.nanoseconds(10, *at))) for name, way in ways.items()}
    times = {name: np.empty(ROUNDS) for name in ways}
    for k in range(ROUNDS):
        for name, way in ways.items():
            times[name][k] = way.nanoseconds(runs[name], *at)
    base = times["lagrange"]
    return {name: float(np.median(one / base) * np.median(base)) for name, one in times.items()}


def measured(
    ways: Mapping[str, Runner], exact: em.Solution, t_end: float, tolerance: float, gap: float
) -> dict[str, Found]:
    """Run every way, and time them; a way that stopped is left out."""
    at = (t_end, tolerance, gap)
    outcomes = {name: way.outcome(*at) for name, way in ways.items()}
    outcomes = {name: one for name, one in outcomes.items() if one.status == 0}
    times = timed({name: ways[name] for name in outcomes}, *at)
    return {
        name: Found(one.nfev, np.abs(one.x - exact.sol(one.t)[:2].T).max(), one.n_bounded / one.nsteps, times[name])
        for name, one in outcomes.items()
    }


def time_at(error: float, found: Sequence[Found]) -> float:
    """Return nanoseconds at an error: by a parabola through log error, log time; infinite where no run is as good."""
    if min(one.error for one in found) > error:
        return np.inf
    errors = np.log([one.error for one in found])
    times = np.log([one.nanoseconds for one in found])
    return float(np.exp(np.polyval(np.polyfit(errors, times, 2), np.log(error))))


def ladder(every: Measured, gap: float, name: str) -> list[Found]:
    return [every[gap, tolerance][name] for tolerance in LADDER if name in every[gap, tolerance]]


def over_lagrange(every: Measured, name: str, error: float, gaps: Sequence[float]) -> str:
    """Return the geometric mean over the gaps at which the error is reached, with the largest, and how many are not."""
    times = np.array([[time_at(error, ladder(every, gap, one)) for one in (name, "lagrange")] for gap in gaps])
    ratios = times[:, 0] / times[:, 1]
    reached = ratios[np.isfinite(ratios)]
    missed = f", {len(gaps) - len(reached)} not" if len(reached) < len(gaps) else ""
    largest = f" ({reached.max():.2f})" if len(gaps) > 1 else ""
    return f"{np.exp(np.log(reached).mean()):.2f}{largest}{missed}"


# --- the tables -------------------------------------------------------------------------------------------------------


def table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    print(f"\n{title}\n")
    for cells in (head, ["---"] * len(head), *rows):
        print("| " + " | ".join(cells) + " |")


def passages(every: Measured) -> None:
    names = (*GENERATED, *SMOOTH)
    rows = []
    for rtol in TOLERANCES:
        for gap in (*GAPS, APART):
            found = every[gap, rtol]
            share = f"{found['bounded'].n_bounded:.0%}"
            cells = [cell(found.get(name), found["lagrange"]) for name in names]
            rows.append([f"{rtol:.0e}", f"{gap:.0e}", *cells, share])
    title = "right-hand sides, largest error at accepted steps, run time, each over lagrange's"
    table(title, ["rtol", "gap", *names, "bounded steps"], rows)


def cell(found: Found | None, base: Found) -> str:
    if found is None:
        return "stopped"
    time = found.nanoseconds / base.nanoseconds
    return f"{found.nfev / base.nfev:.2f}, {found.error / base.error:.2g}, {time:.2f}"


def at_equal_error(every: Measured) -> None:
    names = (*GENERATED, *SMOOTH)
    rows = [
        [f"{error:.0e}", title, *(over_lagrange(every, name, error, gaps) for name in names)]
        for error in ERRORS
        for title, gaps in (("to 1e-1", GAPS), ("1", (APART,)))
    ]
    title = "run time at equal error, over lagrange's: geometric mean over the gaps, largest in brackets"
    table(title, ["error", "gaps", *names], rows)


def thresholds(every: Measured, paper: Mapping[str, Runner]) -> None:
    """Print what other thresholds of `bounded` change here, and on the paper's scene, 10 s at rtol 1e-9."""
    times, rows = timed(paper, 10.0, 1e-9), []
    for name in ("bounded", *map(str, THRESHOLDS)):
        once = paper[name].outcome(10.0, 1e-9)
        there = f"{once.n_bounded / once.nsteps:.0%}, {times[name] / times['lagrange']:.2f}"
        largest = [worst(every, name, rtol) for rtol in TOLERANCES]
        rows.append([name, *largest, over_lagrange(every, name, 1e-7, GAPS), there])
    head = ["EM_NEAR, EM_FAR, EM_APART", *(f"rtol {rtol:.0e}" for rtol in TOLERANCES), "error 1e-7", "paper's scene"]
    title = "other thresholds: largest right-hand sides and error; time at equal error; bounded steps and time there"
    table(title, head, rows)


def worst(every: Measured, name: str, rtol: float) -> str:
    """Return the largest numbers of right-hand sides and errors over the gaps, over lagrange's."""
    pairs = [(every[gap, rtol][name], every[gap, rtol]["lagrange"]) for gap in GAPS]
    nfev, error = max(one.nfev / base.nfev for one, base in pairs), max(one.error / base.error for one, base in pairs)
    return f"{nfev:.2f}, {error:.2g}"


def main() -> None:
    systems = choices()
    every: Measured = {}
    with tempfile.TemporaryDirectory() as name:
        ways = of_generator(veering.model, Path(name)) | by_hand(Path(name))
        for gap in (*GAPS, APART):
            t_end, exact = exactly(systems, gap)
            for tolerance in LADDER:
                every[gap, tolerance] = measured(ways, exact, t_end, tolerance, gap)
        passages(every)
        at_equal_error(every)
        thresholds(every, of_generator(dual_link.model, Path(name)))


if __name__ == "__main__":
    main()
