"""Rendering of a program's files by templates, with a stamp of hashes."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

import jinja2

from ..kernel.line_breaks import WHOLE, fitted, folded, literal
from ..program.program import Program
from .template_cache import Bytecode

TEMPLATES = {"h": "file/model.h.jinja", "c": "file/model.c.jinja", "pyx": "file/module.pyx.jinja"}
ESCAPES = {"\\": r"\\", '"': r"\"", "?": r"\?", "\n": r"\n", "\t": r"\t"}
BEHIND_THE_STAMP = 3
"""Number of lines of the stamp, which the body hash does not cover."""


@dataclass(frozen=True, slots=True)
class SourceFile:
    """One file: its name and its text."""

    name: str
    text: str


@dataclass(frozen=True, slots=True)
class Sources:
    """The files of one model: NAME.h, NAME.c, NAME.pyx."""

    name: str
    files: tuple[SourceFile, ...]


@dataclass(frozen=True, slots=True)
class Stamp:
    """The hashes in the head of a generated file: SHA-256 of the model and choices, and of the text below the stamp."""

    input_hash: str
    body_hash: str


def emit(program: Program, origin: str, input_hash: str) -> Sources:
    """Render every file of a program.

    Parameters
    ----------
    origin
        The command that generates these files.
    input_hash
        See `Stamp`.
    """
    rendered = ((suffix, environment().get_template(template).render(program=program))
                for suffix, template in TEMPLATES.items())  # fmt: skip
    stamped = (SourceFile(f"{program.name}.{suffix}", _stamped(suffix, text, origin, input_hash))
               for suffix, text in rendered)  # fmt: skip
    return Sources(program.name, tuple(stamped))


def _stamped(suffix: str, text: str, origin: str, input_hash: str) -> str:
    opening, closing = ("# ", "") if suffix == "pyx" else ("/* ", " */")
    lines = (commented(origin), f"input sha256:{input_hash}", f"body sha256:{_digest(text)}")
    return "".join(f"{opening}{line}{closing}\n" for line in lines) + text


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def body_hash(text: str) -> str:
    """Return the SHA-256 of a generated file's text below the stamp."""
    return _digest("".join(text.splitlines(keepends=True)[BEHIND_THE_STAMP:]))


def stamp(text: str) -> Stamp:
    """Read the stamp of a generated file; a missing hash is an empty string."""
    lines = (text.splitlines() + [""] * BEHIND_THE_STAMP)[:BEHIND_THE_STAMP]
    return Stamp(*(_hash_in(line) for line in lines[1:]))


def _hash_in(line: str) -> str:
    _, separator, rest = line.partition("sha256:")
    return rest.split()[0] if separator and rest else ""


@cache
def environment() -> jinja2.Environment:
    """Return the environment that all templates share; an undefined name is an error."""
    made = jinja2.Environment(
        loader=jinja2.FunctionLoader(_load),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        bytecode_cache=Bytecode(),
    )
    made.filters["quoted"] = quoted
    made.filters["commented"] = commented
    made.filters["strings"] = strings
    made.filters["listed"] = listed
    made.filters["fitted"] = fitted
    made.filters["literal"] = literal
    return made


def compile_templates() -> None:
    """Compile every template into the cache (`Bytecode`)."""
    for folder in files("eigenmotion.templates").iterdir():
        for file in folder.iterdir() if folder.is_dir() else ():
            if file.name.endswith(".jinja"):
                environment().get_template(f"{folder.name}/{file.name}")


def quoted(text: str) -> str:
    r"""Return a text with the escapes of a C string literal; users may choose names such as \theta."""
    return "".join(ESCAPES.get(char) or (char if char.isprintable() else _octal(char)) for char in text)


def strings(texts: Iterable[str]) -> list[str]:
    """Return texts as C string literals."""
    return [f'"{quoted(text)}"' for text in texts]


def listed(items: Iterable[object], head: str, last: str = "") -> str:
    """Return the definition of an array, broken into lines; `last` is a final item, for arrays that may be empty."""
    return folded(f"{head} = {{ ", [*map(str, items), *filter(None, [last])], " };", 4, WHOLE)


def _octal(char: str) -> str:
    return "".join(f"\\{byte:03o}" for byte in char.encode())


def commented(text: str) -> str:
    r"""Return a text that is safe in a comment of C or Cython: on one line, and without the end of a comment.

    Characters that are not printable, such as those that change the direction of writing, are escaped: \n, \u202e.
    """
    escaped = "".join(char if char.isprintable() else char.encode("unicode_escape").decode() for char in text)
    return escaped.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")


def _load(name: str) -> str | None:
    path = files("eigenmotion.templates").joinpath(name)
    return path.read_text(encoding="utf-8") if path.is_file() else None
