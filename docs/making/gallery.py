"""Pages of the gallery: one a model, from its file and from what `exhibit.py` has made of it; and the page of all."""

import ast
import json
import re
from pathlib import Path

from sphinx.application import Sphinx

DOCS = Path(__file__).parents[1]
MODELS = DOCS.parent / "models"
MADE, GALLERY, CARDS = DOCS / "made", DOCS / "gallery", DOCS / "_static" / "cards"

_INDEX = """\
---
hide-toc: true
---

# Gallery

Every mechanism here is one file of `models/`, with an oracle that tests hold it against, and moves on its page under
your hands. Each is run for ten seconds, or to where it ends, with `dop853` at `rtol=1e-9`, `atol=1e-9`; the times are
those of the machine that made this site.

{cards}

## Ninety thousand at once

:::{{figure}} ../pictures/flips.png
:alt: When the lower rod of a double pendulum first flips, over both angles of the start
:target: ../flips.html
:width: 70%

When a [double pendulum](double_pendulum.md) that is let go at rest first flips over:
[a run for each point](../flips.md), each ended by its own event.
:::

```{{toctree}}
:hidden:

{names}
../flips
```
"""
_PAGE = """\
---
hide-toc: true
---

# {title}

{summary}

{moving}

{cost}

## The mechanism

```{{eval-rst}}
{description}
```

```sh
eigenmotion run models/{name}.py --plot {name}.png
eigenmotion page models/{name}.py
```

## The model file

`models/{name}.py`; `make generate-all` writes its C to `build/generated/{generated}`.

```{{literalinclude}} {path}
:language: python
```
"""
_LIVE = """\
```{{live}} {name}
:height: 900
```"""
_STILL = """\
![The mechanism at the end of a motion](../_static/cards/{name}.webp)

This site has no live page of it, which takes minutes to build; the last command below makes one."""
_CARD = """\
<a class="card" href="{name}.html"><img src="../_static/cards/{name}.webp" alt="" loading="lazy">
<strong>{title}</strong><span>{summary}</span></a>"""


def setup(app: Sphinx) -> dict[str, bool]:
    """Write the pages before they are read."""
    app.connect("builder-inited", lambda _: write())
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def write() -> None:
    """Write docs/gallery/; a page that stays the same keeps its date, and is not read again."""
    GALLERY.mkdir(exist_ok=True)
    names = sorted(path.stem for path in MODELS.glob("*.py") if path.stem != "__init__")
    pages = {name: _page(name) for name in names}
    cards = "\n".join(["```{raw} html", '<div class="cards">', *map(_card, names), "</div>", "```"])
    pages["index"] = _INDEX.format(cards=cards, names="\n".join(names))
    for name, text in pages.items():
        path = GALLERY / f"{name}.md"
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
    for path in GALLERY.glob("*.md"):
        if path.stem not in pages:
            path.unlink()


def _docstring(name: str) -> tuple[str, str]:
    """Return the first line of a model's docstring, and the rest."""
    text = ast.get_docstring(ast.parse((MODELS / f"{name}.py").read_text(encoding="utf-8"))) or name
    first, _, rest = text.partition("\n\n")
    return first.replace("\n", " "), rest


def _page(name: str) -> str:
    summary, description = _docstring(name)
    title = name.replace("_", " ")
    return _PAGE.format(
        title=title[0].upper() + title[1:], name=name, summary=summary, description=_rst(description),
        cost=_cost(name), moving=_moving(name), path=f"../../models/{name}.py", generated=_generated(name),
    )  # fmt: skip


def _generated(name: str) -> str:
    """Return the name of a model's C file, which may have a size in it."""
    sums = (DOCS.parent / "generated" / "sums.txt").read_text()
    return min(re.findall(rf"\b{name}\w*\.c$", sums, re.MULTILINE), key=len, default=f"{name}.c")


def _rst(text: str) -> str:
    """Escape what reStructuredText takes for markup; drawings stay as they are."""
    return "\n".join(
        line if line.startswith(" ") else re.sub(r"([|*])|(?<=\w)(_)(?!\w)", r"\\\1\2", line)
        for line in text.split("\n")
    )


def _cost(name: str) -> str:
    path = MADE / f"{name}.json"
    if not path.exists():
        return ""
    c = json.loads(path.read_text())
    size = f"{c['n']} coordinates, {c['m']} constraint rows, {c['n_state']} states."
    took = f"**{1e3 * c['seconds']:.3g} ms** for {c['t']:.4g} s: {c['nsteps']} steps, {c['nfev']} right-hand sides"
    return f"{size} {took} ({c['ended']})."


def _card(name: str) -> str:
    """Return the card of a model; its picture is one of those that `cards.py` draws.

    Raises
    ------
    FileNotFoundError
        A model has no picture yet.
    """
    if not (CARDS / f"{name}.webp").is_file():
        raise FileNotFoundError(f"{name} has no card: run python docs/making/cards.py {name}, and commit what it draws")
    summary, _ = _docstring(name)
    title = name.replace("_", " ")
    return _CARD.format(name=name, title=title[0].upper() + title[1:], summary=summary)


def _moving(name: str) -> str:
    """Return the live page of a model where it has been made, else its picture."""
    made = (MADE / "extra" / "live" / f"{name}.html").is_file()
    return (_LIVE if made else _STILL).format(name=name)
