"""What eigenfactors in the state cost: runs of chains and of dual_link in C, over those of lagrange.

Two seconds at 1e-9 with dop853, in interleaved rounds: medians of the ratios, with quartiles. With a folder of other
headers (of another version, say) it prints each formulation over itself with those, too.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
from common.plain import Runner, compiled, generated
from common.timing import ratio
from eigenmotion.models import chain, dual_link

from eigenmotion import Model

FORMULATIONS = ("lagrange", "cholesky", "eigenfactor")
SPAN, TOLERANCE, ROUNDS = 2.0, 1e-9, 21


def runner(model: Model, formulation: str, folder: Path, headers: str | None) -> Runner:
    work = generated(model, folder / f"{formulation}{bool(headers)}", formulation=formulation)
    first = () if headers is None else (f"-I{headers}",)
    return Runner(compiled(work, model.name, (f"{model.name}.c",), "run.c", *first))


def times(runners: dict[object, Runner]) -> dict[object, np.ndarray]:
    """Nanoseconds a run (rounds,), about a millisecond of runs each time."""
    runs = {name: 1 + int(1e6 / one.nanoseconds(3, SPAN, TOLERANCE)) for name, one in runners.items()}
    rounds = [{name: one.nanoseconds(runs[name], SPAN, TOLERANCE) for name, one in runners.items()}
              for _ in range(ROUNDS)]  # fmt: skip
    return {name: np.array([each[name] for each in rounds]) for name in runners}


def main() -> None:
    other = sys.argv[1] if len(sys.argv) > 1 else None
    print("| model | formulation | over lagrange |" + (" over itself with other headers |" if other else ""))
    print("| --- | --- | --- |" + (" --- |" if other else ""))
    for model in (dual_link.model, chain.model(4), chain.model(8), chain.model(16)):
        with tempfile.TemporaryDirectory() as folder:
            found = times({(name, headers): runner(model, name, Path(folder), headers)
                           for name in FORMULATIONS for headers in ({None, other})})  # fmt: skip
        for name in FORMULATIONS:
            cells = [model.name, name, ratio(found[name, None], found["lagrange", None])]
            cells += [ratio(found[name, None], found[name, other])] if other else []
            print(f"| {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
