"""Quantities on a page: outputs and multipliers, over the time or over one of them, and limits of sliders."""

import re
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import draw, multiplier
from eigenmotion.building.request import request
from eigenmotion.webpage.page import Place, Run, page

from ..support.browser import Browser, opened_page

theta, r = dynamicsymbols("theta r")
m, l, g = symbols("m l g", positive=True)
T_END = 2.0
DOCS = Path(__file__).parents[2] / "docs" / "pages.md"


def rod() -> em.Model:
    """A pendulum that turns over; its length is a coordinate, with the tension as an output."""
    return em.Model(
        name="rod_of_a_page", coordinates=[theta, r], kinetic_energy=m * (r.diff() ** 2 + r**2 * theta.diff() ** 2) / 2,
        potential_energy=-m * g * r * cos(theta), holonomic_constraints={"rod": [r - l]},
        parameters={m: 1.0, l: 0.01, g: 9.81}, initial={theta: 0.5, r: 0.01, theta.diff(): 80.0},
        outputs={"tension": multiplier("rod")}, drawing=[draw.Line((0, 0), (r * sin(theta), -r * cos(theta)))],
        units={"theta": "rad", "r": "m", "tension": "N", "m": "kg", "l": "m", "g": "m/s^2"},
    )  # fmt: skip


@pytest.fixture(scope="module")
def browser(tmp_path_factory) -> Iterator[Browser]:
    with opened_page(rod(), tmp_path_factory.mktemp("quantities") / "rod.html", T_END) as opened:
        yield opened
        assert not opened.errors


def captions(browser: Browser) -> list[str]:
    return browser.ask("[...document.querySelectorAll('#plots figcaption')].map((one) => one.textContent)")


def choose(browser: Browser, which: str) -> None:
    """Choose what the plots are over, by the beginning of its text."""
    browser.ask(f"""(() => {{ const select = document.querySelector("#abscissa");
        select.value = [...select.options].find((one) => one.text.startsWith("{which}")).value;
        select.dispatchEvent(new Event("change")); }})()""")


def test_the_output_is_that_of_a_native_run(browser):
    native = em.build(rod(), flags="-O0").simulate((0, T_END), rtol=1e-9, atol=1e-9)
    places = browser.ask("eigenmotion.motion.places")
    end = np.array(browser.ask("Array.from(eigenmotion.motion.table.slice(-eigenmotion.motion.width))"))
    force = 1e-2 * native.v[0, -1] ** 2 + 9.81 * np.cos(native.x[0, -1])  # m l theta'^2 + m g cos(theta), by hand
    assert end[places["outputs"]] == pytest.approx(force, rel=1e-6)
    assert end[places["lambda"]] == pytest.approx(end[places["outputs"]], rel=1e-12)


def test_each_unit_has_its_axes_and_the_row_its_name(browser):
    found = captions(browser)
    assert found == ["coordinates [rad]\u03b8", "coordinates [m]r", "outputs [N]tension", "multipliers\u03bbrod"]
    assert browser.ask("document.querySelector('#checks').open") is False
    assert browser.ask("document.querySelectorAll('#checks figure').length") == 2  # energy and constraints


def test_names_beside_sliders_are_not_cut(browser):
    fits = """(() => { const names = [...document.querySelectorAll(".control .name")], short = names[0].innerHTML;
        names[0].textContent = "shoulder_pan";
        const cut = names[0].scrollWidth > names[0].clientWidth;
        document.querySelector("#initial").parentElement.dispatchEvent(new Event("toggle"));
        const found = [cut, names.every((name) => name.scrollWidth <= name.clientWidth), names[0].title];
        names[0].innerHTML = short;
        return found; })()"""
    assert browser.ask(fits) == [True, True, "theta"]


def test_plots_are_over_a_coordinate(browser):
    choose(browser, "\u03b8")
    drawn = "((plot) => [plot.abscissa.text, Array.from(plot.places), plot.across])(eigenmotion.plots[2])"
    text, places, across = browser.ask(drawn)
    theta = browser.ask("Array.from(eigenmotion.motion.column(1))")
    assert text == "\u03b8 [rad]"
    assert places == theta
    assert across[0] < min(theta) < max(theta) < across[1]
    assert browser.ask("eigenmotion.plots.at(-1).abscissa.text") == "t [s]"  # residuals stay over the time
    middle = len(theta) // 2
    assert browser.ask(f"eigenmotion.plots[2].timeAt({theta[middle]})") == pytest.approx(T_END / 2, abs=0.05)
    choose(browser, "time")
    assert browser.ask("eigenmotion.plots[2].abscissa.text") == "t [s]"


def test_limits_of_a_slider_can_be_changed(browser):
    change = """((end, value) => { const field = document.querySelectorAll('[data-limit="g"]')[end];
        field.value = value; field.dispatchEvent(new Event("change"));
        const slider = document.querySelector('input[type=range][data-name="g"]');
        return [+slider.min, +slider.max, +slider.value, +field.value]; })"""
    assert browser.ask(f"{change}(1, 40)") == pytest.approx([0.981, 40, 9.81, 40])
    assert browser.ask(f"{change}(1, 5)") == pytest.approx([0.981, 5, 5, 5])  # the value moves with it
    assert browser.ask(f"{change}(0, 7)") == pytest.approx([0.981, 5, 5, 0.981])  # above the other limit: undone
    browser.ask("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    assert browser.ask("eigenmotion.engine.parameters[2]") == 5
    browser.ask("document.querySelector('#reset').click()")
    assert browser.ask(f"{change}(1, 50)") == pytest.approx([0.981, 50, 9.81, 50])


def settled_height(browser: Browser) -> float:
    """Return the height that the frame has got, when it stays."""
    seen: list[float | None] = []
    for _ in range(60):
        seen.append(browser.ask("parseFloat(document.getElementById('linkage')?.style.height)"))
        if seen[-1] is not None and seen[-3:] == [seen[-1]] * 3:
            return seen[-1]
        time.sleep(0.3)
    raise AssertionError(f"the height of the frame does not settle: {seen}")


def test_a_page_in_a_frame_reports_its_height_and_leads_home(browser, tmp_path):
    place = Place(embed=True, home="https://example.org/docs?a=1&b=2")
    text = page(request(rod()), "", Run(T_END), None, place)
    (tmp_path / "inner.html").write_text(text, encoding="utf-8")
    host = re.search("```html\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)[1]
    host = host.replace("four_bar.html", "inner.html").replace("width: 100%", "width: 600px")
    (tmp_path / "host.html").write_text(host, encoding="utf-8")
    browser.visit(tmp_path / "host.html")
    height = settled_height(browser)
    assert height > 375  # the mechanism is 5 high for 8 of width, and the folded parts are below it
    browser.ask("document.getElementById('linkage').style.width = '1000px'")
    assert settled_height(browser) - height == pytest.approx(400 * 5 / 8, abs=2)
    assert "<header>" not in text
    assert 'href="https://example.org/docs?a=1&amp;b=2"' in text
    assert "<h2>Equations" not in text
