"""Files of the limits of a model."""

from itertools import chain
from pathlib import Path

from ...building.toolchain import toolchain
from ...presentation.machine import machine
from ...presentation.page import write_page
from ..output.files import numbers
from ..output.page import page
from .drawing import pictures_of
from .survey import Limits
from .text import summary_of


def write_limits(found: Limits, folder: Path) -> tuple[Path, ...]:
    """Write stability.html, stability.json and stability_*.png, stability_*.svg; return their paths, the page first."""
    drawn, known, lines = pictures_of(found), machine(toolchain().described), summary_of(found)
    own = found.own
    record = {
        "model": own.model.name, "span": own.span, "period": own.period, "budget": found.budget, "summary": lines,
        "formulations": own.formulations, "no_reference": own.why, "unbuilt": found.unbuilt,
        "singular_positions": found.searched, "left_out": found.left_out,
    }  # fmt: skip
    texts = {
        "stability.html": page(found.matrix, drawn, known, heading=own.model.name, lines=lines),
        "stability.json": numbers(found.matrix, known, record),
    }
    return write_page(folder, texts, chain.from_iterable(drawn.values()))
