"""Shared by the tests of single models: their pictures, pages and time integrals of outputs."""

from pathlib import Path

import numpy as np
import pytest

from eigenmotion import Solution, System
from eigenmotion.building.errors import BuildError
from eigenmotion.cli import main
from eigenmotion.webpage import wasm

MODELS = Path(__file__).parents[2] / "models"


def check_picture(name: str, folder: Path, *options: str) -> None:
    """`eigenmotion run models/NAME.py --plot` draws curves and the mechanism in more than one colour."""
    image = pytest.importorskip("matplotlib.image")
    file = folder / f"{name}.png"
    assert main(["run", str(MODELS / f"{name}.py"), "--plot", str(file), *options]) == 0
    pixels = image.imread(file)
    assert min(pixels.shape[:2]) > 300
    left, right = np.array_split(pixels[..., :3], 2, axis=1)
    for half in (left, right):
        assert len(np.unique((8 * half).round().reshape(-1, 3), axis=0)) > 10


def check_page(name: str, folder: Path) -> None:
    """`eigenmotion page models/NAME.py` writes one file that loads nothing."""
    try:
        wasm.wasm_compiler()
    except BuildError as error:
        pytest.skip(str(error))
    file = folder / f"{name}.html"
    assert main(["page", str(MODELS / f"{name}.py"), "-o", str(file)]) == 0
    text = file.read_text(encoding="utf-8")
    assert name in text
    assert 'id="about"' in text


def integrals(system: System, span: tuple[float, float], names: tuple[str, ...], **options) -> tuple[Solution, list]:
    """Return a run, and time integrals of outputs by Gauss's quadrature with eight nodes in each of its steps."""
    run = system.simulate(span, **options)
    edges = run.t[np.concatenate([[True], np.diff(run.t) > 1e-13 * (span[1] - span[0])])]
    nodes, weights = np.polynomial.legendre.leggauss(8)
    half = np.diff(edges)[:, None] / 2
    times = edges[:-1, None] + half * (1 + nodes)
    fine = system.simulate(span, t_eval=times.ravel(), **options)
    assert run.success
    assert fine.success
    return run, [float(np.sum(half * weights * fine.outputs[name].reshape(times.shape))) for name in names]
