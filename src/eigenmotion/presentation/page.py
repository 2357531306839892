"""HTML pages: one self-contained file, and other files beside it."""

from collections.abc import Iterable, Mapping
from importlib.resources import files
from pathlib import Path

from jinja2 import Environment, FunctionLoader, StrictUndefined

from ..files import write
from .figures import Picture


def render(package: str, **values: object) -> str:
    """Render page.html.jinja of a package, which uses templates of its own, and those of this package."""

    def load(name: str) -> str:
        own = files(package).joinpath(name)
        return (own if own.is_file() else files(__package__).joinpath(name)).read_text(encoding="utf-8")

    environment = Environment(
        loader=FunctionLoader(load), autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    return environment.get_template("page.html.jinja").render(values)


def write_page(folder: Path, texts: Mapping[str, str], pictures: Iterable[Picture]) -> tuple[Path, ...]:
    """Write texts (file name -> text), and STEM.png and STEM.svg of each picture; return the paths in that order."""
    contents = {name: text.encode() for name, text in texts.items()}
    for picture in pictures:
        contents |= {f"{picture.stem}.png": picture.png, f"{picture.stem}.svg": picture.svg.encode()}
    for name, content in contents.items():
        write(folder / name, content)
    return tuple(folder / name for name in contents)
