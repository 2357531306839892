"""macOS, Windows and ARM: generated C and the stepper compile for them, and run in emulators as they do here.

Nothing here is run on macOS: there is no emulator of it. docs/platforms.md says what was tried where.
"""

import shutil
import struct
from collections.abc import Iterator
from pathlib import Path

import pytest

from eigenmotion.building.toolchain import BUNDLE, INCLUDE, SHARED, ZIG, link_flags, zig_is_there

from ..support.generation import NAMES, model_of, relative
from ..support.other_platforms import ARM_LIBRARIES, QEMU, WINE, compile_for, numbers_of_run, sources_in

TARGETS = ("aarch64-linux-musl", "aarch64-macos", "aarch64-windows-gnu", "x86_64-macos", "x86_64-windows-gnu")
BY_DAY = ("bouncing_ball", "four_bar")
"""An event that acts, and constraints with a redundant coordinate."""
UNITS = "-DEM_UNIT=EM_MODEL|EM_RHS|EM_ASIDE|EM_DERIVATIVES"
SPANS = {"bouncing_ball": 2.0, "dual_link": 10.0, "four_bar": 2.0, "pendulum": 10.0, "rolling_disk": 5.0}
SAME = 1e-9
"""Of the end of a run at this tolerance. C libraries round sin and cos differently, and so sizes of steps differ."""

pytestmark = pytest.mark.skipif(not zig_is_there(), reason="the ziglang wheel is not installed")
IN_QEMU = pytest.mark.skipif(QEMU is None, reason="qemu-aarch64 is not here (Debian: qemu-user)")
WITH_LIBRARIES = pytest.mark.skipif(not ARM_LIBRARIES.exists(), reason="no C library of ARM (libc6-arm64-cross)")
IN_WINE = pytest.mark.skipif(WINE is None, reason="Wine is not here (Debian: wine64)")


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("name", [pytest.param(name, marks=() if name in BY_DAY else pytest.mark.nightly)
                                  for name in NAMES])  # fmt: skip
def test_generated_c_compiles(name, target, tmp_path):
    """As numbers, and in the vectors of that processor; a warning is an error."""
    work = sources_in(tmp_path, name)
    source = f"{model_of(name).name}.c"  # some name themselves by their number of bodies
    compile_for(target, work, UNITS, "-c", source, "-o", "model.o")
    compile_for(target, work, "-DEM_ON_LANES", "-c", source, "-o", "lanes.o")


@pytest.mark.parametrize("target", TARGETS)
def test_the_stepper_compiles(target, tmp_path):
    compile_for(target, tmp_path, "-c", str(INCLUDE / "em_stepper.c"), "-o", "stepper.o")


@pytest.mark.parametrize("target", ["aarch64-macos", "x86_64-macos"])
def test_a_library_is_linked_for_macos(target, tmp_path):
    """With the flags by which modules are linked there: a dynamic library of that processor."""
    work = sources_in(tmp_path, "pendulum")
    compile_for(target, work, *link_flags(ZIG, "darwin"), *SHARED, "pendulum.c", "-lm", "-o", "pendulum.so")
    magic, processor, _, kind = struct.unpack("<4I", (work / "pendulum.so").read_bytes()[:16])
    assert (magic, kind) == (0xFEEDFACF, 6)  # MH_MAGIC_64, MH_DYLIB
    assert processor == {"aarch64-macos": 0x0100000C, "x86_64-macos": 0x01000007}[target]


def test_modules_are_bundles_by_apples_compiler():
    assert link_flags(("/usr/bin/cc",), "darwin") == BUNDLE
    assert link_flags(("/usr/bin/cc",), "linux") == link_flags(ZIG, "linux") == ("-shared",)


@pytest.fixture(scope="module")
def work(tmp_path_factory) -> Iterator[Path]:
    """A folder for programs, and for the 700 MB that Wine writes."""
    folder = tmp_path_factory.mktemp("programs")
    yield folder
    shutil.rmtree(folder / "wine", ignore_errors=True)


def assert_same_runs(work: Path, name: str, target: str, emulator: tuple[str, ...]) -> None:
    """The same counts of right-hand sides, steps and rows, the same status, and the same motion."""
    sources_in(work, name)
    here, there = (numbers_of_run(*program) for program in (("", work, name, SPANS[name]),
                                                            (target, work, name, SPANS[name], emulator)))  # fmt: skip
    assert there[0] == here[0]
    assert len(there) == len(here) > 10
    assert relative(there[-1], here[-1]) < SAME


@IN_QEMU
@WITH_LIBRARIES
@pytest.mark.parametrize("name", BY_DAY)
def test_runs_on_arm_are_those_of_this_machine(name, work):
    assert_same_runs(work, name, "aarch64-linux-gnu", (str(QEMU), "-L", str(ARM_LIBRARIES)))


@pytest.mark.nightly
@IN_QEMU
@pytest.mark.parametrize("name", SPANS)
def test_static_programs_on_arm_run_as_on_this_machine(name, work):
    assert_same_runs(work, name, "aarch64-linux-musl", (str(QEMU),))


@pytest.mark.nightly
@IN_WINE
@pytest.mark.parametrize("name", SPANS)
def test_runs_on_windows_are_those_of_this_machine(name, work):
    assert_same_runs(work, name, "x86_64-windows-gnu", (str(WINE),))
