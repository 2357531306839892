"""Generated C as a plain program, without Python: to time what takes nanoseconds."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from eigenmotion import Model
from eigenmotion.order import order
from eigenmotion.toolchain import CHECKED, INCLUDE, OPTIMISED, run, toolchain

TIMER = Path(__file__).with_name("right_hand_side.c")


def right_hand_side(model: Model, formulation: str, folder: Path) -> Callable[[int], float]:
    """Compile the model with the timer; return calls -> nanoseconds a call."""
    work = folder / formulation
    work.mkdir()
    for file in order(model, formulation=formulation).sources().files:
        (work / file.name).write_text(file.text)
    name = f"-DMODEL={model.name}_model"
    files = (f"{model.name}.c", str(TIMER))
    run((*toolchain().command, *CHECKED, *OPTIMISED, name, f"-I{INCLUDE}", *files, "-lm", "-o", "timer"), work)

    def nanoseconds(calls: int) -> float:
        done = subprocess.run([work / "timer", str(calls)], capture_output=True, text=True, check=True)
        return float(done.stdout)

    return nanoseconds
