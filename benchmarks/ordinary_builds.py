"""Benchmark of first builds of ordinary mechanisms, with the stepper in the cache.

Seconds from a `Model` to a `System`, medians of three builds, each with a cache that has the stepper only, and where
they go. They depend on the machine and its other load.
"""

from __future__ import annotations

import atexit
import functools
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from statistics import median
from unittest.mock import patch

from common.ordinary_models import ORDINARY, two_frictions
from eigenmotion.codegen import compiler
from pipeline import GENERATOR, timed, unit_by_unit

import eigenmotion as em
from eigenmotion.building import shared_library, toolchain, verification
from eigenmotion.building.cache import LOCATION

REPEATS = 3


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


def main() -> None:
    em.build(two_frictions())  # what is imported at the first build
    for make in ORDINARY:
        results = [stages(make) for _ in range(REPEATS)]
        middle = {name: median(one[name] for one in results if name in one) for one in results for name in one}
        print(f"{make.__name__}: build {middle.pop('build'):.2f} s")
        print("  " + ", ".join(f"{name} {seconds:.2f}" for name, seconds in middle.items()))


if __name__ == "__main__":
    main()
