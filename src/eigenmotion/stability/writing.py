"""The files of the command."""

from collections.abc import Mapping
from dataclasses import asdict
from itertools import chain
from pathlib import Path

from ..building.toolchain import toolchain
from ..pages.machine import machine
from ..pages.page import write_page
from ..pages.tables import as_json
from .drawing import pictures
from .matrix import Matrix
from .outcome import RULES, Outcome
from .page import page


def write_matrix(matrix: Matrix, folder: Path) -> tuple[Path, ...]:
    """Write stability.html, stability.json and stability_*.png, stability_*.svg; return their paths, the page first."""
    drawn, known = pictures(matrix), machine(toolchain().described)
    texts = {"stability.html": page(matrix, drawn, known), "stability.json": numbers(matrix, known)}
    return write_page(folder, texts, chain.from_iterable(drawn.values()))


def numbers(matrix: Matrix, known: Mapping[str, str]) -> str:
    """Write everything that was found as JSON."""
    record = {
        "machine": known,
        "seconds": matrix.seconds,
        "workers": matrix.workers,
        "rules": {str(outcome): rule for outcome, rule in RULES.items()},
        "outcomes": {str(outcome): matrix.count(outcome) for outcome in Outcome},
        "cases": [{"name": c.name, "title": c.title, "about": c.about, "axis": c.axis} for c in matrix.cases],
        "points": [asdict(point) for point in matrix.points],
    }
    return as_json(record)
