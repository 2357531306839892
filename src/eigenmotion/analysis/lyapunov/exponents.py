"""Lyapunov exponents of a motion, with their spread."""

from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...compiled.compiled_system import CompiledSystem


@dataclass(frozen=True)
class Lyapunov:
    """Mean rates at which small deviations from a motion grow.

    Attributes
    ----------
    exponents : (k,) [1 / s], the largest first; -inf of deviations that vanish, as where friction sticks
    spread : (k,) standard errors, from means over parts of the run
    local : (pieces, k) rates in each piece of the run
    times : (pieces + 1,) [s] limits of the pieces
    x0, v0 : name -> value at the end of the run, a start for another one

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/rimless_wheel.py")
    >>> found = em.lyapunov(system, 100.0, x0={"theta": -0.3}, v0={"theta": 1.2})
    >>> found.local.shape, found.exponents[1].round(1)
    ((200, 2), np.float64(-0.7))
    """

    system: CompiledSystem
    exponents: Vector
    spread: Vector
    local: Vector
    times: Vector
    x0: dict[str, float]
    v0: dict[str, float]

    @property
    def dimension(self) -> float:
        """Kaplan and Yorke's dimension of the attractor; without the time of a forcing, which adds 1."""
        sums = np.cumsum(self.exponents)
        count = int((sums >= 0.0).sum())
        if count in {0, len(sums)}:
            return float(count)
        return count + float(sums[count - 1] / -self.exponents[count])

    def __str__(self) -> str:
        texts = [f"{one:.4g} ± {error:.2g}" for one, error in zip(self.exponents, self.spread, strict=True)]
        return f"{self.system.name}: {', '.join(texts)}"

    def __repr__(self) -> str:
        return f"<Lyapunov {self}>"
