"""One of N parts of the tests: so many nights, one after the other, run all of them, with a tenth of all seeds."""

import random
import zlib
from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple

import pytest

from .by_day import is_random

TURNS = 10
"""Each round of nights runs one seed in so many; the next round takes others."""


class Slice(NamedTuple):
    """Part number `part` of `parts`, with the seeds whose `turn` it is."""

    part: int
    parts: int
    turn: int

    def seeds(self, first: int, count: int) -> range:
        """Return its own of `count` seeds from `first` on."""
        return range(first + self.turn + TURNS * self.part, first + count, TURNS * self.parts)


def slice_of(text: str) -> Slice:
    """Return the part that "K/N" names: K counts modulo N, so that the number of a day will do; K // N is the turn.

    Raises
    ------
    ValueError
        It is not that.
    """
    k, _, n = text.partition("/")
    if not (k.isdecimal() and n.isdecimal() and int(n)):
        raise ValueError(f"{text!r} is not K/N. Give a part and how many there are, as 3/10.")
    return Slice(int(k) % int(n), int(n), int(k) // int(n) % TURNS)


def out_of_turn(items: list[pytest.Item], turn: int) -> Iterator[pytest.Item]:
    """Give the random cases of the night whose turn it is not.

    Cases of a file that are parametrised alike stay together, for they share what is drawn. They are dealt in random
    order, each test's in equal shares: what goes by seeds and by formulations meets all of these each time.
    """
    files = defaultdict[str, dict[str, list[pytest.Item]]](dict)
    for item in filter(is_random, items):
        files[item.path.name].setdefault(item.callspec.id, []).append(item)
    for file, cases in files.items():
        order = list(cases)
        random.Random(file).shuffle(order)
        order.sort(key=lambda case: cases[case][0].originalname)
        for number, case in enumerate(order, zlib.crc32(file.encode())):
            if number % TURNS != turn:
                yield from cases[case]


def outside_slice(items: list[pytest.Item], k: int, n: int) -> set[pytest.Item]:
    """Return the cases of other parts.

    Cases of a file that are parametrised alike stay together, for they share compiled models; files start at
    different parts, so that the single cases of many files do not all fall into one night.
    """
    files = defaultdict[str, dict[str, list[pytest.Item]]](dict)
    for item in items:
        case = item.callspec.id if hasattr(item, "callspec") else item.name
        files[item.path.name].setdefault(case, []).append(item)
    return {
        item
        for file, cases in files.items()
        for number, alike in enumerate(cases.values(), zlib.crc32(file.encode()))
        for item in alike
        if number % n != k
    }
