"""Files of a report."""

from collections.abc import Sequence
from pathlib import Path

from ..building.toolchain import toolchain
from ..presentation.machine import machine
from ..presentation.page import write_page
from .curves import pictures
from .examine import Findings
from .number_files import one_a_line, record
from .page import page


def write_report(reports: Sequence[Findings], folder: Path) -> tuple[Path, ...]:
    """Write report.html, report.json, report.csv and NAME_*.png, NAME_*.svg; return their paths, the page first."""
    drawings, known = [pictures(findings) for findings in reports], machine(toolchain().described)
    texts = {
        "report.html": page(reports, drawings, known),
        "report.json": record(reports, known),
        "report.csv": one_a_line(reports),
    }
    return write_page(folder, texts, [picture for drawn in drawings for picture in drawn])
