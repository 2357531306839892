"""The site: every how-to is in one group, every page has a place, and every model of the gallery has a picture."""

import re
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
GROUPS = ("State a mechanism", "Run it", "Understand it", "Design with it", "Embed it")
MODELS = sorted(path.stem for path in (ROOT / "models").glob("*.py") if path.stem != "__init__")


def navigation() -> dict[str, list[str]]:
    """Return the pages of docs/index.md by the caption above them."""
    text = (DOCS / "index.md").read_text(encoding="utf-8")
    trees = re.findall(r"```\{toctree\}\n(.*?)```", text, re.DOTALL)
    captions = [re.search(r":caption: (.*)", tree) for tree in trees]
    return {
        caption[1] if caption else "": re.findall(r"^\w[\w/]*$", tree, re.MULTILINE)
        for caption, tree in zip(captions, trees, strict=True)
    }


def landing() -> dict[str, list[str]]:
    """Return the pages that docs/howto.md leads to, by heading."""
    parts = re.split(r"^## (.*)\n", (DOCS / "howto.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
    return {
        heading: re.findall(r"^- \[.*?\]\((\w+)\.md\)", text, re.MULTILINE)
        for heading, text in zip(parts[1::2], parts[2::2], strict=True)
    }


def test_how_tos_are_grouped_alike_in_the_navigation_and_on_their_page():
    assert tuple(landing()) == GROUPS
    assert landing() == {group: navigation()[group] for group in GROUPS}


def test_each_page_has_one_place_in_the_navigation():
    placed = Counter(page for pages in navigation().values() for page in pages)
    elsewhere = {"index", "flips"}  # the gallery has the second
    assert placed == Counter({page.stem for page in DOCS.glob("*.md")} - elsewhere | {"gallery/index"})


def test_the_titles_of_how_tos_are_those_of_their_pages():
    said = dict(re.findall(r"^- \[(.*?)\]\((\w+)\.md\)", (DOCS / "howto.md").read_text(encoding="utf-8"), re.MULTILINE))
    assert {page: title for title, page in said.items()} == {
        page: re.search(r"^# (.*)$", (DOCS / f"{page}.md").read_text(encoding="utf-8"), re.MULTILINE)[1]
        for page in said.values()
    }


@pytest.mark.parametrize("name", MODELS)
def test_every_card_of_the_gallery_has_a_picture(name):
    picture = (DOCS / "_static" / "cards" / f"{name}.webp").read_bytes()
    assert picture[:4] + picture[8:12] == b"RIFFWEBP"


def test_every_picture_is_of_a_model():
    assert {path.stem for path in (DOCS / "_static" / "cards").iterdir()} == set(MODELS)
