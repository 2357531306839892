"""Selection of a method for a run with method="auto".

The limits were measured over all models (benchmarks/nodes.py, benchmarks/ensemble.py, docs/theory.md).
"""

from ..arguments.methods import METHODS, Method
from ..arguments.tasks import Task
from ..results.solution import Solution
from ..runtime import CompiledModel

_LEAST_LANES = 4
_TIGHT = {"eigenfactor": 1e-6}
_TIGHT_OTHERWISE = 1e-5
_TIGHT_WITH_MANY = {4: ((150, 1e-11),), 8: ((150, 1e-10), (100, 1e-8), (60, 1e-7))}
"""Vector width -> (numbers of eigenfactors in the state, tolerance): with more numbers, nodes pay only at tighter
tolerances, since products of eigenfactors already fill the vectors. Measured on chains of 8 to 16 coordinates."""
_PLACED = ((6, 1e-7), (1, 3e-11))
"""For ensembles: (constraints on positions, tolerance): with at least so many constraints, longer steps pay up to this
tolerance."""


def automatic_of_run(task: Task) -> Method:
    """Return the explicit method with which a run begins; the run itself changes it (em_method_change.h)."""
    return automatic(task.model, task.rtol, _may_depend(task))


def _may_depend(task: Task) -> bool:
    """Return whether constraint rows may depend on each other in the run; without rows, the option means nothing."""
    return task.model.m > 0 and task.least_norm != 0


def other_than(method: Method) -> Method:
    """Return the method to which a run by `method` may change: the stiff one, or from it to dop853."""
    return METHODS["dop853" if method.implicit else "radau9"]


def longest_of(solution: Solution) -> Method:
    """Return the method by which a run has covered the longest span."""
    if not solution.methods:
        return METHODS[solution.method]
    times, names = zip(*solution.methods, strict=True)
    spans = dict.fromkeys(names, 0.0)
    for name, start, end in zip(names, times, (*times[1:], solution.t[-1]), strict=True):
        spans[name] += abs(end - start)
    return METHODS[max(spans, key=spans.__getitem__)]


def automatic(model: CompiledModel, rtol: float, least_norm: bool) -> Method:
    """Return ra15 if its longer steps pay, else dop853.

    They pay at tight tolerances, if the processor evaluates four nodes or more in one vector.
    """
    side_by_side = model.lanes >= _LEAST_LANES and not least_norm
    return METHODS["ra15" if side_by_side and rtol <= _nodes_pay(model) else "dop853"]


def _nodes_pay(model: CompiledModel) -> float:
    """Return the tolerance below which steps of ra15 pay."""
    factors = model.n_state - 2 * model.n
    otherwise = _TIGHT.get(model.formulation, _TIGHT_OTHERWISE)
    return next((rtol for many, rtol in _TIGHT_WITH_MANY.get(model.lanes, ()) if factors > many), otherwise)


def automatic_of_many(model: CompiledModel, rtol: float, least_norm: bool) -> Method:
    """Return dop853 if each lane can hold a run, which is faster than the nodes of one run; else `automatic`."""
    in_lanes = model.lane_groups and not least_norm and rtol > _longer_steps_pay(model.h)
    return METHODS["dop853"] if in_lanes else automatic(model, rtol, least_norm)


def _longer_steps_pay(positions: int) -> float:
    """Return the tolerance up to which longer steps pay: the projection of positions does not run in lanes."""
    return next((rtol for least, rtol in _PLACED if positions >= least), 0.0)
