"""Generated C straight into a System: compiled strictly, loaded without Cython, kept in the cache by content."""

import ctypes
import os
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import FORMULATIONS, Choices
from eigenmotion.codegen.equations.specialise import ALL_SAVINGS, Saving
from eigenmotion.codegen.render.emit import Sources

from eigenmotion import Model, System, load_model
from eigenmotion.building.cache import entry, key
from eigenmotion.building.request import Request
from eigenmotion.building.toolchain import INCLUDE, toolchain
from eigenmotion.runtime import CompiledModel

MODELS = Path(__file__).parents[2] / "models"
NAMES = tuple(sorted(path.stem for path in MODELS.glob("*.py") if path.stem != "__init__"))
STRICT = ("-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror")
FLAGS = (*STRICT, "-ffp-contract=fast", "-fPIC")
COMPILERS = tuple(name for name in ("gcc", "clang") if shutil.which(name))
"""Those there are: what users compile with is tried with each."""
KEPT: list[object] = []
LARGE = ("bicycle", "humanoid", "jansen", "quadruped")
"""Models with a block of more than six coordinates, whose inverse nothing writes out."""

__all__ = ["FORMULATIONS", "NAMES", "STRICT", "model_of", "relative", "states", "system_for", "system_of"]


@cache
def model_of(name: str) -> Model:
    """Return the model of models/NAME.py."""
    return load_model(MODELS / f"{name}.py")


@cache
def system_of(name: str, formulation: str = "eigenfactor", **options: str) -> System:
    """Return the System of models/NAME.py, compiled in a hurry: once a process, and kept."""
    return built(model_of(name), choices_for(name, formulation, **options))


def choices_for(name: str, formulation: str, **options: str) -> Choices:
    """Return what to generate of models/NAME.py with; what is refused there by name is no test's."""
    if formulation == "inverse" and name in LARGE:
        pytest.skip("inverses are written out for blocks of up to six coordinates")
    return Choices(formulation, **options)


def system_for(
    model: Model, formulation: str = "eigenfactor", savings: frozenset[Saving] = ALL_SAVINGS, **options: str
) -> System:
    """Return the System of any model, compiled in a hurry."""
    choices = Choices(formulation, **options)
    if savings == ALL_SAVINGS:
        return built(model, choices)
    return loaded(compiler.generate(model, choices, savings=savings), "-O0")


def built(model: Model, choices: Choices) -> System:
    """Return the System of what is asked for: generated, too, only where no process has done so before."""
    asked = Request(model, choices)
    system = system_in(_kept(asked), model.name)
    system.compiled.load_part = partial(_differentiating, asked)
    system.compiled.units = dict(model.units) or None
    return system


def _kept(asked: Request, *, duals: bool = False) -> ctypes.CDLL:
    """Return the library of what is asked for, with its right-hand side on duals or without."""
    name = key("asked", asked.sources_hash, *FLAGS, "-O0", str(duals), *_compiler(["-O0"]), *_headers())
    folder = entry("tests", name, lambda folder: compile_into(folder, asked.sources(), ("-O0",), duals=duals))
    return ctypes.CDLL(str(folder / f"{asked.model.name}.so"))


def _differentiating(asked: Request, part: str) -> CompiledModel:
    """Return what these Systems lack until somebody asks, which is for `System.jacobian`."""
    assert part == "duals"
    toolchain()  # which there has to be
    return system_in(_kept(asked, duals=True), asked.model.name).compiled


@cache
def _headers() -> tuple[str, ...]:
    return tuple(path.read_text() for path in sorted(INCLUDE.rglob("*.h")))


def loaded(sources: Sources, *flags: str, lanes: bool = False, runs: bool = True) -> System:
    """Compile and load sources, with lanes too where asked for; warnings are errors, of which pytest shows the text.

    Where nothing `runs`, the stepper is compiled in a hurry, once for all models of a shape.
    """
    return system_in(ctypes.CDLL(str(_library(sources, flags, lanes, runs))), sources.name)


