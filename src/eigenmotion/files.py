"""Atomic writing of files."""

import os
import secrets
from pathlib import Path


def write(path: Path, content: bytes) -> bool:
    """Write `content` to `path`; readers see the old file or the new one, never a part of it.

    Returns
    -------
    bool
        False if `path` had this content already and was not written.
    """
    if path.is_file() and path.read_bytes() == content:
        return False
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{os.getpid()}.{secrets.token_hex(4)}")
    try:
        temporary.write_bytes(content)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
    return True
