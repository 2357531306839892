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
from eigenmotion.webpage.mathml import in_words, label, mathml
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


def test_rates_of_words_are_apart():
    swing, rope = dynamicsymbols("swing rope")
    product = mathml(2 * swing.diff() * rope.diff() * Symbol("m"))
    assert product.count("<mspace width='0.1667em'/>") == 3  # around each rate
    assert "<mspace" not in mathml(2 * dynamicsymbols("q").diff() * dynamicsymbols("r").diff())


def test_names_of_several_words_stay_as_they_are():
    assert in_words("contact_force") == "<math><mtext>contact_force</mtext></math>"
    for name in ("tension", "x_tip", "theta_max"):
        assert in_words(name) == label(Symbol(name))


def multiplier_of(name: str) -> str:
    return f"<math><msub><mi>λ</mi><mtext>{name}</mtext></msub></math>"


def in_space() -> em.Model:
    """A point on a floor, with friction in both directions."""
    x, y, z = dynamicsymbols("x y z")
    return em.Model(
        name="puck", coordinates=[x, y, z], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=10 * z, initial={x.diff(): 1.0},
        contacts={"floor": em.Contact(z), "slip": em.Friction([x.diff(), y.diff()], limit=0.3, normal="floor")},
    )  # fmt: skip


def test_multipliers_have_the_names_of_rows_and_contacts():
    told = about(em.load_model(MODELS / "gripper.py"), Run(), True)
    assert [one["name"] for one in told["multipliers"]] == [
        f"{side}[{k}]" for side in ("left", "right") for k in range(3)
    ]
    assert [one["name"] for one in told["outputs"]] == ["gap", "rod"]
    told = about(em.load_model(MODELS / "pendulum_with_stop.py"), Run(), True)
    assert told["multipliers"] == [{"name": "wall", "label": multiplier_of("wall")}]
    told = about(em.load_model(MODELS / "four_bar.py"), Run(), True)
    assert [one["label"] for one in told["multipliers"]] == [multiplier_of("0"), multiplier_of("1")]
    told = about(in_space(), Run(), True)
    assert [one["name"] for one in told["multipliers"]] == ["floor", "slip[0]", "slip[1]"]


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
