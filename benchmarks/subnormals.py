"""Benchmark of subnormal numbers: a mechanism that moves beside coordinates that have come to rest.

Prints the time of a right-hand side at rest at 1e-320 over that at rest at 0, called from Python, where nothing is
flushed to zero, and the same for whole runs, in which subnormal numbers count as zero.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from statistics import median
from typing import Any

import numpy as np

import eigenmotion as em

ROUNDS, LINKS, CALLS = 7, 6, 5000
REST = 1e-320


def chain() -> em.Model:
    """Return an arm in a plane whose links may also leave it, which they do not."""
    tree, last = em.Tree(), None
    for k in range(LINKS):
        last = tree.body(f"link_{k}", last, joint="revolute", axis="yx"[k % 2], at=(0, 0, -0.3) if k else (0, 0, 0),
                         mass=1.0, center=(0, 0, -0.15), inertia=(0.01, 0.01, 0.001))  # fmt: skip
    return em.Model(name="chain_in_a_plane", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, forces={q: -q.diff() for q in tree.coordinates[1::2]},
                    initial=dict.fromkeys(tree.coordinates[::2], 0.3))  # fmt: skip


def seconds(function: Callable[[], Any]) -> float:
    """Return the seconds of a call."""
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def called(system: em.System, y: np.ndarray) -> None:
    """Compute the right-hand side many times."""
    for _ in range(CALLS):
        system.rhs(0.0, y)


def main() -> None:
    """Print the ratios."""
    system = em.build(chain(), formulation="articulated_body")
    starts = []
    for rest in (REST, 0.0):
        x, v = (values.copy() for values in system.initial)
        x[1::2] = v[1::2] = rest
        starts.append((x, v))
    calls, runs = [], []
    for _ in range(ROUNDS):
        calls.append([seconds(partial(called, system, system.state(x, v))) for x, v in starts])
        runs.append([seconds(partial(system.simulate, (0.0, 5.0), x0=x, v0=v, rtol=1e-9)) for x, v in starts])
    for name, rounds in (("right-hand side", calls), ("run", runs)):
        print(f"{name}: {median(one / other for one, other in rounds):.2f}")


if __name__ == "__main__":
    main()
