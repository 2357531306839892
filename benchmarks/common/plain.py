"""Programs of generated C without Python, to measure times of nanoseconds."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from eigenmotion import Model
from eigenmotion.building.processes import run
from eigenmotion.building.request import request
from eigenmotion.building.toolchain import INCLUDE, STANDARD, toolchain

HERE = Path(__file__).parent


def right_hand_side(model: Model, formulation: str, folder: Path, *flags: str) -> Callable[[int], float]:
    """Compile the model with the timer; return calls -> nanoseconds per call."""
    work = generated(model, folder / formulation, formulation=formulation)
    program = compiled(work, model.name, (f"{model.name}.c",), "right_hand_side.c", *flags)
    return lambda calls: float(_output(program, calls))


def generated(model: Model, work: Path, **options: str) -> Path:
    """Write the sources of a model into a new folder."""
    work.mkdir(parents=True)
    for file in request(model, **options).sources().files:
        (work / file.name).write_text(file.text)
    return work


def compiled(work: Path, name: str, sources: Iterable[str], main: str, *flags: str) -> Path:
    """Compile a main program of this folder with the model of that name; return the executable."""
    tools = toolchain()
    flags = (*STANDARD, *tools.optimised, f"-DMODEL={name}_model", *flags, f"-I{INCLUDE}")
    run((*tools.command, *flags, *sources, str(HERE / main), "-lm", "-o", "program"), work)
    return work / "program"


def _output(program: Path, *arguments: object) -> str:
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=True).stdout


@dataclass(frozen=True, slots=True)
class Runner:
    """Runs of a model from its initial state, in C."""

    program: Path

    @classmethod
    def of_model(cls, model: Model, work: Path, **options: str) -> Runner:
        """Generate and compile a model."""
        generated(model, work, **options)
        return cls(compiled(work, model.name, (f"{model.name}.c",), "run.c"))

    def nanoseconds(self, runs: int, t_end: float, tolerance: float, *parameters: float) -> float:
        """Return the nanoseconds of a run that records only its end."""
        return float(_output(self.program, runs, t_end, tolerance, *parameters))
