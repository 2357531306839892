"""The same model gives the same bytes, whatever the order in which Python hashes."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
MODELS = sorted(path for path in (ROOT / "models").glob("*.py") if path.stem != "__init__")
SEEDS = ("0", "1", "2", "1234567", "4294967295")


@pytest.fixture(scope="module")
def generated(tmp_path_factory):
    """For each seed, file name -> bytes of every model's sources, generated in one fresh process."""
    return {seed: _generate(seed, tmp_path_factory.mktemp(f"seed{seed}")) for seed in SEEDS}


def _generate(seed, folder):
    command = [sys.executable, "-m", "eigenmotion", "generate", "-o", str(folder), *map(str, MODELS)]
    done = subprocess.run(
        command, env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_every_model_is_generated(generated):
    assert MODELS
    assert all(len(files) == 3 * len(MODELS) for files in generated.values())


@pytest.mark.parametrize("seed", SEEDS[1:])
def test_the_hash_seed_changes_no_byte(generated, seed):
    assert generated[seed].keys() == generated[SEEDS[0]].keys()
    assert [name for name, content in generated[seed].items() if content != generated[SEEDS[0]][name]] == []
