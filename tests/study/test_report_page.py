"""The page of a report in Chromium: charts, the panel of a run, the switch, without JavaScript, on a phone."""

import json
import time
from contextlib import suppress
from itertools import combinations

import pytest

from eigenmotion.presentation.text import number, seconds
from eigenmotion.report.output import write_report

from .made_up import ALL, OURS, findings

UNITS = (("theta", "rad"), ("r", "mm"), ("k", "N/mm"), ("energy", "mJ"), ("time", "ms"))
REPORTS = (
    findings(units=UNITS),
    findings(seed=3, name="crowded", spread=1.2),
    findings(seed=5, name="a_mechanism_whose_name_is_of_some_length_indeed", solvers=OURS[:1]),
    findings(seed=7, name="out_of_reach", error=1e-30),
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("report")
    with pytest.MonkeyPatch.context() as patch:  # of pictures, test_report_charts
        patch.setattr("eigenmotion.report.output.files.pictures", lambda charts, everything: [])
        write_report(REPORTS, place)
    return place


@pytest.fixture
def opened(folder, browser):
    """Open the page at a width; at the end nothing was asked of a network, and nothing complained."""
    browser.errors.clear()
    browser.requests.clear()

    def go(width, scheme="light"):
        browser.look(width, 900, scheme)
        browser.visit(folder / "report.html")
        return browser

    yield go
    assert not browser.errors
    assert all(url.startswith("file:") for url in browser.requests)


def test_the_advice_is_first_and_units_are_named(folder):
    text = (folder / "report.html").read_text()
    chosen = REPORTS[0].recommendation.chosen
    first = text.index(f"formulation {chosen.formulation}, method {chosen.method}, rtol = atol = ")
    assert first < text.index("<h2")
    assert "theta [rad], r [mm]" in text
    assert "t = 0 ... 10 ms" in text
    assert "k = 2 N/mm, theta&#39; = 1 rad/ms" in text
    assert "energy (62) [mJ·ms]" in text


VISIBLE = "[...document.querySelectorAll('svg.chart')].filter((svg) => svg.getBoundingClientRect().height > 0)"
TEXTS = f"""{VISIBLE}.map((svg) => [[0, 0, +svg.viewBox.baseVal.width, +svg.viewBox.baseVal.height],
    [...svg.querySelectorAll("text")].map((text) => {{ const b = text.getBBox();
        return [text.textContent, text.className.baseVal, [b.x, b.y, b.x + b.width, b.y + b.height]]; }}),
    +svg.getAttribute("font-size") * svg.getScreenCTM().a])"""


def apart(a, b):
    """Whether two rectangles overlap by no more than the empty part of a line of type."""
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] + 2 or b[3] <= a[1] + 2


@pytest.mark.parametrize("everything", [False, True])
@pytest.mark.parametrize("width", [1400, 700, 400])
def test_what_is_written_in_a_chart_is_legible(opened, width, everything):
    browser = opened(width)
    if everything:
        browser.ask("document.querySelectorAll('.all').forEach((box) => box.click())")
    charts = browser.ask(TEXTS)
    assert len(charts) == 2 * len(REPORTS)
    for whole, texts, size in charts:
        assert size >= 11.5  # pixels
        for text, _, box in texts:
            assert box[0] >= 0, text
            assert box[1] >= 0, text
            assert box[2] <= whole[2], text
            assert box[3] <= whole[3], text
        for (one, _, a), (two, _, b) in combinations(texts, 2):
            assert apart(a, b), f"{one!r} and {two!r} overlap"
    labels = [text for text, kind, _ in charts[0][1] if kind == "label"]
    assert len(labels) == (len(ALL) if everything else 8)


@pytest.mark.parametrize("width", [1400, 700, 400])
def test_the_page_is_no_wider_than_the_window(opened, width):
    assert opened(width).ask("document.documentElement.scrollWidth") <= width


def shown(browser):
    """The heading and the numbers in the panel of the first chart."""
    return browser.ask("""(() => { const panel = document.querySelector(".panel");
        return [panel.querySelector("strong").textContent,
        Object.fromEntries([...panel.querySelectorAll("dd")].map((dd) => [dd.dataset.name, dd.textContent]))]; })()""")


def expected(m):
    return {
        "method": m["method"], "formulation": m["formulation"], "tolerance": number(m["tolerance"]),
        "largest error": number(m["error_max"]), "error at the end": number(m["error_end"]),
        "run time": seconds(m["seconds"]), "quartiles": f"{seconds(m['seconds_low'])} ... {seconds(m['seconds_high'])}",
        "steps": f"{m['nsteps']:,}, {m['nrejected']:,} rejected", "right-hand sides": f"{m['nfev']:,}",
    }  # fmt: skip


