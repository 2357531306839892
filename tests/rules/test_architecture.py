"""Files and C functions that docs/architecture.md and the pages behind it name exist."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGES = (
    ROOT / "docs" / "architecture.md",
    *sorted((ROOT / "docs" / "architecture").glob("*.md")),
    ROOT / "CONTRIBUTING.md",
)
FOLDERS = ("codegen", "generated", "src", "templates", "models", "tests", "benchmarks", "docs")
ENDINGS = ("py", "pyx", "pxd", "h", "c", "jinja", "md", "toml", "txt")
MADE_UP = ("NAME", "MODEL", "*", "pendulum.py", "em_stepper.o", "build/")
INCLUDE = ROOT / "src" / "eigenmotion" / "runtime" / "include"


def named(page: Path) -> set[str]:
    """Words in code type, blocks of code apart."""
    text = re.sub(r"^ *```.*?^ *```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    return {word for code in re.findall(r"`([^`\n]+)`", text) for word in re.findall(r"[\w./*-]+", code)}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_files_that_pages_name_are_there(page):
    files = {f"/{path.relative_to(ROOT)}" for folder in FOLDERS for path in (ROOT / folder).rglob("*.*")}
    files |= {f"/{path.name}" for path in ROOT.iterdir()}
    asked = {word for word in named(page) if word.rpartition(".")[2] in ENDINGS and "." in word.strip(".")}
    asked = {word for word in asked if not any(part in word for part in MADE_UP)}
    assert asked
    assert not {word for word in asked if not any(path.endswith(f"/{word}") for path in files)}


@pytest.mark.parametrize("page", PAGES[:-1], ids=lambda page: page.stem)
def test_functions_that_pages_name_are_there(page):
    text = "".join(path.read_text(encoding="utf-8") for path in INCLUDE.rglob("*.[ch]"))
    asked = {word for word in named(page) if re.fullmatch(r"em_[a-z_]+|EM_[A-Z_]+", word)} - {"EM_NAME_TABLEAU"}
    assert asked
    assert not {word for word in asked if not re.search(rf"\b{word}\b", text)}


CLAUSE = re.compile(r"(what|how|whether|which|who|whose|where|why)\b", re.IGNORECASE)


def head(path: Path) -> str:
    """The first words of a file: of its docstring, or behind its name in C."""
    text = path.read_text(encoding="utf-8")
    return text.removeprefix('"""') if path.suffix == ".py" else text[:200].partition(f"{path.name}: ")[2]


def test_the_head_of_a_file_is_a_noun_phrase():
    """A file's first line names its subject: no file introduces itself by a clause."""
    folders = ("codegen", "src", "models", "benchmarks", "tests", "docs")
    files = [
        path for folder in folders for path in (ROOT / folder).rglob("*") if path.suffix in {".py", ".h", ".c", ".js"}
    ]
    assert len(files) > 600
    assert not [str(path.relative_to(ROOT)) for path in files if CLAUSE.match(head(path))]
