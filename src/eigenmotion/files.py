"""Files that are either there in full or not at all."""

import os
import secrets
from pathlib import Path


def write(path: Path, content: bytes) -> bool:
    """Make `path` hold `content`; readers see the old file or the new one, never a part.

    Returns
    -------
    bool
        False where `path` held it already and was left alone.
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
