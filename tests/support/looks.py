"""Looks of pages: photographs at two widths, light and dark, and the faults that can be found without eyes."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import product
from pathlib import Path

from .browser import Browser

WIDTHS = (1400, 400)
SCHEMES = ("light", "dark")
LOOKS = tuple(product(WIDTHS, SCHEMES))
_HEIGHTS = {1400: 900, 400: 800}
_HERE = Path(__file__).parent
_FAULTS = (_HERE / "looks.js").read_text(encoding="utf-8")
_BEFORE = (_HERE / "looks_before.js").read_text(encoding="utf-8")


@contextmanager
def critical(browser: Browser) -> Iterator[None]:
    """Have the canvases of pages that are opened keep their text, which `faults` reads."""
    script = browser.call("Page.addScriptToEvaluateOnNewDocument", source=_BEFORE)["identifier"]
    yield
    browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script)


def faults(browser: Browser) -> list[str]:
    """Return what a reader would complain about on the page that is open, each as a sentence."""
    found: list[str] = browser.ask(_FAULTS)
    return found


def look_at(browser: Browser, path: Path, name: str, folder: Path) -> list[str]:
    """Photograph a page into FOLDER/NAME_WIDTH_SCHEME.png in each look; return its faults, with the look."""
    found = []
    for width, scheme in LOOKS:
        browser.errors.clear()
        browser.look(width, _HEIGHTS[width], scheme, motion="reduce")
        browser.visit(path)
        browser.ask(_READY)
        browser.photograph(folder / f"{name}_{width}_{scheme}.png", whole=True)
        found += [f"{width} {scheme}: {fault}" for fault in (*faults(browser), *browser.errors)]
    return found


_READY = """new Promise((done) => {
    for (const one of document.querySelectorAll("[loading=lazy]")) one.loading = "eager"; // below the window, too
    const loaded = document.querySelector("iframe") ? new Promise((then) => setTimeout(then, 700)) : null;
    const frames = (left) => (left ? requestAnimationFrame(() => frames(left - 1)) : done(true));
    const moves = () => !document.querySelector("#stage") || window.eigenmotion?.motion;
    const wait = () => (moves() ? frames(3) : setTimeout(wait, 20));
    Promise.all([document.fonts.ready, loaded]).then(wait); })"""
