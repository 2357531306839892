"""Make what the gallery shows of models: a page on which it moves, and what a run takes (`cards.py` draws pictures).

python docs/making/exhibit.py four_bar dual_link
"""

import json
import sys
from pathlib import Path
from time import perf_counter

import eigenmotion as em
from eigenmotion.cli import main

ROOT = Path(__file__).parents[2]
MADE = ROOT / "docs" / "made"
SPAN, TOLERANCE, RUNS = 10.0, 1e-9, 5


def exhibit(name: str) -> None:
    """Make all of it for models/NAME.py."""
    path = ROOT / "models" / f"{name}.py"
    (MADE / "extra" / "live").mkdir(parents=True, exist_ok=True)
    system = em.build(path)
    solution = system.simulate((0.0, SPAN), rtol=TOLERANCE, atol=TOLERANCE)
    (MADE / f"{name}.json").write_text(json.dumps(_cost(system, solution)))
    if main(["page", str(path), "-o", str(MADE / "extra" / "live" / f"{name}.html"), "--home", "../index.html"]) != 0:
        sys.exit(f"there is no page of {name}")


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
