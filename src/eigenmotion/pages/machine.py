"""What the numbers were measured with. Says nothing of whose machine it is."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from ..building.errors import BuildError
from ..building.toolchain import run, toolchain

_PACKAGES = ("eigenmotion", "numpy", "scipy", "sympy", "heyoka", "casadi")


def machine() -> dict[str, str]:
    """Return processor, cores, compiler, flags and versions."""
    tools = toolchain()
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "compiler": _compiler(tools.command),
        "flags": " ".join((*tools.optimised, *tools.flags)),
        "Python": platform.python_version(),
        **{name: found for name in _PACKAGES if (found := _version(name))},
    }


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def _compiler(command: tuple[str, ...]) -> str:
    try:
        return run((*command, "--version")).splitlines()[0]
    except (BuildError, IndexError):
        return Path(command[0]).name


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""
