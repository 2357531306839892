"""Benchmark of the build: time from a model file to a System by stage, with empty caches; and time of commands.

Seconds, medians of repeats. Unlike ratios, they depend on the machine and on its other load. With the argument
`compiler` only the compiler's processor seconds, unit by unit: they are what a change to the C code affects. With
`ordinary` only first builds of four mechanisms as users write them, with the stepper in the cache.
"""

from __future__ import annotations

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any
from unittest.mock import patch

from common.ordinary_models import ORDINARY
from eigenmotion.codegen import compiler
from eigenmotion.codegen.compiler import explain

from eigenmotion import Model, load_model
from eigenmotion.building import shared_library, verification
from eigenmotion.building.build import build, load_part
from eigenmotion.building.cache import LOCATION
from eigenmotion.building.lazy_units import PARTS, WORDS
from eigenmotion.building.request import request
from eigenmotion.building.toolchain import Toolchain, toolchain

MODELS = Path(__file__).parents[1] / "models"
CASES = (("dual_link", {}, 3), ("spatial_arm", {"n": 6}, 1), ("spatial_arm", {"n": 10}, 1),
         ("chain", {"n": 10}, 1), ("chain", {"n": 32}, 1))  # fmt: skip
"""File, arguments, repeats."""
GENERATOR = ("derive", "specialise", "lower", "emit")
COMPILER = {"compile_module": "C of the module", "link": "link"}
COMPILED = ("dual_link", "four_bar", "puma")
REPEATS = 3


Seconds = dict[str, float]
Spent = tuple[float, float]
"""Elapsed seconds and processor seconds; the latter do not depend on the other load of the machine."""


def timed(name: str, action: Callable[..., Any], seconds: Seconds) -> Callable[..., Any]:
    """Return a wrapper of `action` that adds its time to seconds[name]."""

    def wrapped(*arguments: Any, **keywords: Any) -> Any:
        start = time.perf_counter()
        try:
            return action(*arguments, **keywords)
        finally:
            seconds[name] = seconds.get(name, 0.0) + time.perf_counter() - start

    return wrapped


def unit_by_unit(seconds: Seconds) -> Callable[..., Any]:
    """Return a wrapper of `Toolchain.compile_unit` that adds the time of each unit to seconds["C, UNIT"]."""
    compile_unit = Toolchain.compile_unit

    def wrapped(tools: Toolchain, folder: Path, stem: str, unit: str) -> str:
        return timed(f"C, {unit}", compile_unit, seconds)(tools, folder, stem, unit)

    return wrapped


@contextmanager
def watched(seconds: Seconds) -> Iterator[None]:
    """Add the time of each stage of builds to `seconds`.

    Compilations run in parallel; their times include waiting for a free core.
    """
    with ExitStack() as stack:
        for name in GENERATOR:
            stack.enter_context(patch.object(compiler, name, timed(name, getattr(compiler, name), seconds)))
        for name, title in COMPILER.items():
            stack.enter_context(patch.object(Toolchain, name, timed(title, getattr(Toolchain, name), seconds)))
        stack.enter_context(patch.object(Toolchain, "compile_unit", unit_by_unit(seconds)))
        for place, name, title in ((verification, "prove", "proof"), (shared_library, "system_in", "library loaded")):
            stack.enter_context(patch.object(place, name, timed(title, getattr(place, name), seconds)))
        yield


def stages(file: str, definitions: dict[str, int]) -> Seconds:
    """Build a model with an empty cache, then each part that is built on demand; return the seconds of each stage."""
    seconds: Seconds = {}
    with tempfile.TemporaryDirectory() as cache, patch.dict(os.environ, {LOCATION: cache}), watched(seconds):
        model = timed("load", load_model, seconds)(MODELS / f"{file}.py", **definitions)
        timed("all", build, seconds)(model)
        first = dict(seconds)
        for part in PARTS:
            timed(f"later: {WORDS[part]}", load_part, first)(request(model), toolchain(), part)
    return first


def first_build(make: Callable[[], Model], with_stepper: str) -> Seconds:
    """Build a model with a cache that has nothing but the stepper; return the seconds of each stage."""
    seconds: Seconds = {}
    with tempfile.TemporaryDirectory() as cache, patch.dict(os.environ, {LOCATION: cache}), watched(seconds):
        shutil.copytree(with_stepper, cache, dirs_exist_ok=True)
        timed("all", build, seconds)(timed("Model", make, seconds)())
    return seconds


def ordinary_builds() -> None:
    """Print the times of first builds of mechanisms as users write them."""
    with tempfile.TemporaryDirectory() as with_stepper:
        with patch.dict(os.environ, {LOCATION: with_stepper}):
            shared_library.stepper(toolchain())
        first_build(ORDINARY[-1], with_stepper)  # what is imported at the first build
        for make in ORDINARY:
            results = [first_build(make, with_stepper) for _ in range(REPEATS)]
            middle = {name: median(one[name] for one in results) for name in results[0]}
            print(f"{make.__name__}: build {middle.pop('all'):.2f} s")
            print("  " + ", ".join(f"{name} {seconds:.2f}" for name, seconds in middle.items()))