def test_the_recommended_run_is_shown_at_first(opened, folder):
    model = json.loads((folder / "report.json").read_text())["models"][0]
    chosen = model["recommendation"]["chosen"]
    heading, numbers = shown(opened(1400))
    assert heading == f"{chosen['label']}, recommended"
    assert numbers == expected(chosen)


@pytest.mark.parametrize("width", [1400, 400])
def test_pointing_at_a_run_shows_the_numbers_of_the_json(opened, folder, width):
    """Every drawn run of the few curves, at its own place, with a mouse and with a finger."""
    measured = json.loads((folder / "report.json").read_text())["models"][0]["measurements"]
    browser = opened(width)
    browser.ask(f"({VISIBLE})[0].scrollIntoView()")
    places = browser.ask(f"""[...({VISIBLE})[0].querySelectorAll(".point")].map((point) => {{
        const b = point.getBoundingClientRect();
        return [+point.dataset.run, b.x + b.width / 2, b.y + b.height / 2]; }})""")
    assert len(places) == 8 * 10
    for k, (run, x, y) in enumerate(places[::7]):
        if k % 2:
            browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        else:
            browser.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
            browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        heading, numbers = shown(browser)
        assert heading.partition(",")[0] == measured[run]["label"]
        assert numbers == expected(measured[run])
    assert browser.ask(f"({VISIBLE})[0].querySelectorAll('.near').length") == 1


def test_keys_lead_from_run_to_run(opened):
    browser = opened(1400)
    browser.ask(f"({VISIBLE})[0].focus()")
    tolerance = lambda: (shown(browser)[0].partition(",")[0], float(shown(browser)[1]["tolerance"]))  # noqa: E731
    name, first = tolerance()
    for key, factor in (("ArrowRight", 0.1), ("ArrowLeft", 1.0), ("ArrowLeft", 10.0)):
        browser.call("Input.dispatchKeyEvent", type="keyDown", key=key)
        assert tolerance() == (name, pytest.approx(factor * first))
    seen = set()
    for _ in range(8):
        browser.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowDown")
        seen.add(tolerance()[0])
    assert len(seen) == 8


LUMINANCE = """(() => { const channels = (text) => text.match(/[\\d.]+/g).slice(0, 3).map((c) => { const x = c / 255;
    return x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4; });
  const light = (text) => { const [r, g, b] = channels(text);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const ground = light(getComputedStyle(document.body).backgroundColor);
  const ratio = (text) => { const own = light(text);
    return (Math.max(own, ground) + 0.05) / (Math.min(own, ground) + 0.05); };
  const style = (selector, name) => [...document.querySelectorAll(selector)].map((one) =>
    ratio(getComputedStyle(one)[name]));
  return [Math.min(...style("svg.chart text", "fill"), ...style("p, dt, dd, td, h1, h2, h3", "color")),
          Math.min(...style(".line", "stroke"))]; })()"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_contrast_of_text_and_curves(opened, scheme):
    """WCAG's 4.5 for text. The palette's orange and sky have 2.2 on white, but labels name the curves."""
    text, line = opened(1400, scheme).ask(LUMINANCE)
    assert text >= 4.5
    assert line >= (2.0 if scheme == "light" else 4.0)


def when_there(browser):
    """The document, once it is loaded to its end; there is no script to wait in, and nodes go with the page before."""
    for _ in range(200):
        nodes = browser.call("DOM.getDocument", depth=1)["root"]["nodeId"]
        with suppress(RuntimeError):
            if browser.call("DOM.querySelectorAll", nodeId=nodes, selector="body > ul li")["nodeIds"]:
                return nodes
        time.sleep(0.05)
    raise AssertionError("the page does not load")


def test_without_javascript_the_numbers_are_there(folder, browser):
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    try:
        browser.look(1400, 900)
        browser.call("Page.navigate", url="about:blank")
        browser.call("Page.navigate", url=(folder / "report.html").as_uri())
        nodes = when_there(browser)
        query = lambda selector: browser.call("DOM.querySelectorAll", nodeId=nodes, selector=selector)["nodeIds"]  # noqa: E731
        assert len(query("details table")) == 5 * len(REPORTS)
        (number_of_first,) = query("section:first-of-type details:nth-of-type(4) tbody tr:last-child")
        words = browser.call("DOM.getOuterHTML", nodeId=number_of_first)["outerHTML"]
        assert number(REPORTS[0].measurements[-1].error_max) in words
        first = browser.call("DOM.querySelector", nodeId=nodes, selector="svg.wide.few")["nodeId"]
        assert browser.call("DOM.getBoxModel", nodeId=first)["model"]["height"] > 300
    finally:
        browser.call("Emulation.setScriptExecutionDisabled", value=False)
