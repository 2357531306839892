"""Animation of a run; needs the extra `plot` (matplotlib), for .mp4 also ffmpeg."""

import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from ...codegen.model import ModelError
from ...codegen.model.normalise import number
from ...files import write
from ...presentation.figures import blank, require_matplotlib
from ...progress import PATIENCE, bar
from .moving_shapes import Drawing
from .sketch import Sketch

FRAMES_A_SECOND = 30
_MOST_FRAMES = 100_000


def frame_times(first: float, last: float, speed: float, fps: float) -> Any:
    """Return the times (k,) of the frames of an animation with `speed` seconds of motion per second."""
    speed, fps = number(speed, "speed"), number(fps, "fps")
    if not (speed > 0.0 and fps > 0.0):
        raise ModelError(f"speed is {speed:g} and fps is {fps:g}; both must be positive")
    count = round(abs(last - first) / speed * fps) + 1
    if count > _MOST_FRAMES:
        raise ModelError(f"a picture of {count} frames is too long: show more seconds a second (speed), or fewer fps")
    return np.linspace(first, last, count)


def animation(drawing: Drawing, fps: float = FRAMES_A_SECOND) -> Any:
    """Return a matplotlib animation with one frame for each row of the drawing."""
    require_matplotlib()
    from matplotlib.animation import FuncAnimation  # noqa: PLC0415, an optional package

    figure, sketch = _sketched(drawing)
    clock = sketch.axes.text2D if drawing.dimension == len("xyz") else sketch.axes.text
    words = clock(0.02, 0.98, "", transform=sketch.axes.transAxes, va="top", family="monospace")

    def show(row: int) -> list[Any]:
        words.set_text(f"t = {drawing.t[row]:.2f} s")
        return [*sketch.show(row), words]

    show(0)
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # the layout is computed only once
    return FuncAnimation(figure, show, frames=len(drawing.t), interval=1e3 / fps, blit=False)


def still(drawing: Drawing) -> Any:
    """Return a figure of the mechanism in the last row."""
    figure, sketch = _sketched(drawing)
    sketch.show(len(drawing.t) - 1)
    return figure


def _sketched(drawing: Drawing) -> tuple[Any, Sketch]:
    low, high = drawing.box
    wide, tall = (high - low)[[0, -1]] if drawing.dimension == len("xy") else (1.0, 1.0)
    figure = blank(*_inches(wide / tall))
    return figure, Sketch(figure, 111, drawing, drawing.name.replace("_", " "))


def _inches(ratio: float) -> tuple[float, float]:
    """Return the width and height of a picture of about 25 square inches, with room for its axes."""
    ratio = min(max(ratio, 0.5), 2.0)
    return 5.0 * ratio**0.5 + 0.7, 5.0 / ratio**0.5 + 0.7


def save_animation(moving: Any, path: Path, fps: float = FRAMES_A_SECOND) -> Path:
    """Write an animation atomically, in the format (one of ANIMATIONS) of the ending of `path`."""
    write(path, ANIMATIONS[path.suffix](moving, fps))
    return path


def _gif(moving: Any, fps: float) -> bytes:
    return _through_a_file(moving, "pillow", ".gif", 100, fps=fps)


def _mp4(moving: Any, fps: float) -> bytes:
    require_ffmpeg()
    return _through_a_file(moving, "ffmpeg", ".mp4", 100, fps=fps)


def _html(moving: Any, fps: float) -> bytes:
    """Return a self-contained page with the frames embedded."""
    import matplotlib as mpl  # noqa: PLC0415, an optional package

    with mpl.rc_context({"animation.embed_limit": 200}):
        player = _through_a_file(moving, "html", ".html", None, fps=fps, embed_frames=True, default_mode="loop")
    return b"<!doctype html><meta charset='utf-8'><title>motion</title>" + player


def _through_a_file(moving: Any, writer: str, ending: str, dpi: int | None, **options: Any) -> bytes:
    """Return what a writer of matplotlib makes; shows the progress."""
    from matplotlib.animation import writers  # noqa: PLC0415, an optional package

    with tempfile.TemporaryDirectory() as folder, bar("drawing", every=PATIENCE) as progress:
        file = Path(folder) / f"motion{ending}"

        def drawn(frame: int, count: int) -> None:
            progress(frame / count, f"frame {frame} of {count}")

        moving.save(file, writer=writers[writer](**options), dpi=dpi, progress_callback=drawn)
        return file.read_bytes()


def require_ffmpeg() -> None:
    """Raise ModelError if ffmpeg, which writes .mp4, is not installed."""
    if shutil.which("ffmpeg") is None:
        raise ModelError("moving pictures as .mp4 need ffmpeg, which is not on the PATH; .gif and .html do not")


ANIMATIONS: dict[str, Callable[[Any, float], bytes]] = {".mp4": _mp4, ".gif": _gif, ".html": _html}
