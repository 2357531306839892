"""Findings: the paper's statements about its experiment compared with our runs."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from itertools import combinations

import numpy as np

from ..arguments.named_values import Vector
from .experiment import PAIRS, Experiment, History

SLIGHTLY = 2.0
"""Up to this ratio of two errors, one counts as slightly larger than the other."""
UNCOUPLED = 2


class Verdict(StrEnum):
    """Whether our run confirms a statement."""

    CONFIRMED = "confirmed"
    IN_PART = "in part"
    NOT_CONFIRMED = "not confirmed"


@dataclass(frozen=True, slots=True)
class Finding:
    """One statement of the paper and our measurement.

    figure : number of the paper's figure
    measured, numbers : our measurement as text, and as name -> value
    """

    figure: int
    statement: str
    measured: str
    verdict: Verdict
    numbers: tuple[tuple[str, float], ...]


def findings(experiment: Experiment) -> tuple[Finding, ...]:
    """Return the findings in the order of the figures."""
    history = experiment.eigenfactor.published
    return (
        _verified(experiment),
        _closest(history),
        _no_crossing(history),
        _approached(history),
        _active(history),
        _uncoupled(history),
        _variable_step(experiment),
        _violation(experiment),
        _accuracy(experiment),
    )


def _finding(figure: int, statement: str, measured: str, verdict: Verdict, **numbers: float) -> Finding:
    return Finding(figure, statement, measured, verdict, tuple((name, float(value)) for name, value in numbers.items()))


def _yes(condition: bool) -> Verdict:
    return Verdict.CONFIRMED if condition else Verdict.NOT_CONFIRMED


def _verified(experiment: Experiment) -> Finding:
    ends = [runs.published.x[:, -1] for runs in (experiment.eigenfactor, experiment.inverse)]
    difference = float(np.abs(ends[0] - ends[1]).max())
    measured = f"largest difference of theta(10): {difference:.1e}"
    statement = "the trajectories were verified by integrating the classical equations"
    return _finding(3, statement, measured, _yes(difference < 1e-5), difference=difference)


def closest(history: History, i: int, j: int) -> tuple[float, float]:
    """Return the smallest distance of two eigenvalues [kg m^2, as M] and its time [s]."""
    distance = np.abs(history.eigenvalues[i] - history.eigenvalues[j])
    k = int(distance.argmin())
    return float(distance[k]), float(history.t[k])


def _closest(history: History) -> Finding:
    pairs = list(combinations(range(4), 2))
    distances = [closest(history, *pair) for pair in pairs]
    best = int(np.argmin([distance for distance, _ in distances]))
    (gap, time), (i, j) = distances[best], pairs[best]
    measured = f"{gap:.4f}, between lambda_{i + 1} and lambda_{j + 1} at t = {time:.2f}"
    statement = "two eigenvalues are never closer than 0.03"
    return _finding(5, statement, measured, _yes(round(gap, 2) == 0.03), gap=gap, time=time)


def _no_crossing(history: History) -> Finding:
    """Compare the order of eigenvalues, which would change if they crossed."""
    order = np.argsort(-history.eigenvalues, axis=0)
    coupled = [row for row in order.T.tolist() if row != list(range(4))]
    measured = f"order changes in {len(coupled)} of {len(history.t)} rows"
    return _finding(5, "no eigenvalues cross", measured, _yes(not coupled), rows=len(coupled))


def peaks(history: History, i: int, j: int) -> list[tuple[float, float]]:
    """Return times [s] and heights [1/s] of the local maxima of |Omega_ij| above half its largest."""
    size = np.abs(history.Omega[i, j])
    top = (size[1:-1] > size[:-2]) & (size[1:-1] >= size[2:]) & (size[1:-1] > 0.5 * size.max())
    return [(float(history.t[k]), float(size[k])) for k in 1 + np.flatnonzero(top)]


def approaches(history: History, i: int, j: int) -> list[tuple[float, float]]:
    """Return times [s] and sizes of the local minima of |lambda_i - lambda_j| below half of that at the start."""
    size = np.abs(history.eigenvalues[i] - history.eigenvalues[j])
    low = (size[1:-1] < size[:-2]) & (size[1:-1] <= size[2:]) & (size[1:-1] < 0.5 * size[0])
    return [(float(history.t[k]), float(size[k])) for k in 1 + np.flatnonzero(low)]


def _approached(history: History) -> Finding:
    """List the approaches of eigenvalues within the coupled block, in the order of time."""
    events = sorted((t, size, i, j) for i, j in PAIRS for t, size in approaches(history, i, j))
    measured = "; ".join(f"lambda_{i + 1} and lambda_{j + 1} to {size:.3f} at t = {t:.2f}" for t, size, i, j in events)
    as_stated = bool(events) and events[0][2:] == (1, 3) and abs(events[0][0] - 2.0) < 0.1
    numbers = {f"at_{t:.1f}": size for t, size, _, _ in events}
    return _finding(
        5, "at t = 2 the second and the fourth eigenvalue become close", measured, _yes(as_stated), **numbers
    )


def _active(history: History) -> Finding:
    """Compare the peaks of Omega_24 with 2 and 6.5, and the sign change of Omega_12 with 4.25."""
    (first, _), (last, _) = (peaks(history, 1, 3)[k] for k in (0, -1))
    before, after = (peaks(history, 0, 1)[k][0] for k in (0, -1))
    turns = _zero(history.t, history.Omega[0, 1], before, after)
    measured = (
        f"|Omega_24| peaks at t = {first:.2f} and {last:.2f}; |Omega_12| at {before:.2f} and {after:.2f}, "
        f"and is zero between them at {turns:.2f}"
    )
    near = all(abs(a - b) < 0.15 for a, b in ((first, 2.0), (turns, 4.25), (last, 6.5)))
    statement = "Omega becomes active around t = 2, 4.25 and 6.5, where two eigenvalues approach each other"
    return _finding(6, statement, measured, _yes(near), first=first, turns=turns, last=last)


def _zero(t: Vector, values: Vector, start: float, end: float) -> float:
    """Return the time of a sign change between two times, by linear interpolation."""
    inside = [k for k in range(len(t) - 1) if start <= t[k] < end and values[k] * values[k + 1] <= 0]
    if not inside:
        return float("nan")
    k = inside[0]
    return float(t[k] - values[k] * (t[k + 1] - t[k]) / (values[k + 1] - values[k]))


def _uncoupled(history: History) -> Finding:
    size = float(np.abs(history.Omega[UNCOUPLED]).max())
    statement = "the Omega_3i are always zero"
    return _finding(6, statement, f"largest |Omega_3i|: {size:g}", _yes(size == 0.0), size=size)


def _variable_step(experiment: Experiment) -> Finding:
    gains = {
        name: runs.fixed.energy_error[-1] / runs.published.energy_error[-1]
        for name, runs in (("eigenfactor", experiment.eigenfactor), ("inverse", experiment.inverse))
    }
    measured = (
        f"steps of equal length 0.024 leave {gains['eigenfactor']:.1f} times the energy error "
        f"(brute force: {gains['inverse']:.1f} times)"
    )
    statement = "a variable step is very beneficial with this formulation"
    return _finding(6, statement, measured, _yes(gains["eigenfactor"] > SLIGHTLY), **gains)


def _violation(experiment: Experiment) -> Finding:
    both = (experiment.eigenfactor, experiment.inverse)
    ours, brute = (runs.published.violation.max() for runs in both)
    fixed, projected = ([getattr(runs, kind).violation.max() for runs in both] for kind in ("fixed", "projected"))
    measured = (
        f"largest violation {ours:.1e} m, brute force {brute:.1e} m: {ours / brute:.1f} times "
        f"(equal steps: {fixed[0]:.1e} and {fixed[1]:.1e}; projected: {projected[0]:.1e} and {projected[1]:.1e})"
    )
    statement = "the constraint violation is slightly lower than with brute force"
    return _finding(7, statement, measured, _yes(ours < brute), eigenfactor=ours, inverse=brute)


def _accuracy(experiment: Experiment) -> Finding:
    ours, brute = (runs.published.energy_error[-1] for runs in (experiment.eigenfactor, experiment.inverse))
    ratio = ours / brute
    verdict = Verdict.NOT_CONFIRMED if ratio <= 1 else Verdict.CONFIRMED if ratio < SLIGHTLY else Verdict.IN_PART
    measured = f"energy error {ours:.1e} J s, brute force {brute:.1e} J s: {ratio:.1f} times"
    statement = "only slightly less accurate than brute force"
    return _finding(8, statement, measured, verdict, eigenfactor=ours, inverse=brute)
