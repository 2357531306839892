"""The files of the command."""

import json
import math
from dataclasses import asdict
from pathlib import Path
from typing import Any

from ..files import write
from ..pages.machine import machine
from .drawing import pictures
from .matrix import Matrix
from .outcome import RULES, Outcome
from .page import page


def write_matrix(matrix: Matrix, folder: Path) -> tuple[Path, ...]:
    """Write stability.html, stability.json and stability_*.png, stability_*.svg; return their paths, the page first."""
    drawn = pictures(matrix)
    contents = {"stability.html": page(matrix, drawn).encode(), "stability.json": as_json(matrix).encode()}
    for picture in drawn:
        contents |= {f"{picture.stem}.png": picture.png, f"{picture.stem}.svg": picture.svg.encode()}
    for name, content in contents.items():
        write(folder / name, content)
    return tuple(folder / name for name in contents)


def as_json(matrix: Matrix) -> str:
    """Write everything that was found; numbers that are not there, or not finite, are null."""
    record = {
        "machine": machine(),
        "seconds": matrix.seconds,
        "workers": matrix.workers,
        "rules": {str(outcome): rule for outcome, rule in RULES.items()},
        "outcomes": {str(outcome): matrix.count(outcome) for outcome in Outcome},
        "cases": [{"name": c.name, "title": c.title, "about": c.about, "axis": c.axis} for c in matrix.cases],
        "points": [_finite(asdict(point)) for point in matrix.points],
    }
    return json.dumps(record, indent=1, allow_nan=False) + "\n"


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
