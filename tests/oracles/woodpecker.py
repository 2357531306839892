"""Glocker's woodpecker as `hybrid` has it, in units of 1 cm, 1 g and 10 ms: (6)-(10) of DETC2001/VIB-21608 by hand."""

import numpy as np

from .hybrid import Mechanism

LENGTH, MASS, TIME = 1e-2, 1e-3, 1e-2
UNITS = np.array([LENGTH, 1.0, 1.0])
"""Of y, phi_M, phi_S in SI."""
PERIOD, LOWEST, FREQUENCY = 0.1452, -0.53, 72.91
"""Published: [s], phi_S as it jams, and of the free bird and sleeve [Hz]."""


def matrices() -> tuple[np.ndarray, ...]:
    """M, K, f, N, g, T in SI."""
    m_M, J_M, m_S, J_S, c, gravity = 3e-4, 5e-9, 4.5e-3, 7e-7, 5.6e-3, 9.81
    r_0, r_M, h_M, l_M, l_G, h_S, l_S = 2.5e-3, 3.1e-3, 5.8e-3, 0.01, 0.015, 0.02, 0.0201
    levers = np.array([1.0, l_M, l_G])
    M = np.diag([m_M, J_M, J_S]) + m_S * np.outer(levers, levers)
    K = c * np.array([[0, 0, 0], [0, 1, -1], [0, -1, 1]])
    f = -gravity * np.array([m_S + m_M, m_S * l_M, m_S * l_G])
    N = np.array([[0, 0, -h_S], [0, h_M, 0], [0, -h_M, 0]])
    g = np.array([l_M + l_G - l_S - r_0, r_M - r_0, r_M - r_0])
    T = np.array([[1, l_M, l_G - l_S], [1, r_M, 0], [1, r_M, 0]])
    return M, K, f, N, g, T


def mechanism(law: str = "newton") -> Mechanism:
    """Beak, lower and upper edge; friction 0.3; the beak gives back half."""
    M, K, f, N, g, T = matrices()
    D, energy = np.diag(UNITS), MASS * LENGTH**2 / TIME**2
    return Mechanism(
        D @ M @ D / (energy * TIME**2), D @ K @ D / energy, D @ f / energy, N @ D / LENGTH, g / LENGTH, T @ D / LENGTH,
        0.3, np.array([0.5, 0.0, 0.0]), law,
    )  # fmt: skip


def start() -> tuple[np.ndarray, np.ndarray]:
    """Jammed, the bird at its lowest."""
    return np.array([0.0, -0.6 / 5.8, LOWEST]), np.zeros(3)
