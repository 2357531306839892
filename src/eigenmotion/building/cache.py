"""The cache of generated and compiled models, by content.

    sources/KEY/    NAME.h NAME.c NAME.pyx     KEY: the model, the options, and the text of the generator; and
                                               whether it is what first runs need
    binaries/KEY/   NAME.<extension suffix>    KEY: the sources' text and the ABI's, compiler, flags, processor,
                    NAME_UNIT.o ...                 the model and its proof; which part it is (parts.py), or Python
    steppers/KEY/   UNIT.o                     KEY: its text after the preprocessor, compiler, flags, processor
    KIND/KEY/sums                              hash of every other file of the entry
    KIND/.KEY.XXXXXXXX/                        an entry on its way in or out
    locks/KIND-KEY

An entry is filled under another name and renamed, under a lock of its own: it is there in full or not at all,
and of two processes that want the same one, the second waits and finds it. One that is not as its hashes say is made
anew: what is loaded is what was compiled. The folder is the user's alone, for what it holds is run.
"""

import hashlib
import os
import re
import secrets
import shutil
import stat
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from pathlib import Path

from filelock import FileLock, Timeout
from platformdirs import user_cache_path

from .errors import BuildError, FolderError

LOCATION = "EIGENMOTION_CACHE"
LOCKS, SUMS = "locks", "sums"
_LOOKS = 0.005
"""Seconds from one look whether a lock is free to the next: a build may wait for what it has begun itself."""
_ENTRY = re.compile(r"[0-9a-f]{32}")
_PASSING = re.compile(r"\.([0-9a-f]{32})\.[0-9a-f]{8}")


def location() -> Path:
    """Folder of the cache: $EIGENMOTION_CACHE, or where the platform keeps caches."""
    chosen = os.environ.get(LOCATION)
    try:
        return Path(chosen).expanduser().absolute() if chosen else user_cache_path("eigenmotion", appauthor=False)
    except RuntimeError as error:  # "~" of nobody
        raise FolderError(f"${LOCATION} is {chosen!r}: {error}") from error


def key(*parts: str | bytes) -> str:
    """Hash of a sequence of texts; ("ab", "c") and ("a", "bc") differ."""
    digest = hashlib.sha256()
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        digest.update(f"{len(data)}:".encode())
        digest.update(data)
    return digest.hexdigest()[:32]


def entry(kind: str, name: str, fill: Callable[[Path], None]) -> Path:
    """Return the folder `kind/name`, which `fill(folder)` fills where it is not there yet, or is damaged.

    Whatever `fill` raises is raised, and leaves nothing behind.

    Raises
    ------
    FolderError
        The cache cannot be used: full, not to be written to, or open to others.
    """
    folder = location() / kind / name
    with guarded():
        _refuse_open(folder.parents[1])
        _refuse_open(folder.parent)
        if not _is_sound(folder):
            _make(folder.parents[1])
            _make(folder.parent)
            sweep(folder.parent)
            with _lock(kind, name):
                if not _is_sound(folder):
                    _fill(folder, fill)
    return folder


@contextmanager
def guarded() -> Iterator[None]:
    """Whatever goes wrong with files of the cache says where it is and what to do."""
    try:
        yield
    except BuildError:
        raise
    except OSError as error:
        raise FolderError(
            f"what is built is kept in {location()}, and that failed: {error}. Make room there (`eigenmotion cache` "
            f"shows its size, --clear empties it), or set ${LOCATION} to a folder of yours"
        ) from error


def sweep(kind: Path) -> None:
    """Remove what builds that were killed left behind: a folder on its way of which nobody holds the lock."""
    for left in kind.iterdir():
        if match := _PASSING.fullmatch(left.name):
            with _free(kind.name, match[1]) as free:
                if free:
                    remove(left)


def remove(path: Path) -> None:
    """Remove a file or a folder, as far as that can be done, also one whose rights forbid it and are ours to change."""
    with suppress(OSError):
        if path.is_dir() and not path.is_symlink():
            path.chmod(stat.S_IRWXU)
            shutil.rmtree(path, ignore_errors=True)
        else:
            path.unlink()


def contents() -> dict[str, list[int]]:
    """Return the size of every entry [bytes], by kind."""
    with guarded():
        return {kind.name: [_size(one) for one in _entries(kind)] for kind in _kinds()}


