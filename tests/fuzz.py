"""`make fuzz`: random expressions, mechanisms and machines by the thousand; prints what is wrong and lines of counts.

Exits with 1 if anything is wrong.

    python -m tests.fuzz [--trees N] [--mechanisms N] [--states N] [--tables N] [--driven N]
                         [--machines N] [--first SEED] [--slice K/N] [--workers N]

Everything wrong is named by its seed: `--first SEED --trees 1 --mechanisms 0` looks at it again.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import fields

from eigenmotion.building.toolchain import OPTIMISED, toolchain

from .bodies import machine_checks
from .equations import mechanism_checks, state_checks, table_checks
from .graph import tree_checks
from .support.generation import FORMULATIONS
from .support.night_slice import slice_of

ZEROS_PER_TREE = 5
"""One seed in so many is also asked what is zero: each makes twenty forms."""


def one_tree(seed: int) -> tree_checks.Counts:
    """Values, derivatives and canonical form; now and then what is zero."""
    counts = tree_checks.Counts()
    with _noted(f"tree {seed}", counts.wrong):
        tree_checks.check(seed, counts)
        if seed % ZEROS_PER_TREE == 0:
            tree_checks.check_zeros(seed, counts)
    return counts


def one_mechanism(seed: int) -> mechanism_checks.Counts:
    """All formulations with the flags that users get; now and then runs by nodes."""
    counts = mechanism_checks.Counts()
    with _noted(f"mechanism {seed}", counts.wrong):
        mechanism_checks.check(seed, counts, FORMULATIONS, *OPTIMISED, *toolchain().flags)
        if seed % mechanism_checks.RUN_EVERY == 0:
            mechanism_checks.check_run(seed, counts, *OPTIMISED, *toolchain().flags)
    return counts


def one_with_states(seed: int) -> mechanism_checks.Counts:
    """All formulations of a mechanism with first-order states."""
    counts = mechanism_checks.Counts()
    with _noted(f"states {seed}", counts.wrong):
        state_checks.check(seed, counts, FORMULATIONS, *OPTIMISED, *toolchain().flags)
    return counts


def one_with_tables(seed: int, driven: bool = False) -> mechanism_checks.Counts:
    """Two formulations in turn of a mechanism with tables; now and then the Jacobian of eta."""
    counts = mechanism_checks.Counts()
    kind = {"tables": not driven or seed % 2 == 0, "driven": driven}
    with _noted(f"{'driven' if driven else 'tables'} {seed}", counts.wrong):
        table_checks.check(seed, counts, FORMULATIONS[seed % 2 :: 2], *OPTIMISED, *toolchain().flags, **kind)
        if seed % mechanism_checks.RUN_EVERY == 0:
            table_checks.check_jacobian(seed, counts, **kind)
    return counts


def one_driven(seed: int) -> mechanism_checks.Counts:
    """The same with motions that signals prescribe; every other one has tables, too."""
    return one_with_tables(seed, driven=True)


def one_machine(seed: int) -> machine_checks.Counts:
    """Two formulations of a machine on a tree of bodies, compiled in a hurry; now and then its motion."""
    counts = machine_checks.Counts()
    with _noted(f"machine {seed}", counts.wrong):
        machine_checks.check(seed, counts, "-O0")
    return counts


@contextmanager
def _noted(what: str, wrong: list[str]) -> Iterator[None]:
    """Whatever is raised counts as wrong. NumPy's oracles pass through the roots that a Piecewise does not choose."""
    with warnings.catch_warnings(action="ignore"):
        try:
            yield
        except Exception as error:
            wrong.append(f"{what}: {type(error).__name__}: {error}")


def swept(check: Callable, seeds: range, pool: ProcessPoolExecutor) -> Iterator[object]:  # type: ignore[type-arg]
    """Give the counts of each seed as they come, and print what is wrong at once."""
    for counts in pool.map(check, seeds):
        for fault in counts.wrong:
            print(fault, flush=True)
        yield counts


def summed(name: str, seconds: float, counts: list) -> str:  # type: ignore[type-arg]
    """Return one line: how many of what."""
    entries = [f"{sum(getattr(c, f.name) for c in counts)} {f.name}" for f in fields(counts[0]) if f.name != "wrong"]
    return f"{name}: {', '.join(entries)}, {sum(len(c.wrong) for c in counts)} wrong ({seconds:.0f} s)"


def main() -> int:
    """Run what the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, default in (
        ("trees", 10_000),
        ("mechanisms", 300),
        ("states", 40),
        ("tables", 100),
        ("driven", 100),
        ("machines", 1000),
        ("first", 0),
        ("workers", os.cpu_count() or 1),
    ):
        parser.add_argument(f"--{name}", type=int, default=default)
    parser.add_argument(
        "--slice", type=slice_of, metavar="K/N", help="one of N parts of a tenth of all seeds (default: all)"
    )
    asked = parser.parse_args()
    seeds = asked.slice.seeds if asked.slice else lambda first, count: range(first, first + count)
    lines, wrong = [], 0
    with ProcessPoolExecutor(asked.workers) as pool:
        kinds = (("trees", one_tree, asked.trees), ("mechanisms", one_mechanism, asked.mechanisms),
                 ("states", one_with_states, asked.states), ("tables", one_with_tables, asked.tables),
                 ("driven", one_driven, asked.driven), ("machines", one_machine, asked.machines))  # fmt: skip
        for name, check, count in kinds:
            start = time.monotonic()
            found = list(swept(check, seeds(asked.first, count), pool))
            if found:
                lines.append(summed(name, time.monotonic() - start, found))
                wrong += sum(len(counts.wrong) for counts in found)
    print("\n".join(lines))
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
