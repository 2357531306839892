"""Simulation of an ensemble: arguments, execution and result of K runs of one system."""

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from contextlib import nullcontext
from typing import Any, Never

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.differentiation import Differentiated, differentiated
from ..arguments.methods import AUTO, METHODS, Method, method_of
from ..arguments.options import (
    DEPENDENT,
    STABILISATIONS,
    choice,
    is_system,
    least_norm_of,
    rows_at,
    span,
    step_limits,
    tolerances,
)
from ..arguments.prescribed import covering
from ..arguments.signals import Inputs, Signal
from ..arguments.tasks import EnsembleTask, Members
from ..codegen.model.normalise import ModelError, shown, truth
from ..compiled.compiled_system import CompiledSystem
from ..cores import cores
from ..progress import counted
from ..results.ensemble import Ensemble
from ..simulation.initial_state.consistency import check_direction
from ..simulation.method_selection import automatic_of_many
from ..simulation.sampled_inputs import check_forwards
from ..simulation.sensitivity.sensitivities import through_no_controller
from ..simulation.simulate import NAMES, refused
from . import memory
from .executors import in_executor
from .gather import gather
from .threads import in_threads

_OPTIONS = (
    *("x0", "v0", "parameters", "inputs", "t_eval", "method", "rtol", "atol", "first_step", "max_step", "max_steps"),
    *("stabilisation", "dependent_constraints", "workers", "executor", "progress"),
    "sensitivities",
)


def simulate_ensemble(
    system: CompiledSystem,
    t_span: tuple[float, float],
    *positional: Never,
    x0: Mapping[Any, ArrayLike] | ArrayLike | None = None,
    v0: Mapping[Any, ArrayLike] | ArrayLike | None = None,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | None = None,
    t_eval: ArrayLike | None = None,
    method: str = "dop853",
    rtol: float = 1e-6,
    atol: float | Mapping[Any, float] | ArrayLike = 1e-9,
    first_step: float | None = None,
    max_step: float = np.inf,
    max_steps: int = 1_000_000,
    stabilisation: str = "project",
    dependent_constraints: str = "auto",
    workers: int | None = None,
    executor: Executor | None = None,
    progress: bool = False,
    sensitivities: Sequence[Any] | None = None,
    **misspelt: Any,
) -> Ensemble:
    """Simulate K motions of one system, each as `simulate` does.

    Parameters
    ----------
    x0, v0, parameters
        As in `simulate`; each value is a number or (K,) numbers. Or arrays (K, n), (K, n_parameters) with a row for
        each run. Arrays of length one are for all runs.
    inputs
        As in `simulate` for all runs; or an array (K,) of numbers, or a list of K numbers, pairs, Signals or Sampled.
        Each run has its own controllers (see `Sampled`). A controller that raises ends its run; the `message` of the
        run contains the exception.
    t_eval
        (nt,) times of the rows; None: the end state only.
    method, rtol, atol, first_step, max_step, max_steps, stabilisation, dependent_constraints
        As in `simulate`; "auto" chooses one method for all runs (`Ensemble.method`).
    workers
        Number of threads of this process; None: the number of cores.
    executor
        Any `concurrent.futures.Executor`, such as `dask.distributed.Client.get_executor()`. Work is sent in chunks of
        about one second; a chunk that is lost with its worker is run again.
    sensitivities
        As in `simulate`: `Ensemble.sensitivity[name]` has `dx`, `dv` (K, n, nt). They are NaN for a run without
        sensitivities, and its `message` says why.
    progress
        Write the number of finished runs, their rate and the remaining time to standard error.

    Returns
    -------
    Ensemble
        The results do not depend, bit for bit, on the number of workers, the executor or the order of the members. A
        member that cannot start or fails is listed in `failed` and does not affect the others. Ctrl-C returns the
        results so far.

    Raises
    ------
    ModelError
        Before the runs: an unknown name or option, arrays of different lengths, a value of all members that is out of
        range, or more rows than fit into memory.

    Examples
    --------
    >>> import numpy as np
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> angles = np.linspace(0.0, 3.0, 1000)
    >>> runs = em.simulate_ensemble(em.build(model), (0.0, 2.0), x0={"theta": angles}, t_eval=[1.0, 2.0])
    >>> runs.x.shape, len(runs.failed)
    ((1000, 1, 2), 0)
    """
    if positional or misspelt or not is_system(system):
        raise refused("simulate_ensemble", system, positional, misspelt, _OPTIONS)
    start, end = span(t_span)
    relative, absolute = tolerances(system.compiled, rtol, atol)
    check_direction(system.compiled, start, end)
    least_norm = least_norm_of(dependent_constraints)
    chosen = chosen_method(system, method, relative, least_norm)
    times = rows_at(t_eval, start, end)
    common = EnsembleTask(
        system.compiled, chosen.number, chosen.name, chosen.iterates, start, end, relative, absolute,
        np.array([end]) if times is None else times, times is None,
        *step_limits(first_step, max_step, max_steps, abs(end - start)),
        choice(stabilisation, STABILISATIONS, "stabilisation"), least_norm,
        _differentiated(system, sensitivities, v0),
    )  # fmt: skip
    inputs = covering(system.compiled, inputs, start, end, several=True)
    members = gather(system, start, x0, v0, parameters, inputs)
    _check_signals(system, members, start, end)
    _check_constant(system, common, members)
    _check_controlled(common, members)
    memory.check(common, members)
    with counted(members.count) if truth(progress, "progress") else nullcontext(_silent) as report:
        if executor is None:
            return Ensemble(common, members, in_threads(common, members, _threads(workers), report))
        return Ensemble(common, members, in_executor(common, members, _executor(executor, workers), report))


