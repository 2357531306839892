"""Faults of matplotlib figures at a width of 700 pixels: small type, texts that overlap or are cut off."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import combinations
from typing import Any
from unittest import mock

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

PIXELS = 700  # width of a column of text
LEAST = 9.5  # [pixel] of type there
ROOM = 1.5  # [pixel] of an overlap that nobody sees


@contextmanager
def _drawn() -> Iterator[list[Text]]:
    """Gather the texts that are drawn: axes have others, of ticks that are out of sight."""
    texts: list[Text] = []
    draw = Text.draw

    def noted(text: Text, renderer: Any) -> None:
        if text.get_visible() and text.get_text().strip():
            texts.append(text)
        draw(text, renderer)

    with mock.patch.object(Text, "draw", noted):
        yield texts


def figure_faults(figure: Any) -> list[str]:
    """Return what a reader would complain about, each as a sentence."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()  # of a layout that is found while it is drawn
    figure.set_layout_engine("none")
    with _drawn() as texts:
        canvas.draw()
    scale = PIXELS / figure.bbox.width
    boxes = [(text.get_text(), text.get_window_extent(canvas.get_renderer())) for text in dict.fromkeys(texts)]
    found = [
        f"small: {text.get_text()!r}, {size:.1f} pixels"
        for text in texts
        if (size := text.get_fontsize() * figure.dpi / 72 * scale) < LEAST
    ]
    found += [
        f"cut off: {text!r}"
        for text, box in boxes
        if box.x0 < -1 or box.y0 < -1 or box.x1 > figure.bbox.width + 1 or box.y1 > figure.bbox.height + 1
    ]
    for (one, a), (two, b) in combinations(boxes, 2):
        across, down = min(a.x1, b.x1) - max(a.x0, b.x0), min(a.y1, b.y1) - max(a.y0, b.y0)
        if scale * across > ROOM and scale * down > ROOM:
            found.append(f"overlap: {one!r} and {two!r}")
    return found
