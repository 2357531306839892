"""Prescribed motions on the command line, on pages and in units."""

from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion.cli import main

from ..support.fmu_slaves import Unit

SOURCE = """
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model

x, y, path = dynamicsymbols("x y path")
model = Model(
    name="driven_elsewhere",
    coordinates=[x, y],
    kinetic_energy=x.diff() ** 2 / 2 + y.diff() ** 2 / 2,
    potential_energy=2 * (y - x) ** 2,
    holonomic_constraints={"drive": x - path},
    inputs={path: 0.5},
    initial={x: 0.5},
)
"""


@pytest.fixture(autouse=True)
def driven(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Return the file of a mass on a spring, whose other end is driven; y = (1 - cos 2 t) path where it is held."""
    monkeypatch.chdir(tmp_path)
    Path("driven.py").write_text(SOURCE)
    return "driven.py"


def test_a_run_holds_a_joint_at_a_constant(driven, capsys):
    assert main(["run", driven, "--t-end", "1", "--set", "path=0.3"]) == 2
    assert "constraint drive" in (words := capsys.readouterr().err)
    assert "x0 = [0.3, 0]" in words
    assert main(["run", driven, "--t-end", "1", "--rtol", "1e-9", "--set", "path=0.3", "--set", "x=0.3",
                 "--save", "run.csv"]) == 0  # fmt: skip
    end = np.loadtxt("run.csv", delimiter=",", skiprows=1)[-1]
    np.testing.assert_allclose(end[:3], [1.0, 0.3, 0.3 * (1 - np.cos(2))], rtol=0, atol=1e-8)


def test_a_sweep_takes_constants_and_says_why_runs_fail(driven, capsys):
    given = ["sweep", driven, "--t-end", "1", "--rtol", "1e-9", "-o", "runs.npz"]
    assert main([*given, "--sweep", "path=0.5,0.3"]) == 0
    out = capsys.readouterr().out
    assert "1 start refused  (run 1)" in out
    assert "constraint drive by 0.2" in out
    assert "x0 = [0.3, 0]" in out
    np.testing.assert_allclose(np.load("runs.npz")["x"][0, :, 0], [0.5, 0.5 * (1 - np.cos(2))], rtol=0, atol=1e-8)


def test_a_page_refuses_another_path(driven, capsys):
    assert main(["page", driven, "--set", "path=0.3"]) == 2
    assert "--set path: it prescribes a motion" in capsys.readouterr().err
    assert not list(Path().glob("*.html"))


def test_a_unit_holds_the_default(driven, capsys):
    file = em.export_fmu(driven, "driven.fmu", rtol=1e-9)
    unit, other = Unit(file, Path("unit").absolute()), Unit(file, Path("other").absolute())
    unit.begin()
    unit.step(0.0, 1.0)
    np.testing.assert_allclose(unit.get("x", "y"), [0.5, 0.5 * (1 - np.cos(2))], rtol=0, atol=1e-7)
    with pytest.raises(Exception, match="fmi2SetReal failed"):
        other.begin(path=0.3)
    assert "path prescribes a motion" in capsys.readouterr().out  # by the unit's logger
