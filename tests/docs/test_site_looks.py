"""Looks of the site in Chromium: its pages at 1400 and 400 pixels, light and dark. `make docs` has them looked at."""

from pathlib import Path

import pytest

from ..support.looks import critical, look_at

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
DAILY = ("index", "constraints", "gallery/index", "gallery/four_bar")
PAGES = sorted(
    {
        *(
            str(path.relative_to(DOCS).with_suffix(""))
            for path in (*DOCS.glob("*.md"), *DOCS.glob("architecture/*.md"))
        ),
        *(f"gallery/{path.stem}" for path in (ROOT / "models").glob("*.py") if path.stem != "__init__"),
        *DAILY,
    }
)


@pytest.fixture(scope="module")
def site(request):
    """The folder of the site, as it has just been made."""
    if not (folder := request.config.getoption("--site")):
        pytest.skip("the site has its looks tested where it is made: make docs")
    return folder


@pytest.fixture(scope="module")
def critic(site, browser):
    with critical(browser):
        yield browser


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name in DAILY else pytest.mark.nightly) for name in PAGES]
)
def test_a_page_of_the_site(critic, site, tmp_path, request, name):
    folder = request.config.getoption("--screenshots") or tmp_path
    found = look_at(critic, site / f"{name}.html", f"site_{name.replace('/', '_')}", folder)
    assert not found, f"photographs are in {folder}"
