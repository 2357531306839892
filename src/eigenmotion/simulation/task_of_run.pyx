# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""The task of a run, from the arguments of `simulate`.

Compiled, because a short run takes no longer than its arguments.
"""

from libc.math cimport fabs

from ..arguments.options cimport checked_atol, choice, least_norm_of, real_of, rows_at, span, step_limits
from ..compiled.at_state cimport constants, motion
from ..runtime.abi cimport EM_REFUSED, EM_SHARED_FROM_START
from ..runtime.arrays cimport Numbers, floats, zeros
from ..runtime.point cimport PointModel, Prepared

from ..arguments.options import STABILISATIONS
from ..arguments.prescribed import covering
from ..arguments.tasks import Task
from ..codegen.model.normalise import ModelError, truth
from ..runtime import EvaluationError
from .initial_state.consistency import start_state
from .initial_state.restart import restart_state

cdef object _new = tuple.__new__  # faster than Task(*fields)


def task_of_run(system, PointModel model not None, t_span, x0, v0, argument, parameters, inputs, rtol, atol, t_eval,
                dense_output, first_step, max_step, max_steps, stabilisation, dependent_constraints):
    """Return the task, and the rows whose multipliers are not unique; `argument` is `start` of simulate.

    Raises
    ------
    ModelError
        Names an argument that is invalid, or why no motion starts at x0, v0.
    """
    cdef double start, end, relative, first, longest
    cdef long long most
    cdef Prepared prepared
    cdef Numbers absolute
    cdef int least_norm
    cdef tuple shared = ()
    start, end = span(t_span)
    relative = real_of(rtol, "rtol")
    absolute = checked_atol(model, relative, atol)
    first, longest, most = step_limits(first_step, max_step, max_steps, fabs(end - start))
    prepared, signals = constants_and_inputs(system, model, parameters, inputs, start, end)
    y = initial_state(system, model, prepared, start, x0, v0, argument, relative, absolute)
    stabilise, times = choice(stabilisation, STABILISATIONS, "stabilisation"), rows_at(t_eval, start, end)
    dense = dense_output if type(dense_output) is bool else truth(dense_output, "dense_output")
    least_norm = least_norm_of(dependent_constraints)
    if least_norm != EM_REFUSED and model.m > 0:
        depend, shared = model.redundant_rows(start, floats(y, (model.n_state,), "y").data, prepared)
        if not depend and least_norm == EM_SHARED_FROM_START and not model.has_cones:
            least_norm = EM_REFUSED
    fields = (model, prepared, signals, start, end, y, relative, absolute.array, times, dense, first, longest, most, stabilise,
              least_norm)
    return _new(Task, fields), shared


cdef initial_state(object system, PointModel model, Prepared prepared, double t, object x0, object v0, object argument,
                   double rtol, Numbers atol):
    """The initial y (n_state,): at x0, v0, or at the end of another run."""
    cdef Numbers q, w, y
    if argument is None:
        q, w = motion(system, model, prepared, x0, v0, t, None)
        y = zeros((model.n_state,))
        if not model.extrapolates and model.starts(t, q, w, prepared, rtol, atol, y):
            return y.array
        return start_state(model, prepared, t, q.array, w.array, rtol, atol.array)  # checks more, and names what is wrong
    if not (x0 is None and v0 is None):
        raise ModelError("start= says where the run begins, and so do x0 and v0: give one of them")
    at, state = restart_state(model, prepared, argument, rtol, atol.array)
    if at != t:
        raise ModelError(f"start is a state at t = {at!r}, but t_span begins at {t!r}")
    return state


cdef tuple constants_and_inputs(object system, PointModel model, object parameters, object inputs, double start,
                                double end):
    """The constants of the parameters and of prescribed motions, and the other inputs, which cover the span."""
    try:
        if inputs is None and not model.prescribed:
            return constants(system, model, system._defaults, parameters), system._inputs
        if inputs is not None:
            inputs = covering(model, inputs, start, end)
        prepared, inputs = system.prepare_both(parameters, inputs)
    except EvaluationError as error:
        raise ModelError(str(error)) from error
    bound = system.bind(inputs)
    if inputs is not None and (gap := bound.uncovered(start, end)) is not None:
        name = tuple(system.inputs)[gap[0]]
        raise ModelError(f"{system.name}: input {name!r} {gap[1]}, which does not cover t_span ({start:g}, {end:g})")
    return prepared, bound
