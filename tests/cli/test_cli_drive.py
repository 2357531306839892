"""The command `eigenmotion drive`."""

from pathlib import Path

import numpy as np
import pytest

from eigenmotion.cli import main

MODEL = str(Path(__file__).parents[2] / "models" / "four_bar.py")


def test_an_expression_and_a_file_give_the_same(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    t = np.linspace(0.0, 1.0, 101)
    np.savetxt("crank.csv", np.column_stack([t, 0.5 + 2 * t + 0.1 * np.sin(3 * t)]), delimiter=",", header="t,q1",
               comments="")  # fmt: skip
    common = [MODEL, "--rows", "51", "--formulation", "lagrange"]
    assert main(["drive", *common, "--path", "q1=0.5+2*t+sin(3*t)/10", "--t-end", "1", "-o", "a.csv"]) == 0
    first = capsys.readouterr().out
    assert main(["drive", *common, "--path", "q1=crank.csv", "--actuators", "q1", "-o", "b.csv"]) == 0
    assert "saved to b.csv" in capsys.readouterr().out
    assert "four_bar, t = 0 ... 1 in 51 rows" in first
    one, two = (np.genfromtxt(name, delimiter=",", names=True, deletechars="") for name in ("a.csv", "b.csv"))
    assert one.dtype.names == two.dtype.names
    assert np.abs(one["force_q1"] - two["force_q1"]).max() < 1e-4 * np.abs(one["force_q1"]).max()
    largest = one["force_q1"][np.abs(one["force_q1"]).argmax()]
    assert f"{largest:.6g}" in first


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--path", "q1=nothing.csv"], "nothing.csv"),
        (["--path", "q1=wrong.csv"], "the first line names the columns, t and q1"),
        (["--path", "q1=("], "is no expression in t"),
        (["--path", "q1=w*t"], "has w in it"),
        (["--path", "q9=t"], "q9"),
        (["--path", "q1=t", "--path", "q1=2*t"], "given twice"),
        (["--path", "q1=0.5+t", "--actuators", "u"], "actuator"),
        (["--path", "q1=0.5+t", "--set", "q1'=1"], "rates follow from the paths"),
        (["--path", "q1=0.5+t", "-o", "a.txt"], "known endings"),
        ([], "--path"),
    ],
)
def test_mistakes_are_named(tmp_path, capsys, monkeypatch, options, words):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wrong.csv").write_text("a,b\n1,2\n", encoding="utf-8")
    assert main(["drive", MODEL, "--formulation", "lagrange", *options]) == 2
    assert words in capsys.readouterr().err