def chosen_method(system: CompiledSystem, method: object, rtol: float, least_norm: int = 0) -> Method:
    """Return the method of that name; for "auto" the one that is best for ensembles on this machine."""
    name = method_of(method, NAMES)
    return (
        automatic_of_many(system.compiled, rtol, least_norm == DEPENDENT["least_norm"])
        if name == AUTO
        else METHODS[name]
    )


def _differentiated(system: CompiledSystem, argument: Any, v0: Any) -> Differentiated | None:
    if argument is None:
        return None
    return differentiated(system.compiled, argument, v0)


def _check_constant(system: CompiledSystem, common: EnsembleTask, members: Members) -> None:
    """Raise ModelError if `sensitivities` names an input that is a signal."""
    names = common.differentiated.names if common.differentiated else ()
    for name, column in zip(system.inputs, members.signals, strict=True):
        if name in names and any(isinstance(one, Signal) for one in (column if isinstance(column, list) else [column])):
            raise ModelError(f"sensitivities: input {name!r} is sampled; only inputs that are constant can be named")


def _check_controlled(common: EnsembleTask, members: Members) -> None:
    """Raise ModelError if the runs have controllers and also an option that excludes controllers."""
    if not members.controllers:
        return
    check_forwards(common.t_start, common.t_end)
    if common.differentiated is not None:
        raise through_no_controller(common.model.name)


def _silent(_: int) -> None:
    """Report nothing."""


def _threads(workers: object) -> int:
    if workers is None:
        return cores()
    if isinstance(workers, bool) or not isinstance(workers, int | np.integer) or workers < 1:
        raise ModelError(f"workers is {shown(workers)}, but must be a whole number of threads, at least 1, or None")
    return int(workers)


def _executor(executor: Any, workers: object) -> Executor:
    if not callable(getattr(executor, "submit", None)):
        raise ModelError(f"executor is {shown(executor)}, not a concurrent.futures.Executor")
    if workers is not None:
        raise ModelError("give workers, threads of this process, or an executor, which has its own; not both")
    return executor  # type: ignore[no-any-return]


def _check_signals(system: CompiledSystem, members: Members, start: float, end: float) -> None:
    """Check that signals cover the span: a shared one raises ModelError, one of a member refuses that member."""
    for name, column in zip(system.inputs, members.signals, strict=True):
        for k, signal in enumerate(column if isinstance(column, list) else [column]):
            if not isinstance(signal, Signal) or (gap := Inputs((signal,)).uncovered(start, end)) is None:
                continue
            words = f"input {name!r} {gap[1]}, which does not cover t_span ({start:g}, {end:g})"
            if not isinstance(column, list):
                raise ModelError(f"{system.name}: {words}")
            members.refused[k] = True
            members.reasons.setdefault(k, words)
