"""One C file that needs no others: headers are written in place of their includes."""

import re
from pathlib import Path

from ..building.toolchain import INCLUDE

NEVER = frozenset(("EM_ON_LANES", "EM_ON_DUALS", "EM_NODES_ALONE", "EM_UNIT"))
"""Macros that this file never defines: what is compiled with them is left out."""
_INCLUDE = re.compile(r'\s*#include "([\w/]+\.h)"')
_TEST = re.compile(r"\s*#if(n?)def (\w+)")
_GUARD = re.compile(r"#ifndef (EM_\w+_H|EIGENMOTION_H)\b")


def single_file(text: str) -> str:
    """Return a C file with the headers of the runtime in it.

    A header that is included under a condition is written again where it is included next; its guard keeps the first.
    """
    lines: list[str] = []
    _expand(_alive(text), set(), lines, conditional=False)
    return "\n".join(lines) + "\n"


def _expand(text: str, done: set[str], lines: list[str], conditional: bool) -> None:
    guard = next((line for line in text.splitlines() if _GUARD.match(line)), None)
    depth = 0 if guard is None else -1
    for line in text.splitlines():
        depth += line.lstrip().startswith("#if")
        depth -= line.lstrip().startswith("#endif")
        found = _INCLUDE.match(line)
        if found is None:
            lines.append(line)
        elif found[1] not in done:
            inside = conditional or depth > 0
            if not inside:
                done.add(found[1])
            _expand(_header(found[1]), done, lines, inside)


def _header(name: str) -> str:
    return _alive((INCLUDE / name).read_text(encoding="utf-8"))


def _alive(text: str) -> str:
    """Return C without what is only compiled with the macros in NEVER."""
    kept: list[str] = []
    stack: list[bool | None] = []  # None: a condition that is left to the compiler; else whether its lines are alive
    for line in text.splitlines():
        word = line.lstrip()
        found = _TEST.match(line)
        if word.startswith("#if"):
            stack.append(found[1] == "n" if found and found[2] in NEVER else None)
        elif word.startswith("#else") and stack[-1] is not None:
            stack[-1] = not stack[-1]
        elif word.startswith("#endif"):
            if stack.pop() is not None:
                continue
            if False not in stack:
                kept.append(line)
            continue
        ours = word.startswith(("#if", "#else")) and stack[-1] is not None
        if False not in stack and not ours:
            kept.append(line)
    return "\n".join(kept)


def beside(name: str) -> str:
    """Return the text of a file of this folder."""
    return (Path(__file__).parent / name).read_text(encoding="utf-8")
