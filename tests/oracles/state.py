"""Positions and velocities at one time, and what a model says about its start."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from eigenmotion import Model


@dataclass(frozen=True, slots=True)
class State:
    """x, v : (n,); NaN where an oracle says nothing."""

    x: np.ndarray
    v: np.ndarray


def parameters_of(model: Model) -> dict[str, float]:
    """Return the default parameters by name."""
    return {str(symbol): value for symbol, value in model.parameters}


def initial_state(model: Model) -> State:
    """Return the start that the model states."""
    return State(np.array(model.initial_x), np.array(model.initial_v))
