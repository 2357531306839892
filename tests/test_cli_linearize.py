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


@pytest.mark.parametrize("words", [["linearize", "scene.py", "--at", "size=1"], ["linearize", "scene.py", "--at", "g"],
                                   ["linearize", "scene.py", "--plot", "plane.txt"],
                                   ["linearize", "scene.py", "--at", "g=heavy"],
                                   ["equilibrium", "scene.py", "--free", "size"]])  # fmt: skip
def test_mistakes_are_2(scene, capsys, words):
    assert main(words) == 2
    assert words[-1].split("=")[0] in capsys.readouterr().err
