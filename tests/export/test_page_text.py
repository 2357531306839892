"""The text of a page about a model, before any browser sees it."""

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
from sympy import Piecewise, Symbol, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.cli import main
from eigenmotion.webpage.faces import around
from eigenmotion.webpage.mathml import label, mathml
from eigenmotion.webpage.page import Run, about, summary

MODELS = Path(__file__).parents[2] / "models"


def test_faces_of_a_box():
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-2, 2) for z in (-3, 3)], dtype=float)
    found = around(corners)
    assert sorted(map(len, found)) == [4] * 6
    for face in found:
        ring = corners[[*face, face[0]]]
        assert all(np.count_nonzero(a != b) == 1 for a, b in pairwise(ring))  # edges, no diagonals


def test_any_name_is_a_text_on_the_page():
    angle = dynamicsymbols("a<b>")
    for symbol in (Symbol("<script>"), Symbol("k_<i>"), angle, angle.diff()):
        assert not re.search("<(?:script|i|b)>", label(symbol))
        assert "&lt;" in label(symbol)
    assert label(dynamicsymbols("theta1").diff()) == (
        "<math><msub><mover><mi>&#952;</mi><mo>&#183;</mo></mover><mi>1</mi></msub></math>"
    )


def test_equations_are_spaced_as_latex_does():
    theta, (g, mass) = dynamicsymbols("theta"), symbols("g mass")
    thin, times = "<mspace width='0.1667em'/>", "<mo>&#x2062;</mo>"
    text = mathml(-g * sin(theta))
    assert text.startswith(f"<mrow><mo>&#x2212;</mo><mi>g</mi>{times}{thin}<mrow><mi>sin</mi>")
    assert f"<mi>g</mi>{times}{thin}<mi>mass</mi>" in mathml(g * mass)
    assert "<msup><mi>sin</mi><mn>2</mn></msup><mrow><mo>(</mo>" in mathml(sin(theta) ** 2)
    assert thin not in mathml(g * Symbol("m"))
    cases = mathml(Piecewise((g, g < 1), (0, True)))
    assert "<mo>&lt;</mo>" in cases
    assert "<mtext>otherwise</mtext>" in cases


def test_multipliers_have_the_names_of_rows_and_contacts():
    told = about(em.load_model(MODELS / "gripper.py"), Run(), True)
    assert [one["name"] for one in told["multipliers"]] == [
        f"{side}[{k}]" for side in ("left", "right") for k in range(3)
    ]
    assert [one["name"] for one in told["outputs"]] == ["gap", "rod"]
    told = about(em.load_model(MODELS / "pendulum_with_stop.py"), Run(), True)
    assert told["multipliers"] == [{"name": "wall", "label": "λ<sub>wall</sub>"}]
    told = about(em.load_model(MODELS / "four_bar.py"), Run(), True)
    assert [one["label"] for one in told["multipliers"]] == ["λ<sub>0</sub>", "λ<sub>1</sub>"]


def test_sliders_begin_where_they_are_told_to():
    given = {"parameters": {"a": 0.2}, "x0": {"q1": 1.5}, "v0": {"q2": -1.0}}
    told = about(em.load_model(MODELS / "four_bar.py"), Run(given=given), True)
    assert told["coordinates"][0]["value"] == 1.5
    assert told["v"][1] == -1.0
    assert {one["name"]: one["value"] for one in told["parameters"]}["a"] == 0.2
    assert main(["page", str(MODELS / "four_bar.py"), "--set", "q9=1"]) == 2


def test_modes_of_contacts_have_no_slider():
    told = about(em.load_model(MODELS / "bouncing_ball.py"), Run(), True)
    assert [one["name"] for one in told["parameters"] if one["mode"]] == ["floor_held", "floor_idle"]


def test_the_summary_is_the_first_line_of_the_docstring():
    assert summary('"""A pendulum: a mass on a rod.\n\nMore."""\n') == "A pendulum: a mass on a rod."
    assert not summary("x = 1\n")
