"""Processes of compilers and other tools, which Ctrl-C ends, and threads that wait for them."""

import os
import shlex
import signal
import subprocess
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from .errors import BuildError

_PIPE = subprocess.PIPE
_MOMENT = 5.0  # [s] for a killed process to end
_of_thread = threading.local()


class _Group:
    """The processes that the threads of a pool have started, and the groups of the pools in these threads."""

    def __init__(self) -> None:
        self.lock, self.stopped = threading.Lock(), False
        self.processes: set[subprocess.Popen[str]] = set()
        self.within: list[_Group] = []

    def start(self, command: tuple[str, ...], folder: Path | None) -> "subprocess.Popen[str]":
        with self.lock:
            if self.stopped:
                raise BuildError(f"{command[0]} is not started: the build has ended")
            one = subprocess.Popen(command, cwd=folder, stdin=_PIPE, stdout=_PIPE, stderr=_PIPE, text=True,
                                   encoding="utf-8", errors="replace", start_new_session=True)  # fmt: skip
            self.processes.add(one)
            return one

    def stop(self) -> None:
        with self.lock:
            self.stopped = True
            for one in self.processes:
                _kill(one)
            within = list(self.within)
        for group in within:
            group.stop()


def _kill(process: "subprocess.Popen[str]") -> None:
    """Kill a tool and what it has started: the driver of a compiler starts another process, which holds its pipes."""
    if process.returncode is not None:
        return
    with suppress(OSError):
        os.killpg(process.pid, signal.SIGKILL) if hasattr(os, "killpg") else process.kill()
    with suppress(subprocess.TimeoutExpired):
        process.wait(_MOMENT)


class ToolPool(ThreadPoolExecutor):
    """Threads that wait for tools. Where an exception leaves its block, the tools are killed, and no others start."""

    def __init__(self, threads: int) -> None:
        self.tools = _Group()
        if (outer := getattr(_of_thread, "group", None)) is not None:
            outer.within.append(self.tools)
            self.tools.stopped = outer.stopped
        super().__init__(threads, initializer=lambda: setattr(_of_thread, "group", self.tools))

    def __exit__(self, *exception: Any) -> None:
        """Wait for all threads; if this is interrupted, or after an exception, end them."""
        ended = False
        try:
            if exception[0] is None:
                self.shutdown()
                ended = True
        finally:
            if not ended:
                self.tools.stop()
                self.shutdown(wait=False, cancel_futures=True)  # a thread may wait for a pool around this one


@contextmanager
def _started(command: tuple[str, ...], folder: Path | None) -> "Iterator[subprocess.Popen[str]]":
    """Start a tool, in a session of its own, so that it ends when this process says so and no earlier."""
    group = getattr(_of_thread, "group", None) or _Group()
    with group.start(command, folder) as tool:
        try:
            yield tool
        except BaseException:
            _kill(tool)
            raise
        finally:
            with group.lock:
                group.processes.discard(tool)


def run(command: tuple[str, ...], folder: Path | None = None, text: str = "") -> str:
    """Run a tool with `text` as standard input, and return its standard output.

    Raises
    ------
    BuildError
        The tool cannot be started, or its exit code is not 0.
    """
    try:
        with _started(command, folder) as tool:
            output, errors = tool.communicate(text)
    except (OSError, ValueError) as error:
        raise BuildError(f"cannot start {command[0]}: {error}") from error
    if tool.returncode:
        words = (errors + output).strip() or f"(no output; exit code {tool.returncode})"
        raise BuildError(f"{words}\n\nthe command was: {shlex.join(command)}")
    return output
