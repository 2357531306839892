"""What leaving SLP vectorisation off costs: right-hand sides and runs without it over those with it.

The default flags hold -fno-tree-slp-vectorize, for GCC 12 miscompiles what it packs; here each formulation is compiled
as by default and with it back on, and timed in pairs. CC=clang measures the same of Clang. Prints the table of
docs/flags.md: medians over interleaved rounds, with quartiles; above 1, the default is slower.
"""

from __future__ import annotations

import tempfile
from functools import partial
from pathlib import Path

import numpy as np
from common.plain import right_hand_side
from common.timing import interleaved, ratio
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.models import chain, dual_link, spatial_arm

from eigenmotion import Model, build

PACKED = "-ftree-slp-vectorize"
ROUNDS, CALLS = 101, 20_000
AT = {"rtol": 1e-9, "atol": 1e-9}


def alone(model: Model, formulation: str) -> str:
    """One right-hand side in C, each call waiting for the one before."""
    with tempfile.TemporaryDirectory() as folder:
        timers = [right_hand_side(model, formulation, Path(folder) / f"with{''.join(flags)}", *flags)
                  for flags in ((), (PACKED,))]  # fmt: skip
        found = np.array([[timer(CALLS) for timer in timers] for _ in range(ROUNDS)])
    return ratio(found[:, 0], found[:, 1])


def within(model: Model, formulation: str) -> str:
    """A run of two seconds with all that belongs to it."""
    systems = {flags: build(model, formulation=formulation, flags=flags) for flags in ("", PACKED)}
    found = interleaved({name: partial(one.simulate, (0.0, 2.0), **AT) for name, one in systems.items()}, ROUNDS)
    return ratio(found[""], found[PACKED])


def main() -> None:
    print("| model | formulation | right-hand side | run |\n| --- | --- | --- | --- |")
    for model in (dual_link.model, chain.model(8), spatial_arm.model()):
        for formulation in FORMULATIONS:
            if formulation == "inverse" and len(model.coordinates) > 6:  # which it is not for
                continue
            cells = (model.name, formulation, alone(model, formulation), within(model, formulation))
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
