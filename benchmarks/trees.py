"""Benchmark of trees of bodies: time of a right-hand side and of a build, for spatial arms of n joints.

For each n: seconds to build (derivation, compiler, proof) and nanoseconds of a right-hand side within a run by dop853,
for each formulation. It prints the table of docs/trees.md, with times relative to articulated bodies. Pinocchio's `aba`
is timed beside, called from Python, where it is installed.
"""

from __future__ import annotations

import time
from importlib import import_module
from importlib.util import find_spec
from statistics import median

import numpy as np

import eigenmotion as em

SIZES = (2, 4, 6, 8, 12, 16, 24)
FORMULATIONS = {"articulated_body": 24, "lagrange": 24, "eigenfactor": 12}
"""Formulation -> largest n that it is built for."""
ROUNDS = 5


def arm(n: int) -> em.Model:
    """Return an arm of n cylinders, whose joints turn about z and y in turn."""
    tree, body = em.Tree(), None
    for k in range(n):
        body = tree.body(f"link_{k}", body, joint="revolute", axis="zy"[k % 2], at=(0.6, 0, 0) if k else (0, 0, 0),
                         mass=1.0, center=(0.3, 0, 0), inertia=(0.00125, 0.0306, 0.0306))  # fmt: skip
    return em.Model(name=f"arm_of_{n}", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, initial=dict.fromkeys(tree.coordinates, 0.3))  # fmt: skip


def nanoseconds(system: em.System) -> float:
    """Return the time of a run over its right-hand sides."""
    start = time.perf_counter()
    run = system.simulate((0.0, 1.0), rtol=1e-8, method="dop853")
    return (time.perf_counter() - start) / run.nfev * 1e9


def built(n: int) -> dict[str, tuple[em.System, float]]:
    """Return each formulation's system and the seconds of its build."""
    systems = {}
    for formulation, largest in FORMULATIONS.items():
        if n <= largest:
            start = time.perf_counter()
            systems[formulation] = em.build(arm(n), formulation=formulation), time.perf_counter() - start
    return systems


def pinocchio(n: int) -> float | None:
    """Return the nanoseconds of `aba` of the same arm, called from Python."""
    if find_spec("pinocchio") is None:
        return None
    pin = import_module("pinocchio")
    model, last = pin.Model(), 0
    for k in range(n):
        joint = pin.JointModelRY() if k % 2 else pin.JointModelRZ()
        place = pin.SE3(np.eye(3), np.array([0.6 if k else 0.0, 0, 0]))
        last = model.addJoint(last, joint, place, f"joint_{k}")
        inertia = pin.Inertia(1.0, np.array([0.3, 0, 0]), np.diag([0.00125, 0.0306, 0.0306]))
        model.appendBodyToJoint(last, inertia, pin.SE3.Identity())
    data, q, v, calls = model.createData(), np.full(n, 0.3), np.full(n, 0.1), 2000
    start = time.perf_counter()
    for _ in range(calls):
        pin.aba(model, data, q, v, v)
    return (time.perf_counter() - start) / calls * 1e9


def main() -> None:
    """Print the table."""
    heads = ("n", "articulated_body, ns", "build, s", "lagrange", "build, s", "eigenfactor", "build, s", "aba, ns")
    print(f"| {' | '.join(heads)} |\n|{' --- |' * len(heads)}")
    for n in SIZES:
        systems = built(n)
        rounds = [{name: nanoseconds(system) for name, (system, _) in systems.items()} for _ in range(ROUNDS)]
        times = {name: median(one[name] for one in rounds) for name in systems}
        unit = times["articulated_body"]
        cells = [f"{unit:.0f}", f"{systems['articulated_body'][1]:.1f}"]
        for name in ("lagrange", "eigenfactor"):
            cells += [f"{times[name] / unit:.2f}", f"{systems[name][1]:.1f}"] if name in systems else ["", ""]
        others = [one for one in (pinocchio(n) for _ in range(ROUNDS)) if one is not None]
        print(f"| {n} | {' | '.join(cells)} | {f'{median(others):.0f}' if others else ''} |", flush=True)


if __name__ == "__main__":
    main()
