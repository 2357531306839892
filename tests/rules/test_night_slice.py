"""The parts of the night: each case is in one of them."""

from types import SimpleNamespace

import pytest

from ..support.night_slice import outside_slice, slice_of


def cases(file: str, *names: str) -> list[SimpleNamespace]:
    path = SimpleNamespace(name=file)
    return [HashedCase(path=path, name=name, callspec=SimpleNamespace(id=name.partition("-")[2])) for name in names]


class HashedCase(SimpleNamespace):
    __hash__ = object.__hash__


@pytest.mark.parametrize("n", [1, 2, 7])
def test_the_parts_are_all_cases_each_once(n):
    items = cases("a.py", *(f"{test}-{case}" for test in "pq" for case in range(20))) + cases("b.py", "p-1", "p-2")
    parts = [[item for item in items if item not in outside_slice(items, k, n)] for k in range(n)]
    assert sorted(id(item) for part in parts for item in part) == sorted(map(id, items))
    for part in parts:
        assert len(part) <= 2 * (20 // n + 1) + 2
        for item in part:  # cases alike stay together
            alike = [one for one in items if one.path is item.path and one.callspec.id == item.callspec.id]
            assert all(one in part for one in alike)


def test_days_count_modulo_the_parts():
    assert slice_of("028/10") == (8, 10)
    for wrong in ("3", "3/0", "a/2", ""):
        with pytest.raises(ValueError, match="Give a part and how many there are"):
            slice_of(wrong)
