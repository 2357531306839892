# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Variational equations: derivatives of a motion with respect to its start, parameters and inputs.

At one state, and integrated along the rows of a run (em_variations.h).
"""

from libc.math cimport NAN
from libc.stdlib cimport calloc, free
from libc.string cimport memcpy

from .abi cimport em_fault, em_model, em_pile, em_run, em_signal, em_signal_kind
from .arrays cimport Numbers, floats, zeros
from .point cimport PointModel, Prepared
from .run cimport Interruptible, Run, poll

import numpy as np

from .status.stop_reasons import EvaluationError, StopReason


cdef extern from "sensitivity/em_adjoint.h" nogil:
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

    ctypedef struct em_pass:
        int n

    ctypedef struct em_taped_pass:
        em_variations of
        em_pass recorded "pass"

    ctypedef struct em_adjoint:
        # "lambda" is a keyword of Python
        double *cotangents "lambda"
        const double *rows
        const double *stops
        double *gradient

    int em_record_tape(em_taped_pass *, int, const double *)
    void em_taped_close(em_taped_pass *)
    void em_pull(const em_pass *, em_adjoint *)


_END_MESSAGES = (
    "", "{} and {} act at once, and which of them is first depends on what is varied",
    "{} only touches zero, so that whether it happens depends on what is varied",
    "the directions went through other events than the run",
    "a condition in the time changes at the start, or at once with another, and their times change apart with what is varied",
    "constraint rows jump",
    "a force jumps where {} and {} happen at once, whose times change apart: with which of them it does not show",
    "a force jumps",
    "forces change faster than steps can follow",
    "a condition in the time changes at once with {}, and their times change apart with what is varied",
    "{} stops while its slip turns so fast that derivatives of when it stops are not known (smaller rtol and "
    "atol follow the slip further)",
)  # of em_variation_pass.h


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


cdef class Variations(Interruptible):
    """An integration of directions S (2 n, columns) from the first of `stops` along a run with dense output.

    See em_variations.h. The directions of inputs, parameters and time are P (n_forcing, columns).

    run : None if there is nothing to integrate between the stops
    tolerance : relative error of a step; together : initial length of a step, in steps of the run
    stops : t (stops,), z (stops, 2 n), number of spans after each (stops,); spans : from, to (spans,); marks : stop, event
    (marks,); nodes : place (nodes,), A, A^2, series (nodes, nodes); rows : (k,) times

    Results: at_stops (stops, 2 n, columns), shifts (marks, columns) of the times of events, at_rows (k, 2 n, columns) at
    the rows within spans; all NaN where the integration did not reach.
    """

    cdef em_variations of
    cdef em_signal *signals
    cdef readonly PointModel model
    cdef readonly object at_stops
    cdef readonly object shifts
    cdef readonly object at_rows
    cdef list keep_alive

    def __cinit__(self, PointModel model not None, Prepared c not None, Run run, tuple inputs, double direction,
                  double tolerance, double together, stops, spans, marks, nodes, rows, S, P, bint stabilise,
                  int least_norm):
        cdef em_variations *of = &self.of
        cdef Py_ssize_t k = len(stops[0]), n_spans = len(spans[0]), n_marks = len(marks[0]), n = model.n
        cdef tuple square = (EM_VARIATION_NODES, EM_VARIATION_NODES)
        cdef int columns = S.shape[1]
        model.need_derivatives()
        self.model, self.keep_alive = model, [c, run]
        self.hold_inputs(inputs)
        of.model, of.c, of.columns, of.run = model.model, c.c, columns, NULL if run is None else &run.run
        of.tolerance, of.initial_steps, of.direction = tolerance, together, direction
        of.least_norm, of.stabilise, of.n_forcing = least_norm, stabilise, model.n_arguments - 2 * n
        of.n_stops, of.n_spans, of.n_marks, of.n_rows = k, n_spans, n_marks, len(rows)
        of.t, of.z = self.hold(stops[0], (k,)), self.hold(stops[1], (k, 2 * n))
        of.start, of.to = self.hold(spans[0], (n_spans,)), self.hold(spans[1], (n_spans,))
        of.place, of.A = self.hold(nodes[0], (EM_VARIATION_NODES,)), self.hold(nodes[1], square)
        of.A2, of.series = self.hold(nodes[2], square), self.hold(nodes[3], square)
        of.t_rows, of.P = self.hold(rows, (len(rows),)), self.hold(P, (of.n_forcing, columns))
        self.hold_marks(_whole(stops[2], np.int_), _whole(marks[0], np.int_), _whole(marks[1], np.intc))
        self.hold_results(S, _unknown(k, 2 * n, columns), _unknown(n_marks, columns), _unknown(len(rows), 2 * n, columns))
        of.poll, of.poll_argument, of.t_reached = poll, <void *> self, of.t[0]

    def __dealloc__(self):
        free(self.signals)

    cdef const double *hold(self, array, tuple shape) except NULL:
        """The numbers of an array, which this object keeps alive."""
        cdef Numbers kept = floats(array, shape, "variations")
        self.keep_alive.append(kept)
        return kept.data

    cdef hold_inputs(self, tuple inputs):
        self.signals = <em_signal *> calloc(len(inputs) + 1, sizeof(em_signal))
        if self.signals == NULL:
            raise MemoryError
        for j, (kind, times, values) in enumerate(inputs):
            self.signals[j].kind, self.signals[j].count = <em_signal_kind> (<int> kind), len(times)
            self.signals[j].times, self.signals[j].values = self.hold(times, (len(times),)), self.hold(values, (len(values),))
        self.of.inputs = self.signals

    cdef hold_marks(self, long[::1] spans, long[::1] mark_stop, int[::1] mark_event):
        self.keep_alive.append((spans, mark_stop, mark_event))
        self.of.spans, self.of.mark_stop, self.of.mark_event = &spans[0], &mark_stop[0], &mark_event[0]

    cdef hold_results(self, S, Numbers at_stops, Numbers shifts, Numbers at_rows):
        at_stops.array[0] = S
        self.keep_alive.append((at_stops, shifts, at_rows))
        self.at_stops, self.shifts, self.at_rows = at_stops.array, shifts.array, at_rows.array
        self.of.S, self.of.dt, self.of.rows = at_stops.data, shifts.data, at_rows.data

    cdef object error(self, int status, const em_variations *of):
        """The error of an integration, or None."""
        if status == 0:
            return None
        self.raise_pending(True)
        if not of.why:
            return self.model.failure(<em_fault *> &of.fault)
        events = [repr(self.model.events[k]) for k in (of.fault.first, of.fault.second) if k >= 0]
        words = _END_MESSAGES[of.why].format(*events)
        return EvaluationError(f"{self.model.name}: {words} at about t = {of.t_reached:.9g}", StopReason.NON_FINITE_STATE)

    def integrate(self):
        """Return an EvaluationError if the integration ended early, or None."""
        cdef int status
        with nogil:
            status = em_integrate_variations(&self.of)
        return self.error(status, &self.of)

    @property
    def counts(self):
        """The numbers of steps accepted, rejected, and integrated with a motion of their own."""
        return self.of.n_steps, self.of.n_refused, self.of.n_own_motion


cdef class Tape:
    """The derivative of a run as a product of linear maps (em_derivative_tape.h), recorded along `variations`.

    basis : (n_forcing, columns): directions of inputs, parameters and time with respect to which there are gradients; each
    has one entry
    """

    cdef em_taped_pass *taped
    cdef readonly Variations variations
    cdef readonly object fault
    cdef Py_ssize_t columns

    def __cinit__(self, Variations variations not None, basis):
        cdef int status
        cdef Numbers P = floats(basis, (variations.of.n_forcing, basis.shape[1]), "basis")
        if np.any(np.count_nonzero(basis, axis=0) != 1):
            raise ValueError("each direction of the basis has one entry")
        self.variations, self.columns = variations, basis.shape[1]
        self.taped = <em_taped_pass *> calloc(1, sizeof(em_taped_pass))
        if self.taped == NULL:
            raise MemoryError
        self.taped.of = variations.of
        with nogil:
            status = em_record_tape(self.taped, self.columns, P.data)
        variations.of.n_steps, variations.of.n_refused = self.taped.of.n_steps, self.taped.of.n_refused
        self.fault = variations.error(status, &self.taped.of)

    def __dealloc__(self):
        if self.taped != NULL:
            em_taped_close(self.taped)
            free(self.taped)

    def pull(self, at_stops, at_rows, cotangents):
        """Return the transpose, applied to cotangents of S at stops (stops, 2 n), rows (k, 2 n) and the end (2 n).

        Returns the cotangents (2 n) of the start, and the gradient (columns) along the basis.
        """
        cdef Py_ssize_t wide = 2 * self.variations.model.n
        cdef Numbers stops = floats(at_stops, (self.variations.of.n_stops, wide), "stops")
        cdef Numbers rows = floats(at_rows, (self.variations.of.n_rows, wide), "rows")
        cdef Numbers start = floats(np.array(cotangents, dtype=np.float64), (wide,), "cotangents")
        cdef Numbers gradient = zeros((self.columns,))
        cdef em_adjoint by
        by.cotangents, by.rows, by.stops, by.gradient = start.data, rows.data, stops.data, gradient.data
        with nogil:
            em_pull(&self.taped.recorded, &by)
        return start.array, gradient.array


def _unknown(*shape):
    cdef Numbers made = zeros(shape)
    made.array.fill(NAN)
    return made


def _whole(numbers, kind):
    """Integers as an array with one extra entry, so that it is never empty."""
    padded = np.zeros(len(numbers) + 1, dtype=kind)
    padded[:len(numbers)] = numbers
    return padded
