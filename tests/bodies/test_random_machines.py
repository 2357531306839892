"""Random machines on trees of bodies, a few by day; `make fuzz` takes a thousand."""

import pytest

from .machine_checks import Counts, check


@pytest.mark.parametrize("seed", [4, 10, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(20, 32))])
def test_machines_move_as_newton_and_euler_say(seed):
    counts = Counts()
    check(seed, counts, "-O0")
    assert counts.states > 0
    assert not counts.wrong
