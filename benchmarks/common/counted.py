"""Time and operation count of one right-hand side of generated C in a folder."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from eigenmotion.building.toolchain import EXTENSION_SUFFIX, INCLUDE, STANDARD, run, toolchain

TIMER, COUNTER = (Path(__file__).with_name(name) for name in ("right_hand_side.c", "operations.cpp"))


def timer(name: str, work: Path) -> Callable[[int], float]:
    """Link the timer with the compiled library of NAME.c in a folder; return calls -> nanoseconds per call."""
    tools = toolchain()
    command = (*tools.command, *STANDARD, *tools.optimised, f"-DMODEL={name}_model", f"-I{INCLUDE}")
    run((*command, str(TIMER), f"{name}{EXTENSION_SUFFIX}", f"-Wl,-rpath,{work}", "-o", "timer"), work)

    def nanoseconds(calls: int) -> float:
        done = subprocess.run([work / "timer", str(calls)], capture_output=True, text=True, check=True)
        return float(done.stdout)

    return nanoseconds


def operations(name: str, work: Path) -> int:
    """Compile NAME.c with a counting number type; return the operations that one right-hand side executes.

    Raises
    ------
    BuildError
        There is no C++ compiler, or the C code is not valid C++.
    """
    model = (f'-DSOURCE="{name}.c"', f"-DMODEL={name}_model", f"-I{INCLUDE}", "-I.")
    unresolved = ("-no-pie", "-Wl,--unresolved-symbols=ignore-all")  # functions that no right-hand side calls
    run(("c++", "-std=c++20", "-fpermissive", "-w", *model, str(COUNTER), *unresolved, "-o", "counter"), work)
    return sum(map(int, run((str(work / "counter"),)).split()))
