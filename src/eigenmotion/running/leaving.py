"""How a leg begins whose steps are made in Python: where a contact has let go, its gap opens as slowly as t^3.

What a method makes of the first moments decides whether that gap opens or is shut again. Steps of order one are off by
their tolerance before they know how it bends, and a collocation polynomial does not leave with the velocity that there
is. So legs after events that act begin with steps of order five, and between their ends are what positions, rates and
accelerations there say.
"""

from collections.abc import Callable

import numpy as np
import scipy

from ..arguments.names import Vector

FIRST_STEPS = 5
"""How many: by then they are as long as the motion allows, and gaps are wider than tolerances."""
_RESOLVED = 0.1
"""By which part of an acceleration the mean of both ends may miss that of a step, or they say nothing of it."""


def joined(
    t: tuple[float, float], z: tuple[Vector, Vector], rate: tuple[Vector, Vector]
) -> Callable[[Vector], Vector] | None:
    """Return x and v (2 n, k) at times (k,) of a step that has such z = (x, v) and rates (2 n,) at its ends.

    None where accelerations change too fast within it, as on the way to a stiff equilibrium.
    """
    (start, end), n = t, len(z[0]) // 2
    h, a = end - start, (rate[0][n:], rate[1][n:])
    missed = np.abs((z[1] - z[0])[n:] - h * (a[0] + a[1]) / 2).max()
    if not missed <= _RESOLVED * h * np.abs(a).max():
        return None
    ends = [[end[:n], end[n:], of] for end, of in zip(z, a, strict=True)]
    x = scipy.interpolate.BPoly.from_derivatives([0.0, h], ends)
    v = x.derivative()
    return lambda times: np.concatenate((x(times - start), v(times - start)), axis=1).T
