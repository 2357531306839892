"""Every link within a built site leads somewhere, cards and frames included: pages, pictures, and places in pages.

python docs/making/links.py build/site
"""

import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Links(HTMLParser):
    """What a page links to, and the places in it that others can link to."""

    def __init__(self) -> None:
        super().__init__()
        self.targets: set[str] = set()
        self.places: set[str] = set()

    def handle_starttag(self, _: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note an element."""
        for name, value in attrs:
            if name in ("href", "src") and value:
                self.targets.add(value)
            elif name == "id" and value:
                self.places.add(value)


@cache
def read(page: Path) -> Links:
    """Return the links of a page."""
    links = Links()
    links.feed(page.read_text(encoding="utf-8"))
    return links


def broken(page: Path) -> list[str]:
    """Return the links of a page that lead nowhere in the site."""
    found = []
    for target in sorted(read(page).targets):
        parts = urlsplit(target)
        if parts.scheme or parts.netloc:
            continue
        file = page if not parts.path else (page.parent / unquote(parts.path)).resolve()
        there = file.is_file() and (
            not parts.fragment or file.suffix != ".html" or unquote(parts.fragment) in read(file).places
        )
        if not there:
            found.append(f"{page}: {target}")
    return found


if __name__ == "__main__":
    site = Path(sys.argv[1]).resolve()
    pages = [page for page in site.rglob("*.html") if "_static" not in page.parts]
    lost = [link for page in pages for link in broken(page)]
    print(*lost, f"{len(pages)} pages, {len(lost)} links that lead nowhere", sep="\n")
    sys.exit(bool(lost))