def spent_by_compilers(seconds: Seconds, name: str, action: Callable[[], Any]) -> Any:
    """Return what `action` returns; seconds[name] is the processor time of the processes that it started."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = action()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds[name] = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return result


def compiler_by_unit() -> dict[str, Seconds]:
    """Return the compiler's processor seconds for the stepper, and for each unit of first builds, one at a time."""
    found: dict[str, Seconds] = {"stepper": {}, **{file: {"all": 0.0} for file in COMPILED}}
    compile_unit = Toolchain.compile_unit

    def measured(tools: Toolchain, folder: Path, stem: str, unit: str) -> str:
        target = spent_by_compilers(found[stem], unit, partial(compile_unit, tools, folder, stem, unit))
        found[stem]["all"] += found[stem][unit]
        return target

    with tempfile.TemporaryDirectory() as cache, ExitStack() as stack:
        stack.enter_context(patch.dict(os.environ, {LOCATION: cache}))
        stack.enter_context(patch.object(shared_library, "cores", lambda: 1))
        stack.enter_context(patch.object(Toolchain, "compile_unit", measured))
        spent_by_compilers(found["stepper"], "all", partial(shared_library.stepper, toolchain()))
        for file in COMPILED:
            build(load_model(MODELS / f"{file}.py"))
    return found


def compiler_seconds() -> None:
    """Print these seconds. The stepper is compiled once on a machine, the units with every model."""
    results = [compiler_by_unit() for _ in range(REPEATS)]
    print("the compiler's processor seconds by unit")
    for name, seconds in results[0].items():
        medians = (f"{unit} {median(one[name][unit] for one in results):.2f}" for unit in seconds)
        print(f"  {name:<10} {', '.join(medians)}")


def command(*words: str, cache: str) -> Spent:
    """Return the time of `eigenmotion WORDS` in a new process, including the compilers that it starts."""
    environment = os.environ | {LOCATION: cache}
    start, before = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-m", "eigenmotion", *words], env=environment, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    busy = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return time.perf_counter() - start, busy


def warm_build(cache: str) -> float:
    """Return the seconds of `em.build` of a cached model in a new process, without imports and loading of the model."""
    words = (
        "import time, eigenmotion as em; em.build, em.System, em.simulate; m = em.load_model('models/dual_link.py');"
        "s = time.perf_counter(); em.build(m); print(time.perf_counter() - s)"
    )
    environment, place = os.environ | {LOCATION: cache}, MODELS.parent
    done = subprocess.run([sys.executable, "-c", words], env=environment, cwd=place, check=True, capture_output=True)
    return float(done.stdout)


def middle(action: Callable[[], Spent], repeats: int = REPEATS) -> str:
    elapsed, busy = zip(*(action() for _ in range(repeats)), strict=True)
    return f"{median(elapsed):5.2f} s elapsed, {median(busy):5.2f} s of processor"


def in_fresh_cache(*words: str) -> Spent:
    with tempfile.TemporaryDirectory() as cache:
        return command(*words, "-o", f"{cache}/out", cache=cache)


def after_a_change(cache: str) -> Spent:
    """Return the time to build dual_link after a change of its energies, with the stepper in the cache."""
    source, changed = (MODELS / "dual_link.py").read_text(), Path(cache) / "dual_link.py"
    changed.write_text(source.replace("potential_energy=potential_energy", "potential_energy=2 * potential_energy"))
    return command("build", str(changed), "-o", f"{cache}/changed", cache=cache)


def operations(n: int) -> str:
    """Return the operation count of `explain` for the chain of n links, in all and per pair of coordinates."""
    line = next(line for line in explain(load_model(MODELS / "chain.py", n=n)).splitlines() if "eigenfactor: " in line)
    total = sum(int(word) for word in line.replace(",", "").split() if word.isdigit())
    return f"{total}, {total / (n * (n + 1) / 2):.1f} per pair"


def commands() -> None:
    """Print the times of commands in new processes."""
    model, chain = str(MODELS / "dual_link.py"), str(MODELS / "chain.py")
    print("commands, in processes of their own")
    print(f"  build dual_link, empty cache      {middle(partial(in_fresh_cache, 'build', model))}")
    for n in (10, 20):
        words = ("generate", chain, "-D", f"n={n}")
        print(f"  generate chain n={n}, empty cache  {middle(partial(in_fresh_cache, *words), 1)}")
    with tempfile.TemporaryDirectory() as cache:
        print(f"  --help                            {middle(lambda: command('--help', cache=cache))}")
        command("build", model, "-o", f"{cache}/out", cache=cache)
        print(f"  its energies changed              {middle(partial(after_a_change, cache), 1)}")
        warm = median(warm_build(cache) for _ in range(REPEATS))
        print(f"  em.build dual_link, warm cache    {warm:5.2f} s after imports")


def main() -> None:
    toolchain().identity  # noqa: B018, computed once in a process, so not part of the first build
    if "ordinary" in sys.argv[1:]:
        ordinary_builds()
        return
    compiler_seconds()
    if "compiler" in sys.argv[1:]:
        return
    for file, definitions, repeats in CASES:
        results = [stages(file, definitions) for _ in range(repeats)]
        title = " ".join([file, *(f"{name}={value}" for name, value in definitions.items())])
        print(f"{title}: {median(one['all'] for one in results):.2f} s in all")
        for name in results[0]:
            if name != "all":
                print(f"  {name:<42} {median(one[name] for one in results if name in one):.3f}")  # imports occur once
    commands()
    print("operations of the straight-line part of chain, eigenfactor")
    for n in (5, 10, 20):
        print(f"  n={n:<3} {operations(n)}")


if __name__ == "__main__":
    main()
