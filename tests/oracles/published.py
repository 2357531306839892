"""Values certified elsewhere: the paper's experiment, agreed by independent integrations in many digits."""

from __future__ import annotations

import numpy as np

from eigenmotion import Model

from .state import State

DUAL_LINK_X = ("0.700265153433880811", "2.454211044030905019", "0.141975525603218242", "1.677302668798167215")
DUAL_LINK_MULTIPLIER = "2.898544609494369686"

ANDREWS = (0.1581077119629904e2, -0.1575637105984298e2, 0.4082224013073101e-1, -0.5347301163226948,
           0.5244099658805304, 0.5347301163226948, 0.1048080741042263e1)  # fmt: skip
BICYCLE = {
    0.0: (-5.53094371765393, -3.13164324790656, 3.13164324790656, 5.53094371765393),
    3.0: (-10.35101467245920, -2.63366137253667, 1.70675605663975 + 2.31582447384325j),
    5.0: (-14.07838969279822, -0.32286642900409, -0.77534188219585 + 4.46486771378823j),
}
"""Forward speed [m/s] -> eigenvalues [1/s] of the benchmark bicycle (Meijaard and others 2007, table 2)."""
PUMA_TORQUES = (0.0, 31.6399, 6.0351, 0.0, 0.0283, 0.0)
"""[N m], which hold the PUMA 560 in its nominal pose (manual of the Robotics Toolbox for MATLAB, release 7)."""
PUMA_INERTIA = (3.6594, 4.4137, 0.9378, 0.1925, 0.1713, 0.1941)
"""[kg m^2], the diagonal of its mass matrix there (the same)."""


def andrews(model: Model, time: float) -> State:
    """Andrews' mechanism at t = 0.03 s (Test Set for IVP Solvers); ValueError at other times."""
    if time != 0.03:
        raise ValueError("the published state is that at t = 0.03 s")
    return State(np.array(ANDREWS), np.full(7, np.nan))


def dual_link(model: Model, time: float) -> State:
    """theta at t = 10 s of the paper's manipulator; ValueError at other times."""
    if time != 10.0:
        raise ValueError("the certified state is that at t = 10 s")
    return State(np.array(DUAL_LINK_X, dtype=np.longdouble), np.full(4, np.nan))
