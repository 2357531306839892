"""Benchmark of first builds of ordinary mechanisms, with the stepper in the cache; and of the flags of cold code.

Seconds from a `Model` to a `System`, medians of three builds, each with a cache that has the stepper only, and where
they go. They depend on the machine and its other load. Then two ratios of code that no step calls, compiled with `-O1`
(the default) over `-O3`: the compiler's processor time, and the thread time of runs of five models with contacts.
"""

from __future__ import annotations

import atexit
import functools
import os
import resource
import shutil
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from statistics import median
from unittest.mock import patch

from common.ordinary_models import ORDINARY, two_frictions
from eigenmotion.codegen import compiler
from pipeline import GENERATOR, timed, unit_by_unit

import eigenmotion as em
from eigenmotion.building import shared_library, toolchain, verification
from eigenmotion.building.cache import LOCATION

MODELS = Path(__file__).parents[1] / "models"
WITH_CONTACTS = ("newtons_cradle", "clock", "block_on_incline", "bouncing_ball", "rimless_wheel")
REPEATS, RUNS, SPAN = 3, 40, (0.0, 5.0)


@contextmanager
def empty_cache() -> Iterator[None]:
    """Use a cache that has nothing but the stepper."""
    with tempfile.TemporaryDirectory() as cache, patch.dict(os.environ, {LOCATION: cache}):
        shutil.copytree(_with_stepper(), cache, dirs_exist_ok=True)
        yield


@functools.cache
def _with_stepper() -> str:
    """Return a cache in which the stepper has been compiled; it is removed at the end."""
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder)
    with patch.dict(os.environ, {LOCATION: folder}):
        shared_library.stepper(toolchain.toolchain())
    return folder


def stages(make: Callable[[], em.Model]) -> dict[str, float]:
    """Return the seconds of one first build by stage; those of units include waiting for a free core."""
    seconds: dict[str, float] = {}
    with empty_cache(), ExitStack() as stack:
        for name in GENERATOR:
            stack.enter_context(patch.object(compiler, name, timed(name, getattr(compiler, name), seconds)))
        stack.enter_context(patch.object(toolchain.Toolchain, "compile_unit", unit_by_unit(seconds)))
        stack.enter_context(patch.object(verification, "prove", timed("proof", verification.prove, seconds)))
        model = timed("Model", make, seconds)()
        timed("build", em.build, seconds)(model)
    return seconds


def compiler_time(level: str) -> float:
    """Return the compiler's processor seconds for a build of two frictions with this level for cold code."""
    with empty_cache(), patch.object(toolchain, "ASIDE", level):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        em.build(two_frictions())
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def built(name: str, level: str) -> em.System:
    with empty_cache(), patch.object(toolchain, "ASIDE", level):
        return em.build(em.load_model(MODELS / f"{name}.py"))


def thread_time(system: em.System) -> float:
    start = time.thread_time()
    em.simulate(system, SPAN)
    return time.thread_time() - start


def ratio(first: Callable[[], float], second: Callable[[], float], pairs: int) -> float:
    """Return the median of the first over that of the second, measured in turn."""
    times = [(first(), second()) for _ in range(pairs)]
    one, other = zip(*times, strict=True)
    return median(one) / median(other)


def main() -> None:
    em.build(em.load_model(MODELS / "pendulum.py"))  # what is imported at the first build
    for make in ORDINARY:
        results = [stages(make) for _ in range(REPEATS)]
        middle = {name: median(one[name] for one in results if name in one) for one in results for name in one}
        print(f"{make.__name__}: build {middle.pop('build'):.2f} s")
        print("  " + ", ".join(f"{name} {seconds:.2f}" for name, seconds in middle.items()))
    found = ratio(partial(compiler_time, "-O1"), partial(compiler_time, "-O3"), REPEATS)
    print(f"-O1 over -O3 for cold code: compiler, two frictions {found:.2f}")
    for name in WITH_CONTACTS:
        runs = [partial(thread_time, built(name, level)) for level in ("-O1", "-O3")]
        print(f"  runs of {name} {ratio(*runs, RUNS):.3f}")


if __name__ == "__main__":
    main()
