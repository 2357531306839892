"""Figures: colours that are distinct for any colour vision, axes, files. Needs the extra `plot` (matplotlib)."""

import io
import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import scipy
from numpy.typing import NDArray

from ..codegen.model import ModelError
from ..files import write

# Okabe & Ito's palette without its yellow, which is too faint on white.
COLOURS = BLUE, VERMILION, GREEN, PURPLE, SKY, ORANGE, BLACK = (
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000",
)  # fmt: skip
STYLES = ("-", "--", ":", "-.")
FORMULATIONS = {"eigenfactor": BLUE, "cholesky": VERMILION, "lagrange": GREEN, "inverse": PURPLE}
FORMATS = (".png", ".svg", ".pdf")
_LETTERS = 11.5  # on an inch of an axis


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure in both formats. `stem` is the name of its files; `title` and `text` are for the page."""

    stem: str
    title: str
    text: str
    svg: str
    png: bytes


def has_matplotlib() -> bool:
    """Return whether matplotlib is installed."""
    return find_spec("matplotlib") is not None


def require_matplotlib() -> None:
    """Raise ModelError if matplotlib is missing."""
    if not has_matplotlib():
        raise ModelError("pictures need matplotlib: pip install 'eigenmotion[plot]'")


def blank(width: float, height: float) -> Any:
    """Return a figure [inch] without axes."""
    require_matplotlib()
    from matplotlib.figure import Figure  # noqa: PLC0415, an optional package

    return Figure(figsize=(width, height), layout="constrained")


def uncluttered(axes: Any, grid: str = "0.9", **look: Any) -> None:
    """Draw a faint grid, and no frame at the top and right."""
    axes.grid(color=grid, **look)
    axes.spines[["top", "right"]].set_visible(False)


def spread_labels(ends: Sequence[float] | NDArray[np.float64], gap: float) -> NDArray[np.float64]:
    """Return the positions (k,) within [0, 1] nearest to `ends` that keep their order and are at least `gap` apart."""
    targets = np.asarray(ends, dtype=np.float64)
    order = np.argsort(targets, kind="stable")
    steps = gap * np.arange(len(targets))
    places = np.empty_like(targets)
    places[order] = np.clip(scipy.optimize.isotonic_regression(targets[order] - steps).x, 0.0, 1.0 - steps[-1]) + steps
    return places


def folded(text: str, length: float) -> str:
    """Return the label of an axis of some length [inch] in lines that fit it; a formula stays whole."""
    if len(text) <= _LETTERS * length:
        return text
    if "$" in text:
        return text.replace(" [", "\n[")
    return textwrap.fill(text, int(_LETTERS * length), break_long_words=False, break_on_hyphens=False)


def plain_text(name: str) -> str:
    """Return a name escaped so that matplotlib does not parse parts of it as mathematics."""
    return name.replace("$", r"\$")


def readable(svg: str) -> str:
    """Return SVG without control characters, which are not valid XML but which matplotlib writes from names."""
    return re.sub("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]", "\ufffd", svg)


def save(figure: Any, path: Path) -> Path:
    """Write a figure atomically, in the format (one of FORMATS) of the ending of `path`."""
    content = io.BytesIO()
    figure.savefig(content, format=path.suffix[1:], dpi=150)
    data = content.getvalue()
    write(path, readable(data.decode()).encode() if path.suffix == ".svg" else data)
    return path


def picture(figure: Any, stem: str, title: str, text: str) -> Picture:
    """Return a figure as a picture for a page."""
    import matplotlib as mpl  # noqa: PLC0415, an optional package

    svg, png = io.StringIO(), io.BytesIO()
    # unique names of clip paths, since several pictures are on one page
    with mpl.rc_context({"svg.hashsalt": stem, "svg.fonttype": "path", "hatch.linewidth": 0.6}):
        figure.savefig(svg, format="svg", metadata={"Date": None, "Creator": None})
        figure.set_layout_engine("none")  # the layout is known now; it takes half the time of a picture
        figure.savefig(png, format="png", dpi=150)
    drawn = readable(svg.getvalue())
    return Picture(stem, title, text, drawn[drawn.index("<svg") :], png.getvalue())
