"""Robots of example-robot-data, as Pinocchio reads them: tests that compare with it skip where it is not installed."""

import re
from pathlib import Path
from types import ModuleType

import pytest


def pinocchio() -> ModuleType:
    """Return Pinocchio's module, or skip the test."""
    return pytest.importorskip("pinocchio", reason="compares with Pinocchio: pip install 'eigenmotion[oracles]'")


def robot_file(name: str) -> Path:
    """Return the URDF file of a robot, or skip the test."""
    pytest.importorskip("yourdfpy", reason="URDF files are read by yourdfpy: pip install 'eigenmotion[robots]'")
    file = Path(pinocchio().__file__).parents[4] / "share/example-robot-data/robots" / name
    if not file.exists():
        pytest.skip("example-robot-data is not here: pip install 'eigenmotion[oracles]'")
    return file


def bodies_alone(file: Path, folder: Path) -> Path:
    """Return a copy without what Pinocchio's `rnea` leaves out: damping, friction, and joints that follow others."""
    copy = folder / file.name
    copy.write_text(re.sub(r"<(dynamics|mimic)\b[^>]*/>", "", file.read_text()))
    return copy
