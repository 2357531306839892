"""The C compiler: which one, with which flags, and what it said."""

import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from .cache import key
from .codegen.model import ModelError

INCLUDE = Path(__file__).parent / "runtime" / "include"
OPTIMISED = ("-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno", "-fno-trapping-math")
CHECKED = ("-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror")
SHARED = ("-fPIC", "-fvisibility=hidden")
GLUE = ("-O1", "-fwrapv", "-w")  # what Cython writes: seldom called, not ours to lint
LINK = ("-bundle", "-undefined", "dynamic_lookup") if sys.platform == "darwin" else ("-shared",)
EXTENSION_SUFFIX: str = sysconfig.get_config_var("EXT_SUFFIX")


class BuildError(RuntimeError):
    """Generated code did not become a module; carries the tool's own words and the command."""


class CompilerNotFoundError(BuildError, ModelError):
    """There is no C compiler. Also a ModelError, as everything is that stops a model before its first run."""


@dataclass(frozen=True)
class Toolchain:
    """A C compiler of the GCC or Clang kind and the flags that follow ours (the last of two that disagree wins)."""

    command: tuple[str, ...]
    flags: tuple[str, ...] = field(default=())

    @cached_property
    def identity(self) -> str:
        """Hash of what the code it makes depends on: version, flags, and the processor `-march=native` stands for.

        The macros that the compiler predefines tell all three.
        """
        macros = self._run(*OPTIMISED, *self.flags, "-dM", "-E", "-x", "c", os.devnull)
        return key(*self.command, "", *OPTIMISED, *CHECKED, *SHARED, *GLUE, *LINK, *self.flags, "", macros)

    def compile_model(self, folder: Path, stem: str) -> None:
        """STEM.c -> STEM.o, warnings as errors."""
        self._run(*CHECKED, *OPTIMISED, *SHARED, *self.flags, f"-I{INCLUDE}", "-c", f"{stem}.c", "-o", f"{stem}.o",
                  folder=folder)  # fmt: skip

    def compile_glue(self, folder: Path, stem: str) -> None:
        """STEM.c, written by Cython -> STEM.o."""
        headers = (f"-I{INCLUDE}", f"-I{sysconfig.get_path('include')}", f"-I{sysconfig.get_path('platinclude')}")
        self._run(*GLUE, *SHARED, *headers, "-c", f"{stem}.c", "-o", f"{stem}.o", folder=folder)

    def link(self, folder: Path, stems: tuple[str, ...], name: str) -> None:
        """STEM.o ... -> the extension module NAME."""
        objects = [f"{stem}.o" for stem in stems]
        self._run(*LINK, *SHARED, *self.flags, *objects, "-lm", "-o", f"{name}{EXTENSION_SUFFIX}", folder=folder)

    def _run(self, *arguments: str, folder: Path | None = None) -> str:
        return run((*self.command, *arguments), folder)


def toolchain(compiler: str | None = None, flags: str | None = None) -> Toolchain:
    """Return the compiler to use: the argument, else $CC, else the first of cc, gcc, clang.

    Parameters
    ----------
    compiler
        A command, words as in a shell.
    flags
        Flags after ours, words as in a shell; else $EIGENMOTION_CFLAGS.

    Raises
    ------
    CompilerNotFoundError
        The compiler asked for, or any, is not on the PATH.
    """
    chosen = compiler or os.environ.get("CC")
    candidates = [tuple(shlex.split(chosen))] if chosen else [("cc",), ("gcc",), ("clang",)]
    more = tuple(shlex.split(os.environ.get("EIGENMOTION_CFLAGS", "") if flags is None else flags))
    for command in candidates:
        found = shutil.which(command[0])
        if found:
            return Toolchain((found, *command[1:]), more)
    raise CompilerNotFoundError(
        f"no C compiler: {' '.join(command[0] for command in candidates)} not found. Install GCC or Clang "
        "(Debian, Ubuntu: apt install gcc libc6-dev; macOS: xcode-select --install; Windows: use WSL), "
        "or set CC to the compiler's command"
    )


def run(command: tuple[str, ...], folder: Path | None = None) -> str:
    """Run a tool and return its standard output.

    Raises
    ------
    BuildError
        It could not be started, or did not answer 0.
    """
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", check=False)
    except OSError as error:
        raise BuildError(f"cannot start {command[0]}: {error.strerror}") from error
    if done.returncode:
        words = (done.stderr + done.stdout).strip() or f"(no output; exit code {done.returncode})"
        raise BuildError(f"{words}\n\nthe command was: {shlex.join(command)}")
    return done.stdout
