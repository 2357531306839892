"""Time of one right-hand side of generated C in a folder."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from eigenmotion.building.processes import run
from eigenmotion.building.toolchain import EXTENSION_SUFFIX, INCLUDE, STANDARD, toolchain

TIMER = Path(__file__).with_name("right_hand_side.c")


def timer(name: str, work: Path) -> Callable[[int], float]:
    """Link the timer with the compiled library of NAME.c in a folder; return calls -> nanoseconds per call."""
    tools = toolchain()
    command = (*tools.command, *STANDARD, *tools.optimised, f"-DMODEL={name}_model", f"-I{INCLUDE}")
    run((*command, str(TIMER), f"{name}{EXTENSION_SUFFIX}", f"-Wl,-rpath,{work}", "-o", "timer"), work)

    def nanoseconds(calls: int) -> float:
        done = subprocess.run([work / "timer", str(calls)], capture_output=True, text=True, check=True)
        return float(done.stdout)

    return nanoseconds
