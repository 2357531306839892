"""A model written by hand against eigenmotion.h: System and Solution are tested without the generator."""

import ctypes
import os
import subprocess
from functools import cache
from pathlib import Path

from eigenmotion.building.cache import entry, key
from eigenmotion.building.toolchain import FLAGS, INCLUDE, headers, toolchain
from eigenmotion.system.system import System

_HERE = Path(__file__).parent
_NAMES: dict[bytes, ctypes.Array[ctypes.c_char]] = {}
_STRICT = ("-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fPIC", "-shared")


@cache
def _library() -> ctypes.CDLL:
    """Compiled once for all processes; with optimisation, where GCC finds more to warn of, unless all is in a hurry."""
    optimised = "-O0" if os.environ.get(FLAGS) == "-O0" else "-O2"
    command = (*toolchain().command, *_STRICT, optimised, f"-I{INCLUDE}", str(_HERE / "bead.c"), "-lm", "-o", "bead.so")

    def fill(folder: Path) -> None:
        subprocess.run(command, cwd=folder, check=True)

    name = key(*command, headers(), (_HERE / "bead.c").read_bytes())
    return ctypes.CDLL(str(entry("tests", name, fill) / "bead.so"))


def capsule(name: bytes = b"eigenmotion.em_model") -> object:
    """The PyCapsule that a generated module makes."""
    new = ctypes.pythonapi.PyCapsule_New
    new.restype, new.argtypes = ctypes.py_object, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]
    kept = _NAMES.setdefault(name, ctypes.create_string_buffer(name))  # a capsule does not own its name
    return new(ctypes.addressof(model()), kept, None)


def model() -> ctypes.c_int:
    """The em_model, seen as its first member: the version of the interface."""
    return ctypes.c_int.in_dll(_library(), "bead_model")


@cache
def bead() -> System:
    """The System of bead.c."""
    return System(capsule())
