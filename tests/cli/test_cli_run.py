"""`eigenmotion run`: what it takes, says and saves."""

import re
from pathlib import Path

import mpmath
import numpy as np
import pytest

from eigenmotion.cli import main

from ..conftest import SCENE


def summary_of(text):
    return {match[1].strip(): match[2] for match in re.finditer(r"^(\S.{0,21}) (\S.*)$", text, re.M)}


def test_run_prints_a_summary(scene, capsys):
    assert main(["run", "scene.py", "--t-end", "2", "--rtol", "1e-9"]) == 0
    rows = summary_of(capsys.readouterr().out)
    assert rows["ended"] == "finished at t = 2"
    assert float(rows["energy drift"].split()[0]) < 1e-7
    assert "constraint violation" not in rows
    assert "angle" in rows


@pytest.mark.parametrize(("end", "mode"), [("0.2", "friction slides forward"), ("2", "friction stuck")])
def test_run_says_the_mode_in_words(capsys, end, mode):
    """A block that is pushed up an incline comes to rest there after 0.39 s."""
    assert main(["run", "models/block_on_incline.py", "--t-end", end]) == 0
    assert summary_of(capsys.readouterr().out)["mode at the end"] == mode


def test_run_takes_parameters_initial_values_and_rates(scene, capsys):
    assert main(["run", "scene.py", "--t-end", "1.5", "--set", "g=0", "--set", "angle=0.25", "--set", "angle'=2"]) == 0
    final = capsys.readouterr().out.splitlines()[-1].split()
    assert [float(word) for word in final[1:]] == pytest.approx([3.25, 2.0], rel=1e-8)


def test_run_estimates_its_error(scene, capsys):
    """Against the closed form of a pendulum."""
    assert main(["run", "scene.py", "--t-end", "3", "--rtol", "1e-7", "--atol", "1e-7", "--estimate-error"]) == 0
    out = capsys.readouterr().out
    rows = summary_of(out)
    final = out.splitlines()[-1].split()
    k = mpmath.sin(0.25)
    exact = 2 * mpmath.asin(k * mpmath.ellipfun("cd", 3 * mpmath.sqrt(mpmath.mpf("9.81")), k=k))
    true = abs(float(mpmath.mpf(final[1]) - exact))
    assert float(final[3]) == pytest.approx(true, rel=0.3)
    at_end, on_the_way = (float(word) for word in re.findall(r"[\d.]+e-\d+", rows["estimated error"]))
    assert at_end == pytest.approx(true / (1 + abs(float(exact))), rel=0.3)
    assert at_end <= on_the_way < 1e-5
    words = r"dop853 at rtol 1.0e-09, \d+ right-hand sides, [\d.]+ m?s: [\d.]+ times as long as the steps of the first"
    assert re.fullmatch(words, rows["from a second run"])


def test_run_that_goes_nowhere_has_no_error_to_estimate(scene, capsys):
    scene.write_text(SCENE.replace("-n * m * g * cos(angle)", "-m / angle"))
    assert main(["run", "scene.py", "--set", "angle=1e-300", "--estimate-error"]) == 2
    out = capsys.readouterr().out
    assert summary_of(out)["estimated error"] == "There are no rows to compare."
    assert "nan" not in out


def test_run_says_what_limits_the_estimate(scene, capsys):
    assert main(["run", "scene.py", "--t-end", "1", "--rtol", "1e-13", "--atol", "1e-13", "--estimate-error"]) == 0
    assert "good to a factor of about 3" in capsys.readouterr().out


def test_run_without_an_estimate_does_not_speak_of_it(scene, capsys):
    assert main(["run", "scene.py", "--t-end", "1"]) == 0
    assert "error" not in capsys.readouterr().out


def test_run_saves_and_draws(scene, capsys):
    assert main(["run", "scene.py", "--t-end", "1", "--save", "a.npz", "--plot", "a.png"]) == 0
    assert main(["run", "scene.py", "--t-end", "1", "--save", "a.csv"]) == 0
    with np.load("a.npz") as file:
        saved = dict(file)
    names = Path("a.csv").read_text().splitlines()[0].split(",")
    table = np.loadtxt("a.csv", delimiter=",", skiprows=1)
    assert names == ["t", "angle", "angle'", "energy"]
    assert np.array_equal(table[:, 0], saved["t"])
    assert np.array_equal(table[:, 1], saved["x"][0])
    assert np.array_equal(table[:, 2], saved["v"][0])
    assert Path("a.png").read_bytes().startswith(b"\x89PNG")


def read(name):
    lines = Path(name).read_text().splitlines()
    return lines[0].split(","), np.loadtxt(lines[1:], delimiter=",", ndmin=2)


def test_run_saves_rows_at_equal_distances(scene, capsys):
    """At small angles and g = 1, angle = 0.5e-4 cos(t)."""
    small = ["--set", "g=1", "--set", "angle=0.5e-4", "--rtol", "1e-10", "--atol", "1e-14", "--t-end", "2"]
    assert main(["run", "scene.py", *small, "--save", "a.csv", "--rows", "9"]) == 0
    assert main(["run", "scene.py", *small, "--save", "b.csv", "--every", "0.25"]) == 0
    assert main(["run", "scene.py", *small, "--save", "c.csv", "--every", "0.3"]) == 0
    assert Path("a.csv").read_text() == Path("b.csv").read_text()
    _, table = read("a.csv")
    np.testing.assert_allclose(table[:, 0], np.linspace(0, 2, 9), atol=1e-15)
    np.testing.assert_allclose(table[:, 1], 0.5e-4 * np.cos(table[:, 0]), atol=1e-12)
    np.testing.assert_allclose(read("c.csv")[1][:, 0], 0.3 * np.arange(7), atol=1e-15)
    capsys.readouterr()
    for wrong, words in ((["--rows", "5"], "--save"), (["--rows", "5", "--every", "1", "--save", "a.csv"], "not both")):
        assert main(["run", "scene.py", *wrong]) == 2
        assert words in capsys.readouterr().err


