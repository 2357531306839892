"""Which method a run takes that leaves the choice to us: method="auto".

As measured over all models (benchmarks/nodes.py, docs/theory.md). A method for stiff scenes finds its place here,
before the others.
"""

from ..runtime import CompiledModel
from .methods import METHODS, Method

_LEAST_LANES = 4
_TIGHT = {"eigenfactor": 1e-6}
_TIGHT_OTHERWISE = 1e-5


def automatic(model: CompiledModel, rtol: float, least_norm: bool) -> Method:
    """Return steps by nodes where their length pays, else dop853.

    It does at tight tolerances, where the processor evaluates four nodes and more at once.
    """
    side_by_side = model.lanes >= _LEAST_LANES and not least_norm
    tight = rtol <= _TIGHT.get(model.formulation, _TIGHT_OTHERWISE)
    return METHODS["ra15" if side_by_side and tight else "dop853"]


def automatic_of_many(model: CompiledModel, rtol: float, least_norm: bool) -> Method:
    """Return dop853 where lanes hold a run each, which is quicker than one run's nodes in them; else as of one run."""
    return METHODS["dop853"] if model.flocks and not least_norm else automatic(model, rtol, least_norm)