def clear() -> dict[str, list[int]]:
    """Remove every entry, but those that are being made, and return the sizes of what is gone. Touches nothing else."""
    gone = {}
    with guarded():
        for kind in _kinds():
            sweep(kind)
            sizes = {one: _size(one) for one in _entries(kind)}
            gone[kind.name] = [size for one, size in sizes.items() if _cleared(kind, one)]
    return gone


def _cleared(kind: Path, one: Path) -> bool:
    with _free(kind.name, one.name) as free:
        if free:
            one.rename(passing := _passing(one))
            remove(passing)
    return free


def _kinds() -> list[Path]:
    folder = location()
    return sorted(one for one in folder.iterdir() if one.is_dir() and one.name != LOCKS) if folder.exists() else []


def _entries(kind: Path) -> list[Path]:
    return [one for one in kind.iterdir() if _ENTRY.fullmatch(one.name)]


def _size(folder: Path) -> int:
    return sum(file.lstat().st_size for file in (folder, *folder.rglob("*")) if file.is_file())


@contextmanager
def _free(kind: str, name: str) -> Iterator[bool]:
    """Hold the lock of an entry, or say that somebody else does."""
    try:
        with _lock(kind, name, timeout=0.0):
            yield True
    except Timeout:
        yield False


def _lock(kind: str, name: str, timeout: float = -1.0) -> AbstractContextManager[object]:
    """Take the lock of an entry, which is held to the end of a `with`."""
    folder = location() / LOCKS
    _make(folder)
    return FileLock(folder / f"{kind}-{name}").acquire(timeout=timeout, poll_interval=_LOOKS)


def _make(folder: Path) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    folder.mkdir(mode=stat.S_IRWXU, exist_ok=True)


def _refuse_open(folder: Path) -> None:
    """Refuse a folder that somebody else (but root) owns or can write to."""
    try:
        found = folder.stat()
    except FileNotFoundError:
        return
    if _is_open(found):
        whose = "belongs to somebody else" if _is_foreign(found) else "can be written to by others"
        raise FolderError(
            f"the cache {folder} {whose}, and what it holds is run. Make it yours alone (chmod go-w), "
            f"or set ${LOCATION} to a folder that is"
        )


def _is_open(found: os.stat_result) -> bool:
    return _is_foreign(found) or bool(found.st_mode & (stat.S_IWGRP | stat.S_IWOTH))


def _is_foreign(found: os.stat_result) -> bool:
    return found.st_uid not in (os.geteuid(), 0)


def _is_sound(folder: Path) -> bool:
    """Whether an entry is there, it and all in it ours alone, and to the last bit what was put there."""
    try:
        if any(_is_open(found) or stat.S_ISLNK(found.st_mode) for found in (folder.lstat(), *_stats(folder))):
            return False
        return (folder / SUMS).read_bytes() == _sums(folder)
    except OSError:
        return False


def _stats(folder: Path) -> list[os.stat_result]:
    return [file.lstat() for file in folder.iterdir()]


def _sums(folder: Path) -> bytes:
    """Return a line for each file, as `sha256sum` writes it."""
    files = sorted(file for file in folder.iterdir() if file.name != SUMS)
    return "".join(f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in files).encode()


def _passing(folder: Path) -> Path:
    return folder.with_name(f".{folder.name}.{secrets.token_hex(4)}")


def _fill(folder: Path, fill: Callable[[Path], None]) -> None:
    temporary = _passing(folder)
    temporary.mkdir(mode=stat.S_IRWXU)
    try:
        fill(temporary)
        (temporary / SUMS).write_bytes(_sums(temporary))
        for file in temporary.iterdir():  # whatever the user's umask lets others do
            file.chmod(stat.S_IMODE(file.stat().st_mode) & ~(stat.S_IWGRP | stat.S_IWOTH))
        _clear_the_way(folder)
        temporary.rename(folder)
    finally:
        if temporary.exists():
            remove(temporary)


def _clear_the_way(folder: Path) -> None:
    """Remove a damaged entry; renamed first, for whoever reads it now keeps what was opened."""
    if os.path.lexists(folder):
        damaged = _passing(folder)
        folder.rename(damaged)
        remove(damaged)
