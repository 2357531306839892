"""Pictures of stability: rows for what is not right, formulations that fare alike in one, type that is legible."""

import io
import re
from itertools import cycle

import pytest

from eigenmotion.stability import CASES, Matrix, Outcome
from eigenmotion.stability.evaluation.examine import PointResult
from eigenmotion.stability.evaluation.outcome import Cell
from eigenmotion.stability.output import drawing
from eigenmotion.stability.output.drawing import TYPE, WIDTH, detail, overview
from eigenmotion.stability.output.groups import alike, named

pytest.importorskip("matplotlib", reason="pictures need matplotlib")
METHODS = ("rk34", "dopri5", "dop853", "ra15", "radau5", "radau9")
PAGE = 700 / 96
"""[inch] of a page at 700 pixels"""


def matrix_of(count: int, wrong_every: int) -> Matrix:
    """All outcomes right, but those of every few cases, which go by all outcomes."""
    other, points = cycle([Outcome.REFUSED, Outcome.DEGRADED, Outcome.WRONG]), []
    for k, case in enumerate(list(CASES.values())[:count]):
        outcome = next(other) if wrong_every and k % wrong_every == 0 else Outcome.RIGHT
        for value in ("1e-2", "1", "1e2"):
            cells = tuple(
                Cell(case.name, value, variant.label, method, 1e-8, outcome if method == "rk34" else Outcome.RIGHT,
                     "too many steps" if outcome is Outcome.REFUSED else "",
                     error=None if outcome is Outcome.REFUSED and method == "rk34" else 1e-9)
                for method in METHODS for variant in case.variants
            )  # fmt: skip
            points.append(PointResult(case.name, value, "made up", 0.0, 1.0, 0.0, cells))
    return Matrix(tuple(points), 1.0, 1)


def pixels(png: bytes) -> tuple[int, int]:
    import matplotlib.image  # noqa: PLC0415, an optional package

    height, width = matplotlib.image.imread(io.BytesIO(png)).shape[:2]
    return width, height


@pytest.fixture
def texts(monkeypatch) -> list[tuple[str, float]]:
    """Words and sizes of all text that is drawn."""
    import matplotlib.text  # noqa: PLC0415, an optional package

    seen, drawn = [], matplotlib.text.Text.draw

    def noted(self, renderer, *rest, **named):
        if self.get_visible() and self.get_text().strip():
            seen.append((self.get_text(), self.get_fontsize()))
        return drawn(self, renderer, *rest, **named)

    monkeypatch.setattr(matplotlib.text.Text, "draw", noted)
    return seen


@pytest.mark.parametrize(("count", "wrong_every"), [(len(CASES), 2), (4, 1), (4, 0)])
def test_the_overview_has_legible_rows_for_what_is_not_right(count, wrong_every, texts):
    matrix = matrix_of(count, wrong_every)
    made = overview(matrix)
    words = " ".join(" ".join(text.split()) for text, _ in texts)
    assert min(size for _, size in texts) * PAGE / WIDTH >= 9.0
    width, height = pixels(made.png)
    assert width == pytest.approx(150 * WIDTH, abs=2)
    assert height < 1.6 * width
    bad = [case for k, case in enumerate(matrix.cases) if wrong_every and k % wrong_every == 0]
    for case in matrix.cases:
        runs = sum(len(point.cells) for point in matrix.of(case))
        assert (f"{case.title} ({runs})" in words) == (case not in bad)


def test_formulations_that_fare_alike_share_a_row(texts):
    matrix = matrix_of(1, 1)
    (case,) = matrix.cases
    detail(matrix, case)
    labels = {text for text, _ in texts}
    assert set(METHODS) <= labels
    assert min(size for _, size in texts) * PAGE / WIDTH >= 9.0
    assert TYPE == 9


def cell(variant: str, outcome: Outcome, method: str = "ra15") -> Cell:
    return Cell("a", "1", variant, method, 1e-8, outcome)


def test_groups():
    cells = [cell("a", Outcome.RIGHT), cell("b", Outcome.WRONG), cell("c", Outcome.RIGHT)]
    assert alike(cells, lambda one: one.outcome) == [("a", "c"), ("b",)]
    assert alike([*cells, cell("c", Outcome.WRONG, "rk34")], lambda one: one.outcome) == [("a",), ("b",), ("c",)]
    assert named(("a", "c"), ("a", "b", "c")) == "all but b"
    assert named(("b",), ("a", "b", "c")) == "b"
    assert named(("a", "b"), ("a", "b")) == ""


def test_no_label_is_longer_than_its_room():
    for case in CASES.values():
        assert max(map(len, drawing.wrapped(case.title).splitlines())) <= 34
    assert not re.search(r"\S{35}", " ".join(case.title for case in CASES.values()))
