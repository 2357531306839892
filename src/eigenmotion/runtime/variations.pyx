# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""How a compiled motion changes with what it starts from and what it is given: at one place, and along the rows of a
run (em_variations.h)."""

from cpython.exc cimport PyErr_CheckSignals
from libc.stdlib cimport calloc, free
from libc.string cimport memcpy

from .abi cimport em_fault, em_model, em_pile, em_signal, em_signal_kind
from .arrays cimport Numbers, given, zeros
from .point cimport PointModel, Prepared

import numpy as np

from .faults import EvaluationError, StopReason, explain


cdef extern from "em_variations.h" nogil:
    ctypedef struct em_variations:
        const em_model *model
        const double *c
        const em_signal *inputs
        int columns
        int least_norm
        int stabilise
        int n_given
        double rtol
        const double *atol
        const double *size
        long max_steps
        size_t n_rows
        size_t n_marks
        const double *t
        const double *z
        const double *P
        const long *mark_row
        const int *mark_event
        double *S
        double *dt
        int (*poll)(void *) noexcept nogil
        void *poll_argument
        em_fault fault
        int why
        double t_reached
        long n_rhs
        long n_steps

    int em_vary(em_variations *)


_REASONS = tuple(StopReason)
_ENDS = (
    "", "a force jumps", "{} and {} act at once, and which of them is first depends on what is varied",
    "{} only touches zero, so that whether it happens depends on what is varied",
    "the directions went through other events than the run",
)  # of em_variation_steps.h


cdef int poll(void *argument) noexcept with gil:
    try:
        PyErr_CheckSignals()
    except BaseException:
        return 1
    return 0


# --- derivatives by the arguments (n_arguments): x, v, inputs, parameters, time ---


def motion_derivatives(PointModel model not None, double t, x, v, Prepared c not None, u, bint least_norm):
    """a (n), lambda (m), da (n, n_arguments), dlambda (m, n_arguments)."""
    cdef em_fault fault
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v"), s = given(u, (model.n_inputs,), "inputs")
    cdef Numbers a = zeros((model.n,)), multipliers = zeros((model.m,))
    cdef Numbers da = zeros((model.n, model.n_arguments)), dm = zeros((model.m, model.n_arguments))
    if model.model.motion_derivatives == NULL:
        raise ValueError(f"{model.name} states no derivatives")
    if model.model.motion_derivatives(t, q.data, w.data, c.c, s.data, least_norm, a.data, multipliers.data, da.data,
                                      dm.data, &fault) != 0:
        raise model.failure(&fault)
    return a.array, multipliers.array, da.array, dm.array


def constraint_partials(PointModel model not None, double t, x, v, Prepared c not None):
    """(h + m, n_arguments), of phi and of A v + b."""
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v")
    cdef Numbers D = zeros((model.h + model.m, model.n_arguments))
    if model.model.constraint_partials != NULL:
        model.model.constraint_partials(t, q.data, w.data, c.c, D.data)
    return D.array


def output_partials(PointModel model not None, double t, x, v, a, multipliers, Prepared c not None, u):
    """(n_outputs, n + m + n_arguments), first by a and lambda."""
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v"), s = given(u, (model.n_inputs,), "inputs")
    cdef Numbers b = given(a, (model.n,), "a"), r = given(multipliers, (model.m,), "multipliers")
    cdef Numbers D = zeros((model.n_outputs, model.n + model.m + model.n_arguments))
    if model.model.output_partials != NULL:
        model.model.output_partials(t, q.data, w.data, b.data, r.data, c.c, s.data, D.data)
    return D.array


def event_partials(PointModel model not None, double t, x, v, Prepared c not None, u):
    """(n_events, n_arguments)."""
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v"), s = given(u, (model.n_inputs,), "inputs")
    cdef Numbers D = zeros((model.n_events, model.n_arguments))
    if model.model.event_partials != NULL:
        model.model.event_partials(t, q.data, w.data, c.c, s.data, D.data)
    return D.array


def quasi_partials(PointModel model not None, double t, x, v, Prepared c not None):
    """(n_quasi, n_arguments), of P(x, t) v."""
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v")
    cdef Numbers D = zeros((len(model.quasi_velocities), model.n_arguments))
    if model.model.quasi_partials != NULL:
        model.model.quasi_partials(t, q.data, w.data, c.c, D.data)
    return D.array


# --- along a motion ---


def tangent(PointModel model not None, double t, x, v, Prepared c not None, bint least_norm, S, P):
    """S (2 n, columns): the nearest directions along which the constraints stay satisfied."""
    cdef em_fault fault
    cdef int columns = S.shape[1]
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v")
    cdef Numbers made = given(np.array(S, dtype=np.float64, order="C"), (2 * model.n, columns), "S")
    cdef Numbers rest = given(P, (model.n_arguments - 2 * model.n, columns), "P")
    if model.model.tangent != NULL and model.model.tangent(t, q.data, w.data, c.c, least_norm, columns, made.data,
                                                           rest.data, &fault) != 0:
        raise model.failure(&fault)
    return made.array


def act_along(PointModel model not None, double t, x, v, Prepared c not None, u, bint least_norm, fired, S, P):
    """S (2 n, columns) after the events `fired` (n_events) at t, of directions S, P as they happen."""
    cdef em_fault fault
    cdef int columns = S.shape[1]
    cdef Numbers q = given(np.array(x, dtype=np.float64), (model.n,), "x")
    cdef Numbers w = given(np.array(v, dtype=np.float64), (model.n,), "v")
    cdef Numbers s = given(u, (model.n_inputs,), "inputs"), pile = zeros((model.n_events, 2))
    cdef Numbers made = given(np.array(S, dtype=np.float64, order="C"), (2 * model.n, columns), "S")
    cdef Numbers rest = given(P, (model.n_arguments - 2 * model.n, columns), "P")
    cdef Numbers constants = zeros((model.model.n_prepared + 1,))
    cdef int[::1] jumps = np.array(fired, dtype=np.intc)
    memcpy(constants.data, c.c, model.model.n_prepared * sizeof(double))
    if model.model.act_along(t, q.data, w.data, constants.data, s.data, least_norm, &jumps[0], <em_pile *> pile.data,
                             columns, made.data, rest.data, &fault) != 0:
        raise model.failure(&fault)
    return made.array


def vary(PointModel model not None, Prepared c not None, tuple inputs, t, z, mark_row, mark_event, S, P, size,
         double rtol, atol, long max_steps, bint stabilise, bint least_norm):
    """S (k, 2 n, columns) at the rows t (k,), z (k, 2 n), from S (2 n, columns) at the first, and dt (marks, columns),
    how the times of events change: events mark_event happen at rows mark_row; where some act, the next row is what they
    make of that one. NaN where a pass did not get; and what ended it, None where nothing did; steps, evaluations."""
    cdef em_variations pass_
    cdef Py_ssize_t k = len(t), j
    cdef int columns = S.shape[1], status
    cdef Numbers T = given(t, (k,), "t"), Z = given(z, (k, 2 * model.n), "z")
    cdef Numbers rest = given(P, (model.n_arguments - 2 * model.n, columns), "P")
    cdef Numbers made = given(np.full((k, 2 * model.n, columns), np.nan), (k, 2 * model.n, columns), "S")
    cdef Numbers sizes = given(size, (columns,), "size"), absolute = given(atol, (model.n,), "atol")
    cdef Py_ssize_t marks = len(mark_row)
    cdef long[::1] at = np.append(mark_row, -1).astype(np.int_)
    cdef int[::1] happens = np.append(mark_event, -1).astype(np.intc)
    cdef Numbers shifts = given(np.full((marks, columns), np.nan), (marks, columns), "dt")
    cdef em_signal *signals = <em_signal *> calloc(len(inputs) + 1, sizeof(em_signal))
    cdef list held = []
    if signals == NULL:
        raise MemoryError
    made.array[0] = S
    try:
        for j, (kind, times, values) in enumerate(inputs):
            held.append((given(times, (len(times),), "times"), given(values, (len(values),), "values")))
            signals[j].kind, signals[j].count = <em_signal_kind> (<int> kind), len(times)
            signals[j].times, signals[j].values = (<Numbers> held[j][0]).data, (<Numbers> held[j][1]).data
        pass_.model, pass_.c, pass_.inputs, pass_.columns = model.model, c.c, signals, columns
        pass_.least_norm, pass_.stabilise, pass_.rtol, pass_.n_rows = least_norm, stabilise, rtol, k
        pass_.atol, pass_.size, pass_.max_steps = absolute.data, sizes.data, max_steps
        pass_.n_given = model.n_arguments - 2 * model.n
        pass_.t, pass_.z, pass_.P, pass_.S = T.data, Z.data, rest.data, made.data
        pass_.n_marks, pass_.mark_row, pass_.mark_event, pass_.dt = marks, &at[0], &happens[0], shifts.data
        pass_.poll, pass_.poll_argument, pass_.n_rhs, pass_.n_steps = poll, NULL, 0, 0
        pass_.t_reached = T.data[0]
        with nogil:
            status = em_vary(&pass_)
    finally:
        free(signals)
    if status == 0:
        return made.array, shifts.array, None, pass_.n_steps, pass_.n_rhs
    if _REASONS[<int> pass_.fault.status] is StopReason.INTERRUPTED:
        raise KeyboardInterrupt
    said = model.failure(&pass_.fault)
    if pass_.why:
        words = _ENDS[pass_.why].format(*(repr(model.events[k]) for k in (pass_.fault.first, pass_.fault.second) if k >= 0))
        said = EvaluationError(f"{model.name}: {words} at about t = {pass_.t_reached:.9g}", StopReason.NON_FINITE_STATE)
    return made.array, shifts.array, said, pass_.n_steps, pass_.n_rhs
