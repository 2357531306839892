"""Docstrings as this project writes them, for Sphinx: plain text with sections, fields `name : what`, and formulas."""

import re
from collections.abc import Iterator

from sphinx.application import Sphinx

_SECTIONS = ("Parameters", "Returns", "Raises", "Attributes", "Examples")
_FIELD = re.compile(r"[\w, .()\[\]']+ : ")
_FORMULA = re.compile(r"([*|])|(?<=\w)(_)(?!\w)")


def setup(app: Sphinx) -> dict[str, bool]:
    """Rewrite every docstring on its way into the site."""
    app.connect("autodoc-process-docstring", lambda *given: rewrite(given[-1]))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def rewrite(lines: list[str]) -> None:
    """Turn a docstring into reStructuredText, in place."""
    lines[:] = list(_sections(_paragraphs(lines)))


def _paragraphs(lines: list[str]) -> Iterator[list[str]]:
    """Give the paragraphs, without the blank lines between them."""
    paragraph: list[str] = []
    for line in [*lines, ""]:
        if line.strip():
            paragraph.append(line)
        elif paragraph:
            yield paragraph
            paragraph = []


def _sections(paragraphs: Iterator[list[str]]) -> Iterator[str]:
    """Give the text of paragraphs: headings, lists of fields, examples, or as they are."""
    for paragraph in paragraphs:
        headed = len(paragraph) > 1 and paragraph[0] in _SECTIONS and set(paragraph[1]) == {"-"}
        if headed:
            yield from (f".. rubric:: {paragraph[0]}", "")
        yield from _lines(paragraph[2:] if headed else paragraph)
        yield ""


def _lines(paragraph: list[str]) -> list[str]:
    if not paragraph or paragraph[0].lstrip().startswith(">>>"):
        return paragraph
    escaped = [_escaped(line) for line in paragraph]
    if not _FIELD.match(paragraph[0]):
        return escaped
    return [line for given in escaped for line in _field(given)]


def _field(line: str) -> list[str]:
    """Return a term and what it is, on a line of its own; lines that go on stay below it."""
    if line.startswith(" ") or not _FIELD.match(line):
        return ["    " + line.strip()]
    name, _, what = line.partition(" : ")
    return [name, "    " + ("\\" if what.startswith("(") else "") + what]  # no number of a list


def _escaped(line: str) -> str:
    """Escape what reStructuredText would read as markup, outside of code."""
    parts = re.split(r"(`[^`]*`)", line)
    return "".join(part if part.startswith("`") else _FORMULA.sub(r"\\\1\2", part) for part in parts)
