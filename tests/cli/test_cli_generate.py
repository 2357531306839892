"""`eigenmotion generate` and `build`: what they write, and what is found to differ."""

import os
import subprocess
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

from eigenmotion.cli import main

from ..conftest import SCENE

ROOT = Path(__file__).parents[2]
MODELS = ROOT / "models"


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


@pytest.mark.parametrize("suffix", [".c", ".h", ".pyx"])
@pytest.mark.parametrize("edit", ["append", "first line", "delete", "inside"])
def test_check_finds_an_edited_file(scene, capsys, suffix, edit):
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
    for options in (["--check"], ["--check", "--strict"], ["--check", "--diff"]):
        capsys.readouterr()
        assert main(["generate", *options, "scene.py"]) == 1, options
        out, err = capsys.readouterr()
        assert str(path) in err, options
        assert ("+++ " in out) == ("--diff" in options)
        assert (path.read_text() if path.exists() else None) == edited, options


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


@pytest.mark.parametrize("names", [("dual_link", "pendulum", "four_bar", "bouncing_ball", "rolling_disk")])
def test_committed_sources_are_those_of_the_models(names):
    """Those that are committed as text; the sums of all are compared in `make check`."""
    models = [str(MODELS / f"{name}.py") for name in names]
    assert main(["generate", "--check", "-o", str(ROOT / "generated"), *models]) == 0


def test_build_makes_an_importable_module(scene):
    assert main(["build", "scene.py"]) == 0
    assert Path(f"generated/swing1{EXTENSION_SUFFIXES[0]}").is_file()
    script = "from generated import swing1; print(swing1.system.coordinates)"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "('angle',)"
    assert main(["generate", "--check", "--strict", "scene.py"]) == 0
