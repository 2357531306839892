"""Files of the stability matrix."""

from collections.abc import Mapping
from dataclasses import asdict
from itertools import chain
from pathlib import Path

from ...building.toolchain import toolchain
from ...presentation.machine import machine
from ...presentation.page import write_page
from ...presentation.tables import as_json
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import RULES, Outcome
from .drawing import pictures
from .page import page


def write_matrix(matrix: Matrix, folder: Path) -> tuple[Path, ...]:
    """Write stability.html, stability.json and stability_*.png, stability_*.svg; return their paths, the page first."""
    drawn, known = pictures(matrix), machine(toolchain().described)
    texts = {"stability.html": page(matrix, drawn, known), "stability.json": numbers(matrix, known)}
    return write_page(folder, texts, chain.from_iterable(drawn.values()))


def numbers(matrix: Matrix, known: Mapping[str, str], more: Mapping[str, object] | None = None) -> str:
    """Return all results as JSON, and more on top."""
    record = {
        **(more or {}),
        "machine": known,
        "seconds": matrix.seconds,
        "workers": matrix.workers,
        "rules": {str(outcome): rule for outcome, rule in RULES.items()},
        "outcomes": {str(outcome): matrix.count(outcome) for outcome in Outcome},
        "cases": [{"name": c.name, "title": c.title, "about": c.about, "axis": c.axis} for c in matrix.cases],
        "points": [asdict(point) for point in matrix.points],
    }
    return as_json(record)
