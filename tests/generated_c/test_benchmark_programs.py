"""Programs that benchmarks build around generated C."""

import sys
from pathlib import Path

import pytest
from eigenmotion.models import pendulum

sys.path.append(str(Path(__file__).parents[2] / "benchmarks"))
from common.plain import compiled, generated

HURRIED = "-O0"


@pytest.mark.parametrize("main", ["run.c", "right_hand_side.c", "control.c"])
def test_programs_around_generated_c_compile(main, tmp_path):
    work = generated(pendulum.model, tmp_path / "generated")
    assert compiled(work, "pendulum", ("pendulum.c",), main, HURRIED).exists()
