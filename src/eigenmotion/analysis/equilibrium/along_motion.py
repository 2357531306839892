"""States along the motion of a system that comes to rest by itself, from which its equilibrium is found."""

from collections.abc import Iterator

from ...arguments.named_values import Vector
from ...simulation.simulate import simulate
from .equilibrium_equations import Balance

_SPANS = 12
"""Most runs, each of four times the span of the one before, which is an inertial time constant at first."""
_STEPS = 20_000


def along_motion(balance: Balance) -> Iterator[Vector]:
    """Yield the unknowns at the ends of runs from the guess, one after the other, until a run fails.

    A controller that is saturated has no slope that shows the way out of saturation; its motion does.
    """
    system, at = balance.system, balance.point(balance.start)
    n, span, t, start = at.model.n, float(at.time), balance.t, at.model.state(balance.t, at.x, at.v, at.prepared)
    inputs = dict(zip(at.model.inputs, at.u.tolist(), strict=True))
    for _ in range(_SPANS):
        run = simulate(system, (t, t + span), start=(t, start), parameters=at.prepared, inputs=inputs, method="radau5",
                       rtol=1e-4, atol=1e-7, max_steps=_STEPS)  # fmt: skip
        if not run.success:
            return
        t, span, start = run.t[-1], 4 * span, run.y[:, -1]
        moving = balance.given.copy()
        moving[: system.n] = run.x[:, -1]
        moving[n + system.n : 2 * n] = [z[-1] for z in run.states.values()]
        yield moving[list(balance.free)]
