"""Compiled templates, kept where Python keeps compiled modules.

Compiling all takes as long as deriving a small model, reading them a millisecond.
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
    """In __pycache__, beside the templates; where nobody may write, templates are compiled anew, as modules are."""

    def load_bytecode(self, bucket: Bucket) -> None:
        """Read what is there, if it is whole and of this text."""
        try:
            with _place(bucket).open("rb") as file:
                bucket.load_bytecode(file)
        except Exception:  # whatever a damaged pickle raises
            bucket.reset()

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Write it whole or not at all: others may read and write the same."""
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
        """Hash of all that compiling a template reads: constants in it go through our filters then."""
        return hashlib.sha256(f"{_readers()}{source}".encode()).hexdigest()


def _place(bucket: Bucket) -> Path:
    return Path(cache_from_source(str(files("eigenmotion.templates") / f"{bucket.key}.py")))


@cache
def _readers() -> str:
    rooms = (files(f"eigenmotion.codegen.{room}") for room in ("kernel", "render"))
    texts = (file.read_text("utf-8") for room in rooms for file in room.iterdir() if file.name.endswith(".py"))
    return "".join((version("jinja2"), *sorted(texts)))
