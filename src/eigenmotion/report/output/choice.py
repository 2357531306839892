"""Choice of the few curves of a report that are drawn unless all are asked for."""

from collections.abc import Sequence

from ..recommend import Curve, Recommendation
from ..solvers import OURS

MOST = 8
"""More curves than this are not told apart at a glance."""
_ERRORS = tuple(10.0 ** (-k / 2) for k in range(4, 29))  # 1e-2, 3e-3 ... 1e-14

RULE = (
    "One curve of each kind is drawn: each of our formulations with an explicit method, our implicit methods, and each "
    "other package. Of a kind it is the curve that takes the least time at the most errors from 1e-2 to 1e-14, two in "
    "a decade. The recommended curve stands for its kind."
)


def kind(curve: Curve) -> str:
    """Return the kind of a curve: a formulation of ours, "implicit" for our implicit methods, else the package."""
    if curve.family != OURS:
        return curve.family
    return "implicit" if curve.is_implicit else curve.formulation


def foremost(curves: Sequence[Curve], advice: Recommendation) -> tuple[Curve, ...]:
    """Return the curve of each kind that RULE chooses, at most MOST of them, in their order."""
    chosen = advice.chosen or advice.closest
    kinds: dict[str, list[Curve]] = {}
    for curve in curves:
        if curve.points:
            kinds.setdefault(kind(curve), []).append(curve)
    return tuple(_best(every, chosen.curve if chosen else None) for every in kinds.values())[:MOST]


def _best(curves: Sequence[Curve], recommended: tuple[str, str, str] | None) -> Curve:
    """Return the recommended curve, else the one that is fastest at the most errors, else the most accurate one."""
    named = [c for c in curves if (c.family, c.formulation, c.method) == recommended]
    return named[0] if named else max(curves, key=lambda c: (_wins(c, curves), -min(c.errors)))


def _wins(curve: Curve, others: Sequence[Curve]) -> int:
    """Return at how many errors a curve takes no longer than any other: its share of the lower envelope."""
    wins = 0
    for error in _ERRORS:
        times = [seconds for other in others if (seconds := other.seconds_at(error)) is not None]
        wins += bool(times) and curve.seconds_at(error) == min(times)
    return wins
