"""Benchmark of trees of bodies: time of a right-hand side and of a build, for arms of n joints.

python benchmarks/trees.py [--growth | --angles | --root | --derivatives]

For each n: seconds to build (derivation, compiler, proof) and nanoseconds of a right-hand side within a run by dop853,
for each formulation. It prints the table of docs/trees.md, with times relative to articulated bodies. Pinocchio's `aba`
is timed beside, called from Python, where it is installed.

With `--growth`: for planar and spatial arms of 4 to 400 joints, in formulation articulated_body, seconds of all
processors to build an arm with an empty cache, of these in the proof, nanoseconds of an acceleration (a call from
Python), milliseconds to run a second of motion by dop853, and its right-hand sides; each time divided by the number of
joints, too, that of the run also by its right-hand sides.

With `--angles`: for chains of 4 to 32 pendulums whose energies are written in the angles between links, seconds of all
processors and on the clock to build one with an empty cache.

With `--root`: formulation cholesky, whose root of M follows from M or from articulated bodies, whichever has fewer
operations. For each n, the operations of a right-hand side (an addition counts 1, a multiplication 1, a division 4, a
root 5, a function 15), and its nanoseconds within a run by dop853: with the root of M, with that of articulated bodies,
and in formulation articulated_body.

With `--derivatives`: what the first Jacobian of an arm that is built takes with an empty cache, in processor seconds of
this process and of the compiler, and microseconds of a later one: by loops over a table of bodies, and by straight-line
code.
"""

from __future__ import annotations

import argparse
import os
import resource
import tempfile
import time
from contextlib import ExitStack
from importlib import import_module
from importlib.util import find_spec
from statistics import median
from typing import Any
from unittest.mock import patch

import numpy as np
import sympy
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.program import kernels, memory_layout
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.building import verification

SIZES = (2, 4, 6, 8, 12, 16, 24)
FORMULATIONS = {"articulated_body": 24, "lagrange": 24, "eigenfactor": 12}
"""Formulation -> largest n that it is built for."""
ROUNDS = 5
ANGLES = (4, 8, 12, 16, 20, 32)
ROOTED = (4, 6, 8, 12, 16, 32, 64)
LARGEST_M = 32
"""Joints for which the root of M is built: beyond, a compiler takes minutes."""
DIFFERENTIATED = (16, 20, 32, 100)
STRAIGHT = 20
"""Joints up to which derivatives are built as straight-line code, too: of 32 it takes minutes."""
LENGTHS = (4, 8, 16, 32, 64, 100, 200, 300, 400)


def arm(n: int, axes: str = "zy") -> em.Model:
    """Return an arm of n cylinders, whose joints turn about these axes in turn."""
    tree, body = em.Tree(), None
    for k in range(n):
        body = tree.body(f"link_{k}", body, joint="revolute", axis=axes[k % len(axes)],
                         at=(0.6, 0, 0) if k else (0, 0, 0), mass=1.0, center=(0.3, 0, 0),
                         inertia=(0.00125, 0.0306, 0.0306))  # fmt: skip
    return em.Model(name=f"arm_of_{n}_{axes}", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, initial=dict.fromkeys(tree.coordinates, 0.3))  # fmt: skip


def pendulums(n: int) -> em.Model:
    """Return a chain of n pendulums by its energies, in the angles between them."""
    angles, (x, y, turn, T, V) = dynamicsymbols(f"q_1:{n + 1}"), (sympy.S.Zero,) * 5
    for angle in angles:
        turn += angle
        x, y = x + sympy.sin(turn) / 2, y - sympy.cos(turn) / 2
        T += (x.diff(em.t) ** 2 + y.diff(em.t) ** 2 + turn.diff(em.t) ** 2 / 50) / 2
        V += 9.81 * y
    return em.Model(name=f"pendulums_{n}", coordinates=angles, kinetic_energy=T, potential_energy=V)


def nanoseconds(system: em.System) -> float:
    """Return the processor time of a run over its right-hand sides."""
    start = time.process_time()
    run = system.simulate((0.0, 1.0), rtol=1e-8, method="dop853")
    return (time.process_time() - start) / run.nfev * 1e9


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


def processor_seconds() -> float:
    """Return the processor time of this process and of compilers."""
    return sum(os.times()[:4])


def grown(n: int, axes: str) -> tuple[float, float, float, float, int]:
    """Return seconds to build, in the proof, of an acceleration, and to run a second; the right-hand sides of that."""
    model, proof, spent = arm(n, axes), verification.prove, [0.0]

    def timed(*given: Any) -> None:
        start = processor_seconds()
        proof(*given)
        spent[0] = processor_seconds() - start

    start, verification.prove = processor_seconds(), timed
    system = em.build(model, formulation="articulated_body")
    building, verification.prove = processor_seconds() - start, proof
    x, v, calls = np.full(n, 0.3), np.full(n, 0.1), 50
    accelerations, runs = [], []
    for _ in range(ROUNDS):
        start = time.process_time()
        for _ in range(calls):
            system.acceleration(x, v)
        accelerations.append((time.process_time() - start) / calls)
        start = time.process_time()
        run = system.simulate((0.0, 1.0), rtol=1e-8, method="dop853")
        runs.append(time.process_time() - start)
    return building, spent[0], min(accelerations), min(runs), run.nfev


