"""Random expression trees with roots, absolute values and choices, through the graph and its derivatives."""

import pytest

from . import tree_checks

PARTS = 4
TREES, ZEROS = 180, 24
"""In all parts together; `make fuzz` takes more."""


@pytest.mark.parametrize("part", range(PARTS))
def test_the_graph_means_what_the_tree_means(part):
    counts = tree_checks.Counts()
    for seed in range(part, TREES, PARTS):
        tree_checks.check(seed, counts)
    assert counts.wrong == []
    assert counts.trees > 0.9 * TREES / PARTS
    assert counts.values - counts.unreal > 10 * counts.trees


@pytest.mark.parametrize("part", range(PARTS))
def test_only_what_is_zero_everywhere_counts_as_zero(part):
    counts = tree_checks.Counts()
    for seed in range(part, ZEROS, PARTS):
        tree_checks.check_zeros(seed, counts)
    assert counts.wrong == []
    assert counts.zeros > 10 * ZEROS / PARTS
