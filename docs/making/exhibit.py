"""Make what the gallery shows of models: a picture, a page on which it moves, and what a run takes.

python docs/making/exhibit.py four_bar dual_link
"""

import json
import sys
from pathlib import Path
from time import perf_counter

import eigenmotion as em
from eigenmotion.cli import main
from eigenmotion.results.pictures.animation import still
from eigenmotion.results.pictures.moving_shapes import Drawing

ROOT = Path(__file__).parents[2]
MADE = ROOT / "docs" / "made"
SPAN, TOLERANCE, RUNS = 10.0, 1e-9, 5


def exhibit(name: str) -> None:
    """Make all of it for models/NAME.py."""
    path = ROOT / "models" / f"{name}.py"
    for folder in (MADE / "extra" / "live", MADE / "extra" / "pictures"):
        folder.mkdir(parents=True, exist_ok=True)
    system = em.build(path)
    solution = system.simulate((0.0, SPAN), rtol=TOLERANCE, atol=TOLERANCE)
    (MADE / f"{name}.json").write_text(json.dumps(_cost(system, solution)))
    if solution.drawing is not None:
        _photograph(solution.drawing, MADE / "extra" / "pictures" / f"{name}.png")
    if main(["page", str(path), "-o", str(MADE / "extra" / "live" / f"{name}.html")]) != 0:
        sys.exit(f"there is no page of {name}")


def _photograph(drawing: Drawing, path: Path) -> None:
    """Write the mechanism at the end, without axes: it is shown small."""
    figure = still(drawing)
    for axes in figure.axes:
        axes.set_axis_off()
        axes.set_title("")
    figure.savefig(path, dpi=100, bbox_inches="tight")


def _cost(system: em.System, solution: em.Solution) -> dict[str, object]:
    """Return what a run takes: the quickest of several, in seconds."""
    times = []
    for _ in range(RUNS):
        before = perf_counter()
        system.simulate((0.0, SPAN), rtol=TOLERANCE, atol=TOLERANCE)
        times.append(perf_counter() - before)
    return {
        "n": system.n, "m": system.m, "n_state": system.n_state, "seconds": min(times), "nfev": int(solution.nfev),
        "nsteps": int(solution.nsteps), "t": float(solution.t[-1]), "ended": str(solution.stop),
    }  # fmt: skip


if __name__ == "__main__":
    for model in sys.argv[1:]:
        exhibit(model)
