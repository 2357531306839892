"""A model written by hand against eigenmotion.h: System and Solution are tested without the generator."""

import ctypes
import subprocess
import tempfile
from functools import cache
from pathlib import Path

from eigenmotion.building.toolchain import INCLUDE, toolchain
from eigenmotion.system.system import System

_HERE = Path(__file__).parent
_NAMES: dict[bytes, ctypes.Array[ctypes.c_char]] = {}
_FLAGS = ("-std=c11", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fPIC", "-shared")


@cache
def _library() -> ctypes.CDLL:
    with tempfile.TemporaryDirectory() as folder:
        library = Path(folder) / "bead.so"
        source = str(_HERE / "bead.c")
        command = [*toolchain().command, *_FLAGS, f"-I{INCLUDE}", source, "-lm", "-o", str(library)]
        subprocess.run(command, check=True)
        return ctypes.CDLL(str(library))


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
