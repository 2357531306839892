"""Page object: displayed in a notebook, or written to a file."""

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from os import PathLike
from pathlib import Path
from typing import Any

from ..building.errors import BuildError
from ..building.request import request
from ..codegen.model import Model, ModelError
from ..files import write
from .page import Place, Run, page
from .three import Three, three

_HEIGHT = 640  # [pixel] of a frame in a notebook


@dataclass(frozen=True, slots=True)
class Page:
    """An interactive page of a model; a notebook displays it in a frame.

    html : the complete file
    missing : a message about a missing component, or ""
    """

    html: str
    missing: str = ""

    def save(self, file: str | PathLike[str]) -> None:
        """Write the page to a file.

        Raises
        ------
        ModelError
            The file cannot be written.
        """
        try:
            write(Path(file), self.html.encode())
        except OSError as error:
            raise ModelError(f"{file}: the page cannot be written there ({error.strerror})") from error

    def _repr_html_(self) -> str:
        words = f"<p>{escape(self.missing)}</p>" if self.missing else ""
        frame = f"style='width:100%;height:{_HEIGHT}px;border:0' srcdoc='{escape(self.html, quote=True)}'"
        return f"{words}<iframe title='the mechanism, moving' {frame}></iframe>"

    def __repr__(self) -> str:
        return f"<Page of {len(self.html.encode()) / 1e3:.0f} kB>"


def show(
    source: Model | str | PathLike[str],
    *,
    t_end: float = 10.0,
    rtol: float = 1e-9,
    atol: float = 1e-9,
    formulation: str | None = None,
    embed: bool = False,
    **keywords: Any,
) -> Page:
    """Return an interactive page of a model: one file that contains its C as WebAssembly and needs no network.

    Parameters
    ----------
    source
        A Model, or the file that defines one; `keywords` are arguments of the file's function.
    t_end, rtol, atol
        Duration [s] and tolerances of the runs.
    embed
        Whether the page is for a frame in a page of yours: compact, and it reports its height.

    Raises
    ------
    ModelError
        The file or the model has a mistake.
    BuildError
        There is no compiler for WebAssembly (the extra `page` installs one), or it failed.

    Examples
    --------
    >>> import eigenmotion as em
    >>> shown = em.show("models/pendulum.py", t_end=5.0)
    >>> shown.save("pendulum.html")
    >>> shown
    <Page of ... kB>
    """
    requested = request(source, with_meshes(source, keywords), formulation=formulation)
    text = "" if isinstance(source, Model) else Path(source).read_text(encoding="utf-8")
    library, missing = of_space(requested.model)
    return Page(page(requested, text, Run(t_end, rtol, atol), library, Place(embed)), missing)


def with_meshes(source: object, definitions: Mapping[str, object]) -> dict[str, object]:
    """Return the arguments of the file of a robot, which shows its meshes unless they say otherwise."""
    is_robot = not isinstance(source, Model) and Path(str(source)).suffix.lower() == ".urdf"
    return {"meshes": True, **definitions} if is_robot else dict(definitions)


def of_space(model: Model) -> tuple[Three | None, str]:
    """Return three.js for a drawing in space, or None and the reason; then the page uses a plain canvas."""
    if not model.drawing or model.drawing[0].dimension < len("xyz"):
        return None, ""
    try:
        return three(), ""
    except BuildError as error:
        return None, f"three.js is not to be had, so the page shows space on a plain canvas: {error}"
