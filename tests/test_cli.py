"""The command line: what it writes, says and answers."""

import io
import logging
import os
import re
import subprocess
import sys
import time
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import mpmath
import numpy as np
import pytest

from eigenmotion.cli import main
from eigenmotion.cli.progress import bar, clock

ROOT = Path(__file__).parents[1]
MODELS = ROOT / "models"
SCENE = """\
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model

angle = dynamicsymbols("angle")
m, g = symbols("m g", positive=True)

def model(n: int = 1, tag: str = ""):
    return Model(name=f"swing{n}{tag}", coordinates=[angle], kinetic_energy=m * angle.diff() ** 2 / 2,
                 potential_energy=-n * m * g * cos(angle), parameters={m: 1.0, g: 9.81}, initial={angle: 0.5})
"""


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory, monkeypatch):
    """One cache for this file's tests, none of the user's."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path_factory.getbasetemp() / "cli-cache"))


@pytest.fixture
def scene(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "scene.py"
    path.write_text(SCENE)
    return path


def files(folder="generated"):
    return {path.name: path.read_text() for path in Path(folder).glob("*") if path.suffix in {".c", ".h", ".pyx"}}


def test_generate_writes_sources_that_do_not_name_this_machine(scene, tmp_path):
    assert main(["generate", "scene.py"]) == 0
    assert set(files()) == {"swing1.c", "swing1.h", "swing1.pyx"}
    for text in files().values():
        assert "eigenmotion generate scene.py" in text
        assert str(tmp_path) not in text
        assert os.uname().nodename not in text


def test_the_folder_and_the_way_to_the_model_change_no_byte(scene, tmp_path):
    main(["generate", "scene.py"])
    assert main(["generate", str(scene), "-o", "elsewhere/deep"]) == 0
    assert files("elsewhere/deep") == files()


def test_generate_leaves_what_is_right_alone(scene, capsys):
    main(["generate", "scene.py"])
    before = Path("generated/swing1.c").stat().st_mtime_ns
    assert main(["generate", "scene.py"]) == 0
    assert Path("generated/swing1.c").stat().st_mtime_ns == before
    assert "same  generated/swing1.c" in capsys.readouterr().out


def test_definitions_reach_the_model_and_the_header(scene):
    assert main(["generate", "scene.py", "-D", "n=3", "-D", "tag=_b"]) == 0
    assert "eigenmotion generate scene.py -D n=3 -D tag=_b" in files()["swing3_b.c"]
    assert main(["generate", "--check", "--strict", "scene.py", "-D", "tag=_b", "-D", "n=3"]) == 0


@pytest.mark.parametrize("options", [["--check"], ["--check", "--strict"], ["--strict"], ["--check", "--diff"]])
def test_check_answers_0_when_nothing_differs(scene, options, capsys):
    main(["generate", "scene.py"])
    capsys.readouterr()
    assert main(["generate", *options, "scene.py"]) == 0
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize("options", [["--check"], ["--check", "--strict"], ["--check", "--diff"]])
@pytest.mark.parametrize("suffix", [".c", ".h", ".pyx"])
@pytest.mark.parametrize("edit", ["append", "first line", "delete", "inside"])
def test_check_finds_an_edited_file(scene, capsys, options, suffix, edit):
    main(["generate", "scene.py"])
    path = Path(f"generated/swing1{suffix}")
    text = path.read_text()
    lines = text.splitlines(keepends=True)
    middle = len(lines) // 2
    edited = {
        "append": text + "\n",
        "first line": text.replace("generate", "degenerate", 1),
        "inside": "".join([*lines[:middle], " ", *lines[middle:]]),
        "delete": None,
    }[edit]
    path.unlink() if edited is None else path.write_text(edited)
    assert main(["generate", *options, "scene.py"]) == 1
    out, err = capsys.readouterr()
    assert str(path) in err
    assert ("+++ " in out) == ("--diff" in options)
    assert (path.read_text() if path.exists() else None) == edited


@pytest.mark.parametrize("options", [["--check"], ["--strict"]])
@pytest.mark.parametrize(("old", "new"), [("9.81", "9.82"), ("- n * m", "- 2 * n * m"), ("angle: 0.5", "angle: 0.6")])
def test_check_finds_an_edited_model(scene, options, old, new):
    scene.write_text(SCENE.replace("=-n * m", "=- n * m"))
    main(["generate", "scene.py"])
    scene.write_text(SCENE.replace("=-n * m", "=- n * m").replace(old, new))
    assert main(["generate", *options, "scene.py"]) == 1


def test_check_finds_another_option(scene):
    main(["generate", "scene.py"])
    assert main(["generate", "--check", "--formulation", "lagrange", "scene.py"]) == 1


def test_diff_alone_writes_nothing_and_answers_0(scene, capsys):
    assert main(["generate", "--diff", "scene.py"]) == 0
    assert not Path("generated").exists()
    out = capsys.readouterr().out
    assert "--- /dev/null\n+++ generated/swing1.c" in out


def test_committed_sources_are_those_of_the_models():
    models = sorted(str(path) for path in MODELS.glob("*.py") if path.stem != "__init__")
    assert main(["generate", "--check", "-o", str(ROOT / "generated"), *models]) == 0


def test_build_makes_an_importable_module(scene):
    assert main(["build", "scene.py"]) == 0
    assert Path(f"generated/swing1{EXTENSION_SUFFIXES[0]}").is_file()
    script = "from generated import swing1; print(swing1.system.coordinates)"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "('angle',)"
    assert main(["generate", "--check", "--strict", "scene.py"]) == 0


def test_explain_names_states_and_what_was_left_out(capsys):
    assert main(["explain", str(MODELS / "dual_link.py")]) == 0
    text = capsys.readouterr().out
    for word in ("20 states", "theta1", "theta4", "additions"):
        assert word in text


def summary_of(text):
    return {match[1].strip(): match[2] for match in re.finditer(r"^(\S.{0,21}) (\S.*)$", text, re.M)}


def test_run_prints_a_summary(scene, capsys):
    assert main(["run", "scene.py", "--t-end", "2", "--rtol", "1e-9"]) == 0
    rows = summary_of(capsys.readouterr().out)
    assert rows["ended"] == "finished at t = 2"
    assert float(rows["energy drift"].split()[0]) < 1e-7
    assert "constraint violation" not in rows
    assert "angle" in rows


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


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "Usage"),
        (["frobnicate"], "No such command"),
        (["generate"], "Missing argument"),
        (["generate", "absent.py"], "no such file"),
        (["generate", "scene.py", "scene.py"], "more than one model is named swing1"),
        (["generate", "scene.py", "-D", "links=3"], "no argument `links`; it has `n`, `tag`"),
        (["generate", "scene.py", "-D", "n=three"], "n=three is not an int"),
        (["generate", "scene.py", "-D", "n"], "expected NAME=VALUE"),
        (["generate", "scene.py", "--formulation", "newton"], "newton"),
        (["run", "scene.py", "--set", "gee=1"], "gee: not known to swing1, which has"),
        (["run", "scene.py", "--set", "g=heavy"], "heavy is not a number"),
        (["run", "scene.py", "--method", "euler"], "euler"),
        (["run", "scene.py", "--save", "a.xlsx"], "known endings are .npz, .csv"),
        (["run", "scene.py", "--plot", "absent/a.png"], "there is no folder"),
        (["run", "scene.py", "--save", "/proc/a.npz"], "--save /proc: nothing can be written there"),
        (["run", "scene.py", "--plot", "/proc/a.png"], "--plot /proc: nothing can be written there"),
        (["run", "scene.py", "--plot", ""], "--plot"),
        *((["run", "scene.py", option, "nan"], f"'{option}'") for option in ("--t-end", "--rtol", "--atol")),
        (["run", "scene.py", "--t-end", "1e400"], "'--t-end'"),
        (["run", "scene.py", "--rtol", "-1e-6"], "rtol is -1e-06"),
        (["run", "scene.py", "--atol", "-1"], "atol of 'angle' is -1"),
        (["run", "scene.py", "--method", ""], "known: rk34, dopri5, dop853, Radau, BDF, LSODA, CVODE"),
        *((["run", "scene.py", "--set", text], f"--set {text}") for text in ("", "=", "g", "g=", "=1", "g=1j")),
        (["run", "scene.py", "--set", "g=1e400"], "'g' is not a finite number"),
        (["run", "scene.py", "-D", "="], "-D =: expected NAME=VALUE"),
        (["run", "", "--t-end", "1"], "not a file"),
        (["run", "."], "not a file"),
        (["generate", "scene.py", "-o", "scene.py/a"], "scene.py/a: Not a directory"),
        (["report", "scene.py", "-o", "scene.py/a"], "-o scene.py/a: nothing can be written there"),
        (["report", "scene.py", "--error", "nan"], "'--error'"),
        (["report", "scene.py", "--t-end", "inf"], "'--t-end'"),
        (["stability", "-o", "scene.py/a"], "-o scene.py/a: nothing can be written there"),
    ],
)
def test_the_users_mistakes_answer_2(scene, capsys, arguments, words):
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert words in out + err
    assert "Traceback" not in err
    assert {path.name for path in scene.parent.iterdir()} == {"scene.py"}


def test_a_mistake_in_the_model_answers_2_and_names_the_line(scene, capsys):
    scene.write_text(SCENE.replace("n * m * g", "n * m * gravity"))
    assert main(["generate", "scene.py"]) == 2
    assert "scene.py:10: NameError" in capsys.readouterr().err


def test_a_run_that_ends_early_answers_2_and_says_why(scene, capsys):
    scene.write_text(SCENE.replace("- n", "-n").replace("=-n * m * g * cos(angle)", "=-m * g * angle**4"))
    assert main(["run", "scene.py", "--t-end", "100"]) == 2
    out = capsys.readouterr().out
    assert "finished" not in out
    assert "angle" in out


def test_a_failed_compilation_answers_3(scene, monkeypatch, capsys):
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-fno-such-flag-at-all")
    assert main(["build", "scene.py"]) == 3
    assert "-fno-such-flag-at-all" in capsys.readouterr().err
    assert not Path("generated").exists()


def test_a_missing_compiler_answers_3(scene, monkeypatch, capsys):
    monkeypatch.setenv("CC", "no-such-compiler")
    assert main(["build", "scene.py"]) == 3
    assert "Install GCC or Clang" in capsys.readouterr().err


def test_tracebacks_are_shown_when_asked_for(scene, monkeypatch, capsys):
    monkeypatch.setenv("EIGENMOTION_DEBUG", "1")
    assert main(["generate", "absent.py"]) == 2
    assert "Traceback" in capsys.readouterr().err


def test_an_interrupt_answers_130(scene):
    scene.write_text("import os, signal\nos.kill(os.getpid(), signal.SIGINT)\n" + SCENE)
    command = [sys.executable, "-m", "eigenmotion", "generate", "scene.py"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr.strip()) == (130, "interrupted")


def test_help_does_not_wait_for_sympy():
    heavy = "{'sympy', 'numpy', 'scipy'} & set(sys.modules)"
    script = f"import sys; from eigenmotion.cli import main; main(['--help']); print({heavy})"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "set()"


@pytest.mark.parametrize("name", ["generate", "build", "explain", "run", "report"])
def test_every_command_has_help(name, capsys):
    assert main([name, "--help"]) == 0
    assert "MODEL" in capsys.readouterr().out


def test_run_takes_inputs(tmp_path, monkeypatch, capsys):
    """A body of mass 1 pushed by a force of 3 N: x = v0 t + 3 t^2 / 2."""
    monkeypatch.chdir(tmp_path)
    Path("pushed.py").write_text(
        "from sympy.physics.mechanics import dynamicsymbols\n"
        "from eigenmotion import Model\n"
        'q, u = dynamicsymbols("q u")\n'
        'model = Model(name="pushed", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, forces=[u], inputs={u: 0})\n'
    )
    assert main(["run", "pushed.py", "--t-end", "2", "--set", "u=3", "--set", "q'=1"]) == 0
    final = capsys.readouterr().out.splitlines()[-1].split()
    assert [float(word) for word in final[1:]] == pytest.approx([8.0, 7.0], rel=1e-12)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_long_stages_show_their_seconds_and_leave_no_trace(monkeypatch):
    screen, log = Terminal(), logging.getLogger("eigenmotion")
    monkeypatch.setattr(sys, "stderr", screen)
    with clock(patience=0.0):
        log.info("compiling %s", "swing")
        while "compiling swing ... 0 s" not in screen.getvalue():
            time.sleep(0.01)
    assert screen.getvalue().endswith("\r\x1b[K")
    assert not log.handlers


def test_nothing_is_shown_of_what_is_quick_or_of_which_nobody_watches(monkeypatch):
    for screen, patience in ((Terminal(), 1e9), (io.StringIO(), 0.0)):
        monkeypatch.setattr(sys, "stderr", screen)
        with clock(patience):
            logging.getLogger("eigenmotion").info("compiling")
            time.sleep(0.05)
        assert screen.getvalue() == ""


def test_bars_show_what_comes_next(monkeypatch):
    monkeypatch.setattr(sys, "stderr", Terminal())
    with bar("swing") as progress:
        progress(0.5, "time, round 3 of 9")
    assert "time, round 3 of 9" in sys.stderr.getvalue()
    assert "100%" in sys.stderr.getvalue()
