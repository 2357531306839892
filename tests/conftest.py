"""What the tests of generated code share."""

from collections.abc import Callable

import pytest

from eigenmotion import System

from . import generation


@pytest.fixture(scope="session")
def systems() -> Callable[..., System]:
    """(name of a file in models/, formulation) -> its System; each is generated and compiled once."""
    return generation.system_of
