"""A swing of the bead, against the pendulum on paper."""

import numpy as np
from scipy.integrate import solve_ivp

M, G, L = 2.0, 9.81, 1.5
TIGHT = {"rtol": 1e-10, "atol": 1e-12}
START = {"x0": L * np.array([np.sin(1.0), -np.cos(1.0)]), "v0": [0.0, 0.0]}


def pendulum(t: np.ndarray, push=lambda t: 0.0) -> np.ndarray:
    """Positions (2, k) by way of the angle, from rest at one radian."""
    found = solve_ivp(
        lambda t, q: [q[1], (-G * np.sin(q[0]) + push(t) * np.cos(q[0]) / M) / L],
        (0, max(t)), [1.0, 0.0], "DOP853", t_eval=t, rtol=1e-12, atol=1e-13, max_step=0.05,
    )  # fmt: skip
    return L * np.array([np.sin(found.y[0]), -np.cos(found.y[0])])
