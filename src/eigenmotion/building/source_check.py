"""Check of generated files: whether they are what the generator would write."""

import difflib
import re
from dataclasses import dataclass
from pathlib import Path

from ..codegen.render.emit import Sources, body_hash, commented, stamp
from .request import Request

_COMMENT = re.compile(r"# (.+)|/\* (.+) \*/")


@dataclass(frozen=True, slots=True)
class Difference:
    """One generated file that is out of date, and the reason."""

    file: Path
    reason: str


def differences_by_hash(request: Request, folder: Path) -> tuple[Difference, ...]:
    """Compare the hash of the model, and of the body of each file, with those in the header of the file.

    Finds an edited model and an edited file without a derivation; does not find a changed generator.
    """
    requested = request.input_hash
    reasons = [(folder / name, _doubt(folder / name, request, requested)) for name in request.file_names]
    return tuple(Difference(file, reason) for file, reason in reasons if reason)


def differences_by_bytes(sources: Sources, folder: Path) -> tuple[Difference, ...]:
    """Compare byte by byte with freshly generated sources."""
    pairs = [(folder / file.name, file.text.encode()) for file in sources.files]
    return tuple(
        Difference(path, "differs from what the generator writes" if path.is_file() else "missing")
        for path, content in pairs
        if not path.is_file() or path.read_bytes() != content
    )


def unified_diff(sources: Sources, folder: Path) -> str:
    """Return the changes that writing `sources` to `folder` would make, as a unified diff."""
    return "".join(_changes(folder / file.name, file.text) for file in sources.files)


def _changes(path: Path, text: str) -> str:
    before = path.read_bytes().decode("utf-8", "replace") if path.is_file() else ""
    lines = difflib.unified_diff(
        before.splitlines(keepends=True),
        text.splitlines(keepends=True),
        fromfile=str(path) if path.is_file() else "/dev/null",
        tofile=str(path),
    )
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)


def _doubt(path: Path, request: Request, requested: str) -> str:
    """Return why a file is out of date, or "". Every byte of it is checked, the header included."""
    if not path.is_file():
        return "missing"
    text = path.read_bytes().decode("utf-8", "replace")
    header = stamp(text)
    if not (header.input_hash and header.body_hash):
        return "has no header of ours"
    if header.input_hash != requested:
        return "was generated from another model or with other options"
    head = (commented(request.origin), f"input sha256:{requested}", f"body sha256:{body_hash(text)}")
    return "" if _comments(text, len(head)) == head else "was edited by hand, or made by another command"


def _comments(text: str, count: int) -> tuple[str, ...]:
    """Return the text of the first lines, which are comments of C or Cython; "" for a line that is not a comment."""
    matches = [_COMMENT.fullmatch(line) for line in text.splitlines()[:count]]
    return tuple(match[1] or match[2] if match else "" for match in matches)
