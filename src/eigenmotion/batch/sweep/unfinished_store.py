"""A sweep while it runs: parts in a folder beside its store, which belongs to one process at a time.

    .STORE.parts/lock           held by the process that writes here
    .STORE.parts/sweep.json     what the sweep is: there before any part
    .STORE.parts/000000.npz     a part: some runs, and of which sweep they are
    .STORE.parts/store.ENDING   of all parts, on its way to its place
    .STORE.parts/stored.json    what was sweep.json, once the store is in its place: the last to go

A process may be killed between any two steps. So every file is written under another name and renamed; what lies here
with neither sweep.json nor stored.json is nobody's and goes; what lies beside stored.json only has to go; and a part
counts where it can be read to its end and says that it is of this sweep, and which part of it.
"""

import fcntl
import hashlib
import io
import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...codegen.model.normalise import ModelError
from ...files import write

Arrays = dict[str, NDArray[Any]]
_LOCK, _OF = "lock", "of"


@dataclass(frozen=True)
class Parts:
    """The parts of a sweep of a store.

    order : what the sweep is, as JSON has it; time (nt,), coordinates (n,) : what all runs share
    """

    store: Path
    order: dict[str, Any]
    count: int
    time: NDArray[np.float64]
    coordinates: tuple[str, ...]

    @property
    def folder(self) -> Path:
        """Where they lie."""
        return self.store.with_name(f".{self.store.name}.parts")

    @property
    def said(self) -> str:
        """The order on one line, as stores keep it."""
        return json.dumps(self.order, sort_keys=True)

    @property
    def is_begun(self) -> bool:
        """Whether a sweep is under way here, this one or another."""
        return self._order.is_file()

    @property
    def is_stored(self) -> bool:
        """Whether this sweep's store came to its place, and only what is left of its parts has to go."""
        return self.store.exists() and _content(self._stored) == self._text

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Be the one who writes here. What is empty at the end goes.

        Raises
        ------
        ModelError
            Another process writes here now.
        """
        descriptor = self._locked()
        try:
            yield
        finally:
            with suppress(OSError):
                if [path.name for path in self.folder.iterdir()] == [_LOCK]:
                    shutil.rmtree(self.folder)
            os.close(descriptor)

    def begin(self, *, resume: bool) -> None:
        """Begin, or go on with what is there.

        Raises
        ------
        ModelError
            There are parts and nobody said to go on, or they are of another sweep.
        """
        if not self.is_begun:
            self.forget()
        elif not resume:
            raise ModelError(
                f"{self.store}: a sweep into it was not finished. --resume goes on with it; remove {self.folder} to "
                "begin anew"
            )
        elif _content(self._order) != self._text:
            raise ModelError(f"{self.store}: what was begun there is another sweep; {self._order} says which")
        write(self._order, self._text)

    def give_up(self) -> None:
        """Leave nothing behind of a sweep that kept no part."""
        if not any(self.folder.glob("[0-9]*.npz")):
            self.forget()

    def settle(self, finished: Path) -> None:
        """Put the store in its place, in one step where it is a file; the parts go."""
        if self.store.is_dir():
            self.store.replace(self.folder / "before")
        finished.replace(self.store)
        self._order.replace(self._stored)
        self.forget()

    def forget(self) -> None:
        """Remove all that lies here, and last what says of which sweep it is."""
        for path in self.folder.iterdir():
            if path not in (self._order, self._stored) and path.name != _LOCK:
                remove(path)
        self._order.unlink(missing_ok=True)
        self._stored.unlink(missing_ok=True)

    def is_damaged(self, number: int) -> bool:
        """Whether a part is there that cannot be read, or is not of this sweep."""
        return self._path(number).exists() and not self.has(number)

    def has(self, number: int) -> bool:
        """Whether a part is there, of this sweep, and can be read to its end."""
        try:
            self._read(number)
        except Exception:  # zipfile and NumPy raise what they like at bytes that are not theirs
            return False
        return True

    def keep(self, number: int, arrays: Arrays) -> None:
        """Write a part."""
        write(self._path(number), _npz({_OF: self._of(number), **arrays}))

    def arrays(self) -> Iterator[Arrays]:
        """Read all parts, in order.

        Raises
        ------
        ModelError
            One cannot be read.
        """
        for number in range(self.count):
            try:
                yield self._read(number)
            except Exception as error:
                raise ModelError(f"{self._path(number)} cannot be read ({error}); --resume makes it anew") from error

    def _read(self, number: int) -> Arrays:
        with self._path(number).open("rb") as file, np.load(file) as part:
            found = dict(part)
        if str(found.pop(_OF)) != str(self._of(number)):
            raise ValueError("it is of another sweep")
        return found

    def _of(self, number: int) -> NDArray[Any]:
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

    def _locked(self) -> int:
        """Return the file that holds the lock, which goes with the process, however that ends."""
        while True:
            self.folder.mkdir(exist_ok=True)
            with suppress(FileNotFoundError):  # whoever was here before has just removed the folder
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
    """Remove a file or a folder, if it is there."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _npz(arrays: Arrays) -> bytes:
    """Return arrays as the content of a file."""
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **arrays)
    return buffer.getvalue()


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None
