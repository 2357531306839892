"""Simulation: options of a run, their checks, and the solution."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, Never

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.differentiation import differentiated
from ..arguments.methods import AUTO, METHODS, Method, method_of
from ..arguments.named_values import Vector, unknown
from ..arguments.options import SCIPY_OPTIONS, OptionError, is_system, no_system
from ..arguments.tasks import TO_DERIVE, Task
from ..codegen.model.normalise import ModelError, shown
from ..compiled.compiled_system import CompiledSystem
from ..results.multiplier_uniqueness import with_shared
from ..results.solution import DenseOutput, Solution
from ..runtime import CompiledModel
from .compiled_run import run_compiled
from .error_estimate import with_error_estimate
from .initial_state.consistency import check_direction
from .method_selection import automatic_of_run, other_than
from .sampled_inputs import check_forwards
from .sensitivity.sensitivities import directions, sensitivity
from .task_of_run import task_of_run

NAMES = {name: name for name in (*METHODS, AUTO)}
_OPTIONS = (
    *("x0", "v0", "start", "parameters", "inputs", "method", "rtol", "atol", "t_eval", "dense_output"),
    *("first_step", "max_step", "max_steps", "stabilisation", "dependent_constraints", "estimate_error"),
    "sensitivities",
)


def simulate(
    system: CompiledSystem,
    t_span: tuple[float, float],
    *positional: Never,
    x0: Mapping[Any, float] | ArrayLike | None = None,
    v0: Mapping[Any, float] | ArrayLike | None = None,
    start: Any = None,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | None = None,
    method: str = "dop853",
    rtol: float = 1e-6,
    atol: float | Mapping[Any, float] | ArrayLike = 1e-9,
    t_eval: ArrayLike | None = None,
    dense_output: bool = False,
    first_step: float | None = None,
    max_step: float = np.inf,
    max_steps: int = 1_000_000,
    stabilisation: str = "project",
    dependent_constraints: str = "auto",
    estimate_error: bool | CompiledSystem = False,
    sensitivities: Sequence[Any] | None = None,
    **misspelt: Any,
) -> Solution:
    """Integrate the motion from t_span[0] to t_span[1], forwards or backwards.

    Parameters
    ----------
    x0, v0
        (n,), or mapping coordinate -> value over the model's `initial`; v0 also quasi-velocity -> value. They must
        satisfy the constraints (to ten times rtol); `System.project_initial_state` gives the nearest that do.
    start
        In place of x0 and v0: a Solution, to continue from its end, or a pair (t, y); t is t_span[0].
    parameters
        Mapping name -> value over the defaults, array, or what `System.prepare` returned.
    inputs
        Mapping name -> number, (times, values) (linear interpolation), Signal, or Sampled (a controller that is called
        every period); or a tuple of names -> a Sampled for all of them. An exception of a controller is passed on, with
        the motion so far as its attribute `solution`.
    method
        "rk34", "dopri5", "dop853": Runge-Kutta. "ra15": eight Radau nodes in parallel, order 15, often the fastest for
        smooth motions and tight tolerances. "radau5", "radau9": implicit, for stiff scenes, Radau IIA of orders 5 and 9
        on the motion (x, v). "auto": begins with "dop853" or "ra15", depending on tolerance, formulation and processor,
        and changes to "radau9" and back during the run where that costs less (`Solution.methods`, docs/stiff.md). All
        are compiled; upper or lower case. For solvers of SciPy and SUNDIALS use `System.rhs` and `System.jacobian`.
    rtol, atol
        The error of a step in x_k and v_k is below atol_k + rtol |.|. atol: a number, or a mapping coordinate -> number
        (also for the velocity; 1e-9 for others).
    t_eval
        (k,) times of the rows, sorted in the direction of time; None: one row for every accepted step.
    dense_output
        Keep y(t) as the function `Solution.sol`.
    first_step, max_step
        [s]; by default chosen automatically, and unbounded.
    max_steps
        Accepted steps after which the run ends as TOO_MANY_STEPS, in every method. A million rows of 20 states are
        160 MB.
    stabilisation
        "project": constraints and eigenfactors are restored after every step. "none": as in the paper.
    dependent_constraints
        "auto": rows that depend on each other from the start, and are consistent, get the multipliers of least norm,
        and `Solution.not_unique` lists them. "least_norm": so do rows that become dependent later. "refuse": an error
        in both cases.
    estimate_error
        True: run again with a hundredth of the tolerances or less; the solution's `error_estimate` is the difference,
        and `error_cost` the cost, about twice the time of a run by dop853. A System (the same model in another
        formulation): use it for the second run, which shows errors of a formulation, too.
    sensitivities
        Names of parameters ("K1"), constant inputs, initial positions ("theta1") and rates ("theta1'"), or
        quasi-velocities: `Solution.sensitivity[name]` has `dx`, `dv` (n, k), the exact derivatives of the rows. The
        derivatives of the start satisfy the constraints. Events are included, with derivatives `dt_events` of their
        times.

    Returns
    -------
    Solution
        The motion, also if the run failed or Ctrl-C ended it: see `success`, `stop` and `message`.

    Raises
    ------
    ModelError
        Before the run: an unknown name or option, a value out of range, or an inconsistent start.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> sol = em.simulate(em.build(model), (0.0, 1.0), x0={"theta": 1.0}, t_eval=[0.0, 0.5, 1.0], rtol=1e-9)
    >>> sol.x.round(6)
    array([[ 1.      ,  0.104258, -0.980067]])
    """
    compiled = getattr(system, "compiled", None)
    if positional or misspelt or not isinstance(compiled, CompiledModel):
        raise refused("simulate", system, positional, misspelt, _OPTIONS)
    named = method if type(method) is str and method in METHODS else method_of(method, NAMES)
    task, shared = task_of_run(
        system, compiled, t_span, x0, v0, start, parameters, inputs, rtol, atol, t_eval, dense_output, first_step,
        max_step, max_steps, stabilisation, dependent_constraints,
    )  # fmt: skip
    return _run(task, named, shared, v0, estimate_error, sensitivities)


def _run(
    task: Task,
    named: str,
    shared: tuple[int, ...],
    v0: Any,
    estimate_error: bool | CompiledSystem,
    sensitivities: Any,
) -> Solution:
    """Run a task by the method of that name, with the requested error estimate and sensitivities.

    shared : the constraint rows whose multipliers are not unique
    """
    chosen = automatic_of_run(task) if named == AUTO else METHODS[named]
    run = run_changing if named == AUTO else run_task
    if task.inputs.sampled:
        _check_sampled(task, estimate_error)
    if task.t_end < task.t_start:
        check_direction(task.model, task.t_start, task.t_end)
    variables = None
    if sensitivities is not None:
        variables = directions(differentiated(task.model, sensitivities, v0), task)
        dense, task = task.dense, task._replace(dense=task.dense or TO_DERIVE)
    if estimate_error is False:
        solution = run(task, chosen)
    else:
        checker = None if estimate_error is True else _checker(estimate_error)
        solution = with_error_estimate(task, chosen, checker, run)
    if shared:
        solution["not_unique"] = shared
        solution["message"] = with_shared(solution["message"], task.model, shared)
    if variables is not None:
        solution["sensitivity"] = sensitivity(task, solution, variables, chosen)
        solution["sol"] = solution["sol"] if dense else None
    return solution


def refused(
    call: str, system: object, positional: tuple[object, ...], misspelt: Mapping[str, object], known: tuple[str, ...]
) -> OptionError:
    """Return an error for unknown or missing arguments that suggests the right option; `known` are the options."""
    if not is_system(system):
        return no_system(call, system, ", t_span")
    if positional:
        words = ", ".join(f"{name}={shown(value)}" for name, value in zip(known, positional, strict=False))
        return OptionError(f"{call}: everything after t_span is given by keyword; did you mean {words}?")
    return OptionError(f"{call}: {unknown('option', misspelt, known, SCIPY_OPTIONS)}")


def _checker(argument: Any) -> CompiledModel:
    if not is_system(argument):
        raise OptionError(f"estimate_error is {shown(argument)}; give True, False, or a System in another formulation")
    checker: CompiledModel = argument.compiled
    return checker


def run_changing(task: Task, method: Method) -> Solution:
    """Run a checked task by a method that is kept only where it costs less than another."""
    return run_task(task, method, other_than(method))


def run_task(task: Task, method: Method, other: Method | None = None) -> Solution:
    """Run a checked task; `other` is the method to which the run may change."""
    result = run_compiled(task, method, other)
    if task.dense and task.t_start == task.t_end and result.success and len(result.t):
        row = result.y.T[:1]  # there are no steps to interpolate in
        result["sol"] = DenseOutput(result.t, partial(_standing, row))
    return result


def _standing(row: Vector, t: Vector) -> Vector:
    """Return the single row (1, n_state), repeated for every t (k,)."""
    return np.repeat(row, len(t), axis=0)


def _check_sampled(task: Task, estimate_error: Any) -> None:
    """Raise ModelError for runs in which controllers cannot be called."""
    check_forwards(task.t_start, task.t_end)
    if estimate_error is not False:
        raise ModelError(
            "estimate_error asks a controller twice, at states that differ: run without it, and then again with the "
            "inputs that the solution has held"
        )
