"""Unfinished sweep: the folder of parts beside its store, used by one process at a time.

    .STORE.parts/lock           locked by the process that writes to the folder
    .STORE.parts/sweep.json     the order (what the sweep is), written before any part
    .STORE.parts/000000.npz     a part: the results of some runs, with the digest of the order
    .STORE.parts/store.ENDING   the finished store before it is moved into place
    .STORE.parts/stored.json    sweep.json after the store is in place; deleted last

A process may be killed between any two steps. So every file is written under another name and renamed. Files without
sweep.json and stored.json are leftovers and are deleted. If there is stored.json, only deletion remains to be done. A
part counts only if it can be read completely and names this sweep and its own number.
"""

import fcntl
import hashlib
import io
import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...codegen.model.normalise import ModelError
from ...files import write
from .order import differences

Arrays = dict[str, NDArray[Any]]
_LOCK, _OF = "lock", "of"


@dataclass(frozen=True)
class Parts:
    """The parts of one sweep.

    order : the description of the sweep, as JSON data; time (nt,), coordinates (n,), reactions (m,), the columns of
    multipliers, units of names : common to all runs
    """

    store: Path
    order: dict[str, Any]
    count: int
    time: NDArray[np.float64]
    coordinates: tuple[str, ...]
    reactions: tuple[str, ...]
    units: Mapping[str, str] | None = None

    @property
    def folder(self) -> Path:
        """The folder of the parts."""
        return self.store.with_name(f".{self.store.name}.parts")

    @property
    def order_text(self) -> str:
        """The order as one line of JSON, as stores contain it."""
        return json.dumps(self.order, sort_keys=True)

    @property
    def is_begun(self) -> bool:
        """Whether there is an unfinished sweep in the folder, this one or another."""
        return self._order.is_file()

    @property
    def is_stored(self) -> bool:
        """Whether the store of this sweep is in place, and only leftovers of its parts remain."""
        return self.store.exists() and _content(self._stored) == self._text

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Lock the folder for this process; at the end, delete it if it is empty.

        Raises
        ------
        ModelError
            Another process has the lock.
        """
        descriptor = self._open_lock()
        try:
            yield
        finally:
            with suppress(OSError):
                if [path.name for path in self.folder.iterdir()] == [_LOCK]:
                    shutil.rmtree(self.folder)
            os.close(descriptor)

    def begin(self, *, resume: bool) -> None:
        """Begin the sweep, or resume it with the parts that exist.

        Raises
        ------
        ModelError
            There are parts and `resume` is false, or they are of another sweep.
        """
        if not self.is_begun:
            self.clear()
        elif not resume:
            raise ModelError(
                f"{self.store}: a sweep into it was not finished. --resume goes on with it; remove {self.folder} to "
                "begin anew"
            )
        elif _content(self._order) != self._text:
            begun = differences((_content(self._order) or b"").decode(errors="replace"), self.order)
            raise ModelError(
                f"{self.store}: what was begun there is another sweep: {begun}. Resume that one by its own command, "
                f"name another file with -o, or remove {self.folder}"
            )
        write(self._order, self._text)

    def clear_if_empty(self) -> None:
        """Delete all files if there is no part."""
        if not any(self.folder.glob("[0-9]*.npz")):
            self.clear()

    def move_into_place(self, finished: Path) -> None:
        """Move the finished store into place (atomically if it is a file), and delete the parts."""
        if self.store.is_dir():
            self.store.replace(self.folder / "before")
        finished.replace(self.store)
        self._order.replace(self._stored)
        self.clear()

    def clear(self) -> None:
        """Delete all files but the lock; last those that name the sweep."""
        for path in self.folder.iterdir():
            if path not in (self._order, self._stored) and path.name != _LOCK:
                remove(path)
        self._order.unlink(missing_ok=True)
        self._stored.unlink(missing_ok=True)

    def is_damaged(self, number: int) -> bool:
        """Whether a part exists but cannot be read or is of another sweep."""
        return self._path(number).exists() and not self.has(number)

    def has(self, number: int) -> bool:
        """Whether a part of this sweep exists and can be read completely."""
        try:
            self._read(number)
        except Exception:  # zipfile and NumPy raise all kinds of exceptions for damaged files
            return False
        return True

    def write_part(self, number: int, arrays: Arrays) -> None:
        """Write a part."""
        write(self._path(number), _npz({_OF: self._label(number), **arrays}))

    def arrays(self) -> Iterator[Arrays]:
        """Read all parts, in order.

        Raises
        ------
        ModelError
            A part cannot be read.
        """
        for number in range(self.count):
            try:
                yield self._read(number)
            except Exception as error:
                raise ModelError(f"{self._path(number)} cannot be read ({error}); --resume makes it anew") from error

    def _read(self, number: int) -> Arrays:
        with self._path(number).open("rb") as file, np.load(file) as part:
            arrays = dict(part)
        if str(arrays.pop(_OF)) != str(self._label(number)):
            raise ValueError("it is of another sweep")
        return arrays

    def _label(self, number: int) -> NDArray[Any]:
        return np.array(f"part {number} of {hashlib.sha256(self._text).hexdigest()}")

    def _path(self, number: int) -> Path:
        return self.folder / f"{number:06}.npz"

    @property
    def _order(self) -> Path:
        return self.folder / "sweep.json"

    @property
    def _stored(self) -> Path:
        return self.folder / "stored.json"

    @property
    def _text(self) -> bytes:
        return (json.dumps(self.order, indent=1, sort_keys=True) + "\n").encode()

    def _open_lock(self) -> int:
        """Return the descriptor of the locked file. The system releases the lock when the process ends, in any way."""
        while True:
            self.folder.mkdir(exist_ok=True)
            with suppress(FileNotFoundError):  # another process has just deleted the folder
                descriptor = os.open(self.folder / _LOCK, os.O_RDWR | os.O_CREAT, 0o666)
                try:
                    self._lock(descriptor)
                    if os.path.samestat(os.fstat(descriptor), (self.folder / _LOCK).stat()):
                        return descriptor
                except (OSError, ModelError):
                    os.close(descriptor)
                    raise
                os.close(descriptor)

    def _lock(self, descriptor: int) -> None:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            words = "another sweep writes into it now. Wait for its end, or name another file"
            raise ModelError(f"{self.store}: {words}") from error
        except OSError as error:
            words = f"the file system there locks no files ({error}). Write to another, and move the store then"
            raise ModelError(f"{self.store}: {words}") from error


def remove(path: Path) -> None:
    """Delete a file or a folder if it exists."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _npz(arrays: Arrays) -> bytes:
    """Return the content of an .npz file."""
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **arrays)
    return buffer.getvalue()


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None
