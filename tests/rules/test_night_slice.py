"""The parts of the night: each case is in one of them."""

from types import SimpleNamespace

import pytest

from ..support.night_slice import TURNS, out_of_turn, outside_slice, slice_of


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


def random_cases(file: str, *names: str) -> list[SimpleNamespace]:
    items = cases(file, *names)
    for item in items:
        item.callspec.params = {"seed": 0}
        item.originalname = item.name.partition("-")[0]
        item.get_closest_marker = lambda _: pytest.mark.nightly.mark
    return items


def test_each_turn_has_a_tenth_of_the_random_cases_and_ten_turns_have_all():
    items = random_cases(
        "a.py", *(f"{test}-{case}" for test in "pq" for case in range(40)), *(f"r-r{k}" for k in range(3))
    )
    others = cases("b.py", "p-1", "p-2")
    for item in others:
        item.get_closest_marker, item.callspec.params = lambda _: None, {"seed": 0}
    turns = []
    for turn in range(TURNS):
        left_out = set(out_of_turn(items + others, turn))
        turns.append([item for item in items + others if item not in left_out])
        assert all(item in turns[-1] for item in others)
        for test, share in (("p", 4), ("q", 4)):
            assert sum(item.name.startswith(test) for item in turns[-1] if item in items) == share
    assert sorted(id(item) for turn in turns for item in turn if item in items) == sorted(map(id, items))


@pytest.mark.parametrize("n", [1, 10])
def test_nights_take_all_seeds_in_turn(n):
    nights = [set(slice_of(f"{night}/{n}").seeds(5, 1000)) for night in range(n * TURNS)]
    assert set().union(*nights) == set(range(5, 1005))
    assert sum(map(len, nights)) == 1000
    assert max(map(len, nights)) == min(map(len, nights)) == 1000 // (n * TURNS)


def test_days_count_modulo_the_parts():
    assert slice_of("028/10") == (8, 10, 2)
    assert slice_of("365/1") == (0, 1, 5)
    for wrong in ("3", "3/0", "a/2", ""):
        with pytest.raises(ValueError, match="Give a part and how many there are"):
            slice_of(wrong)
