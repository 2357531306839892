"""Ctrl-C in `eigenmotion stability MODEL` and `eigenmotion report`: what is kept, and what is said."""

import os
import signal
import time
from concurrent.futures import process
from concurrent.futures.process import BrokenProcessPool
from types import SimpleNamespace

import pytest
from eigenmotion.models import pendulum

from eigenmotion import StopReason
from eigenmotion.cli import main
from eigenmotion.cli.simulation import report as report_command
from eigenmotion.cli.simulation import stability as stability_command
from eigenmotion.comparison.deadline import NONE
from eigenmotion.comparison.interrupts import Pool, uninterrupted
from eigenmotion.stability import limits_of, summary_of
from eigenmotion.stability.limits import survey

from ..support.models_table import MODELS

PENDULUM = str(MODELS / "pendulum.py")


def test_a_run_that_was_interrupted_interrupts():
    ended = SimpleNamespace(stop=StopReason.INTERRUPTED)
    for call in (lambda: uninterrupted(ended), lambda: NONE.complete(lambda _: ended, 10)):
        with pytest.raises(KeyboardInterrupt):
            call()


@pytest.fixture
def third_is_interrupted(monkeypatch):
    count, examine = iter(range(100)), survey.examine

    def interrupted(*given, **options):
        if next(count) == 2:
            raise KeyboardInterrupt
        return examine(*given, **options)

    monkeypatch.setattr(survey, "examine", interrupted)
    monkeypatch.setattr(survey, "FORMULATIONS", ("lagrange",))


@pytest.mark.usefixtures("third_is_interrupted")
def test_stability_keeps_what_was_found_and_says_so():
    found = limits_of(pendulum.model, t_end=1.0, budget=300.0, workers=1)
    assert found.interrupted
    assert len(found.matrix.points) == 2
    lines = summary_of(found)
    assert lines[0].startswith("interrupted after 2 of ")
    assert not any("raise --budget" in line for line in lines)


@pytest.mark.usefixtures("third_is_interrupted")
def test_the_command_writes_whole_files_and_says_130(tmp_path, capsys):
    assert (
        main(["stability", PENDULUM, "--t-end", "1", "--budget", "300", "--workers", "1", "-o", str(tmp_path)]) == 130
    )
    said = capsys.readouterr()
    assert said.out.startswith("interrupted after 2 of ")
    assert (tmp_path / "stability.html").read_text(encoding="utf-8").rstrip().endswith("</html>")


@pytest.mark.parametrize(
    ("command", "module", "function"),
    [("stability", stability_command, "limits_of"), ("report", report_command, "examine")],
)
def test_before_anything_is_found_nothing_is_written(command, module, function, tmp_path, capsys, monkeypatch):
    def interrupted(*given, **options):
        progress = options.get("progress") or given[-1]
        progress(0.42, "the second stage")
        raise KeyboardInterrupt

    monkeypatch.setattr(module, function, interrupted)
    assert main([command, PENDULUM, "-o", str(tmp_path)]) == 130
    assert "interrupted at 42 %, the second stage: nothing of pendulum is written" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def interrupted_pool() -> int:
    with Pool(1) as pool:
        one: int = pool.submit(os.getpid).result()
        pool.submit(signal.pause)
        raise KeyboardInterrupt(one)


def test_processes_of_a_pool_end_with_its_block():
    """One that waits for a signal is not waited for."""
    with pytest.raises(KeyboardInterrupt) as raised:
        interrupted_pool()
    with pytest.raises(ProcessLookupError):
        os.kill(raised.value.args[0], 0)


def test_ctrl_c_of_a_process_is_silent(capfd):
    with Pool(1) as pool:
        one = pool.submit(os.getpid).result()
        os.kill(one, signal.SIGINT)
        with pytest.raises(Exception, match="terminated abruptly"):
            pool.submit(signal.pause).result()
    assert "Traceback" not in capfd.readouterr().err


def test_a_call_that_is_submitted_as_a_process_dies_ends(monkeypatch):
    """Here after `submit` has seen that all is well, and before the call is among those that wait."""

    class Late(process._WorkItem):
        def __init__(self, *given):
            os.kill(one, signal.SIGKILL)
            time.sleep(1.0)
            super().__init__(*given)

    with Pool(1) as pool:
        one = pool.submit(os.getpid).result()
        monkeypatch.setattr(process, "_WorkItem", Late)
        with pytest.raises(BrokenProcessPool):
            pool.submit(signal.pause).result(timeout=60.0)