def test_run_saves_rows_over_a_coordinate(scene, capsys):
    """Without gravity the angle grows evenly: 0.25 + 2 t."""
    command = ["run", "scene.py", "--t-end", "1.5", "--set", "g=0", "--set", "angle=0.25", "--set", "angle'=2"]
    assert main([*command, "--over", "angle", "--rows", "4", "--save", "a.csv", "--plot", "a.png"]) == 0
    assert main([*command, "--over", "angle", "--every", "1.25", "--save", "b.csv"]) == 0
    for name, angles in (("a.csv", [0.25, 1.25, 2.25, 3.25]), ("b.csv", [0.25, 1.5, 2.75])):
        table = read(name)[1]
        np.testing.assert_allclose(table[:, 1], angles, atol=1e-12)
        np.testing.assert_allclose(table[:, 0], (table[:, 1] - 0.25) / 2, atol=1e-12)
    capsys.readouterr()
    for wrong, words in ((["--over", "angel"], "the coordinates are angle"), (["--over", "angle"], "give --rows")):
        assert main([*command, *wrong]) == 2
        assert words in capsys.readouterr().err


LOOP = """\
from sympy import cos, sin
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model, draw
q1, q2, x = dynamicsymbols("q1 q2 x")
model = Model(
    name="loop", coordinates=[q1, q2, x], initial={q1: 1, q2: -0.3, x: 0.7},
    kinetic_energy=(q1.diff() ** 2 + q2.diff() ** 2 + x.diff() ** 2) / 2,
    holonomic_constraints=[0.2 * cos(q1) + 0.6 * cos(q2) - x, 0.2 * sin(q1) + 0.6 * sin(q2)],
    drawing=[draw.Line((0, 0), (x, 0))],
)
"""


def closed(angle):
    """x of the loop, by the law of cosines."""
    return 0.2 * np.cos(angle) + np.sqrt(0.36 - (0.2 * np.sin(angle)) ** 2)


def test_run_closes_a_start_when_asked(scene, capsys):
    """Values that are set are kept."""
    scene.write_text(LOOP)
    assert main(["run", "scene.py", "--t-end", "1"]) == 2
    assert "--assemble" in capsys.readouterr().err
    command = ["run", "scene.py", "--t-end", "1", "--set", "q1=0.9", "--set", "q1'=2", "--save", "a.csv"]
    assert main([*command, "--assemble"]) == 0
    assert summary_of(capsys.readouterr().out)["assembled"].startswith("q2 moved most")
    head, table = read("a.csv")
    first = dict(zip(head, table[0], strict=True))
    assert first["q1"] == 0.9
    assert first["q1'"] == 2.0
    assert first["x"] == pytest.approx(closed(0.9), abs=1e-12)


def test_run_says_why_a_start_cannot_be_closed(scene, capsys):
    scene.write_text(LOOP)
    assert main(["run", "scene.py", "--assemble", "--set", "x=0.95"]) == 2
    assert "cannot be closed with x kept" in capsys.readouterr().err


def test_a_run_that_ends_early_answers_2_and_says_why(scene, capsys):
    scene.write_text(SCENE.replace("- n", "-n").replace("=-n * m * g * cos(angle)", "=-m * g * angle**4"))
    assert main(["run", "scene.py", "--t-end", "100"]) == 2
    out = capsys.readouterr().out
    assert "finished" not in out
    assert "angle" in out


def test_run_takes_inputs(scene, capsys):
    """A body of mass 1 pushed by a force of 3 N: x = v0 t + 3 t^2 / 2."""
    scene.write_text(
        "from sympy.physics.mechanics import dynamicsymbols\n"
        "from eigenmotion import Model\n"
        'q, u = dynamicsymbols("q u")\n'
        'model = Model(name="pushed", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, forces=[u], inputs={u: 0})\n'
    )
    assert main(["run", "scene.py", "--t-end", "2", "--set", "u=3", "--set", "q'=1"]) == 0
    final = capsys.readouterr().out.splitlines()[-1].split()
    assert [float(word) for word in final[1:]] == pytest.approx([8.0, 7.0], rel=1e-12)


def test_so_many_rows_are_refused_before_the_run(scene, capsys):
    """It was an internal error of NumPy, after the run."""
    assert main(["run", "scene.py", "--t-end", "1", "--save", "a.csv", "--every", "1e-300"]) == 2
    found = capsys.readouterr()
    assert "--every: so many rows take 1e+293 GB" in found.err
    assert "finished" not in found.out


def test_an_output_that_is_closed_is_no_failure(scene, monkeypatch):
    """As by >&- in a shell: it was an internal error, with exit code 3."""
    monkeypatch.setattr("sys.stdout", None)
    assert main(["run", "scene.py", "--t-end", "1"]) == 0
