"""The README's first steps after a plain install, without matplotlib. `test_docs.py` runs all of it."""

import re
import shlex
from pathlib import Path

import pytest

from eigenmotion.building.errors import BuildError
from eigenmotion.cli import main
from eigenmotion.webpage.wasm import wasm_compiler

README = (Path(__file__).parents[2] / "README.md").read_text()


def block(heading: str, language: str) -> str:
    """Return the first code block of a language below a heading."""
    return re.search(rf"```{language}\n(.*?)```", README.split(f"### {heading}\n")[1], re.DOTALL)[1]


@pytest.fixture
def pendulum(tmp_path, shared_cache, monkeypatch):
    monkeypatch.setenv("EIGENMOTION_CACHE", shared_cache)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-O0")
    monkeypatch.setattr("eigenmotion.presentation.figures.find_spec", lambda name: None)
    Path("pendulum.py").write_text(block("A model file", "python"))


def test_the_commands_work_without_matplotlib_and_the_one_that_draws_asks_for_it(pendulum, capsys):
    first, *others, drawing = [
        shlex.split(line, comments=True)[1:] for line in block("From the command line", "sh").splitlines()
    ]
    assert first[:2] == ["run", "pendulum.py"]
    assert [main(command) for command in (first, *others)] == [0, 0]
    assert "finished at t = 10" in capsys.readouterr().out
    assert Path("pendulum.csv").is_file()
    assert main(drawing) == 2
    assert "pip install 'eigenmotion[plot]'" in capsys.readouterr().err


def test_the_pictures_move(tmp_path, shared_cache, monkeypatch, capsys):
    """A page, and an animation, as the README has them."""
    pytest.importorskip("matplotlib")
    try:
        wasm_compiler()
    except BuildError as error:
        pytest.skip(str(error))
    monkeypatch.setenv("EIGENMOTION_CACHE", shared_cache)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-O0")
    Path("pendulum.py").write_text(block("A model file", "python"))
    page, animation = [shlex.split(line, comments=True)[1:] for line in block("See it move", "sh").splitlines()]
    assert main(page) == 0
    assert "open it in a browser" in capsys.readouterr().out
    assert Path("pendulum.html").read_text(encoding="utf-8").startswith("<!doctype html>")
    assert main([*animation, "--t-end", "0.2"]) == 0
    assert Path("pendulum.gif").read_bytes().startswith(b"GIF89a")
