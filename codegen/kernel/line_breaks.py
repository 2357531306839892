"""Long C in lines."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

WIDTH = 110
"""Of what functions hold, which may stand further in."""
WHOLE = 120
"""Of what stands alone."""


def folded(before: str, items: Sequence[str], after: str, indent: int | None = None, width: int = WIDTH) -> str:
    """Write a list into lines, without a break inside an item; nothing for no items.

    Lines are indented as far as the first item is, or as told.
    """
    if not items:
        return ""
    text = before + ", ".join(_whole(item) for item in items) + _whole(after)
    inside = " " * (len(before) if indent is None else indent)
    return _broken(text, inside, width).replace("\0", " ")


def wrapped(statement: str) -> str:
    """Break a long statement into lines."""
    return _broken(statement, "    ", WIDTH)


def _whole(text: str) -> str:
    """Return a text that is not broken."""
    return text.replace(" ", "\0")


def _broken(text: str, inside: str, width: int) -> str:
    wrapper = textwrap.TextWrapper(width, subsequent_indent=inside, break_long_words=False, break_on_hyphens=False)
    return wrapper.fill(text)
