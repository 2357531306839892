"""The equations that `contact_modes` solves, whatever the mode."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

NONE = -1


@dataclass(frozen=True)
class Rub:
    """A friction: slip acceleration = rows @ a + offset; limits L + mu p of the normal's p.

    rows : (d, n), d = 1: on a line, 2: in a plane; slip : (d,), zero: at rest
    grip : (L, mu) at rest; drag : (L, mu) sliding
    """

    rows: np.ndarray
    offset: np.ndarray
    grip: tuple[float, float]
    drag: tuple[float, float]
    normal: int = NONE
    slip: np.ndarray | None = None

    @property
    def way(self) -> np.ndarray | None:
        """Where it slides already; None: at rest."""
        size = 0.0 if self.slip is None else np.linalg.norm(self.slip)
        return self.slip / size if size else None


@dataclass(frozen=True)
class Problem:
    """M a = h + N^T p + sum of rubs' rows^T f + rows^T l; N a + c >= 0; rows a + g = 0."""

    M: np.ndarray
    h: np.ndarray
    N: np.ndarray
    c: np.ndarray
    rubs: tuple[Rub, ...] = ()
    rows: np.ndarray | None = None
    g: np.ndarray | None = None

    @cached_property
    def inverse(self) -> np.ndarray:
        return np.linalg.inv(self.M)

    @property
    def permanent(self) -> tuple[np.ndarray, np.ndarray]:
        n = len(self.h)
        return (np.zeros((0, n)), np.zeros(0)) if self.rows is None else (self.rows, self.g)
