"""Generated C as a plain program, without Python: to time what takes nanoseconds."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from eigenmotion import Model
from eigenmotion.order import order
from eigenmotion.toolchain import CHECKED, INCLUDE, OPTIMISED, run, toolchain

TIMER = Path(__file__).with_name("right_hand_side.c")
COUNTER = Path(__file__).with_name("operations.cpp")


def right_hand_side(model: Model, formulation: str, folder: Path) -> Callable[[int], float]:
    """Compile the model with the timer; return calls -> nanoseconds a call."""
    work = folder / formulation
    work.mkdir()
    for file in order(model, formulation=formulation).sources().files:
        (work / file.name).write_text(file.text)
    return timer(model.name, f"{model.name}.c", work)


def timer(name: str, file: str, work: Path) -> Callable[[int], float]:
    """Compile the timer with a model's C or object file in a folder; return calls -> nanoseconds a call."""
    of = f"-DMODEL={name}_model"
    files = (file, str(TIMER))
    run((*toolchain().command, *CHECKED, *OPTIMISED, of, f"-I{INCLUDE}", *files, "-lm", "-o", "timer"), work)

    def nanoseconds(calls: int) -> float:
        done = subprocess.run([work / "timer", str(calls)], capture_output=True, text=True, check=True)
        return float(done.stdout)

    return nanoseconds


def operations(name: str, work: Path) -> int:
    """Compile NAME.c in a folder with a number that counts; return the operations of one right-hand side, loops too.

    Raises
    ------
    BuildError
        There is no C++ compiler, or the code is C that no C++ compiler takes.
    """
    model = (f'-DSOURCE="{name}.c"', f"-DMODEL={name}_model", f"-I{INCLUDE}", "-I.")
    run(("c++", "-std=c++20", "-fpermissive", "-w", *model, str(COUNTER), "-o", "counter"), work)
    return sum(map(int, run((str(work / "counter"),)).split()))
