"""Charts of a report: which curves are drawn, and whether pictures are legible."""

from dataclasses import replace
from itertools import combinations

import pytest

from eigenmotion.report.output.chart import charts
from eigenmotion.report.output.choice import MOST, foremost, kind
from eigenmotion.report.recommend import curves, recommend

from .made_up import ALL, OURS, PEERS, findings, measurement

MADE = {
    "all solvers": {},
    "crowded": {"spread": 1.2, "seed": 3},
    "wide": {"spread": 9.0, "seed": 4},
    "one": {"solvers": OURS[:1]},
    "peers only": {"solvers": PEERS},
    "long": {"name": "a_mechanism_whose_name_is_of_some_length_indeed", "seed": 5},
    "dollars": {"name": "a$b$c", "seed": 6},
    "out of reach": {"error": 1e-30, "seed": 7},
}


def points(solver, *pairs):
    return [measurement(solver, 10.0**-k, error, seconds) for k, (error, seconds) in enumerate(pairs)]


def test_the_curve_of_a_kind_is_its_fastest_at_most_errors():
    loose = points(("SciPy", "f", "A"), (1e-2, 1.0), (1e-4, 2.0), (1e-5, 90.0))
    tight = points(("SciPy", "f", "B"), (1e-2, 3.0), (1e-5, 4.0), (1e-12, 5.0))
    (chosen,) = foremost(curves([*loose, *tight]), recommend((), 1e-8))
    assert chosen.method == "B"  # from 3e-5 to 1e-12; the other one from 1e-2 to 1e-4


def test_the_recommended_curve_stands_for_its_kind():
    often = points(("eigenmotion", "lagrange", "ra15"), (1e-3, 1.0), (1e-6, 2.0), (1e-12, 3.0))
    once = points(("eigenmotion", "lagrange", "rk34"), (1e-2, 0.5), (1e-3, 50.0))
    lines = curves([*often, *once])
    assert [c.method for c in foremost(lines, recommend(lines, 1e-2))] == ["rk34"]
    assert [c.method for c in foremost(lines, recommend(lines, 1e-8))] == ["ra15"]


@pytest.mark.parametrize("made", MADE.values(), ids=MADE)
def test_one_curve_of_each_kind_and_no_more_than_eight(made):
    found = findings(**made)
    few = foremost(found.curves, found.recommendation)
    assert len(few) <= MOST == 8
    assert sorted(map(kind, few)) == sorted({kind(c) for c in found.curves})
    for chart in charts(found):
        assert len(chart.few) <= MOST
        assert {line.label for line in chart.few} <= {line.label for line in chart.every} or chart.stem.endswith(
            "order"
        )


def test_solvers_that_were_measured_nowhere_are_not_drawn():
    found = findings(solvers=OURS)
    nothing = replace(found.curves[0], points=())
    assert nothing not in foremost((nothing, *found.curves[1:]), found.recommendation)


def test_more_kinds_than_fit_are_cut():
    others = [(f"package {k}", "f", "m") for k in range(9)]
    found = findings(solvers=[*OURS, *others])
    assert len(foremost(found.curves, found.recommendation)) == MOST


def test_points_are_errors_and_times_of_measurements():
    time, order = charts(findings())
    for line in (*time.few, *time.every):
        assert all((error, height) == (m.error_max, m.seconds) for error, height, m in line.points)
        assert {m.label for *_, m in line.points} == {line.label}
    for line in order.every:
        assert all((error, height) == (m.error_max, m.nsteps) for error, height, m in line.points)
    assert len(time.every) == len(ALL)


def test_the_order_of_a_label_is_that_of_the_curve():
    found = findings(solvers=OURS)
    _, order = charts(found)
    for line in order.every:
        (curve,) = [c for c in found.curves if c.label == line.label.partition(",")[0]]
        p = curve.order(found.floor)
        assert line.label == (curve.label if p is None else f"{curve.label}, p = {p:.1f}")


# -- pictures


def boxes(figure):
    """What is written in a figure, with the rectangles [pixel] that it takes."""
    renderer = figure.canvas.get_renderer()
    (axes,) = figure.axes
    ticks = [label for axis in (axes.xaxis, axes.yaxis) for label in axis.get_ticklabels() if label.get_text()]
    texts = [*figure.texts, *axes.texts, axes.xaxis.label, *ticks]
    return [(text.get_text(), text.get_window_extent(renderer)) for text in texts]


@pytest.mark.parametrize("everything", [False, True])
@pytest.mark.parametrize("made", MADE.values(), ids=MADE)
def test_a_picture_is_legible(made, everything):
    pytest.importorskip("matplotlib")
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415, an optional package

    from eigenmotion.report.output.curves import figure_of  # noqa: PLC0415

    for chart in charts(findings(**made)):
        figure = figure_of(chart, everything)
        FigureCanvasAgg(figure).draw()
        found, whole = boxes(figure), figure.bbox
        words = [text for text, _ in found]
        assert {line.label for line in chart.lines(everything)} <= set(words)
        for text, box in found:
            assert box.x0 >= 0, text
            assert box.y0 >= 0, text
            assert box.x1 <= whole.x1, text
            assert box.y1 <= whole.y1, text
        for (one, a), (two, b) in combinations(found, 2):
            assert not a.overlaps(b), f"{one!r} and {two!r} overlap"
        smallest = min(t.get_fontsize() for t in (*figure.texts, *figure.axes[0].texts))
        assert smallest / 72 * 400 / figure.get_figwidth() >= 9.5  # pixels on a phone
