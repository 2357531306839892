"""`{live} NAME`: a page on which a model moves, within a page of the site, where it has been made."""

from html import escape
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

MADE = Path(__file__).parents[1] / "made" / "extra" / "live"
"""Pages by the name of their model: what `make docs` has made."""


class Live(SphinxDirective):
    """A frame with the page, and a link to it; a sentence how to make it where it is missing."""

    required_arguments = 1
    option_spec = {"height": directives.nonnegative_int}  # noqa: RUF012

    def run(self) -> list[nodes.Node]:
        """Return the frame."""
        name = self.arguments[0]
        self.env.note_dependency(str(MADE / f"{name}.html"))
        if not (MADE / f"{name}.html").is_file():
            words = f"This build of the site has no live page of it; eigenmotion page models/{name}.py makes one."
            return [nodes.paragraph(words, words)]
        address = "../" * self.env.docname.count("/") + f"live/{name}.html"
        height = self.options.get("height", 900)
        title = escape(name.replace("_", " "))
        frame = (
            f'<iframe class="live" src="{address}" title="{title}, moving" height="{height}" loading="lazy"></iframe>'
            f'<p class="live-link"><a href="{address}">Open it on a page of its own</a></p>'
        )
        return [nodes.raw("", frame, format="html")]


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("live", Live)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
