"""Every snippet of the README and of the documentation does what its page says, from top to bottom."""

import doctest
import importlib.util
import io
import sys
from pathlib import Path

import click
import pytest

import eigenmotion

ROOT = Path(__file__).parents[2]
PAGES = (
    ROOT / "README.md",
    *sorted((ROOT / "docs").glob("*.md")),
    *sorted((ROOT / "docs" / "architecture").glob("*.md")),
)


def _module(path: Path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = sys.modules[path.stem] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


snippets = _module(ROOT / "docs" / "making" / "snippets.py")


LATE = ("impacts", "linearize", "lqr", "tutorial")
"""Pages that build many models, of subjects that have many tests: at night; `make docs` runs the last by day, too."""


def with_snippets(night: bool) -> list:
    """Return the pages that have something to run by day, or by night only."""
    marks = {
        page: {"nightly" if page.stem in LATE else block.mark for block in snippets.blocks(page)} for page in PAGES
    }
    found = [page for page in PAGES if ("nightly" in marks[page] if night else marks[page] - {"nightly"})]
    return [pytest.param(page, id=page.name) for page in found]


def _mark(page: Path, block: snippets.Block) -> str:
    return "nightly" if page.stem in LATE else block.mark


@pytest.fixture
def folder(tmp_path, shared_cache, monkeypatch, hurried):
    """A clone as a reader has it, and a cache that all pages share; compiled in a hurry."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "models").symlink_to(ROOT / "models")
    monkeypatch.setenv("EIGENMOTION_CACHE", shared_cache)
    return tmp_path


@pytest.mark.parametrize("page", with_snippets(night=False))
@pytest.mark.usefixtures("folder")
def test_snippets_do_what_the_page_says(page):
    snippets.Reader().read(page, night=False)


@pytest.mark.nightly
@pytest.mark.parametrize("page", with_snippets(night=True))
@pytest.mark.usefixtures("folder")
def test_snippets_that_take_longer_do_too(page):
    snippets.Reader().read(page)


NAMES = sorted(set(eigenmotion._HOME) - {"t"})  # a symbol of SymPy's has no docstring of ours


NEEDS = {"to_jax": "jax", "to_torch": "torch"}
"""Names whose examples need a package that may not be here; `make nightly` installs PyTorch."""


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.usefixtures("folder")
def test_every_public_name_has_an_example_that_does_what_it_says(name):
    finder = doctest.DocTestFinder(recurse=False)
    found = [test for test in finder.find(getattr(eigenmotion, name), name, module=False, globs={}) if test.examples]
    assert found, f"the docstring of {name} has no example"
    if name in NEEDS:
        pytest.importorskip(NEEDS[name])
    runner = doctest.DocTestRunner(optionflags=snippets.LENIENT)
    said = io.StringIO()
    for test in found:
        runner.run(test, out=said.write)
    assert runner.failures == 0, said.getvalue()


def test_the_site_names_everything_public():
    """A new name goes to its place in docs/api.md, and gets an example in its docstring."""
    said = (ROOT / "docs" / "api.md").read_text()
    assert [name for name in dir(eigenmotion) if name in eigenmotion._HOME and f"eigenmotion.{name}\n" not in said] == [
        "draw"
    ]
    assert "eigenmotion.codegen.model.statement.draw" in said


WRONG = {
    "python that raises": "```python\nassert 1 == 2\n```\n",
    "a session that prints something else": "```python\n>>> 1 + 1\n3\n```\n",
    "a command that fails": "```sh\neigenmotion run nowhere.py\n```\n",
    "a command that prints something else": "```console\n$ eigenmotion --version\nneverland\n```\n",
    "text that was not printed": "```python\nprint(1)\n```\n\n```text\n2\n```\n",
    "C that was not generated": "```c\nint nowhere;\n```\n",
    "yaml that is none": "```yaml\na: [\n```\n",
    "what nobody can run": "```fortran\nend\n```\n",
    "syntax of what is not run": "<!-- not run: it takes a cluster -->\n```python\nclient =\n```\n",
    "options of what is not run": "<!-- not run: minutes -->\n```sh\neigenmotion report a.py --erorr 1\n```\n",
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG.keys())
def test_a_page_that_says_something_else_is_found_out(folder, text):
    page = folder / "page.md"
    page.write_text(f"# A page\n\n{text}")
    with pytest.raises((snippets.SnippetError, SyntaxError, click.UsageError)):
        snippets.Reader().read(page)


def test_marks_are_kept_to(folder):
    page = folder / "page.md"
    page.write_text(
        "# A page\n\n<!-- nightly -->\n```python\nseen = 'night'\n```\n\n<!-- python\nhidden = 1\n-->\n\n"
        "1. In a list:\n\n   ```python\n   inner = hidden\n   ```\n\n<!-- not run: why -->\n```python\n1 / 0\n```\n"
    )
    day, night = snippets.Reader(), snippets.Reader()
    day.read(page, night=False)
    night.read(page)
    assert "seen" not in day.names
    assert night.names["seen"] == "night"
    assert day.names["inner"] == 1


def test_links_that_lead_nowhere_are_found(tmp_path):
    links = _module(ROOT / "docs" / "making" / "links.py")
    (tmp_path / "there.html").write_text('<p id="place"></p>')
    page = tmp_path / "page.html"
    page.write_text(
        '<a href="there.html#place"></a><a href="https://example.org/x"></a><a href="#top" id="top"></a>'
        '<a href="there.html#nowhere"></a><img src="lost.png"><a href="#below"></a>'
    )
    assert [link.split(": ")[1] for link in links.broken(page)] == ["#below", "lost.png", "there.html#nowhere"]


def test_a_whole_page_may_be_for_the_night(folder):
    page = folder / "page.md"
    page.write_text("<!-- nightly -->\n\n# A page\n\n```python\n1\n```\n")
    assert [block.mark for block in snippets.blocks(page)] == ["nightly"]
