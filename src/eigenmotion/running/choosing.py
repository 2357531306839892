"""Which method a run takes that leaves the choice to us: method="auto".

As measured over all models (benchmarks/nodes.py, docs/theory.md). A method for stiff scenes finds its place here,
before the others.
"""

from ..arguments.options import Task
from .methods import METHODS, Method

_LEAST_LANES = 4
_TIGHT = {"eigenfactor": 1e-6}
_TIGHT_OTHERWISE = 1e-5


def automatic(task: Task) -> Method:
    """Return steps by nodes where their length pays, else dop853.

    It does at tight tolerances, where the processor evaluates four nodes and more at once.
    """
    model = task.model
    side_by_side = model.lanes >= _LEAST_LANES and not task.least_norm
    tight = task.rtol <= _TIGHT.get(model.formulation, _TIGHT_OTHERWISE)
    return METHODS["ra15" if side_by_side and tight else "dop853"]
