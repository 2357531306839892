"""C compiler: its choice, its flags, and its runs."""

import os
import shlex
import shutil
import sys
import sysconfig
from dataclasses import dataclass, field
from functools import cache, cached_property, partial
from importlib.util import find_spec
from pathlib import Path

from .cache import key
from .errors import BuildError, CompilerNotFoundError
from .processes import run

INCLUDE = Path(__file__).parents[1] / "runtime" / "include"
OPTIMISED = (
    "-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno", "-fno-trapping-math",
    "-fno-tree-slp-vectorize",  # GCC 12 vectorises straight-line code of unrolled loops wrongly,
    "--param=vect-epilogues-nomask=0",  # and uses an unaligned stack in the epilogues of loops
)  # fmt: skip
"""Default flags, if the compiler knows them (docs/flags.md)."""
STANDARD = ("-std=c11",)  # without warnings, which users of a model cannot act on
SHARED = ("-fPIC", "-fvisibility=hidden")
MODULE = ("-O1", "-w")  # code that runs once; no warnings about Python's headers
HURRIED = {"duals": ("-O1",), "aside": ("-O1",)}
"""Units whose functions no step calls, or seldom -> the flags that follow the others (docs/flags.md)."""
UNITS = {
    "derivatives": ("EM_UNIT=EM_DERIVATIVES",),
    "members": ("EM_ON_LANES",),
    "model": ("EM_UNIT=EM_MODEL",),
    "rhs": ("EM_UNIT=EM_RHS",),
    "lanes": ("EM_NODES_ALONE",),
    "aside": ("EM_UNIT=EM_ASIDE",),
    "duals": ("EM_ON_LANES", "EM_ON_DUALS"),
}
"""Units of a model's C file (compiled in parallel, the longest first) -> the macros that select them (em_units.h)."""
STEPPER = "em_stepper"
"""The C file of the object that all models share."""
IN_PLACE_OF = {"members": "lanes"}
"""Unit -> another unit whose functions it contains, and which is therefore not linked beside it."""
FLAGS = "EIGENMOTION_CFLAGS"
ZIG = (sys.executable, "-m", "ziglang", "cc", "-fno-sanitize=undefined")
"""Clang of the `ziglang` wheel. Without the flag, unoptimised code would trap at undefined behaviour."""
BUNDLE = ("-bundle", "-undefined", "dynamic_lookup")
"""How Apple's linker makes a module: Python's symbols are found when it is loaded."""
_MACROS = ("-dM", "-E", "-x", "c", os.devnull)
EXTENSION_SUFFIX: str = sysconfig.get_config_var("EXT_SUFFIX")


@cache
def headers() -> str:
    """Return a hash of all C files and headers of the runtime."""
    return key(*(path.read_bytes() for path in sorted(INCLUDE.rglob("*.[ch]"))))


@dataclass(frozen=True)
class Toolchain:
    """A C compiler of the GCC or Clang kind, and flags that follow ours (the last of two that disagree wins)."""

    command: tuple[str, ...]
    flags: tuple[str, ...] = field(default=())

    @cached_property
    def optimised(self) -> tuple[str, ...]:
        """The flags of OPTIMISED that the compiler accepts in a test run."""
        accepts = partial(_accepts, self.command, _stamp(self.command[0]))
        return OPTIMISED if accepts(*OPTIMISED) else tuple(flag for flag in OPTIMISED if accepts(flag))

    @cached_property
    def identity(self) -> str:
        """Hash of all that compiled code depends on: version, flags, and the processor of `-march=native`.

        The predefined macros of the compiler depend on all three.
        """
        macros = self._ask(*self.optimised, *self.flags, *_MACROS)
        units = map(str, (*HURRIED.items(), *UNITS.items()))
        fixed = (*STANDARD, *SHARED, *MODULE, *link_flags(self.command), *units)
        flags = (*self.optimised, *fixed, *self.flags)
        return key(*self.command, "", *flags, "", macros)

    @cached_property
    def lanes(self) -> int:
        """Doubles in a vector of the processor, as in em_real.h; 1: it has no vectors."""
        header = str(INCLUDE / "numeric/em_real.h")
        macros = self._ask(*self.optimised, *self.flags, "-dM", "-E", "-x", "c", header)
        return next(int(line.split()[2]) for line in macros.splitlines() if line.startswith("#define EM_LANES "))

    @property
    def described(self) -> dict[str, str]:
        """The version of the compiler, and its flags."""
        try:
            name = self._ask("--version").splitlines()[0]
        except (BuildError, IndexError):
            name = Path(self.command[0]).name
        return {"compiler": name, "flags": " ".join((*self.optimised, *self.flags))}

    def compile_unit(self, folder: Path, stem: str, unit: str) -> str:
        """Compile a unit, STEM.c -> STEM_UNIT.o; return the name of the object."""
        target, optimised = f"{stem}_{unit}.o", (*self.optimised, *HURRIED.get(unit, ()))
        macros = (f"-D{macro}" for macro in UNITS[unit])
        self._run(*self._object(optimised), *macros, "-c", f"{stem}.c", "-o", target, folder=folder)
        return target

    def compile_stepper(self, folder: Path) -> str:
        """Compile the stepper, em_stepper.c -> em_stepper.o; return the name of the object."""
        target = f"{STEPPER}.o"
        self._run(*self._object(self.optimised), "-c", str(INCLUDE / f"{STEPPER}.c"), "-o", target, folder=folder)
        return target

    def _object(self, optimised: tuple[str, ...]) -> tuple[str, ...]:
        return (*STANDARD, *optimised, *SHARED, *self.flags, f"-I{INCLUDE}")

    def compile_module(self, folder: Path, stem: str) -> str:
        """Compile em_module.c -> STEM_module.o, which makes the library a Python module STEM; return its name."""
        headers = (f"-I{INCLUDE}", f"-I{sysconfig.get_path('include')}", f"-I{sysconfig.get_path('platinclude')}")
        names = (f"-DEM_MODEL={stem}_model", f"-DEM_INIT=PyInit_{stem}")
        source, target = str(INCLUDE / "em_module.c"), f"{stem}_module.o"
        self._run(*MODULE, *SHARED, *headers, *names, "-c", source, "-o", target, folder=folder)
        return target

    def link(self, folder: Path, objects: tuple[str, ...], name: str) -> None:
        """Link object files to the library NAME."""
        flags = (*link_flags(self.command), *SHARED, *self.flags)
        self._run(*flags, *objects, "-lm", "-o", f"{name}{EXTENSION_SUFFIX}", folder=folder)

    def _ask(self, *arguments: str) -> str:
        """Run the compiler for what it says about itself: once in a process, as long as it is the same file."""
        return _answer((*self.command, *arguments), _stamp(self.command[0]))

    def _run(self, *arguments: str, folder: Path | None = None) -> str:
        return run((*self.command, *arguments), folder)


