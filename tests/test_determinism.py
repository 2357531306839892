"""The same model gives the same bytes, whatever the order in which Python hashes."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from .models_table import HEAVY

MODELS = sorted(path for path in (Path(__file__).parents[1] / "models").glob("*.py") if path.stem != "__init__")
LIGHT = [path for path in MODELS if path.stem not in HEAVY]
MORE_SEEDS = pytest.param(("0", "1", "2", "4294967295"), MODELS, marks=pytest.mark.nightly)


@pytest.mark.parametrize(("seeds", "models"), [(("0", "1234567"), LIGHT), MORE_SEEDS], ids=["light", "all"])
def test_the_hash_seed_changes_no_byte(seeds, models, tmp_path):
    first, *others = (generated(seed, tmp_path / seed, models) for seed in seeds)
    assert len(first) == 3 * len(models) > 0
    for seed, files in zip(seeds[1:], others, strict=True):
        assert files.keys() == first.keys()
        assert [name for name in files if files[name] != first[name]] == [], seed


def generated(seed: str, folder: Path, models: list[Path]) -> dict[str, bytes]:
    """File name -> bytes of the models' sources, generated in one fresh process."""
    command = [sys.executable, "-m", "eigenmotion", "generate", "-o", str(folder), *map(str, models)]
    given = {**os.environ, "PYTHONHASHSEED": seed}
    done = subprocess.run(command, env=given, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return {path.name: path.read_bytes() for path in folder.iterdir()}
