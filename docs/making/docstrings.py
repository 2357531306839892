"""Docstrings as this project writes them, for Sphinx: plain text with sections, fields `name : what`, and formulas.

Fields become tables, and a class begins with a table of its members.
"""

import inspect
import re
from collections.abc import Iterator
from typing import Any

from sphinx.application import Sphinx

_SECTIONS = ("Parameters", "Returns", "Raises", "Attributes", "Examples")
_FIELD = re.compile(r"[\w, .()\[\]']+ : ")
_FEW = 3
_FORMULA = re.compile(r"([*|])|(?<=\w)(_)(?!\w)")


def setup(app: Sphinx) -> dict[str, bool]:
    """Rewrite every docstring on its way into the site."""
    app.connect("autodoc-process-docstring", _process)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _process(_: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    rewrite(lines)
    if what == "class" and options.get("members"):
        lines += _members(name, thing, options)


def _members(name: str, thing: type, options: Any) -> list[str]:
    """Return a table of what a class has, where that is more than a reader sees at once."""
    asked, left_out = options["members"], options.get("exclude-members") or ()
    rows = [
        (member, inspect.getdoc(value))
        for owner in thing.__mro__[:-1]
        for member, value in vars(owner).items()
        if (not isinstance(asked, list) or member in asked) and member not in left_out and _public(member, value)
    ]
    told = {member: re.split(r"\n\n|(?<=\.)\s", words)[0] for member, words in reversed(rows) if words}
    if len(told) <= _FEW:
        return []
    table = [".. list-table::", "   :class: fields members", "   :widths: 25 75", ""]
    for member in dict.fromkeys(member for member, _ in rows if member in told):
        what = _no_list(_escaped(told[member].replace("\n", " ")))
        table += [f"   * - :py:obj:`{member} <{name}.{member}>`", f"     - {what}"]
    return [*table, ""]


def _public(name: str, value: Any) -> bool:
    return not name.startswith("_") and (callable(value) or isinstance(value, property))


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
        yield from _lines(paragraph[2:], named=True) if headed else _lines(paragraph)
        yield ""


def _lines(paragraph: list[str], named: bool = False) -> list[str]:
    """Return text as it is, or fields as a table; below a heading, names stand on lines of their own, too."""
    if not paragraph or paragraph[0].lstrip().startswith(">>>"):
        return paragraph
    escaped = [_escaped(line) for line in paragraph]
    if not (_FIELD.match(paragraph[0]) or (named and paragraph[1:2] and paragraph[1].startswith(" "))):
        return escaped
    table = [".. list-table::", "   :class: fields", "   :widths: 25 75", ""]
    fields = _FIELD.match(paragraph[0]) is not None
    return [*table, *(line for given in escaped for line in _row(given, fields))]


def _row(line: str, fields: bool) -> list[str]:
    """Return the row of a name and what it is; lines that go on stay in its second cell."""
    if line.startswith(" ") or (fields and not _FIELD.match(line)):
        return ["       " + line.strip()]
    name, _, what = line.partition(" : ")
    return [f"   * - {name}", "     - " + _no_list(what)]


def _no_list(text: str) -> str:
    """Escape a text that begins like the number of a list: (n,)."""
    return ("\\" if text.startswith("(") else "") + text


def _escaped(line: str) -> str:
    """Escape what reStructuredText would read as markup, outside of code."""
    parts = re.split(r"(`[^`]*`)", line)
    return "".join(part if part.startswith("`") else _FORMULA.sub(r"\\\1\2", part) for part in parts)
