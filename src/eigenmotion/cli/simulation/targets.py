"""Checks of the files that a command is to write, before its work."""

from collections.abc import Collection
from pathlib import Path

from eigenmotion.presentation.figures import FORMATS, require_matplotlib
from eigenmotion.results.pictures.animation import ANIMATIONS, require_ffmpeg

from ..options import check_targets


def check_results(plot: Path | None, animate: Path | None, saved: tuple[str, Path | None, Collection[str]]) -> None:
    """Check the targets of --plot and --animate, and of an option with its endings that saves numbers."""
    if plot or animate:
        require_matplotlib()
    if animate and animate.suffix == ".mp4":
        require_ffmpeg()
    check_targets(("--plot", plot, FORMATS), ("--animate", animate, ANIMATIONS), saved)
