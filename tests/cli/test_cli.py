"""The command line: mistakes, exit codes, help, progress."""

import io
import logging
import re
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import pytest

import eigenmotion as em
from eigenmotion import progress
from eigenmotion.cli import main
from eigenmotion.progress import bar, clock, counted, durations

from ..conftest import SCENE

ROOT = Path(__file__).parents[2]
MODELS = ROOT / "models"


def test_explain_names_states_and_what_was_left_out(capsys):
    assert main(["explain", str(MODELS / "dual_link.py")]) == 0
    text = capsys.readouterr().out
    for word in ("20 states", "theta1", "theta4", "additions", "nothing goes lane by lane", "This machine"):
        assert word in text


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
        (["run", "scene.py", "--method", ""], "known: rk34, dopri5, dop853, ra15, radau5, radau9, auto"),
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


def test_generating_does_not_wait_for_numpy():
    """A tenth of a second, before the compiler can begin."""
    script = ("import sys; from eigenmotion.building.request import request; "
              f"request({str(MODELS / 'quaternion_top.py')!r}).sources(); print('numpy' in sys.modules)")  # fmt: skip
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "False"


@pytest.mark.parametrize("name", ["generate", "build", "explain", "run", "report"])
def test_every_command_has_help(name, capsys):
    assert main([name, "--help"]) == 0
    assert "MODEL" in capsys.readouterr().out


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
    assert not log.filters


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
    assert "swing 50 %, time, round 3 of 9, 0.0 s left" in sys.stderr.getvalue()
    assert sys.stderr.getvalue().endswith("\r\x1b[K")


def test_runs_are_counted_where_that_takes_long(monkeypatch):
    for screen, written in ((Terminal(), "\r\x1b[K60 %, 8 of 10 runs,"), (io.StringIO(), "")):
        monkeypatch.setattr(sys, "stderr", screen)
        with counted(10, before=5) as add:
            add(1)
            assert screen.getvalue() == ""
            time.sleep(1.0)
            add(2)
        assert screen.getvalue().startswith(written)
        assert bool(screen.getvalue()) is bool(written)


def test_stages_have_their_durations_and_inner_clocks_add_to_the_outer_one(monkeypatch):
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    log = logging.getLogger("eigenmotion")
    level = log.level
    with clock() as stages:
        log.info("deriving %s", "swing")
        time.sleep(0.05)
        with clock() as inner:
            log.info("compiling %s", "swing")
            time.sleep(0.1)
        log.info("compiling %s: 1 of 2 units are done", "swing")
    assert inner is stages
    assert [what for what, _ in stages.spent] == [
        "deriving swing", "compiling swing", "compiling swing: 1 of 2 units are done"]  # fmt: skip
    assert stages.spent[0][1] >= 0.05
    assert stages.spent[1][1] >= 0.1
    assert durations(stages.spent) == ": deriving 0.1 s, compiling 0.1 s" or stages.spent[1][1] > 0.15
    assert (log.level, log.filters) == (level, [])


def test_a_clock_logs_nothing_that_would_not_be_logged_without_it(monkeypatch, caplog):
    monkeypatch.setattr(sys, "stderr", Terminal())
    log = logging.getLogger("eigenmotion")
    for level, expected in ((logging.WARNING, []), (logging.INFO, ["compiling swing"])):
        caplog.set_level(level, logger="eigenmotion")
        caplog.clear()
        with clock():
            log.info("compiling swing")
        assert caplog.messages == expected


def test_builds_and_parts_in_a_call_of_the_library_show_their_stages(monkeypatch, tmp_path, caplog):
    """Of a model whose stages take longer than the thread that shows them waits for the interpreter, 5 ms."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path))
    monkeypatch.setattr(progress, "_POLL", 0.001)
    screen = Terminal()
    monkeypatch.setattr(sys, "stderr", screen)
    monkeypatch.setattr("eigenmotion.building.build.clock", partial(clock, 0.0))
    system = em.build(em.load_model(MODELS / "chain.py", n=8))
    for words in ("deriving chain_8", "compiling chain_8", "proving chain_8"):
        assert words in screen.getvalue()
    with caplog.at_level("INFO", "eigenmotion"):  # the next message follows sooner than the screen shows this one
        system.simulate((0.0, 0.1), method="radau9")
    assert "compiling derivatives of chain_8" in caplog.text
    left = re.findall(
        r"compiling chain_8: \d of 1 units are done \.\.\. \d s, about ([0-9.]+) s left", screen.getvalue()
    )
    assert left, screen.getvalue()  # the stepper has measured the compiler
    assert all(0.0 < float(seconds) < 60.0 for seconds in left)


def test_time_left_counts_down_and_ends(monkeypatch):
    monkeypatch.setattr(progress, "_POLL", 0.001)
    screen = Terminal()
    monkeypatch.setattr(sys, "stderr", screen)
    log = logging.getLogger("eigenmotion")
    with clock(0.0):
        log.info("compiling swing", extra={"expected": 0.2})
        time.sleep(0.3)
        log.info("proving swing")
        time.sleep(0.05)
    left = [float(one) for one in re.findall(r"compiling swing \.\.\. 0 s, about ([0-9.]+) s left", screen.getvalue())]
    assert left[0] > left[-1] >= 0.0
    assert re.search(r"compiling swing \.\.\. 0 s\x1b|compiling swing \.\.\. 0 s\r", screen.getvalue())
    assert not re.search(r"proving swing .* left", screen.getvalue())
