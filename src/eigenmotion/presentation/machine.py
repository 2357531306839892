"""Anonymous description of the machine on which numbers were measured."""

import os
import platform
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

_PACKAGES = ("eigenmotion", "numpy", "scipy", "sympy", "heyoka", "casadi")


def machine(compiler: Mapping[str, str]) -> dict[str, str]:
    """Return the processor, the number of cores, the compiler and versions of packages."""
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        **compiler,
        "Python": platform.python_version(),
        **{name: installed for name in _PACKAGES if (installed := _version(name))},
    }


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""
