"""Compiled templates: read where they are whole and of their text, made anew where not; no folder is needed."""

import sys

import jinja2
import pytest
from eigenmotion.codegen.render import template_cache

TEXT = "{{ 2 * number }}"


@pytest.fixture
def place(tmp_path, monkeypatch):
    """Return where the one template here is kept."""
    path = tmp_path / "kept" / "template.pyc"
    monkeypatch.setattr(template_cache, "_place", lambda bucket: path)
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    return path


@pytest.fixture
def compilations(monkeypatch):
    """Return what templates have been compiled."""
    made, compile_it = [], jinja2.Environment.compile
    monkeypatch.setattr(jinja2.Environment, "compile", lambda *a, **k: made.append(a[1]) or compile_it(*a, **k))
    return made


def rendered(text=TEXT):
    """Render in an environment that has seen nothing."""
    made = jinja2.Environment(loader=jinja2.DictLoader({"template": text}), bytecode_cache=template_cache.Bytecode())
    return made.get_template("template").render(number=3)


@pytest.mark.usefixtures("place")
def test_a_template_is_compiled_once(compilations):
    assert [rendered(), rendered()] == ["6", "6"]
    assert compilations == [TEXT]


@pytest.mark.parametrize("left", [0, 4, 40, 200])
def test_damaged_ones_are_made_anew(place, compilations, left):
    rendered()
    whole = place.read_bytes()
    assert left < len(whole)
    place.write_bytes(whole[:left])
    assert rendered() == "6"
    assert compilations == [TEXT, TEXT]
    assert place.read_bytes() == whole


@pytest.mark.usefixtures("place")
def test_another_text_is_compiled_itself(compilations):
    assert rendered() == "6"
    assert rendered("{{ number }}") == "3"
    assert len(compilations) == 2


@pytest.mark.usefixtures("place")
def test_another_version_of_our_filters_is_another_template(compilations, monkeypatch):
    rendered()
    monkeypatch.setattr(template_cache, "_dependencies", lambda: "another")
    rendered()
    assert compilations == [TEXT, TEXT]


def test_nothing_is_written_where_python_writes_nothing(place, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert rendered() == "6"
    assert not place.parent.exists()


def test_a_folder_that_is_none_is_no_obstacle(place):
    place.parent.write_text("a file")
    assert rendered() == "6"
