"""Random mechanisms with first-order states, in every formulation; `make fuzz` has them by the hundred."""

import pytest

from ..equations import state_checks
from ..equations.mechanism_checks import Counts


@pytest.mark.parametrize("seed", range(6))
def test_random_mechanisms_with_states(seed):
    counts = Counts()
    state_checks.check(seed, counts, ["eigenfactor", "cholesky", "lagrange"][seed % 3 :][:1], "-O0")
    assert not counts.wrong
    assert counts.systems
    assert counts.numbers > 10
