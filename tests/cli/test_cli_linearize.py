"""`eigenmotion linearize` and `eigenmotion equilibrium`: what they take, say and draw."""

import numpy as np
import pytest

from eigenmotion.cli import main


def test_linearize_prints_modes_and_draws(scene, capsys):
    assert main(["linearize", "scene.py", "--at", "angle=0", "--at", "g=4", "--plot", "plane.svg"]) == 0
    out = capsys.readouterr().out
    assert "steady: at rest" in out
    assert f"{2 / (2 * np.pi):.4g}" in out
    assert "undamped: angle" in out
    assert "no mode grows" in out
    assert scene.with_name("plane.svg").stat().st_size > 1000


def test_linearize_says_where_it_is_not_steady(scene, capsys):
    assert main(["linearize", "scene.py"]) == 0
    assert "not steady" in capsys.readouterr().out


def test_equilibrium(scene, capsys):
    assert main(["equilibrium", "scene.py", "--set", "angle=3"]) == 0
    out = capsys.readouterr().out
    assert "3.14159" in out
    assert "unstable: 1 of 2 modes grow" in out
    assert main(["equilibrium", "scene.py", "--set", "angle'=1"]) == 2
    assert "for an instant only" in capsys.readouterr().out
    assert main(["equilibrium", "scene.py", "--free", "g"]) == 0
    assert "g = 0" in capsys.readouterr().out


LEANS = """
from sympy import Symbol, cos
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Contact, Model

angle, g = dynamicsymbols("angle"), Symbol("g")
model = Model(name="leans", coordinates=[angle], kinetic_energy=angle.diff() ** 2 / 2, potential_energy=-g * cos(angle),
              parameters={g: 9.81}, initial={angle: 0.1}, contacts={"wall": Contact(angle - 0.1, rest=0.01)})
"""


def test_what_leans(scene, capsys):
    scene.with_name("leans.py").write_text(LEANS)
    assert main(["equilibrium", "leans.py", "--set", "angle=0.5"]) == 0
    out = capsys.readouterr().out
    assert "0 states" in out
    assert "mode: wall_held = 1" in out
    assert "held: nothing can move" in out
    assert main(["equilibrium", "leans.py", "--set", "g=0"]) == 0
    out = capsys.readouterr().out
    assert "at rest, wall held; contact 'wall' touches without force" in out
    assert "modes meet at this state" in out
    assert main(["equilibrium", "leans.py", "--set", "g=0", "--set", "wall_held=0"]) == 0
    assert "2 states" in capsys.readouterr().out
    assert main(["linearize", "leans.py", "--at", "g=0"]) == 2
    assert "modes meet at this state" in capsys.readouterr().err
    assert main(["linearize", "leans.py", "--at", "g=0", "--at", "wall_held=1"]) == 0
    assert "0 states" in capsys.readouterr().out
    assert main(["linearize", "leans.py", "--at", "angle=0"]) == 2
    assert "inside contact 'wall', and with angle kept" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["linearize", "scene.py", "--at", "size=1"], ["linearize", "scene.py", "--at", "g"],
                                   ["linearize", "scene.py", "--plot", "plane.txt"],
                                   ["linearize", "scene.py", "--at", "g=heavy"],
                                   ["equilibrium", "scene.py", "--free", "size"]])  # fmt: skip
def test_mistakes_are_2(scene, capsys, words):
    assert main(words) == 2
    assert words[-1].split("=")[0] in capsys.readouterr().err