def growth() -> None:
    """Print the table of long arms."""
    heads = ("axes", "n", "build, s", "of these proof", "acceleration, us", "a second, ms", "right-hand sides")
    per_joint = ("build / n, s", "acceleration / n, ns", "a second / n, us", "right-hand side / n, ns")
    print(f"| {' | '.join((*heads, *per_joint))} |\n|{' --- |' * len((*heads, *per_joint))}")
    with tempfile.TemporaryDirectory() as cache:
        os.environ["EIGENMOTION_CACHE"] = cache
        em.build(arm(2), formulation="articulated_body")
        for axes in ("y", "zy"):
            for n in LENGTHS:
                build, proof, acceleration, second, calls = grown(n, axes)
                whole = f"{build:.2f} | {proof / build:.2f} | {acceleration * 1e6:.1f} | {second * 1e3:.1f} | {calls}"
                each = f"{build / n:.3f} | {acceleration / n * 1e9:.0f} | {second / n * 1e6:.0f} | "
                each += f"{second / calls / n * 1e9:.0f}"
                print(f"| {'planar' if axes == 'y' else 'spatial'} | {n} | {whole} | {each} |", flush=True)


def written_as_energies() -> None:
    """Print the table of chains whose energies are written in relative angles."""
    print("| n | formulation | processors, s | clock, s |\n| --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as cache:
        os.environ["EIGENMOTION_CACHE"] = cache
        em.build(pendulums(2))
        for n in ANGLES:
            for formulation in ("lagrange", "eigenfactor"):
                model, clock, start = pendulums(n), time.perf_counter(), processor_seconds()
                em.build(model, formulation=formulation)
                seconds = processor_seconds() - start, time.perf_counter() - clock
                print(f"| {n} | {formulation} | {seconds[0]:.1f} | {seconds[1]:.1f} |", flush=True)


def rooted(n: int, way: str, folder: str) -> tuple[int, em.System]:
    """Return the operations of a right-hand side of an arm, and its system.

    `way` : "M", "bodies" (the root by either, whatever it costs), or "accelerations"
    """
    os.environ["EIGENMOTION_CACHE"] = f"{folder}/{way}"  # the cache does not know of `way`
    dense = kernels.dense_weight
    choices = Choices("articulated_body" if way == "accelerations" else "cholesky")
    with ExitStack() as stack:
        if way == "M":
            for module in (compiler, memory_layout):
                stack.enter_context(patch.object(module, "has_recursive_root", lambda _: False))
        stack.enter_context(patch.object(kernels, "dense_weight", lambda *_: 10**9))
        made = compiler.program(arm(n), choices, whole=False)
        beside = sum(dense(block, 0) for block in made.blocks) if way == "M" else 0
        return made.kernels.published.cost.weight + beside, em.build(arm(n), formulation=choices.formulation)


def roots() -> None:
    """Print the table of the triangular root."""
    ways = ("M", "bodies", "accelerations")
    heads = ("n", *(f"operations, {way}" for way in ways), *(f"{way}, ns" for way in ways))
    print(f"| {' | '.join(heads)} |\n|{' --- |' * len(heads)}")
    with tempfile.TemporaryDirectory() as folder:
        for n in ROOTED:
            made = {way: rooted(n, way, folder) for way in ways if way != "M" or n <= LARGEST_M}
            rounds = [{way: nanoseconds(system) for way, (_, system) in made.items()} for _ in range(ROUNDS)]
            times = [f"{median(one[way] for one in rounds):.0f}" if way in made else "" for way in ways]
            counts = [f"{made[way][0]}" if way in made else "" for way in ways]
            print(f"| {n} | {' | '.join((*counts, *times))} |", flush=True)


def cpu(who: int) -> float:
    """Return processor seconds of this process, or of those that it has waited for."""
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def differentiated(n: int, loops: bool, folder: str) -> tuple[float, float, float]:
    """Return seconds of this process and of the compiler for the first Jacobian, and seconds of one more."""
    os.environ["EIGENMOTION_CACHE"] = f"{folder}/{loops}"
    everyone = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    with ExitStack() as stack:
        if not loops:
            stack.enter_context(patch.object(compiler, "loops_differentiate", lambda _: False))
        em.build(arm(2), formulation="articulated_body").jacobian(0.0, np.zeros(4))
        system, y = em.build(arm(n), formulation="articulated_body"), np.full(2 * n, 0.2)
        before = [cpu(who) for who in everyone]
        system.jacobian(0.0, y)
        own, compiling = (cpu(who) - start for who, start in zip(everyone, before, strict=True))
        rounds = []
        for _ in range(ROUNDS):
            start = time.process_time()
            for _ in range(100):
                system.jacobian(0.0, y)
            rounds.append((time.process_time() - start) / 100)
        return own, compiling, min(rounds)


def derivatives() -> None:
    """Print the table of derivatives."""
    print("| n | by | own, s | compiler, s | a Jacobian, us |\n|" + " --- |" * 5)
    with tempfile.TemporaryDirectory() as folder:
        for n in DIFFERENTIATED:
            for loops in (True, False) if n <= STRAIGHT else (True,):
                own, compiling, each = differentiated(n, loops, folder)
                kind = "loops" if loops else "straight-line code"
                print(f"| {n} | {kind} | {own:.1f} | {compiling:.1f} | {each * 1e6:.0f} |", flush=True)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--growth", action="store_true", help="arms of 4 to 400 joints")
    which.add_argument("--angles", action="store_true", help="chains written as energies")
    which.add_argument("--root", action="store_true", help="the triangular root by M and by articulated bodies")
    which.add_argument("--derivatives", action="store_true", help="the first Jacobian, by loops and without")
    given = parser.parse_args()
    tables = {"growth": growth, "angles": written_as_energies, "root": roots, "derivatives": derivatives}
    next((table for name, table in tables.items() if getattr(given, name)), formulations)()


def formulations() -> None:
    """Print the table of formulations."""
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
