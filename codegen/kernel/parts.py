"""Parts of a long kernel: functions called one after the other, which pass on the values that they share.

The time of a C compiler grows faster than the length of a function, and so does the number of values that it keeps in
memory rather than in registers.
"""

from __future__ import annotations

import re
from bisect import bisect
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate

from .line_breaks import folded

PART = 300
"""Statements of a part, within a third."""
CUT = 450
"""Kernels with more statements are cut."""
KEPT = "kept"
"""The array of values that one part computes and a later one needs."""
_NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")


@dataclass(frozen=True, slots=True)
class Part:
    """A function of a part of a kernel, as C text."""

    head: str
    statements: tuple[str, ...]


def cut(
    name: str, number: str, statements: Sequence[str], arguments: Mapping[str, str]
) -> tuple[tuple[Part, ...], tuple[str, ...]]:
    """Return the parts of a kernel and the statements that call them; a short kernel stays as it is.

    Parameters
    ----------
    number
        The C type of its values.
    arguments
        Name of each input and output -> its declaration as a parameter.
    """
    if len(statements) <= CUT:
        return (), tuple(statements)
    pieces = _Pieces(number, statements, arguments)
    kept = f"{KEPT}[{max(len(pieces.places), 1)}]"
    parts, calls = [], [f"{number} {kept};"]
    for count in range(len(pieces.ranges)):
        body = pieces.body(count)
        within = frozenset().union(*map(_names, body))
        used = [one for one in arguments if one in within]
        function = f"{name}_part_{count + 1}("
        declared = [*(arguments[one] for one in used), f"{number} {kept}"]
        parts.append(Part(folded(f"EM_NOINLINE_KERNEL void {function}", declared, ")"), tuple(body)))
        calls.append(folded(function, [*used, KEPT], ");"))
    return tuple(parts), tuple(calls)


class _Pieces:
    """The statements of a kernel in pieces, and the places of the values that cross from one to another.

    Each piece reads the arguments that it needs itself.
    """

    def __init__(self, number: str, statements: Sequence[str], arguments: Mapping[str, str]) -> None:
        self.number = number  # where names are long, any space may be the end of a line
        load = re.compile(rf"const\s+{number}\s+(\w+)\s+=\s+({'|'.join(arguments)})\[\d+\];")
        self.loads = {found[1]: text for text in statements if (found := load.fullmatch(text))}
        self.texts = [text for text in statements if not load.fullmatch(text)]
        self.names = list(map(_names, self.texts))
        defines = re.compile(rf"const\s+{number}\s+(\w+)\s+=\s")
        self.defined = [found[1] if (found := defines.match(text)) else "" for text in self.texts]
        self.at = {name: at for at, name in enumerate(self.defined) if name}
        self.last = {name: at for at, names in enumerate(self.names) for name in names if name in self.at}
        self.ranges = self._ranges()
        starts = [piece.start for piece in self.ranges]
        crossing = [name for name, at in self.at.items() if bisect(starts, at) != bisect(starts, self.last[name])]
        self.places = {name: place for place, name in enumerate(crossing)}

    def _ranges(self) -> list[range]:
        """Return the statements of each piece; cuts are where few values are alive, within a third of a part."""
        alive, pieces, first = self._alive(), [], 0
        while len(self.texts) - first > PART + PART // 3:
            around = range(first + PART - PART // 3, first + PART + PART // 3)
            last = min(around, key=lambda at: (alive[at], at))
            pieces.append(range(first, last))
            first = last
        return [*pieces, range(first, len(self.texts))]

    def _alive(self) -> list[int]:
        """Return how many values are defined before each statement, and used in it or later."""
        change = [0] * (len(self.texts) + 1)
        for name, at in self.at.items():
            change[at + 1] += 1
            change[self.last[name] + 1 if self.last[name] < len(self.texts) else at + 1] -= 1
        return list(accumulate(change))

    def body(self, count: int) -> list[str]:
        """Return the statements of a piece, with those that read arguments and pass values on."""
        piece, known, body = self.ranges[count], set[str](), list[str]()
        for at in piece:
            for name in sorted(self.names[at] - known, key=lambda name: (self.at.get(name, -1), name)):
                if name in self.loads:
                    body.append(self.loads[name])
                elif name in self.places and self.at[name] < piece.start:
                    body.append(f"const {self.number} {name} = {KEPT}[{self.places[name]}];")
                known.add(name)
            body.append(self.texts[at])
            if self.defined[at] in self.places:
                body.append(f"{KEPT}[{self.places[self.defined[at]]}] = {self.defined[at]};")
        return body


def _names(text: str) -> frozenset[str]:
    return frozenset(_NAME.findall(re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)))
