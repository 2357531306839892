"""Tables without Python: in units for other tools, and in pages."""

from pathlib import Path

import numpy as np
import pytest
import scipy.interpolate as si
from sympy import cos, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.browser import opened_page
from ..support.fmu_slaves import Unit

THETA = dynamicsymbols("theta")
ANGLES = np.linspace(-4.0, 4.0, 33)
LOAD = em.Table(si.CubicSpline(ANGLES, np.sin(3.0 * ANGLES)), name="load")
MODEL = em.Model(
    name="loaded_elsewhere",
    coordinates=[THETA],
    kinetic_energy=THETA.diff() ** 2 / 2,
    potential_energy=LOAD(THETA) / 10 - 9.81 * cos(THETA),
    forces={THETA: LOAD(THETA)},
    initial={THETA: 1.0},
    drawing=[em.draw.Line((0, 0), (sin(THETA), -cos(THETA)))],
)


def test_a_unit_has_its_own_numbers(tmp_path: Path) -> None:
    """It moves as the model does, and takes no number for a table."""
    file = em.export_fmu(MODEL, tmp_path / "loaded.fmu")
    unit = Unit(file, tmp_path / "unit")
    unit.begin()
    unit.step(0.0, 0.5)
    run = em.build(MODEL).simulate((0.0, 0.5), rtol=1e-10, atol=1e-12)
    assert unit.get("theta") == pytest.approx(run.x[:, -1], abs=1e-7)
    with pytest.raises(Exception, match="fmi2SetReal failed"):
        Unit(file, tmp_path / "other").begin(load=3.0)


def test_a_page_moves_as_the_model_does(tmp_path: Path) -> None:
    """The same numbers in WebAssembly, where addresses have 32 bits; and no slider for a table."""
    run = em.build(MODEL).simulate((0.0, 2.0), rtol=1e-10, atol=1e-12)
    with opened_page(MODEL, tmp_path / "loaded.html", 2.0) as browser:
        end = browser.ask("Array.from(eigenmotion.motion.table.slice(-eigenmotion.motion.width))")
        sliders = browser.ask("document.querySelectorAll('input[type=range][data-name=load]').length")
    assert end[1] == pytest.approx(run.x[0, -1], abs=1e-7)
    assert sliders == 0
