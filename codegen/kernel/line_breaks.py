"""Line breaking of long C statements and lists."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

WIDTH = 110
"""Width of statements in functions, which may be indented further."""
WHOLE = 120
"""Width of text at the top level."""


def folded(before: str, items: Sequence[str], after: str, indent: int | None = None, width: int = WIDTH) -> str:
    """Return a list with line breaks between items, never inside one; "" if there are no items.

    Lines are indented like the first item, or by `indent`.
    """
    if not items:
        return ""
    text = before + ", ".join(_whole(item) for item in items) + _whole(after)
    inside = " " * (len(before) if indent is None else indent)
    return _broken(text, inside, width).replace("\0", " ")


def wrapped(statement: str) -> str:
    """Break a long statement into lines."""
    return _broken(statement, "    ", WIDTH)


def fitted(line: str, inside: str = "    ") -> str:
    """Break a line at the top level that is too long at spaces; further lines begin with `inside`."""
    return _broken(line, inside, WHOLE) if len(line) > WHOLE else line


def literal(text: str, indent: int) -> str:
    """Return an escaped text as a C string literal, or in parentheses as several in lines of their own."""
    if len(text) + indent + len('"",') <= WHOLE:
        return f'"{text}"'
    parts = textwrap.wrap(text, WIDTH - indent, drop_whitespace=False, break_long_words=False, break_on_hyphens=False)
    lines = f"\n{' ' * indent} ".join(f'"{part}"' for part in parts)
    return f"({lines})"


def _whole(text: str) -> str:
    """Return a text that is not broken, because its spaces are replaced by NUL."""
    return text.replace(" ", "\0")


def _broken(text: str, inside: str, width: int) -> str:
    wrapper = textwrap.TextWrapper(width, subsequent_indent=inside, break_long_words=False, break_on_hyphens=False)
    return wrapper.fill(text)
