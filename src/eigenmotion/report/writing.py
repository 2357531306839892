"""The files of a report."""

from collections.abc import Sequence
from pathlib import Path

from ..files import write
from .curves import pictures
from .examine import Findings
from .numbers import as_csv, as_json
from .page import page


def write_report(reports: Sequence[Findings], folder: Path) -> tuple[Path, ...]:
    """Write report.html, report.json, report.csv and NAME_*.png, NAME_*.svg; return their paths, the page first."""
    drawings = [pictures(found) for found in reports]
    contents = {
        "report.html": page(reports, drawings).encode(),
        "report.json": as_json(reports).encode(),
        "report.csv": as_csv(reports).encode(),
    }
    for picture in (p for drawn in drawings for p in drawn):
        contents |= {f"{picture.stem}.png": picture.png, f"{picture.stem}.svg": picture.svg.encode()}
    for name, content in contents.items():
        write(folder / name, content)
    return tuple(folder / name for name in contents)
