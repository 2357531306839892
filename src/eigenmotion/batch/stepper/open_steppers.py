"""Opening of a batch of steppers of one system: `System.steppers`."""

from collections.abc import Mapping
from typing import Any, Never

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import options
from ...arguments.named_values import Vector, is_named, unknown
from ...arguments.options import OptionError
from ...arguments.tasks import EnsembleTask
from ...codegen.model.normalise import ModelError, number, shown
from ...compiled.compiled_system import CompiledSystem
from ...cores import cores
from ...simulation.stepper import METHOD_NUMBERS, fixed_step, method_named
from ..gather import gather
from .step_arguments import columns
from .steppers import Starts, Steppers

_OPTIONS = ("t", "x0", "v0", "parameters", "inputs", "rtol", "atol", "method", "step", "max_step", "max_steps",
            "stabilisation", "dependent_constraints", "workers")  # fmt: skip


def steppers(
    system: CompiledSystem,
    count: int | None = None,
    *positional: Never,
    t: float = 0.0,
    x0: Mapping[Any, ArrayLike] | ArrayLike | None = None,
    v0: Mapping[Any, ArrayLike] | ArrayLike | None = None,
    parameters: Any = None,
    inputs: Mapping[Any, ArrayLike] | ArrayLike | None = None,
    rtol: float = 1e-6,
    atol: float | Mapping[Any, float] | ArrayLike = 1e-9,
    method: str = "dop853",
    step: float | None = None,
    max_step: float = np.inf,
    max_steps: int = 1_000_000,
    stabilisation: str = "project",
    dependent_constraints: str = "auto",
    workers: int | None = None,
    **misspelt: Any,
) -> Steppers:
    """Open a batch of K steppers of this mechanism, which `Steppers.advance` advances together.

    Methods of fixed step ("rk4", "midpoint") run in lanes (several members at once on one core) if the model has
    neither constraints nor events and its formulation carries velocities ("lagrange", "inverse"); others run singly.

    Parameters
    ----------
    count
        K; None: the length of the arrays below.
    t, x0, v0, parameters, inputs
        The starts, as in `stepper`; each value is a number or (K,) numbers. Or arrays (K, n) with a row for each
        member. Inputs are numbers, which every `advance` can change.
    method, step, rtol, atol, max_step, max_steps, stabilisation, dependent_constraints
        As in `stepper`.
    workers
        Number of threads; None: the number of cores, or fewer if there are few members.

    Raises
    ------
    ModelError
        An unknown name or option, arrays of different lengths, or an inconsistent start (names the member).
    """
    if positional:
        raise OptionError("steppers: all but their number is given by keyword, as t=0.0, x0={...}")
    if misspelt:
        raise OptionError(f"steppers: {unknown('option', misspelt, _OPTIONS)}")
    begin, named = number(t, "t"), method_named(method)
    relative, absolute = options.tolerances(system.compiled, rtol, atol)
    _, longest, most = options.step_limits(None, max_step, max_steps, np.inf)
    by_columns = inputs if is_named(inputs) else None
    members = gather(system, begin, x0, v0, parameters, by_columns)
    total = _count(count, members.count, inputs)
    if members.reasons:
        k, words = min(members.reasons.items())
        raise ModelError(f"{system.name}: member {k} of {total}: {words}")
    starts = Starts(
        np.full(total, begin), _rows(members.x, total), _rows(members.v, total), _rows(members.parameters, total),
        _columns(system, inputs if by_columns is None else members.signals, total),
    )  # fmt: skip
    common = EnsembleTask(
        system.compiled, METHOD_NUMBERS[named], named, False, begin, np.inf, relative, absolute, np.empty(0), False,
        fixed_step(named, step), longest, most,
        options.choice(stabilisation, options.STABILISATIONS, "stabilisation"),
        options.least_norm_of(dependent_constraints),
    )  # fmt: skip
    return Steppers(common, total, _threads(workers), starts)


def _whole(argument: object, what: str) -> int:
    if isinstance(argument, bool | np.bool_) or not isinstance(argument, int | np.integer) or argument < 1:
        raise ModelError(f"{what} is {shown(argument)}, but must be a whole number of at least 1")
    return int(argument)


def _threads(workers: int | None) -> int:
    return cores() if workers is None else _whole(workers, "workers")


def _count(count: int | None, members: int, inputs: Any) -> int:
    """Return K, from the argument `count` or from the lengths of arrays."""
    rows = 1 if inputs is None or is_named(inputs) or np.ndim(inputs) < 2 else len(inputs)
    if rows > 1 and members not in (1, rows):
        raise ModelError(f"inputs has {rows} rows, but other arrays have {members}")
    total = max(members, rows)
    if count is None:
        return total
    if total not in (1, _whole(count, "the number of steppers")):
        raise ModelError(f"{count} steppers, but arrays of {total}")
    return int(count)


def _rows(table: Vector, count: int) -> Vector:
    return np.ascontiguousarray(np.broadcast_to(table, (count, table.shape[1])))


def _columns(system: CompiledSystem, argument: Any, count: int) -> Vector:
    """Return inputs (K, n_inputs). Signals are not allowed, because each `advance` may set the inputs."""
    names = system.compiled.inputs
    u = np.tile(system.compiled.input_defaults, (count, 1))
    if not isinstance(argument, tuple):
        return u if argument is None else columns(argument, names, u)
    for k, (name, column) in enumerate(zip(names, argument, strict=True)):
        if not isinstance(column, float | np.ndarray):
            raise ModelError(
                f"{system.name}: input {name!r} of steppers is a number for each member, which `advance` sets; "
                "simulate and stepper take signals, and a controller (Sampled) is called between two advances"
            )
        u[:, k] = column
    return u
