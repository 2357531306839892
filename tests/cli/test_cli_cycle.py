"""The command `eigenmotion cycle`."""

from pathlib import Path

import pytest

from eigenmotion.cli import main

MODELS = Path(__file__).parents[2] / "models"
GAIT = [str(MODELS / "compass_gait.py"), "--formulation", "lagrange", "--section", "heel strike"]


def test_a_gait_and_its_branch(tmp_path, capsys):
    picture = tmp_path / "branch.svg"
    assert main(["cycle", *GAIT, "--follow", "gamma=0.016", "--plot", str(picture)]) == 0
    said = capsys.readouterr().out
    assert "period 3.88194 s, stable" in said
    assert "theta = 0.20016" in said
    assert "doubling at 0.014935" in said
    assert "largest multiplier -1" in said
    assert "doubling" in picture.read_text(encoding="utf-8")


def test_a_turn_of_a_pendulum(tmp_path, capsys):
    picture = tmp_path / "motion.png"
    turn = [str(MODELS / "pendulum.py"), "--formulation", "lagrange", "--set", "theta=0", "--set", "theta'=7",
            "--section", "theta", "--symmetry", "theta=theta+2*pi", "--plot", str(picture)]  # fmt: skip
    assert main(["cycle", *turn]) == 0
    assert "one of a family" in capsys.readouterr().out
    assert picture.stat().st_size > 1000


def test_a_slope_for_a_rate(capsys):
    """sin(gamma) = (1.5 tan(2 alpha))^2 l / (4 g sin(alpha))."""
    wheel = [str(MODELS / "rimless_wheel.py"), "--formulation", "lagrange", "--section", "theta", "--free", "gamma",
             "--direction", "1", "--condition", "theta' - 1.5"]  # fmt: skip
    assert main(["cycle", *wheel]) == 2
    assert "section 'theta' is a name" in capsys.readouterr().err
    wheel[4:5], wheel[7:9] = ["step"], []
    assert main(["cycle", *wheel]) == 0
    assert "gamma = 0.150401591" in capsys.readouterr().out


def test_no_cycle(capsys):
    assert main(["cycle", str(MODELS / "pendulum.py"), "--formulation", "lagrange", "--set", "theta=0", "--period", "1"]
                ) == 2  # fmt: skip
    assert "equilibrium" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--follow", "gamma"], "expected NAME=VALUE"),
        (["--follow", "gamma=much"], "no number"),
        (["--period", "2*pi/w"], "expression of parameters"),
        (["--plot", "a.txt"], "known endings"),
        (["--section", "toe strike"], "unknown section"),
    ],
)
def test_mistakes_are_named(tmp_path, capsys, monkeypatch, options, words):
    monkeypatch.chdir(tmp_path)
    assert main(["cycle", *GAIT, *options]) == 2
    assert words in capsys.readouterr().err
