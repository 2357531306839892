"""Page of a model: one self-contained file with the compiled model."""

import base64
import gzip
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any

from jinja2 import Environment, FunctionLoader, StrictUndefined

from ..building.request import Request
from ..codegen.compiler import program
from ..codegen.model import Model
from ..codegen.model.normalise import name_of
from ..codegen.model.table import TableHandle
from ..presentation.units import time_unit, unit_of
from ..runtime.status.stop_reasons import StopReason, explain
from .faces import faces
from .mathml import formulas, in_words, label
from .three import Three
from .wasm import module

SCRIPTS = (
    "drawing/vectors", "theme", "gestures", "motion/motion", "motion/engine", "drawing/shapes", "drawing/stage",
    "drawing/space", "drawing/plot_groups", "drawing/plots", "controls", "player", "embedded", "main",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Run:
    """The duration [s] and tolerances of the page's runs, and initial values of sliders in place of the model's.

    given : "parameters", "inputs", "x0", "v0" -> name -> value
    """

    t_end: float = 10.0
    rtol: float = 1e-9
    atol: float = 1e-9
    given: Mapping[str, Mapping[str, float]] = field(default_factory=dict)

    def value(self, kind: str, name: str, default: float) -> float:
        """Return the initial value of a slider."""
        return self.given.get(kind, {}).get(name, default)


@dataclass(frozen=True, slots=True)
class Place:
    """Where a page is shown.

    embed : whether it is for a frame in another page: no header, settings and plots folded, its height reported
    home : the address that the link at its end leads to; "" for no link
    """

    embed: bool = False
    home: str = ""


ALONE = Place()


def page(requested: Request, source: str, run: Run, space: Three | None = None, place: Place = ALONE) -> str:
    """Return the page of a request as HTML.

    Parameters
    ----------
    source
        The text of the model's file, for download.
    space
        three.js, for drawings in space; None: these are drawn on a plain canvas.

    Raises
    ------
    BuildError
        There is no compiler for WebAssembly, or it failed.
    """
    model, generated = requested.model, program(requested.model, requested.choices, whole=False)
    return _environment().get_template("page.html.jinja").render(
        title=model.name.replace("_", " "), summary=summary(source), space=generated.dimension == len("xyz"),
        inputs=bool(model.inputs), formulas=list(formulas(model.equations())), left_out=generated.left_out,
        download=f"{model.name}.py", source=_base64(source.encode()), origin=requested.origin,
        licence=space.licence if space else "", formulation=generated.formulation, rtol=f"{run.rtol:g}",
        atol=f"{run.atol:g}", time=escape(time_unit(dict(model.units))),
        embed=place.embed, home=place.home, about=_json(about(model, run, generated.conserves_energy)),
        wasm=_packed(module(requested)), parts=_parts(space), scripts=[f"{name}.js" for name in SCRIPTS],
    )  # fmt: skip


def _parts(space: Three | None) -> dict[str, str]:
    """Return element id -> compressed text: the messages about the end of runs, and three.js."""
    texts = {"endings": json.dumps([*map(_ending, StopReason)], ensure_ascii=False)}
    texts |= {"three-core": space.core, "three-module": space.module} if space else {}
    return {name: _packed(text.encode()) for name, text in texts.items()}


def about(model: Model, run: Run, conserves_energy: bool) -> dict[str, Any]:
    """Return the data of a model for the scripts: names, defaults and shapes."""
    shapes, first = [], 0
    for shape, around in zip(model.drawing, faces(model), strict=True):
        shapes.append({"kind": shape.kind, "first": first, "count": len(shape.numbers)} | around)
        first += len(shape.numbers)
    rates = zip(model.coordinates, model.rates, model.initial_x, strict=True)
    start, units = dict(model.initial), dict(model.units)
    return {
        "name": model.name, "n": model.n + len(model.states), "m": model.m, "h": model.h,
        "conservesEnergy": conserves_energy,
        "coordinates": [
            {"name": name_of(x), "label": label(x), "rate": label(v), "value": run.value("x0", name_of(x), x0),
             "unit": unit_of(units, name_of(x)), "rateUnit": unit_of(units, name_of(x), 1)}
            for x, v, x0 in rates
        ] + [{"name": name_of(z), "label": label(z), "rate": label(z), "value": 0.0, "state": True,
              "unit": unit_of(units, name_of(z)), "rateUnit": unit_of(units, name_of(z))}
             for z, _ in model.states],
        "v": [run.value("v0", name_of(x), v0) for x, v0 in zip(model.coordinates, model.initial_v, strict=True)]
        + [run.value("x0", name_of(z), start.get(z, 0.0)) for z, _ in model.states],
        "parameters": [_parameter(model, p, run.value("parameters", p.name, value)) for p, value in model.parameters],
        "inputs": [
            {"name": name_of(u), "label": label(u), "value": run.value("inputs", name_of(u), value),
             "unit": unit_of(units, name_of(u))}
            for u, value in model.inputs
        ],
        "outputs": [
            {"name": name, "label": in_words(name), "unit": unit_of(units, name)} for name, _ in model.outputs
        ],
        "multipliers": _multipliers(model),
        "dimension": model.drawing[0].dimension if model.drawing else 0, "shapes": shapes,
        "measured": bool(units), "time": time_unit(units), "energy": unit_of(units, "energy"),
        "tEnd": run.t_end, "rtol": run.rtol, "atol": run.atol,
    }  # fmt: skip


def _parameter(model: Model, symbol: Any, value: float) -> dict[str, Any]:
    """Return the data of a parameter for the scripts; modes of contacts (set by the run) and tables have no slider."""
    positive = bool(symbol.is_nonnegative) and value > 0
    mode = isinstance(symbol, TableHandle) or any(
        symbol in (one.holds, one.slides, one.idles) for one in model.switches
    )
    return {
        "name": symbol.name, "label": label(symbol), "unit": unit_of(dict(model.units), symbol.name), "value": value,
        "positive": positive, "mode": mode,
    }  # fmt: skip


def _multipliers(model: Model) -> list[dict[str, str]]:
    """Return the name and label of each row's multiplier; contacts and frictions name theirs, others have numbers."""
    names = list(model.row_names or ("",) * model.m)
    for one in model.switches:
        row = one.row if one.slides is None else model.h + one.row
        own = (f"{one.name}[0]", f"{one.name}[1]") if one.cone else (one.name,)
        names[row : row + len(own)] = own
    return [{"name": name, "label": _label_of_multiplier(name or str(k))} for k, name in enumerate(names)]


def _label_of_multiplier(name: str) -> str:
    return f"<math><msub><mi>λ</mi><mtext>{escape(name)}</mtext></msub></math>"


def _ending(stop: StopReason) -> dict[str, Any]:
    """Return the messages of a stop reason; `placed` has placeholders for a coordinate and a constraint row."""
    placed = explain(stop, ("#",), 0).replace("#", "{coordinate}").replace("row 0", "row {row}")
    return {"name": str(stop), "text": explain(stop, ()), "placed": placed, "failure": not stop.success}


def summary(source: str) -> str:
    """Return the first line of the docstring of a model's file."""
    first = source.lstrip().splitlines()[0] if source.strip() else ""
    return first.strip('"').strip() if first.startswith('"""') else ""


def _json(content: Mapping[str, Any]) -> str:
    """Return JSON that is safe in a script element."""
    return json.dumps(content, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")


def _packed(content: bytes) -> str:
    return _base64(gzip.compress(content, 9, mtime=0))


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode()


@cache
def _environment() -> Environment:
    return Environment(loader=FunctionLoader(_load), undefined=StrictUndefined, autoescape=False, trim_blocks=True)


def _load(name: str) -> str | None:
    path = files("eigenmotion.webpage").joinpath("page", name)
    if not path.is_file():
        return None
    text = path.read_text(encoding="utf-8")
    return _short(text) if name.endswith(".js") else text


def _short(script: str) -> str:
    """Return a script without indentation and lines of comments, which are a tenth of a small page."""
    lines = (line.strip() for line in script.splitlines())
    return "\n".join(line for line in lines if line and not line.startswith("//"))
