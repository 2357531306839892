"""Random machines on trees of bodies, a few by day; `make fuzz` takes a thousand."""

import pytest

from .machine_checks import Counts, check


@pytest.mark.parametrize("seed", [4, 10, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(20, 32))])
def test_machines_move_as_newton_and_euler_say(seed):
    counts = Counts()
    check(seed, counts, "-O0")
    assert counts.states > 0
    assert not counts.wrong


@pytest.mark.parametrize("seed", [5, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(32, 40))])
def test_machines_stated_by_first_moments_do_so_too(seed):
    counts = Counts()
    check(seed, counts, "-O0", moments=True)
    assert counts.states > 0
    assert not counts.wrong
