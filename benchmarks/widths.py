"""Steps by nodes on vectors of other widths: AVX2 forced on a machine with AVX-512, and none at all.

Whole runs of the paper's mechanism over 10 s at rtol = atol = 1e-9; ratios are medians over interleaved rounds, with
quartiles: over the time at the machine's own width, and over dop853's.
"""

from __future__ import annotations

from functools import partial
from time import thread_time

from common.timing import interleaved, ratio
from eigenmotion.models.dual_link import model

from eigenmotion import System, build

WIDTHS = {"the machine's": "", "at most AVX2": "-mno-avx512f", "no vectors": "-DEM_LANES=1"}
FORMULATIONS = ("inverse", "lagrange", "eigenfactor")
RUN = {"t_span": (0.0, 10.0), "rtol": 1e-9, "atol": 1e-9}
REPEATS, ROUNDS = 10, 31


def repeated(system: System, method: str) -> None:
    for _ in range(REPEATS):
        system.simulate(**RUN, method=method)


def main() -> None:
    for formulation in FORMULATIONS:
        systems = {name: build(model, formulation=formulation, flags=flags) for name, flags in WIDTHS.items()}
        calls = {name: partial(repeated, system, "ra15") for name, system in systems.items()}
        seconds = interleaved({**calls, "": partial(repeated, systems["the machine's"], "dop853")}, ROUNDS, thread_time)
        print(f"\n{formulation:<20} {'lanes':<6} {'ra15 over the widest':<24} ra15 over dop853")
        for name, system in systems.items():
            beside = ratio(seconds[name], seconds["the machine's"]), ratio(seconds[name], seconds[""])
            print(f"  {name:<18} {system.compiled.lanes:<6} {beside[0]:<24} {beside[1]}", flush=True)


if __name__ == "__main__":
    main()
