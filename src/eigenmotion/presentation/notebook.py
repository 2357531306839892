"""HTML for the display of objects in notebooks: tables and pictures."""

import base64
import io
from collections.abc import Iterable, Mapping
from html import escape
from typing import Any


def table(title: str, rows: Mapping[str, str | Iterable[str]]) -> str:
    """Return a small table as HTML; several texts in a row are on separate lines."""
    cells = "".join(
        f"<tr><th style='text-align:left;vertical-align:top'>{escape(name)}</th>"
        f"<td style='text-align:left'>{_lines(text)}</td></tr>"
        for name, text in rows.items()
    )
    return f"<div><strong>{escape(title)}</strong><table>{cells}</table></div>"


def _lines(text: str | Iterable[str]) -> str:
    return "<br>".join(map(escape, [text] if isinstance(text, str) else text))


def image(figure: Any, words: str) -> str:
    """Return a matplotlib figure as HTML, with `words` as alternative text."""
    png = io.BytesIO()
    figure.savefig(png, format="png", dpi=80)
    data = base64.b64encode(png.getvalue()).decode()
    return f"<img alt='{escape(words, quote=True)}' src='data:image/png;base64,{data}'>"
