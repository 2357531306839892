"""Pictures of a solution; needs the extra `plot` (matplotlib)."""

import io
from importlib.util import find_spec
from itertools import product
from pathlib import Path

import numpy as np
from sympy import Symbol, latex

from .codegen.model import ModelError
from .files import write
from .names import Vector
from .solution import Solution
from .system import System

# Okabe & Ito's palette, told apart with any colour vision; its yellow is left out: too faint on white.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")
STYLES = ("-", "--", ":", "-.")
FORMATS = (".png", ".svg", ".pdf")


def require_matplotlib() -> None:
    """Raise ModelError where matplotlib is missing."""
    if find_spec("matplotlib") is None:
        raise ModelError("pictures need matplotlib: pip install 'eigenmotion[plot]'")


def draw_coordinates(system: System, solution: Solution, path: Path) -> None:
    """Draw x over t, one line a coordinate, to a file whose ending, one of FORMATS, names the format."""
    require_matplotlib()
    from matplotlib.figure import Figure  # noqa: PLC0415, an optional package

    figure = Figure(figsize=(8, 4.5), layout="constrained")
    axes = figure.add_subplot()
    t, x = _smooth(system, solution)
    looks = product(STYLES, COLOURS)
    for name, row, (style, colour) in zip(system.coordinates, x, looks, strict=False):
        axes.plot(t, row, style, color=colour, label=f"${latex(Symbol(name))}$", linewidth=1.6)
    axes.set(xlabel="$t$", ylabel="coordinates", title=system.name.replace("_", " "))
    axes.margins(x=0)
    axes.grid(color="0.9")
    axes.spines[["top", "right"]].set_visible(False)
    figure.legend(loc="outside right upper", frameon=False, ncols=1 + system.n // 16)
    picture = io.BytesIO()
    figure.savefig(picture, format=path.suffix[1:], dpi=150)
    write(path, picture.getvalue())


def _smooth(system: System, solution: Solution) -> tuple[Vector, Vector]:
    """Return t (k,) and x (n, k): dense enough for the eye where the solution was kept dense, else its rows."""
    if solution.sol is None:
        return solution.t, solution.x
    t = np.linspace(solution.t[0], solution.t[-1], 2000)
    return t, solution.sol(t)[system.layout["x"]]
