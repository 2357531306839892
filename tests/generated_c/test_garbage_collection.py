"""Garbage is looked for again once what is made is there, and never by our doing."""

import gc

import pytest

from eigenmotion.garbage import uncollected


@pytest.mark.parametrize("before", [True, False])
def test_afterwards_it_is_as_before(before):
    (gc.enable if before else gc.disable)()
    try:
        with uncollected():
            assert not gc.isenabled()
        with pytest.raises(ZeroDivisionError), uncollected():
            raise ZeroDivisionError
        assert gc.isenabled() == before
    finally:
        gc.enable()
