"""Confidence intervals of estimates, and estimates as text."""

from collections.abc import Iterable
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError, number


def level_of(level: Any) -> float:
    """Return a confidence level.

    Raises
    ------
    ModelError
        It is not between 0 and 1.
    """
    confidence = number(level, "level")
    if not 0.0 < confidence < 1.0:
        raise ModelError(f"level is {confidence:g}. Give a number between 0 and 1.")
    return confidence


def intervals_of(estimates: Vector, covariance: Vector, freedoms: ArrayLike, level: float) -> Vector:
    """Return intervals (k, 2) by Student's t; freedoms of all, or (k,), where infinity is the normal distribution."""
    factor = scipy.special.stdtrit(np.minimum(freedoms, 1e10), 0.5 + level / 2)
    reach = factor * np.sqrt(np.diag(covariance))
    return np.column_stack([estimates - reach, estimates + reach])


def lines_of(texts: Iterable[str], estimates: Vector, deviations: Vector) -> list[str]:
    """Return a line for each estimate, with its standard deviation."""
    rows = zip(texts, estimates, deviations, strict=True)
    return [f"{text} = {value:.6g} +- {deviation:.2g}" for text, value, deviation in rows]
