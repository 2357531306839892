"""Cases that are left for the night run where somebody names them, and are counted by their rule where nobody does."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FILE = "tests/stepper/test_stepper.py"


def collected(*asked):
    command = [Path(sys.executable).parent / "pytest", "--collect-only", "-q", *asked]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout


@pytest.mark.nightly
def test_what_is_named_runs():
    everything, by_day = collected(FILE, "-m", ""), collected(FILE)
    left_out = [case for case in everything.splitlines() if "::" in case and case not in by_day.splitlines()]
    assert f"{len(left_out):5} " in by_day
    assert left_out[0] in collected(left_out[0])
    assert left_out[0] in collected(FILE, "-k", left_out[0].partition("::")[2].partition("[")[0])
    assert left_out[0] not in collected(FILE, "-m", "not nightly")
