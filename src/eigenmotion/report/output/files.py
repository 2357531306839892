"""Files of a report."""

from collections.abc import Sequence
from pathlib import Path

from ...building.toolchain import toolchain
from ...presentation.machine import machine
from ...presentation.page import write_page
from ..examine import Findings
from .chart import charts
from .curves import pictures
from .live.page import page
from .number_files import one_a_line, record


def write_report(reports: Sequence[Findings], folder: Path, everything: bool = False) -> tuple[Path, ...]:
    """Write report.html, report.json, report.csv and NAME_*.png, NAME_*.svg; return their paths, the page first.

    everything : draw all curves in the pictures; the page shows them on demand
    """
    drawings, known = [charts(findings) for findings in reports], machine(toolchain().described)
    texts = {
        "report.html": page(reports, drawings, known),
        "report.json": record(reports, known),
        "report.csv": one_a_line(reports),
    }
    return write_page(folder, texts, pictures([chart for drawn in drawings for chart in drawn], everything))
