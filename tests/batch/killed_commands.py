"""Commands in a process of their own that is killed: at one of its operations on files, or after a time."""

import os
import signal
import sys
import time
import warnings
from collections.abc import Callable, Sequence

from eigenmotion.cli import main

_CHANGES = ("os.rename", "os.remove", "os.rmdir", "os.mkdir")


def _is_change(event: str, given: tuple) -> bool:
    """Whether an audit event is one that changes files, which it announces before it happens."""
    if event == "open":
        return isinstance(given[2], int) and bool(given[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT))
    return event in _CHANGES


def changes(arguments: Sequence[str]) -> int:
    """Return how many changes of files a command makes."""
    read, written = os.pipe()

    def child() -> None:
        seen = []
        sys.addaudithook(lambda event, given: seen.append(event) if _is_change(event, given) else None)
        main(arguments)
        os.write(written, str(len(seen)).encode())

    _wait(_forked(child))
    os.close(written)
    with os.fdopen(read) as said:
        return int(said.read())


def killed_at(change: int, arguments: Sequence[str]) -> None:
    """Run a command that is gone before it makes a change, counted from 0."""

    def child() -> None:
        seen = []

        def hook(event: str, given: tuple) -> None:
            if _is_change(event, given):
                if len(seen) == change:
                    os.kill(os.getpid(), signal.SIGKILL)
                seen.append(event)

        sys.addaudithook(hook)
        main(arguments)

    _wait(_forked(child))


def killed_after(seconds: float, arguments: Sequence[str]) -> bool:
    """Run a command that is killed after a time; whether it was before its end."""
    child = _forked(lambda: main(arguments))
    time.sleep(seconds)
    os.kill(child, signal.SIGKILL)
    return os.WIFSIGNALED(_wait(child))


def _forked(work: Callable[[], object]) -> int:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of threads, none of which is of ours now
        child = os.fork()
    if child:
        return child
    try:
        silent = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silent, 1)
        os.dup2(silent, 2)
        sys.stdout, sys.stderr = open(1, "w", closefd=False), open(2, "w", closefd=False)  # noqa: SIM115
        work()
    finally:
        os._exit(0)


def _wait(child: int) -> int:
    return os.waitpid(child, 0)[1]
