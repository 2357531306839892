"""load_model: finding, running and refusing model files."""

import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import eigenmotion as em

HEAD = """\
from sympy import Piecewise, cos, symbols
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model

q = dynamicsymbols("q")
m, k = symbols("m k", positive=True)
"""
MODEL = 'Model(name="{name}", coordinates=[q], kinetic_energy=m * q.diff() ** 2 / 2, parameters={{m: 1.0}})\n'


@pytest.fixture
def write(tmp_path):
    def write(text: str, name: str = "scene.py") -> Path:
        path = tmp_path / name
        path.write_text(HEAD + text)
        return path

    return write


def line_of(path: Path, words: str) -> int:
    return next(k for k, line in enumerate(path.read_text().splitlines(), 1) if words in line)


def test_a_model(write):
    assert em.load_model(write("model = " + MODEL.format(name="scene"))).name == "scene"


FUNCTION = """
def model(n: int = 5, gain: float = 1.5, closed: bool = False, label: str = "a"):
    seen.append((n, gain, closed, label))
    return """ + MODEL.format(name="scene_").replace('"scene_"', 'f"scene_{n}"')


def test_text_is_parsed_to_the_type_of_the_default(write):
    path = write("seen = []" + FUNCTION.replace("seen.append(", "assert (10, 0.25, True, '7') == ("))
    assert em.load_model(path, n="10", gain="0.25", closed="yes", label="7").name == "scene_10"
    assert em.load_model(path, n=10, gain=0.25, closed=True, label="7").name == "scene_10"


@pytest.mark.parametrize(("keyword", "text"), [("n", "ten"), ("n", "2.5"), ("gain", "much"), ("closed", "maybe")])
def test_text_that_is_not_of_the_type(write, keyword, text):
    with pytest.raises(em.ModelError, match=rf"{keyword}={text} is not an? (int|float|bool)"):
        em.load_model(write("seen = []" + FUNCTION), **{keyword: text})


def test_an_unknown_keyword_names_the_known_ones(write):
    with pytest.raises(em.ModelError, match=r"no argument `links`; it has `n`, `gain`, `closed`, `label`"):
        em.load_model(write("seen = []" + FUNCTION), links=3)


def test_a_model_takes_no_keywords(write):
    with pytest.raises(em.ModelError, match="takes no keywords; `n` given"):
        em.load_model(write("model = " + MODEL.format(name="scene")), n=3)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "defines no `model`"),
        ("model = 3", "is an int, not a Model"),
        ("def model(n): return n", "must have a default; `n` has none"),
        ("def model(): return 'x'", r"model\(\) returned a str"),
        ("raise SystemExit(0)", "ended the program"),
        ("raise BaseException('x')", "ended the program"),
    ],
)
def test_a_file_without_a_model(write, text, words):
    with pytest.raises(em.ModelError, match=words) as caught:
        em.load_model(path := write(text))
    assert str(path) in str(caught.value)


@pytest.mark.parametrize(
    ("text", "at", "words"),
    [
        ("x = 1 / 0\n", "1 / 0", "ZeroDivisionError"),
        ("def f(:\n", "def f", "SyntaxError"),
        ("if q > 0:\n    pass\n", "if q", "Piecewise"),
        ("def model(n=1):\n    return [][n]\n", "[][n]", "IndexError"),
        ("model = Model(name='a b', coordinates=[q], kinetic_energy=q.diff()**2)\n", "model =", "a b"),
    ],
)
def test_a_mistake_is_named_with_its_line(write, text, at, words):
    path = write(text)
    with pytest.raises(em.ModelError) as caught:
        em.load_model(path)
    assert str(caught.value).startswith(f"{path}:{line_of(path, at)}: ")
    assert words in str(caught.value)


@pytest.mark.parametrize("given", [None, 3, b"", [], "", "\0", "a" * 5000, "."])
def test_what_is_no_file(given):
    with pytest.raises(em.ModelError):
        em.load_model(given)
    with pytest.raises(em.ModelError):
        em.build(given)


@pytest.mark.parametrize("content", [b"\xff\xfe", b"x = '\xe9'", b"a\0b", b"# coding: nonsense\n", b"1" * 5000])
def test_a_file_that_is_no_python(tmp_path, content):
    path = tmp_path / "scene.py"
    path.write_bytes(content)
    with pytest.raises(em.ModelError, match=r"scene\.py"):
        em.load_model(path)


def test_numbers_beyond_a_double(write):
    with pytest.raises(em.ModelError, match="beyond the range of a double"):
        em.load_model(write("model = " + MODEL.format(name="scene").replace("1.0", "10**400")))
    with pytest.raises(em.ModelError, match="n=1111"):
        em.load_model(write("seen = []" + FUNCTION), n="1" * 5000)


def test_a_missing_file(tmp_path):
    with pytest.raises(em.ModelError, match="no such file"):
        em.load_model(tmp_path / "absent.py")


def test_neighbours_can_be_imported_and_nothing_stays_behind(write, tmp_path):
    write("MASS = 2.0\n", "neighbour_of_scene.py")
    path = write("from neighbour_of_scene import MASS\nmodel = " + MODEL.format(name="scene").replace("1.0", "MASS"))
    before = list(sys.path)
    assert dict(em.load_model(path).parameters).popitem()[1] == 2.0
    assert sys.path == before
    assert not list(tmp_path.glob("__pycache__/scene*"))
    assert "neighbour_of_scene" not in sys.modules


def test_each_model_imports_its_own_neighbour(tmp_path):
    """Also of one name, and in threads at once: sys.path is the whole process's."""
    text = HEAD + "import time\ntime.sleep(0.01)\nfrom neighbour import MASS\n"
    paths = [tmp_path / str(k) / "scene.py" for k in range(8)]
    for k, path in enumerate(paths):
        path.parent.mkdir()
        path.with_name("neighbour.py").write_text(f"MASS = {k}.5\n")
        path.write_text(text + "model = " + MODEL.format(name="scene").replace("1.0", "MASS"))
    before = list(sys.path)
    with ThreadPoolExecutor(4) as pool:
        models = list(pool.map(em.load_model, paths))
    assert [dict(model.parameters).popitem()[1] for model in models] == [k + 0.5 for k in range(8)]
    assert sys.path == before


def test_an_edit_is_seen_at_once(write):
    for value in ("1.0", "2.0", "3.0"):
        path = write("model = " + MODEL.format(name="scene").replace("1.0", value))
        assert dict(em.load_model(path).parameters).popitem()[1] == float(value)
