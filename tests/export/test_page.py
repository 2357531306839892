"""Pages: what is in them, and what they do in a real browser."""

import base64
import gzip
import json
import re
from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion.building.errors import BuildError, CompilerNotFoundError
from eigenmotion.building.request import request
from eigenmotion.webpage import wasm
from eigenmotion.webpage.page import Run, page
from eigenmotion.webpage.page_object import Page
from eigenmotion.webpage.three import three

MODELS = Path(__file__).parents[2] / "models"
KILOBYTES = 250
T_END, RTOL, ATOL = 3.0, 1e-9, 1e-9


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Name of a model -> the file of its page."""
    try:
        wasm.wasm_compiler()
    except BuildError as error:
        pytest.skip(str(error))
    folder = tmp_path_factory.mktemp("pages")

    def written(name, space=None):
        file = folder / f"{name}{'_three' if space else ''}.html"
        if not file.exists():
            source = (MODELS / f"{name}.py").read_text(encoding="utf-8")
            text = page(request(MODELS / f"{name}.py"), source, Run(T_END, RTOL, ATOL), space)
            file.write_text(text, encoding="utf-8")
        return file

    return written


@pytest.fixture
def own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path))
    return tmp_path


@pytest.fixture
def opened(pages, browser):
    """Open the page of a model; at the end nothing was asked of a network, and nothing complained."""
    browser.errors.clear()
    browser.requests.clear()

    def go(name, space=None, **look):
        browser.look(**{"width": 1000, "height": 800} | look)
        browser.open(pages(name, space))
        return browser

    yield go
    assert not browser.errors
    assert not [url for url in browser.requests if not url.startswith(("file:", "data:", "blob:"))]


def set_slider(browser, name, value):
    """Move a slider, and wait until the page has run the model anew."""
    browser.ask(f"""new Promise((done) => {{
        const slider = document.querySelector('input[type=range][data-name="{name}"]');
        slider.value = {value};
        for (const event of ["input", "change"]) slider.dispatchEvent(new Event(event, {{ bubbles: true }}));
        requestAnimationFrame(() => requestAnimationFrame(done)); }})""")


def last_row(browser):
    """t, x, v ... of the last row."""
    return np.array(browser.ask("Array.from(eigenmotion.motion.table.slice(-eigenmotion.motion.width))"))


# -- without a browser


def test_a_page_is_one_small_file(pages):
    text = pages("dual_link").read_text(encoding="utf-8")
    assert len(text.encode()) < 1000 * KILOBYTES
    assert not re.findall(r"(?:src|href)=[\"'](?!data:)", text)
    assert not re.findall(r"https?://(?!www\.w3\.org)", text)


def test_a_page_holds_model_and_module(pages):
    text = pages("dual_link").read_text(encoding="utf-8")
    module = gzip.decompress(base64.b64decode(re.search(r'id="wasm">([^<]*)<', text)[1]))
    assert module.startswith(b"\0asm")
    source = re.search(r'href="data:text/x-python;base64,([^"]*)"', text)[1]
    assert base64.b64decode(source).decode() == (MODELS / "dual_link.py").read_text(encoding="utf-8")
    about = json.loads(re.search(r'id="about">([^<]*)<', text)[1])
    assert [one["name"] for one in about["coordinates"]] == ["theta1", "theta2", "theta3", "theta4"]
    assert all(line in text for line in em.build(MODELS / "dual_link.py", flags="-O0").left_out)


def test_a_compiler_that_is_missing_is_said_with_the_remedy(monkeypatch):
    monkeypatch.setattr(wasm, "_candidates", lambda: iter(()))
    wasm.wasm_compiler.cache_clear()
    with pytest.raises(CompilerNotFoundError, match=r"pip install 'eigenmotion\[page\]'"):
        wasm.wasm_compiler()
    wasm.wasm_compiler.cache_clear()


# -- in Chromium


def test_the_motion_is_that_of_a_native_run(opened):
    browser = opened("dual_link")
    system = em.build(MODELS / "dual_link.py", flags="-O0")
    native = system.simulate((0, T_END), rtol=RTOL, atol=ATOL)
    end = last_row(browser)
    assert end[0] == T_END
    assert end[1:5] == pytest.approx(native.x[:, -1], abs=1e-9)
    assert end[5:9] == pytest.approx(native.v[:, -1], abs=1e-9)
    assert end[9] == pytest.approx(native.jacobi_integral[-1], rel=1e-9)
    assert end[12] == pytest.approx(native.multipliers[0, -1], abs=1e-9)
    assert end[13:] == pytest.approx(native.drawing.numbers[-1], abs=1e-9)


def test_frames_move(opened):
    browser = opened("dual_link")
    pixels = "document.querySelector('#stage').toDataURL()"
    before = browser.ask(f"[eigenmotion.frames, eigenmotion.player.t, {pixels}]")
    browser.ask("new Promise((done) => setTimeout(done, 400))")
    after = browser.ask(f"[eigenmotion.frames, eigenmotion.player.t, {pixels}]")
    assert browser.ask("eigenmotion.player.playing")
    assert after[0] > before[0]
    assert after[1] != before[1]
    assert after[2] != before[2]


def test_a_slider_changes_the_motion_as_the_model_does(opened):
    browser = opened("dual_link")
    before = last_row(browser)
    set_slider(browser, "K1", 2.5)
    after = last_row(browser)
    assert np.abs(after - before).max() > 0.1
    native = em.build(MODELS / "dual_link.py", flags="-O0").simulate(
        (0, T_END), rtol=RTOL, atol=ATOL, parameters={"K1": 2.5}
    )
    assert after[1:5] == pytest.approx(native.x[:, -1], abs=1e-9)
    browser.ask("document.querySelector('#reset').click()")
    assert last_row(browser) == pytest.approx(before, abs=1e-12)


def test_what_a_slider_moves_off_the_loop_is_put_back_on_it(opened):
    browser = opened("four_bar")
    start = np.array(browser.ask("Array.from(eigenmotion.engine.x)"))
    set_slider(browser, "q1", start[0] + 0.4)
    moved = np.array(browser.ask("Array.from(eigenmotion.engine.x)"))
    assert (np.abs(moved - start) > 1e-3).all()
    system = em.build(MODELS / "four_bar.py", flags="-O0")
    asked = start + np.array([0.4, 0.0, 0.0])
    v = np.array(browser.ask("Array.from(eigenmotion.engine.v)"))
    right, _ = system.compiled.project(0.0, asked, system.initial[1], system.prepare(), False)
    assert moved == pytest.approx(right, abs=1e-9)
    A, b = system.pfaffian(moved)
    assert A @ v + b == pytest.approx(np.zeros(2), abs=1e-12)
    assert "put back on the constraints" in browser.ask("document.querySelector('#word').textContent")
    shown = browser.ask("""document.querySelector('input[type=range][data-name="q2"]').value""")
    assert float(shown) == pytest.approx(moved[1])


def told_of(browser, name: str, value: str) -> str:
    """Type a number into the field of a parameter, and read what is said of it."""
    browser.ask(f"""(() => {{ const field = document.querySelector('input[type=number][data-name="{name}"]');
        field.value = {value}; field.dispatchEvent(new Event("change")); }})()""")
    browser.ask("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return str(browser.ask("document.querySelector('#word.failure').textContent"))


def test_failures_are_shown_by_name(opened):
    browser = opened("dual_link")
    words = told_of(browser, "m3", "5e-324")  # positive, and its moment of inertia zero
    assert "singular mass matrix" in words
    assert "coordinate 'theta4'" in words
    assert "Give it inertia" in words
    assert "not declared to have" in told_of(browser, "m3", "0")


def test_a_loop_that_cannot_close_says_so_and_comes_back(opened):
    browser = opened("four_bar")
    before = last_row(browser)
    set_slider(browser, "d", 2.9)
    assert "position not reached" in browser.ask("document.querySelector('#word.failure').textContent")
    set_slider(browser, "d", 1.0)
    assert browser.ask("document.querySelector('#word.failure')") is None
    assert last_row(browser) == pytest.approx(before, abs=1e-7)


def test_keys_and_scrubbing_hold_the_motion(opened):
    browser = opened("dual_link")
    press = "document.body.dispatchEvent(new KeyboardEvent('keydown', {{ key: '{}', bubbles: true }}))"
    assert browser.ask("eigenmotion.player.playing")
    browser.ask(press.format(" "))
    assert not browser.ask("eigenmotion.player.playing")
    browser.ask(press.format("End"))
    assert browser.ask("eigenmotion.player.t") == T_END
    browser.ask(press.format("ArrowLeft"))
    assert browser.ask("eigenmotion.player.t") == pytest.approx(0.99 * T_END)
    browser.ask(
        "(() => { const s = document.querySelector('#scrub'); s.value = 1; s.dispatchEvent(new Event('input')); })()"
    )
    assert browser.ask("eigenmotion.player.t") == pytest.approx(1.0)
    zoom = browser.ask("eigenmotion.stage.view.zoom")
    browser.ask(press.format("+"))
    assert browser.ask("eigenmotion.stage.view.zoom") == pytest.approx(1.25 * zoom)


def test_a_notebook_shows_it_alive(pages, browser, tmp_path):
    file = tmp_path / "notebook.html"
    file.write_text(Page(pages("dual_link").read_text(encoding="utf-8"))._repr_html_(), encoding="utf-8")
    browser.call("Page.navigate", url=file.as_uri())
    assert browser.ask("""new Promise((done) => { const wait = () => {
        const shown = document.querySelector("iframe")?.contentWindow.eigenmotion?.frames;
        if (shown > 3) done(shown); else setTimeout(wait, 20); }; wait(); })""")


def test_who_prefers_less_motion_starts_it_himself(opened):
    browser = opened("dual_link", motion="reduce")
    assert not browser.ask("eigenmotion.player.playing")
    browser.ask("document.querySelector('#play').click()")
    assert browser.ask("eigenmotion.player.playing")


def test_it_fits_on_a_phone_and_follows_dark(opened):
    browser = opened("dual_link", width=390, height=800, scheme="dark")
    assert browser.ask("document.documentElement.scrollWidth") == 390
    assert browser.ask("getComputedStyle(document.body).backgroundColor") == "rgb(18, 24, 31)"


def picture_after(browser, action):
    """What the stage shows when everything of an action has been drawn."""
    browser.ask(action)
    return browser.ask("""new Promise((done) => requestAnimationFrame(() => {
        eigenmotion.stage.draw(); done(document.querySelector("#stage").toDataURL()); }))""")


@pytest.mark.parametrize("by", ["canvas", "three.js"])
def test_space_moves_and_turns(opened, by):
    """By three.js, and by the plain canvas that serves where that is not to be had."""
    try:
        library = three() if by == "three.js" else None
    except BuildError as error:
        pytest.skip(f"three.js is not to be had: {str(error).splitlines()[0]}")
    browser = opened("heavy_top", library)
    assert browser.ask("eigenmotion.stage.constructor.name") == ("SpaceStage" if library else "Stage")
    first = picture_after(browser, "eigenmotion.player.pause(); eigenmotion.player.seek(0.5)")
    assert first == picture_after(browser, "0")
    later = picture_after(browser, "eigenmotion.player.seek(0.6)")
    assert later != first
    assert picture_after(browser, "eigenmotion.stage.dragged(40, 10, false)") != later
    assert picture_after(browser, "eigenmotion.stage.reset()") == later


def test_three_js_is_what_its_hash_says(monkeypatch, own_cache):
    monkeypatch.setattr("eigenmotion.webpage.three._SHA512", "no hash")
    monkeypatch.setattr("eigenmotion.webpage.three.run", lambda _, folder: (folder / "three.tgz").write_bytes(b"else"))
    monkeypatch.setattr("eigenmotion.webpage.three.shutil.which", lambda name: name)
    with pytest.raises(BuildError, match="its hash is another one"):
        three()
    assert not list((own_cache / "three").glob("*/*.txt"))


def test_without_npm_three_js_is_missed_by_name(monkeypatch, own_cache):
    monkeypatch.setattr("eigenmotion.webpage.three.shutil.which", lambda _: None)
    with pytest.raises(BuildError, match=r"npm, which brings three\.js, is not on the PATH"):
        three()
