"""Text about the stability matrix."""

from collections import Counter

from ...presentation.counts import count_of
from ...presentation.text import number
from ..cases.case import Case
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import OF_OWN_MODELS, Cell, Outcome

LETTERS = {
    "not offered": "F", "start refused": "X", "step size underflow": "S", "too many steps": "N",
    "non-finite state": "I", "singular mass matrix": "M", "dependent constraints": "C", "coincident eigenvalues": "E",
    "position not reached": "P", "eigenfactors drifted": "D",
    "event undefined": "U", "energy drifted": "W", "constraints drifted": "B",
}  # fmt: skip


def summary(matrix: Matrix) -> tuple[str, ...]:
    """Return the number of each outcome, and the wrong cells."""
    lines = [f"{runs_of(matrix)} in {matrix.seconds:.0f} s: {counted(matrix)}."]
    lines += [f"WRONG: {described(cell)}" for cell in matrix.cells if cell.outcome is Outcome.WRONG]
    return tuple(lines)


def runs_of(matrix: Matrix) -> str:
    """Return the numbers of runs and of points."""
    return f"{count_of(len(matrix.cells), 'run')} of {count_of(len(matrix.points), 'point')}"


def counted(matrix: Matrix) -> str:
    """Return the number of runs of each outcome; outcomes of users' models only if they occur."""
    counts = {outcome: matrix.count(outcome) for outcome in Outcome}
    return ", ".join(f"{count} {outcome}" for outcome, count in counts.items() if count or outcome not in OF_OWN_MODELS)


def described(cell: Cell) -> str:
    """Return one line about a cell."""
    point = cell.point.replace("\n", " ")
    error = f"error {number(cell.error)}, bound {number(cell.bound)}, indicators {number(cell.shown.largest)}"
    what = cell.reason if cell.error is None else error
    return f"{cell.case} at {point}, {cell.variant}, {cell.method} at {cell.tolerance:g}: {cell.outcome}; {what}"


def mark(cell: Cell) -> str:
    """Return the mark of a cell: the power of ten of its error, or the letter of its reason."""
    if cell.error is None:
        return LETTERS.get(cell.reason, "!")
    return "" if not cell.error > 0 else f"{cell.error:.0e}".split("e")[1].replace("-0", "-").replace("+0", "")


def reasons(matrix: Matrix, case: Case) -> tuple[tuple[str, int], ...]:
    """Return the reasons in a case, and the number of runs with each."""
    counts = Counter(cell.reason for point in matrix.of(case) for cell in point.cells if cell.reason)
    return tuple(counts.most_common())
