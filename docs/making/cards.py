"""Draw the cards of the gallery, docs/_static/cards: a mechanism at the end of a motion, with faint earlier positions.

A mechanism without a drawing shows its coordinates over time. They are kept in the repository, since robots take
minutes to build.

python docs/making/cards.py             # of models without a card
python docs/making/cards.py four_bar    # again
"""

import io
import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from PIL import Image, ImageChops, ImageOps

import eigenmotion as em
from eigenmotion.results.pictures.moving_shapes import Drawing
from eigenmotion.results.pictures.sketch import Sketch

ROOT = Path(__file__).parents[2]
CARDS = ROOT / "docs" / "_static" / "cards"
SIZE = 480, 360
"""Pixels of a card: twice what a page shows."""
MARGIN = 24
SPAN, ROWS, GHOSTS = 2.0, 120, 4


def names() -> list[str]:
    """Return the models of the gallery."""
    return sorted(path.stem for path in (ROOT / "models").glob("*.py") if path.stem != "__init__")


def card(name: str) -> None:
    """Draw models/NAME.py."""
    system = em.build(ROOT / "models" / f"{name}.py")
    solution = system.simulate((0.0, SPAN), rtol=1e-6, atol=1e-9, t_eval=np.linspace(0.0, SPAN, ROWS))
    figure = Figure(figsize=(SIZE[0] / 100, SIZE[1] / 100), dpi=300, layout="constrained")
    if solution.drawing is None:
        _curves(figure, solution)
    else:
        _mechanism(figure, solution.drawing)
    CARDS.mkdir(parents=True, exist_ok=True)
    _save(figure, CARDS / f"{name}.webp")


def _mechanism(figure: Figure, drawing: Drawing) -> None:
    sketch = Sketch(figure, 111, drawing)
    last = len(drawing.t) - 1
    sketch.ghosts(np.linspace(last // 2, last, GHOSTS + 1, dtype=int)[:-1])
    sketch.show(last)
    sketch.axes.set_axis_off()


def _curves(figure: Figure, solution: em.Solution) -> None:
    axes = figure.add_subplot()
    axes.plot(solution.t, (solution.x / np.abs(solution.x).max(axis=1, keepdims=True)).T, linewidth=2.5)
    axes.spines[["top", "right"]].set_visible(False)
    axes.set(xticks=[], yticks=[], xlabel="t", ylabel="x")


def _save(figure: Figure, path: Path) -> None:
    """Write a picture without its white margins, on a card of a common size with a narrow one."""
    drawn = io.BytesIO()
    figure.savefig(drawn)
    picture = Image.open(drawn).convert("RGB")
    inked = ImageChops.difference(picture, Image.new("RGB", picture.size, "white")).getbbox()
    picture = ImageOps.contain(picture.crop(inked), (SIZE[0] - MARGIN, SIZE[1] - MARGIN), Image.Resampling.LANCZOS)
    plate = Image.new("RGB", SIZE, "white")
    plate.paste(picture, ((SIZE[0] - picture.width) // 2, (SIZE[1] - picture.height) // 2))
    plate.save(path, quality=80, method=6)


if __name__ == "__main__":
    for model in sys.argv[1:] or [name for name in names() if not (CARDS / f"{name}.webp").is_file()]:
        card(model)
