"""Run the four-bar linkage for ten seconds in each tool that is installed, and print what docs/which.md quotes.

The tools go to an environment of their own; some need another Python than others:

python -m venv build/neighbours
build/neighbours/bin/pip install mujoco pin drake exudyn casadi diffrax jitcode pydy symjit newton frax
build/neighbours/bin/python benchmarks/neighbours [NAME ...]

A gap is that of the loop, energy what was gained or lost, crank the error of its angle; each at the end.
"""

import sys
from importlib import import_module
from importlib.metadata import version
from math import pi

from four_bar import energy, reference, start

TOOLS = {
    "eigenmotion": "eigenmotion", "mujoco": "mujoco", "pinocchio": "pin", "drake": "drake", "exudyn": "exudyn",
    "newton": "newton", "casadi": "casadi", "diffrax": "diffrax", "jitcode": "jitcode", "symjit": "symjit",
    "pydy": "pydy", "frax": "frax",
}  # fmt: skip
"""Names of tools, and of their packages."""


def main(names: list[str]) -> None:
    """Try tools, each after its name and version."""
    truth = reference()
    turns = (truth[0] - start()[0][0]) / (2 * pi)
    print(f"the linkage: {turns:.1f} turns of the crank, from {energy(*start()):.3g} J", flush=True)
    for name in names or TOOLS:
        try:
            tool = import_module(f"tools.with_{name}")
        except ImportError as error:
            print(f"{name}: not tried, {error}")
            continue
        print(f"{name} {version(TOOLS[name])}", flush=True)
        for trial in tool.trials():
            print(f"  {trial.line(truth)}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
