"""`--assemble`: starts that close by themselves, in pages and units (in runs: test_cli_run.py)."""

import re
from zipfile import ZipFile

import pytest

from eigenmotion.cli import main
from eigenmotion.cli.generation import page

from .test_cli_run import LOOP, closed


def test_a_unit_starts_closed(scene, capsys):
    scene.write_text(LOOP)
    assert main(["export", "scene.py", "--fmu", "loop.fmu", "--assemble"]) == 0
    assert capsys.readouterr().out.startswith("assembled: ")
    with ZipFile("loop.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    start = {}
    for variable in re.findall(r"<ScalarVariable .*?</ScalarVariable>", text, re.S):
        name, value = re.search(r'name="([^"]+)"', variable), re.search(r'start="([^"]+)"', variable)
        if name and value:
            start[name[1]] = float(value[1])
    assert start["q1"] != 1.0  # nothing was kept
    assert start["x"] == pytest.approx(closed(start["q1"]), abs=1e-12)


def test_functions_for_casadi_have_no_start(scene, capsys):
    assert main(["export", "scene.py", "--casadi", "a.c", "--assemble"]) == 2
    assert "--assemble has no use with --casadi" in capsys.readouterr().err


def test_a_page_starts_closed(scene, capsys, monkeypatch):
    """Without the compiler for WebAssembly: what the page is given."""
    scene.write_text(LOOP)
    given = {}

    def page_of(request, source, run, space, place):
        given.update(run.given)
        return "<html></html>"

    monkeypatch.setattr(page, "page", page_of)
    assert main(["page", "scene.py", "--assemble", "--set", "q1=0.9"]) == 0
    assert "assembled: q2 moved most" in capsys.readouterr().out
    assert given["x0"]["q1"] == 0.9
    assert given["x0"]["x"] == pytest.approx(closed(0.9), abs=1e-12)
