"""Cache of compiled templates, in Python's folder for compiled modules.

Compiling all templates takes as long as deriving a small model; loading them takes a millisecond.
"""

from __future__ import annotations

import hashlib
import os
import sys
from contextlib import suppress
from functools import cache
from importlib.metadata import version
from importlib.resources import files
from importlib.util import cache_from_source
from pathlib import Path

import jinja2
from jinja2.bccache import Bucket


class Bytecode(jinja2.BytecodeCache):
    """The cache in __pycache__ beside the templates; if that is not writable, nothing is stored."""

    def load_bytecode(self, bucket: Bucket) -> None:
        """Read the cached code, if it is complete and belongs to this text."""
        try:
            with _place(bucket).open("rb") as file:
                bucket.load_bytecode(file)
        except Exception:  # any exception of a damaged pickle
            bucket.reset()

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Write the code atomically, since other processes may read and write the same file."""
        if sys.dont_write_bytecode:
            return
        place = _place(bucket)
        own = place.with_suffix(f".{os.getpid()}")
        try:
            place.parent.mkdir(parents=True, exist_ok=True)
            own.write_bytes(bucket.bytecode_to_string())
            own.replace(place)
        except OSError:
            with suppress(OSError):
                own.unlink()

    def get_source_checksum(self, source: str) -> str:
        """Return the hash of everything that the compilation of a template depends on, including our filters."""
        return hashlib.sha256(f"{_dependencies()}{source}".encode()).hexdigest()


def _place(bucket: Bucket) -> Path:
    return Path(cache_from_source(str(files("eigenmotion.templates") / f"{bucket.key}.py")))


@cache
def _dependencies() -> str:
    rooms = (files(f"eigenmotion.codegen.{room}") for room in ("kernel", "render"))
    texts = (file.read_text("utf-8") for room in rooms for file in room.iterdir() if file.name.endswith(".py"))
    return "".join((version("jinja2"), *sorted(texts)))
