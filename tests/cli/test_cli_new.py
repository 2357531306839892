"""`eigenmotion new`: every template is a model that loads, under the name asked for."""

import pytest

import eigenmotion as em
from eigenmotion.cli import main
from eigenmotion.cli.generation.new import TEMPLATES


@pytest.mark.parametrize("template", TEMPLATES)
def test_a_template_is_a_model_of_that_name(template, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "mine", "--template", template]) == 0
    text = (tmp_path / "mine.py").read_text(encoding="utf-8")
    assert "Oracle" not in text
    model = em.load_model("mine.py")
    assert model.name.startswith("mine")
    assert model.drawing
    assert "eigenmotion run mine.py" in capsys.readouterr().out


def test_a_file_that_is_there_stays(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text("x = 1\n")
    assert main(["new", "mine"]) == 2
    assert "is there already" in capsys.readouterr().err
    assert (tmp_path / "mine.py").read_text() == "x = 1\n"


@pytest.mark.parametrize("name", ["2fast", "class", "../x"])
def test_names_that_serve_as_no_model_are_refused(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", name]) == 2
    assert "letters, digits and underscores" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
