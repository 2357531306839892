"""A fixture of the tests of sensitivities: the integrations of variational equations that a test makes."""

import pytest

from eigenmotion.runtime.variations import Variations
from eigenmotion.simulation.sensitivity import sensitivities


@pytest.fixture
def integrations(monkeypatch: pytest.MonkeyPatch) -> list[Variations]:
    """The integrations of variational equations that a test makes, in order."""
    made: list[Variations] = []

    def kept(*arguments):
        made.append(Variations(*arguments))
        return made[-1]

    monkeypatch.setattr(sensitivities, "Variations", kept)
    return made
