"""Cache of generated and compiled models, addressed by content.

    sources/KEY/    NAME.h NAME.c NAME.pyx     KEY: the model, the options, the text of the generator; whether it has
                                               only the sources for first runs
    binaries/KEY/   NAME.<extension suffix>    KEY: the text of the sources and headers, compiler, flags, processor,
                    NAME_UNIT.o ...                 the model and its proof; the part (lazy_units.py), or Python
    steppers/KEY/   UNIT.o, seconds            KEY: the text of the headers, compiler, flags, processor
    KIND/KEY/sums                              hashes of all other files of the entry
    KIND/.KEY.XXXXXXXX/                        an entry that is being written or deleted
    locks/KIND-KEY

An entry is written under another name and renamed, while its lock is held. So it exists completely or not at all, and
of two processes that need the same entry, the second waits for the first. An entry that does not match its hashes is
built again, so that only code that was compiled here is loaded. Only the user may write to the folder, since its
content is executed.
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
_POLL = 0.005
"""[s] between two attempts to take a lock; short, since a build may wait for an entry that it has begun itself."""
_ENTRY = re.compile(r"[0-9a-f]{32}")
_PASSING = re.compile(r"\.([0-9a-f]{32})\.[0-9a-f]{8}")


def location() -> Path:
    """Return the folder of the cache: $EIGENMOTION_CACHE, or the cache folder of the platform."""
    chosen = os.environ.get(LOCATION)
    try:
        return Path(chosen).expanduser().absolute() if chosen else user_cache_path("eigenmotion", appauthor=False)
    except RuntimeError as error:  # no such user after "~"
        raise FolderError(f"${LOCATION} is {chosen!r}: {error}") from error


def key(*parts: str | bytes) -> str:
    """Return a hash of a sequence of texts; ("ab", "c") and ("a", "bc") differ."""
    digest = hashlib.sha256()
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        digest.update(f"{len(data)}:".encode())
        digest.update(data)
    return digest.hexdigest()[:32]


def entry(kind: str, name: str, fill: Callable[[Path], None]) -> Path:
    """Return the folder `kind/name`. If it does not exist or is damaged, `fill(folder)` writes its files.

    An exception of `fill` is passed on, and no incomplete entry remains.

    Raises
    ------
    FolderError
        The cache cannot be used: it is full, read-only, or others can write to it.
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
    """Turn errors with files of the cache into a FolderError that tells where it is and what to do."""
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
    """Delete leftovers of killed builds: temporary folders whose lock is free."""
    for leftover in kind.iterdir():
        if match := _PASSING.fullmatch(leftover.name):
            with _free(kind.name, match[1]) as free:
                if free:
                    remove(leftover)


def remove(path: Path) -> None:
    """Delete a file or a folder as far as possible, also a folder of ours without write permission."""
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
    """Delete all entries but those that are being written, and nothing else; return the sizes of the deleted ones."""
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
    """Try to take the lock of an entry; yield whether it was free."""
    try:
        with _lock(kind, name, timeout=0.0):
            yield True
    except Timeout:
        yield False


def _lock(kind: str, name: str, timeout: float = -1.0) -> AbstractContextManager[object]:
    """Return a context manager that holds the lock of an entry."""
    folder = location() / LOCKS
    _make(folder)
    return FileLock(folder / f"{kind}-{name}").acquire(timeout=timeout, poll_interval=_POLL)


def _make(folder: Path) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    folder.mkdir(mode=stat.S_IRWXU, exist_ok=True)


def _refuse_open(folder: Path) -> None:
    """Raise FolderError if another user (except root) owns the folder or can write to it."""
    try:
        status = folder.stat()
    except FileNotFoundError:
        return
    if _is_open(status):
        whose = "belongs to somebody else" if _is_foreign(status) else "can be written to by others"
        raise FolderError(
            f"the cache {folder} {whose}, and what it holds is run. Make it yours alone (chmod go-w), "
            f"or set ${LOCATION} to a folder that is"
        )


def _is_open(status: os.stat_result) -> bool:
    return _is_foreign(status) or bool(status.st_mode & (stat.S_IWGRP | stat.S_IWOTH))


def _is_foreign(status: os.stat_result) -> bool:
    return status.st_uid not in (os.geteuid(), 0)


def _is_sound(folder: Path) -> bool:
    """Return whether an entry exists, only we can write to it, and all files match their hashes."""
    try:
        if any(_is_open(status) or stat.S_ISLNK(status.st_mode) for status in (folder.lstat(), *_stats(folder))):
            return False
        return (folder / SUMS).read_bytes() == _sums(folder)
    except OSError:
        return False


def _stats(folder: Path) -> list[os.stat_result]:
    return [file.lstat() for file in folder.iterdir()]


def _sums(folder: Path) -> bytes:
    """Return one line for each file in the format of `sha256sum`."""
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
        for file in temporary.iterdir():  # the user's umask may allow others to write
            file.chmod(stat.S_IMODE(file.stat().st_mode) & ~(stat.S_IWGRP | stat.S_IWOTH))
        _clear_the_way(folder)
        temporary.rename(folder)
    finally:
        if temporary.exists():
            remove(temporary)


def _clear_the_way(folder: Path) -> None:
    """Delete a damaged entry. It is renamed first, so that processes that read it now keep their open files."""
    if os.path.lexists(folder):
        damaged = _passing(folder)
        folder.rename(damaged)
        remove(damaged)