def link_flags(command: tuple[str, ...], platform: str = sys.platform) -> tuple[str, ...]:
    """Return the flags by which a compiler links a library that Python can load.

    On macOS modules are bundles, except by zig: its linker crashes at them (0.17.1), and makes a dynamic library, which
    Python loads as well.
    """
    if platform != "darwin":
        return ("-shared",)
    return ("-shared", *BUNDLE[1:]) if command[: len(ZIG)] == ZIG else BUNDLE


def _stamp(program: str) -> tuple[int, ...]:
    """Return numbers that are others after a program was replaced; none if it is not there."""
    try:
        status = os.stat(program)  # noqa: PTH116, of what a link leads to
    except OSError:
        return ()
    return status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns


@cache
def _answer(command: tuple[str, ...], stamp: tuple[int, ...]) -> str:  # noqa: ARG001, part of the key
    return run(command)


@cache
def _accepts(command: tuple[str, ...], stamp: tuple[int, ...], *flags: str) -> bool:  # noqa: ARG001
    """Return whether a compiler accepts flags without a warning; True if it cannot be started."""
    try:
        run((*command, "-Werror", *flags, *_MACROS))
    except BuildError as error:
        return error.__cause__ is not None
    return True


def toolchain(compiler: str | None = None, flags: str | None = None) -> Toolchain:
    """Return the compiler to use: the argument, else $CC, else the first of cc, gcc, clang, else that of ziglang.

    Parameters
    ----------
    compiler
        A command, words as in a shell.
    flags
        Flags after ours, words as in a shell; else $EIGENMOTION_CFLAGS.

    Raises
    ------
    CompilerNotFoundError
        The requested compiler is not on the PATH, or there is none.
    BuildError
        The command or the flags cannot be split as in a shell.
    """
    chosen = _words("" if compiler is None else compiler, "compiler") or _words(os.environ.get("CC", ""), "$CC")
    candidates = [chosen] if chosen else [("cc",), ("gcc",), ("clang",)]
    more = _words(os.environ.get(FLAGS, ""), f"${FLAGS}") if flags is None else _words(flags, "flags")
    for command in candidates:
        path = shutil.which(command[0])
        if path:  # absolute, as it runs in other folders; links are not resolved, as some compilers check their name
            return Toolchain((os.path.abspath(path), *command[1:]), more)  # noqa: PTH100
    if not chosen and zig_is_there():
        return Toolchain(ZIG, more)
    raise CompilerNotFoundError(
        f"no C compiler: {' '.join(command[0] for command in candidates)} not found. "
        "Install GCC or Clang (Debian, Ubuntu: apt install gcc libc6-dev; macOS: xcode-select --install; Windows: use "
        "WSL), or pip install 'eigenmotion[compiler]' (the ziglang wheel), or set CC to the compiler's command"
    )


def zig_is_there() -> bool:
    """Whether the ziglang wheel is installed."""
    return find_spec("ziglang") is not None


def _words(text: object, what: str) -> tuple[str, ...]:
    try:
        if isinstance(text, str) and "\0" not in text:
            return tuple(shlex.split(text))
        problem = "give a text"
    except ValueError as error:
        problem = f"{str(error).lower()}; words are split as in a shell"
    raise BuildError(f"{what} is {text!r}: {problem}")
