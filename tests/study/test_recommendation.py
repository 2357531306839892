"""Advice of the report: on made up points, and on a stiff model."""

import importlib.util
import json
import re
from dataclasses import replace

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion.reference.motion import scaled_error
from eigenmotion.report import Budget, Findings, Measurement, ReportOptions, examine
from eigenmotion.report.output import recommendation, write_report
from eigenmotion.report.output.looks import dashes
from eigenmotion.report.peers import Peers
from eigenmotion.report.recommend import Curve, curves, recommend
from eigenmotion.report.solvers import IMPLICIT, METHODS
from eigenmotion.stability.models.smooth import elastic_link

from .measuring import undisturbed

STIFF = {"parameters": {"k": 1e9, "d": 1e5}, "x0": {"q": 0.01}}  # of elastic_link


def point(
    error: float, seconds: float, method: str = "dop853", tolerance: float = 1e-3, nsteps: int = 1
) -> Measurement:
    return Measurement(
        "eigenmotion", "cholesky", method, f"cholesky {method}", tolerance, error, error, seconds=seconds,
        seconds_low=0.99 * seconds, seconds_high=1.01 * seconds, nsteps=nsteps, nfev=10 * nsteps,
    )  # fmt: skip


def test_a_lucky_point_is_not_recommended():
    quick = [point(1e-9, 1.0), point(1e-5, 2.0), point(1e-9, 5.0), point(1e-10, 6.0)]
    slow = [point(1e-9, 4.0, "rk34"), point(1e-10, 7.0, "rk34")]
    advice = recommend(curves([*quick, *slow]), 1e-8)
    assert (advice.chosen.method, advice.chosen.seconds) == ("rk34", 4.0)
    assert advice.as_fast == ()


def test_what_is_as_fast_is_named_once_a_solver():
    advice = recommend(curves([point(1e-9, 1.0), point(1e-9, 1.001, "rk34"), point(1e-9, 1.002, "rk34")]), 1e-8)
    assert [p.seconds for p in advice.as_fast] == [1.001]


def test_an_accuracy_out_of_reach_is_said_to_be():
    advice = recommend(curves([point(1e-5, 1.0), point(1e-6, 2.0)]), 1e-8)
    assert advice.chosen is None
    assert advice.closest.error_max == 1e-6


def test_times_are_interpolated_in_logarithms():
    curve = Curve("", "", "", "", (point(1e-4, 1.0), point(1e-6, 4.0), point(1e-8, 16.0)))
    assert curve.seconds_at(1e-5) == pytest.approx(2.0)
    assert curve.seconds_at(1e-8) == pytest.approx(16.0)
    assert curve.seconds_at(1e-2) == 1.0
    assert curve.seconds_at(1e-9) is None


def test_a_tighter_run_that_is_quicker_counts():
    """Too loose a tolerance costs an explicit method rejected steps, and an implicit one iterations."""
    curve = Curve("", "", "", "", (point(1e-4, 5.0), point(1e-6, 4.0), point(1e-7, 3.0), point(1e-9, 6.0)))
    assert curve.seconds_at(1e-5) == 3.0
    assert curve.seconds_at(1e-8) == pytest.approx(np.sqrt(18.0))
    advice = recommend(curves([replace(p, family="eigenmotion") for p in curve.points]), 1e-5)
    assert advice.chosen.seconds == 3.0


def test_order_and_cost_of_a_made_up_curve():
    points = tuple(replace(point(float(n) ** -5, 1e-4 + 2e-6 * n), nsteps=n) for n in (10, 20, 40, 80))
    points = tuple(replace(p, nfev=10 * p.nsteps) for p in points)
    curve = Curve("", "", "", "", points)
    assert curve.order(1e-16) == pytest.approx(5)
    assert curve.cost() == pytest.approx((1e-4, 2e-7))
    assert replace(curve, points=tuple(replace(p, nsteps=70) for p in points)).order(1e-16) is None


def test_methods_of_one_kind_differ_in_their_lines():
    """Their colour is the same."""
    for methods in (IMPLICIT, METHODS, ("DOP853", "LSODA", "Radau"), ("Adams", "BDF")):
        assert len({dashes(method) for method in methods}) == len(methods)


@pytest.fixture(scope="module")
def stiff() -> Findings:
    """An elastic link of stiffness 1e9 with damping 1e5, in one formulation, without peers."""
    with undisturbed() as patch:
        patch.setattr("eigenmotion.report.formulations.FORMULATIONS", ("lagrange",))
        patch.setattr(importlib.import_module("eigenmotion.report.examine"), "peers", lambda *_: Peers((), ()))
        patch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", (1e-5, 1e-7, 1e-9, 1e-11))
        ask = ReportOptions(error=1e-6, t_end=0.5, tolerances=(1e-6,), settings=STIFF, budget=Budget(rounds=1))
        return examine(elastic_link(), ask, lambda done, what: None)


def test_on_a_stiff_model_an_implicit_method_is_recommended(stiff):
    chosen = stiff.recommendation.chosen
    assert chosen.method in IMPLICIT
    assert chosen.error_max <= 1e-6
    explicit_ = [m for m in stiff.measurements if m.method in METHODS and m.error_end is not None]
    assert explicit_
    assert all(m.seconds > 2 * chosen.seconds and m.nsteps > 20 * chosen.nsteps for m in explicit_)
    words = " ".join(recommendation(stiff))
    assert f"formulation lagrange, method {chosen.method}" in words
    assert "parameters={'k': 1000000000.0, 'd': 100000.0}, x0={'q': 0.01}" in words
    assert re.search(r"Times as long to that error: .*lagrange \d", words)


def test_the_recommended_call_can_be_made(stiff):
    """As it is printed; compiled otherwise, its steps may differ, and so does its error."""
    _, call, *_ = recommendation(stiff)
    names = {"eigenmotion": em, "model": elastic_link()}
    exec(call.replace("; eigenmotion.simulate", "; solution = eigenmotion.simulate"), names)
    error = scaled_error(names["solution"].x[:, -1], stiff.reference.x[-1])
    assert 0.2 < error / stiff.recommendation.chosen.error_end < 5


def test_every_method_has_a_line_style():
    """Without one, a curve is solid, as that of the usual explicit and implicit method is."""
    assert [name for name in (*METHODS, *IMPLICIT) if not dashes(name)] == ["dop853", "radau9"]


@pytest.mark.parametrize("drawn", [False, pytest.param(True, marks=pytest.mark.nightly)])
def test_page_of_a_stiff_model(stiff, drawn, monkeypatch, tmp_path):
    """Its pictures, of which `test_report` has those of another model, at night."""
    pytest.importorskip("matplotlib")
    if not drawn:
        monkeypatch.setattr("eigenmotion.report.output.files.pictures", lambda charts, everything: [])
    write_report([stiff], tmp_path)
    page = (tmp_path / "report.html").read_text()
    assert "Set: k = 1e+09, d = 100000, q = 0.01." in page
    assert "Radau IIA" in page
    (model,) = json.loads((tmp_path / "report.json").read_text())["models"]
    assert model["settings"] == STIFF
    assert model["x_start"] == [0.4, 1.3, 0.01]
