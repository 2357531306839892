"""Parts that tests of failures share."""

import numpy as np
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model
from eigenmotion.results.solution import Solution
from eigenmotion.runtime import StopReason

X, Y = dynamicsymbols("x y")
FORMULATIONS = ("eigenfactor", "cholesky", "lagrange")


def plane(name: str, **given: object) -> Model:
    """Two masses, each on a line of its own."""
    energy = (X.diff() ** 2 + Y.diff() ** 2) / 2
    return Model(**{"name": name, "coordinates": [X, Y], "kinetic_energy": energy, **given})


def check_honest(found: Solution) -> None:
    """Rows are finite, and a failure says so everywhere."""
    assert len(found.t)
    for name in ("t", "y", "x", "v"):
        assert np.isfinite(found[name]).all(), name
    assert found.success == found.stop.success == (found.status >= 0)
    assert found.message.startswith("The end" if found.stop is StopReason.FINISHED else "At t = ")