def system_in(library: ctypes.CDLL, model: str) -> System:
    """Return the System of a model that is in a library."""
    name = ctypes.create_string_buffer(b"eigenmotion.em_model")
    KEPT.extend((library, name))  # a capsule owns neither
    new = ctypes.pythonapi.PyCapsule_New
    new.restype, new.argtypes = ctypes.py_object, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]
    return System(new(ctypes.addressof(ctypes.c_int.in_dll(library, f"{model}_model")), name, None))


def _compiler(flags: Iterable[str]) -> tuple[str, ...]:
    """In a hurry that which is quickest, Clang, unless CC names one; what users compile with is tried with each."""
    hurried = "-O0" in flags and "clang" in COMPILERS and "CC" not in os.environ
    return ("clang",) if hurried else toolchain().command


def _library(sources: Sources, flags: tuple[str, ...], lanes: bool, runs: bool) -> Path:
    texts = [file.text for file in sources.files]
    name = key(*FLAGS, *flags, *_compiler(flags), str(lanes), str(runs), *texts, *_headers())
    folder = entry("tests", name, lambda folder: compile_into(folder, sources, flags, lanes, runs=runs))
    return folder / f"{sources.name}.so"


def compile_into(
    folder: Path, sources: Sources, flags: tuple[str, ...], lanes: bool = False, duals: bool = False, runs: bool = True
) -> None:
    """Write NAME.c, NAME.h and compile NAME.so in a folder, in a hurry with the stepper that all have in common."""
    for file in sources.files:
        (folder / file.name).write_text(file.text)
    source, cc = f"{sources.name}.c", [*_compiler(flags), *FLAGS, *flags, f"-I{INCLUDE}"]
    others = []
    if lanes:
        _run([*cc, "-DEM_ON_LANES", "-c", source, "-o", "lanes.o"], folder)
        others = ["lanes.o"]
    elif "-O0" in flags or not runs:
        others = ["-DEM_UNIT=EM_MODEL|EM_RHS|EM_ASIDE|EM_DERIVATIVES", _stepper([*cc, "-O0"])]
    if duals:
        _run([*cc, "-DEM_ON_LANES", "-DEM_ON_DUALS", "-c", source, "-o", "duals.o"], folder)
        others.append("duals.o")
    _run([*cc, "-shared", source, *others, "-lm", "-o", f"{sources.name}.so"], folder)


def _stepper(cc: list[str]) -> str:
    """Return the path of the stepper's object, which all models have in common."""

    def fill(kept: Path) -> None:
        _run([*cc, "-c", str(INCLUDE / "em_stepper.c"), "-o", str(kept / "stepper.o")], kept)

    return str(entry("tests", key(*cc, *_headers()), fill) / "stepper.o")


def _run(command: list[str], folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def states(system: System, count: int, seed: int = 1) -> Iterator[tuple[np.ndarray, np.ndarray, float]]:
    """Give x, v, t at random about the model's start; velocities satisfy the constraints, positions need not."""
    random = np.random.default_rng([seed, *system.name.encode()])
    x0, _ = system.initial
    for _ in range(count):
        x, v = x0 + random.uniform(-0.3, 0.3, system.n), random.normal(size=system.n)
        t = float(random.uniform(0, 2))
        A, b = system.pfaffian(x, t)
        if system.m:
            M = system.compiled.factored_matrix(t, x, system.prepare(None))
            v = v - np.linalg.solve(M, A.T) @ np.linalg.lstsq(A @ np.linalg.solve(M, A.T), A @ v + b, rcond=None)[0]
        yield x, v, t


def relative(found: Iterable[float], right: Iterable[float], scale: float = 0.0) -> float:
    """Return the largest difference, relative to the largest number (or `scale`)."""
    found, right = np.asarray(found, dtype=float), np.asarray(right, dtype=float)
    if right.size == 0:
        return 0.0
    return float(np.max(np.abs(found - right)) / max(float(np.max(np.abs(right))), scale, 1e-300))
