"""A measurement of the report, as tests use it."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import SimpleNamespace

import pytest


@contextmanager
def undisturbed() -> Iterator[pytest.MonkeyPatch]:
    """Time is what this process computes, which does not grow where others use the machine."""
    with pytest.MonkeyPatch.context() as patch:
        for module in ("measure", "peers"):
            patch.setattr(f"eigenmotion.report.{module}.time", SimpleNamespace(perf_counter=time.process_time))
        yield patch
