"""Generated C for other systems: compiled by the ziglang wheel, run by QEMU and Wine where these are."""

import os
import shutil
import subprocess
from pathlib import Path

from eigenmotion.codegen import compiler

from eigenmotion.building.toolchain import INCLUDE, ZIG

from .generation import STRICT, model_of

MAIN = Path(__file__).parents[2] / "benchmarks" / "common" / "run.c"
QEMU = shutil.which("qemu-aarch64")
ARM_LIBRARIES = Path("/usr/aarch64-linux-gnu")
"""Where Debian's libc6-arm64-cross is."""
WINE = shutil.which("wine64") or shutil.which("wine64", path="/usr/lib/wine")
"""Debian keeps it outside of the PATH."""


def sources_in(folder: Path, name: str) -> Path:
    """Write the generated C of models/NAME.py into a folder."""
    for file in compiler.generate(model_of(name)).files:
        (folder / file.name).write_text(file.text)
    return folder


def compile_for(target: str, folder: Path, *arguments: str) -> None:
    """Compile for a system ("": this one) in a hurry; warnings are errors, of which pytest shows the text."""
    system = ("-target", target) if target else ()
    command = (*ZIG, *system, *STRICT, "-O0", "-ffp-contract=fast", f"-I{INCLUDE}", *arguments)
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def numbers_of_run(target: str, folder: Path, name: str, t_end: float, emulator: tuple[str, ...] = ()
                   ) -> list[list[float]]:  # fmt: skip
    """Compile NAME.c with the program run.c, run it, and return what it prints: counts and status, then t, x by row."""
    program = f"{name}-{target or 'here'}.exe"
    static = ("-static",) if target.endswith("musl") else ()
    compile_for(target, folder, *static, f"-DMODEL={name}_model", f"{name}.c", str(MAIN), "-lm", "-o", program)
    command = [*emulator, str(folder / program), "0", str(t_end), "1e-9"]
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          env=os.environ | {"WINEPREFIX": str(folder / "wine"), "WINEDEBUG": "-all"})  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return [[float(word) for word in line.split()] for line in done.stdout.splitlines()]
