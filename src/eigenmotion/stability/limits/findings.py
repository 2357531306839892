"""Findings about a model: the best formulation and method, and the limits of each parameter."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ..evaluation.examine import PointResult
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import JUDGED_RIGHT, Cell, Outcome
from .families import PARAMETER

GOOD = (Outcome.RIGHT, Outcome.AGREES, Outcome.NO_DIGITS)
"""Outcomes that say nothing against a run."""
Combination = tuple[str, str]


@dataclass(frozen=True)
class Record:
    """The runs of one formulation and method; `bad` are those with other outcomes than GOOD."""

    combination: Combination
    cells: tuple[Cell, ...]

    @property
    def bad(self) -> tuple[Cell, ...]:
        return tuple(cell for cell in self.cells if cell.outcome not in GOOD)

    @property
    def right(self) -> tuple[Cell, ...]:
        """Runs that were compared, and are right; those without digits are not."""
        return tuple(cell for cell in self.cells if cell.outcome in JUDGED_RIGHT)

    @property
    def key(self) -> tuple[float, ...]:
        """Order: few faults, many right runs, little time."""
        faults = sum(cell.outcome in (Outcome.WRONG, Outcome.DIFFERS) for cell in self.cells)
        return (faults, -len(self.right), sum(cell.seconds for cell in self.right))


def records(matrix: Matrix) -> list[Record]:
    """Return every formulation with every method, from best to worst."""
    pairs = dict.fromkeys((cell.variant, cell.method) for cell in matrix.cells)
    both = [Record(pair, tuple(c for c in matrix.cells if (c.variant, c.method) == pair)) for pair in pairs]
    return sorted(both, key=lambda record: record.key)


@dataclass(frozen=True)
class Range:
    """The factors of a parameter from `least` to `most`, within which every run of a combination is good.

    below, above : the first outcome outside with its reason; "": it was not found within the factors that were run
    """

    name: str
    least: float
    most: float
    below: str
    above: str

    @property
    def limited(self) -> bool:
        return bool(self.below or self.above)


def ranges(matrix: Matrix, combination: Combination) -> list[Range]:
    """Return the range of each parameter that was varied, from the value of the model outwards."""
    found = []
    for case in matrix.cases:
        if case.name.startswith(PARAMETER):
            cells = [(float(p.point), c) for p in matrix.of(case) if (c := _of(p, combination)) is not None]
            least, below = _outwards(cell for cell in reversed(cells) if cell[0] < 1)
            most, above = _outwards(cell for cell in cells if cell[0] > 1)
            found.append(Range(case.title.removeprefix("Parameter "), least, most, below, above))
    return found


def _of(point: PointResult, combination: Combination) -> Cell | None:
    return next((c for c in point.cells if (c.variant, c.method) == combination), None)


def _outwards(cells: Iterable[tuple[float, Cell]]) -> tuple[float, str]:
    """Return the last factor before the first bad cell, and what that is."""
    last = 1.0
    for factor, cell in cells:
        if cell.outcome not in GOOD:
            return last, f"{cell.outcome} at {factor:g}" + (f", {cell.reason}" if cell.reason else "")
        last = factor
    return last, ""


def places(matrix: Matrix, cells: Sequence[Cell | PointResult], most: int = 4) -> str:
    """Return in which cases some cells or points are, with the labels of their points."""
    points: dict[str, list[str]] = {}
    for cell in cells:
        listed = points.setdefault(cell.case, [])
        if cell.point not in listed:
            listed.append(cell.point)
    titles = {case.name: case.title.replace("Parameter ", "") for case in matrix.cases}
    texts = [f"{titles[name]} {', '.join(listed)}" for name, listed in points.items()]
    rest = f"; and {len(texts) - most} more" if len(texts) > most else ""
    return "; ".join(texts[:most]) + rest
