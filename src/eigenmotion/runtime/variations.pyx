# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""How a compiled motion changes with what it starts from and what it is given: at one place, and along the rows of a
run (em_variations.h)."""

from cpython.exc cimport PyErr_CheckSignals
from libc.math cimport NAN
from libc.stdlib cimport calloc, free
from libc.string cimport memcpy

from .abi cimport em_fault, em_model, em_pile, em_signal, em_signal_kind
from .arrays cimport Numbers, given, zeros
from .point cimport PointModel, Prepared

import numpy as np

from .faults import EvaluationError, StopReason, explain


cdef extern from "em_variations.h" nogil:
    const int EM_VARIATION_NODES

    ctypedef struct em_variations:
        const em_model *model
        const double *c
        const em_signal *inputs
        int columns
        int least_norm
        int stabilise
        int n_given
        double direction
        size_t n_stops
        size_t n_marks
        size_t n_steps
        const double *t
        const double *z
        const double *P
        const long *steps
        const long *mark_stop
        const int *mark_event
        # "from" is a word of Python's
        const double *start "from"
        const double *to
        const double *nodes
        const double *place
        const double *A
        const double *A2
        double *S
        double *dt
        double *S_from
        double *K
        double *apart
        int (*poll)(void *) noexcept nogil
        void *poll_argument
        em_fault fault
        int why
        double t_reached

    int em_vary(em_variations *)


_REASONS = tuple(StopReason)
_ENDS = (
    "", "{} and {} act at once, and which of them is first depends on what is varied",
    "{} only touches zero, so that whether it happens depends on what is varied",
    "the directions went through other events than the run",
    "a condition in the time changes at the start, or at once with another or with an event, and their times change apart "
    "with what is varied",
    "constraint rows jump",
    "a force jumps where {} and {} happen at once, whose times change apart: with which of them it does not show",
)  # of em_variation_pass.h


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
    model.need_derivatives()
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
    model.need_derivatives()
    if model.model.constraint_partials != NULL:
        model.model.constraint_partials(t, q.data, w.data, c.c, D.data)
    return D.array


def output_partials(PointModel model not None, double t, x, v, a, multipliers, Prepared c not None, u):
    """(n_outputs, n + m + n_arguments), first by a and lambda."""
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v"), s = given(u, (model.n_inputs,), "inputs")
    cdef Numbers b = given(a, (model.n,), "a"), r = given(multipliers, (model.m,), "multipliers")
    cdef Numbers D = zeros((model.n_outputs, model.n + model.m + model.n_arguments))
    model.need_derivatives()
    if model.model.output_partials != NULL:
        model.model.output_partials(t, q.data, w.data, b.data, r.data, c.c, s.data, D.data)
    return D.array


def quasi_partials(PointModel model not None, double t, x, v, Prepared c not None):
    """(n_quasi, n_arguments), of P(x, t) v."""
    cdef Numbers q = given(x, (model.n,), "x"), w = given(v, (model.n,), "v")
    cdef Numbers D = zeros((len(model.quasi_velocities), model.n_arguments))
    model.need_derivatives()
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
    model.need_derivatives()
    if model.model.tangent != NULL and model.model.tangent(t, q.data, w.data, c.c, least_norm, columns, made.data,
                                                           rest.data, &fault) != 0:
        raise model.failure(&fault)
    return made.array


def act_along(PointModel model not None, double t, x, v, Prepared c not None, u, bint least_norm, fired, S, P):
    """x, v, Prepared after the events `fired` (n_events) at t, and S (2 n, columns), of directions S, P as they happen."""
    cdef em_fault fault
    cdef Prepared after
    cdef int columns = S.shape[1]
    cdef Numbers q = given(np.array(x, dtype=np.float64), (model.n,), "x")
    cdef Numbers w = given(np.array(v, dtype=np.float64), (model.n,), "v")
    cdef Numbers s = given(u, (model.n_inputs,), "inputs"), pile = zeros((model.n_events, 2))
    cdef Numbers made = given(np.array(S, dtype=np.float64, order="C"), (2 * model.n, columns), "S")
    cdef Numbers rest = given(P, (model.n_arguments - 2 * model.n, columns), "P")
    cdef int[::1] jumps = np.array(fired, dtype=np.intc)
    model.need_derivatives()
    after = model.prepare(np.array(c.parameters, dtype=np.float64))
    memcpy(after.c, c.c, model.model.n_prepared * sizeof(double))
    if model.model.act_along(t, q.data, w.data, after.c, s.data, least_norm, &jumps[0], <em_pile *> pile.data,
                             columns, made.data, rest.data, &fault) != 0:
        raise model.failure(&fault)
    after.parameters = tuple([after.c[j] for j in range(model.model.n_parameters)])
    return q.array, w.array, after, made.array


def vary(PointModel model not None, Prepared c not None, tuple inputs, double direction, stops, steps, marks, nodes, S, P,
         bint stabilise, bint least_norm, bint inside):
    """How directions S (2 n, columns) at the first of `stops` go along a motion (em_variation_steps.h).

    stops : t (stops,), z (stops, 2 n), how many steps follow each (stops,); steps : from, to (steps,), z at their nodes
    (steps, nodes, 2 n); marks : stop, event (marks,); nodes : place (nodes,), A, A^2 (nodes, nodes)

    Returns S (stops, 2 n, columns), dt (marks, columns), and of the steps S (steps, 2 n, columns) where they begin, K (steps,
    nodes, n, columns), both empty but where what is `inside` them is asked for, and how far the witness is off (steps,);
    NaN where a pass did not get; and what ended it, or None.
    """
    cdef em_variations pass_
    cdef Py_ssize_t k = len(stops[0]), made = len(steps[0]), happened = len(marks[0]), n = model.n, nodes_of = EM_VARIATION_NODES, j
    cdef int columns = S.shape[1], status
    cdef Numbers T = given(stops[0], (k,), "t"), Z = given(stops[1], (k, 2 * n), "z")
    cdef Numbers start = given(steps[0], (made,), "from"), to = given(steps[1], (made,), "to")
    cdef Numbers within = given(steps[2], (made, nodes_of, 2 * n), "nodes")
    cdef Numbers place = given(nodes[0], (nodes_of,), "place")
    cdef Numbers A = given(nodes[1], (nodes_of, nodes_of), "A"), A2 = given(nodes[2], (nodes_of, nodes_of), "A2")
    cdef Numbers rest = given(P, (model.n_arguments - 2 * n, columns), "P")
    cdef Numbers at_stops = _unknown(k, 2 * n, columns), shifts = _unknown(happened, columns)
    cdef Py_ssize_t kept = made if inside else 0
    cdef Numbers at_steps = _unknown(kept, 2 * n, columns), K = _unknown(kept, nodes_of, n, columns), apart = _unknown(made)
    cdef long[::1] follow = _whole(stops[2], np.int_), at = _whole(marks[0], np.int_)
    cdef int[::1] happens = _whole(marks[1], np.intc)
    cdef em_signal *signals
    cdef list held = []
    model.need_derivatives()
    signals = <em_signal *> calloc(len(inputs) + 1, sizeof(em_signal))
    if signals == NULL:
        raise MemoryError
    at_stops.array[0] = S
    try:
        for j, (kind, times, values) in enumerate(inputs):
            held.append((given(times, (len(times),), "times"), given(values, (len(values),), "values")))
            signals[j].kind, signals[j].count = <em_signal_kind> (<int> kind), len(times)
            signals[j].times, signals[j].values = (<Numbers> held[j][0]).data, (<Numbers> held[j][1]).data
        pass_.model, pass_.c, pass_.inputs, pass_.columns = model.model, c.c, signals, columns
        pass_.least_norm, pass_.stabilise, pass_.direction = least_norm, stabilise, direction
        pass_.n_given = model.n_arguments - 2 * n
        pass_.n_stops, pass_.t, pass_.z, pass_.steps = k, T.data, Z.data, &follow[0]
        pass_.n_steps, pass_.start, pass_.to, pass_.nodes = made, start.data, to.data, within.data
        pass_.n_marks, pass_.mark_stop, pass_.mark_event, pass_.dt = happened, &at[0], &happens[0], shifts.data
        pass_.place, pass_.A, pass_.A2, pass_.P = place.data, A.data, A2.data, rest.data
        pass_.S, pass_.apart = at_stops.data, apart.data
        pass_.S_from, pass_.K = at_steps.data if kept else NULL, K.data if kept else NULL
        pass_.poll, pass_.poll_argument, pass_.t_reached = poll, NULL, T.data[0]
        with nogil:
            status = em_vary(&pass_)
    finally:
        free(signals)
    if status != 0 and _REASONS[<int> pass_.fault.status] is StopReason.INTERRUPTED:
        raise KeyboardInterrupt
    said = None if status == 0 else model.failure(&pass_.fault)
    if status != 0 and pass_.why:
        words = _ENDS[pass_.why].format(*(repr(model.events[k]) for k in (pass_.fault.first, pass_.fault.second) if k >= 0))
        said = EvaluationError(f"{model.name}: {words} at about t = {pass_.t_reached:.9g}", StopReason.NON_FINITE_STATE)
    return at_stops.array, shifts.array, at_steps.array, K.array, apart.array, said


def _unknown(*shape):
    cdef Numbers made = zeros(shape)
    made.array.fill(NAN)
    return made


def _whole(numbers, kind):
    """They, and one more, that there is a first."""
    made = np.zeros(len(numbers) + 1, dtype=kind)
    made[:len(numbers)] = numbers
    return made
