"""Derivatives of a motion by central differences of whole runs, of order 4."""

from typing import Any

import numpy as np

from eigenmotion import System


def differences(
    system: System, name: str, end: float, h: float = 1e-4, rtol: float = 1e-12, **given: Any
) -> np.ndarray:
    """Return d(x, v)/d(name) (2n,) at the end of a run from t = 0; starts are projected."""

    def run(change: float) -> np.ndarray:
        p, (x, v) = system.parameters, system.start()
        if name in p:
            p[name] += change
        elif name in system.coordinates:
            x[system.coordinates.index(name)] += change
        else:
            v[system.coordinates.index(name[:-1])] += change
        x, v = system.project_initial_state(x, v, parameters=p)
        found = system.simulate((0, end), x0=x, v0=v, parameters=p, t_eval=[end], rtol=rtol, atol=1e-14, **given)
        return np.concatenate([found.x[:, -1], found.v[:, -1]])

    return (8 * (run(h) - run(-h)) - (run(2 * h) - run(-2 * h))) / (12 * h)
