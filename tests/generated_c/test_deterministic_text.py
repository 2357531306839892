"""The same model gives the same bytes, whatever the order in which Python hashes."""

import os
import subprocess
import sys
from hashlib import sha256
from pathlib import Path

import pytest

from ..support.models_table import HEAVY

MODELS = sorted(path for path in (Path(__file__).parents[2] / "models").glob("*.py") if path.stem != "__init__")
BY_DAY = [path for path in MODELS if path.stem not in HEAVY][::3]
"""Every third, with one seed. `make check` holds all models against the same sums, with a seed that
Python draws."""
SUMS = (Path(__file__).parents[2] / "generated" / "sums.txt").read_text(encoding="utf-8").splitlines()
MORE_SEEDS = pytest.param(("0", "1", "2", "4294967295"), MODELS, marks=pytest.mark.nightly)


@pytest.mark.parametrize(("seeds", "models"), [(("1234567",), BY_DAY), MORE_SEEDS], ids=["day", "all"])
def test_the_hash_seed_changes_no_byte(seeds, models, tmp_path):
    """By the committed sums, which are there for every default of a model."""
    right = {name: digest for digest, name in map(str.split, SUMS)}
    for seed in seeds:
        files = generated(seed, tmp_path / seed, models)
        assert len(files) == 3 * len(models) > 0
        assert [name for name, text in files.items() if sha256(text).hexdigest() != right[name]] == [], seed


def generated(seed: str, folder: Path, models: list[Path]) -> dict[str, bytes]:
    """File name -> bytes of the models' sources, generated in one fresh process."""
    command = [sys.executable, "-m", "eigenmotion", "generate", "-o", str(folder), *map(str, models)]
    given = {**os.environ, "PYTHONHASHSEED": seed, "OPENBLAS_CORETYPE": "Haswell"}  # as the Makefile says
    done = subprocess.run(command, env=given, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return {path.name: path.read_bytes() for path in folder.iterdir()}
