"""Runs models/four_bar.py."""

from collections.abc import Iterator
from pathlib import Path
from time import perf_counter

from four_bar import SPAN, Trial

import eigenmotion as em

TOLERANCE = 1e-9


def trials() -> Iterator[Trial]:
    """Run models/four_bar.py."""
    system_ = em.build(Path(__file__).parents[3] / "models" / "four_bar.py")
    system_.simulate((0.0, SPAN), rtol=TOLERANCE, atol=TOLERANCE)
    before = perf_counter()
    run = system_.simulate((0.0, SPAN), rtol=TOLERANCE, atol=TOLERANCE)
    yield Trial(f"dop853, {TOLERANCE:g}", run.x[:, -1], run.v[:, -1], perf_counter() - before)
