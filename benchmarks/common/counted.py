"""Of generated C in a folder: the time of one right-hand side from what is compiled already, and its operations."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from eigenmotion.building.toolchain import EXTENSION_SUFFIX, INCLUDE, STANDARD, run, toolchain

TIMER, COUNTER = (Path(__file__).with_name(name) for name in ("right_hand_side.c", "operations.cpp"))


def timer(name: str, work: Path) -> Callable[[int], float]:
    """Link the timer with the library of NAME.c in a folder; return calls -> nanoseconds a call."""
    tools = toolchain()
    command = (*tools.command, *STANDARD, *tools.optimised, f"-DMODEL={name}_model", f"-I{INCLUDE}")
    run((*command, str(TIMER), f"{name}{EXTENSION_SUFFIX}", f"-Wl,-rpath,{work}", "-o", "timer"), work)

    def nanoseconds(calls: int) -> float:
        done = subprocess.run([work / "timer", str(calls)], capture_output=True, text=True, check=True)
        return float(done.stdout)

    return nanoseconds


def operations(name: str, work: Path) -> int:
    """Compile NAME.c of a folder with a number that counts; return the operations of one right-hand side, loops too.

    Raises
    ------
    BuildError
        There is no C++ compiler, or the code is C that no C++ compiler takes.
    """
    model = (f'-DSOURCE="{name}.c"', f"-DMODEL={name}_model", f"-I{INCLUDE}", "-I.")
    not_there = ("-no-pie", "-Wl,--unresolved-symbols=ignore-all")  # what no right-hand side calls
    run(("c++", "-std=c++20", "-fpermissive", "-w", *model, str(COUNTER), *not_there, "-o", "counter"), work)
    return sum(map(int, run((str(work / "counter"),)).split()))
