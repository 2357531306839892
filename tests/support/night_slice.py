"""One of N parts of the tests: so many nights, one after the other, run all of them."""

import zlib
from collections import defaultdict

import pytest


def slice_of(text: str) -> tuple[int, int]:
    """Return (k, N) of "K/N": K counts modulo N, so that the number of a day will do.

    Raises
    ------
    ValueError
        It is not that.
    """
    k, _, n = text.partition("/")
    if not (k.isdecimal() and n.isdecimal() and int(n)):
        raise ValueError(f"{text!r} is not K/N. Give a part and how many there are, as 3/10.")
    return int(k) % int(n), int(n)


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
