"""Names of files as identifiers of C and Python."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable

TAKEN = frozenset(
    "t auto break case char const continue default do double else enum extern float for goto if inline int long "
    "register restrict return short signed sizeof static struct switch typedef union unsigned void volatile "
    "while".split()
)
"""The time, and the words of C"""


def identifier(name: str) -> str:
    """Return a name with other characters than letters, digits and _ replaced, such as "left_knee" for "left-knee"."""
    text = re.sub(r"[^0-9A-Za-z_]+", "_", name) or "_"
    text = re.sub(r"^_*(?=[0-9])", "n", re.sub(r"^__+", "_", text))
    return f"{text}_" if text in TAKEN or keyword.iskeyword(text) else text


def identifiers(names: Iterable[str], taken: Iterable[str] = ()) -> dict[str, str]:
    """Return an identifier for each name, all different, and different from those that are taken."""
    used, made = set(taken), {}
    for name in names:
        text, count = identifier(name), 1
        while (one := text if count == 1 else f"{text}_{count}") in used:
            count += 1
        used.add(one)
        made[name] = one
    return made
