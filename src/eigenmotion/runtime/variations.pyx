# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Variational equations: derivatives of a motion with respect to its start, parameters and inputs.

At one state, and integrated along the rows of a run (em_variations.h).
"""

from cpython.exc cimport PyErr_CheckSignals
from libc.math cimport NAN
from libc.stdlib cimport calloc, free
from libc.string cimport memcpy

from .abi cimport em_fault, em_model, em_pile, em_run, em_signal, em_signal_kind
from .arrays cimport Numbers, floats, zeros
from .point cimport PointModel, Prepared
from .run cimport Run

import numpy as np

from .status.stop_reasons import EvaluationError, StopReason


cdef extern from "sensitivity/em_variations.h" nogil:
    const int EM_VARIATION_NODES

    ctypedef struct em_variations:
        const em_model *model
        const em_run *run
        const double *c
        const em_signal *inputs
        int columns
        int least_norm
        int stabilise
        int n_forcing
        double direction
        double tolerance
        double initial_steps
        size_t n_stops
        size_t n_marks
        size_t n_spans
        size_t n_rows
        const double *t
        const double *z
        const double *P
        const long *spans
        const long *mark_stop
        const int *mark_event
        # "from" is a keyword of Python
        const double *start "from"
        const double *to
        const double *place
        const double *A
        const double *A2
        const double *series
        const double *t_rows
        double *S
        double *dt
        double *rows
        size_t n_steps
        size_t n_refused
        size_t n_own_motion
        int (*poll)(void *) noexcept nogil
        void *poll_argument
        em_fault fault
        int why
        double t_reached

    int em_integrate_variations(em_variations *)


_REASONS = tuple(StopReason)
_END_MESSAGES = (
    "", "{} and {} act at once, and which of them is first depends on what is varied",
    "{} only touches zero, so that whether it happens depends on what is varied",
    "the directions went through other events than the run",
    "a condition in the time changes at the start, or at once with another or with an event, and their times change apart "
    "with what is varied",
    "constraint rows jump",
    "a force jumps where {} and {} happen at once, whose times change apart: with which of them it does not show",
    "a force jumps",
    "forces change faster than steps can follow",
)  # of em_variation_pass.h


cdef int poll(void *argument) noexcept with gil:
    try:
        PyErr_CheckSignals()
    except BaseException:
        return 1
    return 0


# --- derivatives with respect to the arguments (n_arguments): x, v, inputs, parameters, time ---


def motion_derivatives(PointModel model not None, double t, x, v, Prepared c not None, u, int least_norm):
    """a (n), lambda (m), da (n, n_arguments), dlambda (m, n_arguments)."""
    cdef em_fault fault
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v"), s = floats(u, (model.n_inputs,), "inputs")
    cdef Numbers a = zeros((model.n,)), multipliers = zeros((model.m,))
    cdef Numbers da = zeros((model.n, model.n_arguments)), dm = zeros((model.m, model.n_arguments))
    model.need_derivatives()
    if model.model.motion_derivatives(t, q.data, w.data, c.c, s.data, least_norm, a.data, multipliers.data, da.data,
                                      dm.data, &fault) != 0:
        raise model.failure(&fault)
    return a.array, multipliers.array, da.array, dm.array


def equation_partials(PointModel model not None, double t, x, v, a, multipliers, Prepared c not None, u):
    """(n + m, n_arguments), of r = M a + P^T (lambda, rho) - bias and s = A a + gamma, at fixed a (n), lambda (m).

    Raises RuntimeError if the model has no derivatives: it was written by hand.
    """
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v"), s = floats(u, (model.n_inputs,), "inputs")
    cdef Numbers b = floats(a, (model.n,), "a"), r = floats(multipliers, (model.m,), "multipliers")
    cdef Numbers D = zeros((model.n + model.m, model.n_arguments))
    model.need_derivatives()
    if model.model.equation_partials == NULL:
        raise RuntimeError(f"{model.name} was written by hand and has no derivatives of its equations")
    model.model.equation_partials(t, q.data, w.data, b.data, r.data, c.c, s.data, D.data)
    return D.array


def reaction_rows(PointModel model not None, double t, x, v, Prepared c not None, u):
    """P (m + norms, n), along whose rows lambda and norms of it act as forces, and (norms, m), 1 for the lambda of each.

    Without friction that is proportional to multipliers, P is A.
    """
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v"), s = floats(u, (model.n_inputs,), "inputs")
    cdef int k, norms = model.model.n_normals
    cdef Numbers P = zeros((model.m + norms, model.n)), among = zeros((norms, model.m))
    for k in range(norms * model.m):
        among.data[k] = model.model.normals[k]
    if model.pushes:
        model.model.pushes(t, q.data, w.data, c.c, s.data, P.data)
        return P.array, among.array
    return model.pfaffian(t, x, c)[0], among.array


def levels(PointModel model not None, double t, x, v, Prepared c not None, u):
    """(n_switches, 2): the limits of frictions that slide and that stick, over the normal force of those that have one."""
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v"), s = floats(u, (model.n_inputs,), "inputs")
    cdef Numbers made = zeros((model.model.n_switches, 2))
    if model.model.n_switches > 0:
        model.model.levels(t, q.data, w.data, c.c, s.data, made.data)
    return made.array


def input_columns(PointModel model not None, double t, x, v, a, Prepared c not None, u):
    """B (n, n_inputs): df / du."""
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v"), s = floats(u, (model.n_inputs,), "inputs")
    cdef Numbers b = floats(a, (model.n,), "a"), B = zeros((model.n, model.n_inputs))
    if model.n_inputs > 0:
        model.model.input_columns(t, q.data, w.data, b.data, c.c, s.data, B.data)
    return B.array


def constraint_partials(PointModel model not None, double t, x, v, Prepared c not None):
    """(h + m, n_arguments), of phi and of A v + b."""
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v")
    cdef Numbers D = zeros((model.h + model.m, model.n_arguments))
    model.need_derivatives()
    if model.model.constraint_partials != NULL:
        model.model.constraint_partials(t, q.data, w.data, c.c, D.data)
    return D.array


def output_partials(PointModel model not None, double t, x, v, a, multipliers, Prepared c not None, u):
    """(n_outputs, n + m + n_arguments), first with respect to a and lambda."""
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v"), s = floats(u, (model.n_inputs,), "inputs")
    cdef Numbers b = floats(a, (model.n,), "a"), r = floats(multipliers, (model.m,), "multipliers")
    cdef Numbers D = zeros((model.n_outputs, model.n + model.m + model.n_arguments))
    model.need_derivatives()
    if model.model.output_partials != NULL:
        model.model.output_partials(t, q.data, w.data, b.data, r.data, c.c, s.data, D.data)
    return D.array


def quasi_partials(PointModel model not None, double t, x, v, Prepared c not None):
    """(n_quasi, n_arguments), of P(x, t) v."""
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v")
    cdef Numbers D = zeros((len(model.quasi_velocities), model.n_arguments))
    model.need_derivatives()
    if model.model.quasi_partials != NULL:
        model.model.quasi_partials(t, q.data, w.data, c.c, D.data)
    return D.array


# --- along a motion ---


def tangent(PointModel model not None, double t, x, v, Prepared c not None, int least_norm, S, P):
    """S (2 n, columns), projected onto the directions along which the constraints stay satisfied."""
    cdef em_fault fault
    cdef int columns = S.shape[1]
    cdef Numbers q = floats(x, (model.n,), "x"), w = floats(v, (model.n,), "v")
    cdef Numbers made = floats(np.array(S, dtype=np.float64, order="C"), (2 * model.n, columns), "S")
    cdef Numbers rest = floats(P, (model.n_arguments - 2 * model.n, columns), "P")
    model.need_derivatives()
    if model.model.tangent != NULL and model.model.tangent(t, q.data, w.data, c.c, least_norm, columns, made.data,
                                                           rest.data, &fault) != 0:
        raise model.failure(&fault)
    return made.array


def act_along(PointModel model not None, double t, x, v, Prepared c not None, u, int least_norm, fired, S, P):
    """Event actions with their saltation matrix.

    Returns x, v and Prepared after the events `fired` (n_events) at t, and S (2 n, columns) after them.
    """
    cdef em_fault fault
    cdef Prepared after
    cdef int columns = S.shape[1]
    cdef Numbers q = floats(np.array(x, dtype=np.float64), (model.n,), "x")
    cdef Numbers w = floats(np.array(v, dtype=np.float64), (model.n,), "v")
    cdef Numbers s = floats(u, (model.n_inputs,), "inputs"), pile = zeros((model.n_events, 2))
    cdef Numbers made = floats(np.array(S, dtype=np.float64, order="C"), (2 * model.n, columns), "S")
    cdef Numbers rest = floats(P, (model.n_arguments - 2 * model.n, columns), "P")
    cdef int[::1] jumps = np.array(fired, dtype=np.intc)
    model.need_derivatives()
    after = model.prepare(np.array(c.parameters, dtype=np.float64))
    memcpy(after.c, c.c, model.model.n_prepared * sizeof(double))
    if model.model.act_along(t, q.data, w.data, after.c, s.data, least_norm, &jumps[0], <em_pile *> pile.data,
                             columns, made.data, rest.data, &fault) != 0:
        raise model.failure(&fault)
    after.parameters = tuple([after.c[j] for j in range(model.model.n_parameters)])
    return q.array, w.array, after, made.array


def vary(PointModel model not None, Prepared c not None, Run run, tuple inputs, double direction, double tolerance,
         double together, stops, spans, marks, nodes, rows, S, P, bint stabilise, int least_norm):
    """Integrate directions S (2 n, columns) from the first of `stops` along a run with dense output (em_variations.h).

    run : None if there is nothing to integrate between the stops
    tolerance : relative error of a step; together : initial length of a step, in steps of the run
    stops : t (stops,), z (stops, 2 n), number of spans after each (stops,); spans : from, to (spans,); marks : stop, event
    (marks,); nodes : place (nodes,), A, A^2, series (nodes, nodes); rows : (k,) times

    Returns S (stops, 2 n, columns), dt (marks, columns), S (k, 2 n, columns) at the rows within spans, all NaN where the
    integration did not reach; the numbers of steps accepted, rejected, and integrated with a motion of their own; an
    EvaluationError if it ended early, or None.
    """
    cdef em_variations pass_
    cdef Py_ssize_t k = len(stops[0]), n_spans = len(spans[0]), n_marks = len(marks[0]), n = model.n
    cdef Py_ssize_t n_nodes = EM_VARIATION_NODES, j
    cdef int columns = S.shape[1], status
    cdef Numbers T = floats(stops[0], (k,), "t"), Z = floats(stops[1], (k, 2 * n), "z")
    cdef Numbers start = floats(spans[0], (n_spans,), "from"), to = floats(spans[1], (n_spans,), "to")
    cdef Numbers place = floats(nodes[0], (n_nodes,), "place"), series = floats(nodes[3], (n_nodes, n_nodes), "series")
    cdef Numbers A = floats(nodes[1], (n_nodes, n_nodes), "A"), A2 = floats(nodes[2], (n_nodes, n_nodes), "A2")
    cdef Numbers rest = floats(P, (model.n_arguments - 2 * n, columns), "P"), t_rows = floats(rows, (len(rows),), "rows")
    cdef Numbers at_stops = _unknown(k, 2 * n, columns), shifts = _unknown(n_marks, columns)
    cdef Numbers at_rows = _unknown(len(rows), 2 * n, columns)
    cdef long[::1] follow = _whole(stops[2], np.int_), at = _whole(marks[0], np.int_)
    cdef int[::1] happens = _whole(marks[1], np.intc)
    cdef em_signal *signals
    cdef list keep_alive = []
    model.need_derivatives()
    signals = <em_signal *> calloc(len(inputs) + 1, sizeof(em_signal))
    if signals == NULL:
        raise MemoryError
    at_stops.array[0] = S
    try:
        for j, (kind, times, values) in enumerate(inputs):
            keep_alive.append((floats(times, (len(times),), "times"), floats(values, (len(values),), "values")))
            signals[j].kind, signals[j].count = <em_signal_kind> (<int> kind), len(times)
            signals[j].times, signals[j].values = (<Numbers> keep_alive[j][0]).data, (<Numbers> keep_alive[j][1]).data
        pass_.model, pass_.c, pass_.inputs, pass_.columns = model.model, c.c, signals, columns
        pass_.run = NULL if run is None else &run.run
        pass_.tolerance, pass_.initial_steps = tolerance, together
        pass_.least_norm, pass_.stabilise, pass_.direction = least_norm, stabilise, direction
        pass_.n_forcing = model.n_arguments - 2 * n
        pass_.n_stops, pass_.t, pass_.z, pass_.spans = k, T.data, Z.data, &follow[0]
        pass_.n_spans, pass_.start, pass_.to = n_spans, start.data, to.data
        pass_.n_marks, pass_.mark_stop, pass_.mark_event, pass_.dt = n_marks, &at[0], &happens[0], shifts.data
        pass_.place, pass_.A, pass_.A2, pass_.series, pass_.P = place.data, A.data, A2.data, series.data, rest.data
        pass_.S, pass_.n_rows, pass_.t_rows, pass_.rows = at_stops.data, len(rows), t_rows.data, at_rows.data
        pass_.n_steps = pass_.n_refused = pass_.n_own_motion = 0
        pass_.poll, pass_.poll_argument, pass_.t_reached = poll, NULL, T.data[0]
        with nogil:
            status = em_integrate_variations(&pass_)
    finally:
        free(signals)
    if status != 0 and _REASONS[<int> pass_.fault.status] is StopReason.INTERRUPTED:
        raise KeyboardInterrupt
    error = None if status == 0 else model.failure(&pass_.fault)
    if status != 0 and pass_.why:
        words = _END_MESSAGES[pass_.why].format(*(repr(model.events[k]) for k in (pass_.fault.first, pass_.fault.second) if k >= 0))
        error = EvaluationError(f"{model.name}: {words} at about t = {pass_.t_reached:.9g}", StopReason.NON_FINITE_STATE)
    return at_stops.array, shifts.array, at_rows.array, (pass_.n_steps, pass_.n_refused, pass_.n_own_motion), error


def _unknown(*shape):
    cdef Numbers made = zeros(shape)
    made.array.fill(NAN)
    return made


def _whole(numbers, kind):
    """Integers as an array with one extra entry, so that it is never empty."""
    padded = np.zeros(len(numbers) + 1, dtype=kind)
    padded[:len(numbers)] = numbers
    return padded
