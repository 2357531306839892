# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""One compiled run: a call of em_model.simulate, and its results."""

from cpython.exc cimport PyErr_CheckSignals
from libc.stdlib cimport calloc, free
from libc.string cimport memcpy

from .abi cimport EM_DENSE_COEFFICIENTS, EM_RA15, EM_RADAU9
from .abi cimport em_dense_step, em_fault, em_method, em_rows, em_run, em_signal, em_signal_kind, em_status
from .arrays cimport Numbers, blank, floats, unset, zeros
from .point cimport PointModel, Prepared
from .record cimport modes_of, record

import numpy as np

from .status.stop_reasons import StopReason, explain
from .status.stiffness import stiffness

cdef tuple _REASONS = tuple(StopReason)
cdef object _FINISHED = StopReason.FINISHED
cdef str _FINISHED_MESSAGE = explain(StopReason.FINISHED, ())


cdef class Interruptible:
    """What calls compiled code that calls `poll` from time to time, with this object as its argument."""

    cdef int raise_pending(self, bint keyboard_too) except -1:
        """Raise the exception of a signal handler that ended the compiled code; KeyboardInterrupt only if told so."""
        error, self.pending = self.pending, None
        if error is not None and (keyboard_too or not isinstance(error, KeyboardInterrupt)):
            raise error
        return 0


cdef int poll(void *argument) noexcept with gil:
    """Non-zero if a signal handler raised an exception, which is raised again when the compiled code has returned."""
    cdef Interruptible of = <Interruptible> argument
    try:
        PyErr_CheckSignals()
    except BaseException as error:
        of.pending = error
    return of.pending is not None


cdef class Run(Interruptible):
    """One compiled run; its results live as long as this object.

    Parameters
    ----------
    task
        An `eigenmotion.arguments.tasks.Task`.
    method
        em_method; see `eigenmotion.arguments.methods`.
    other
        The em_method to which the run may change at an accepted step (em_method_change.h); -1: none.

    Attributes
    ----------
    stop
        A StopReason.
    unchanged
        The exception because of which the run has kept its method, although the other one costs less; or None.
    """

    def __cinit__(self, task, int method, *_):  # further arguments are those of __init__, here and in derived classes
        if task is not None:
            self.begin(task, method)

    def __init__(self, task, int method, int other=-1):
        self.may_change(other)
        if self.run.changes:
            self.simulate_by_either()
        else:
            with nogil:
                self.run.model.simulate(&self.run)
        self.raise_pending(False)
        self.stop = _REASONS[<int> self.run.fault.status]

    cdef may_change(self, int other):
        """Let the run change its method, unless its model is written by hand, without the functions that continue a run."""
        if other >= 0 and self.run.model.open != NULL:
            self.run.changes, self.run.other = 1, <em_method> other

    cdef simulate_by_either(self):
        cdef void *state = self.run.model.open(&self.run)
        if state == NULL:
            return
        try:
            with nogil:
                self.run.model.advance(state, self.run.t_end, 0)
            self.change_while_it_waits(state, self.run.t_end, self.run.max_steps)
        finally:
            self.run.model.close(state)

    cdef bint load_other(self) except -1:
        """Load what the other method needs. Return whether the run goes on: Ctrl-C ends it, as within a step.

        If it cannot be compiled, the run keeps its method, which costs more but gives the same motion. If it is wrong, a
        ProofError is passed on.
        """
        try:
            self.model.need_method(self.run.other)
        except RuntimeError as error:
            if getattr(error, "disproves", False):
                raise
            self.unchanged = error
            self.run.changes = self.run.waits = 0
        except KeyboardInterrupt:
            self.run.fault = em_fault(status=<em_status> (<int> _REASONS.index(StopReason.INTERRUPTED)), first=-1, second=-1, size=0.0)
            self.run.waits = 0
            return False
        return True

    cdef change_while_it_waits(self, void *state, double t, long most_steps):
        """Load what the other method needs where the run waits for it, and advance to t."""
        while self.run.waits and self.load_other():
            self.run.max_steps = most_steps - self.run.n_steps
            with nogil:
                self.run.model.advance(state, t, 0)

    @property
    def methods(self):
        """(time, em_method) of each change of the method."""
        cdef em_rows *rows = &self.run.methods
        return [(rows.t[k], int(rows.y[k])) for k in range(rows.count)]

    cdef begin(self, task, int method):
        cdef em_run *run = &self.run
        cdef PointModel model
        cdef Prepared prepared
        (model, prepared, inputs, run.t_start, run.t_end, y, run.rtol, atol, t_eval, run.dense, run.first_step,
         run.max_step, run.max_steps, run.stabilise, run.least_norm) = <tuple> task
        model.need_method(method)
        self.model, self.keep_alive = model, [prepared]
        run.model, run.prepared, run.method = model.model, prepared.c, <em_method> method
        run.y_start, run.atol = self.hold(y, (model.n_state,), "y"), self.hold(atol, model.vector, "atol")
        run.event_direction, run.event_terminal = model.model.event_direction, model.model.event_terminal
        run.poll, run.poll_argument = poll, <void *> self
        if t_eval is not None:
            run.n_t_eval = len(t_eval)
            run.t_eval = self.hold(t_eval, (run.n_t_eval,), "t_eval")
        if model.n_inputs > 0:
            self.hold_inputs(inputs.compiled)

    def __dealloc__(self):
        if self.run.model != NULL:
            self.run.model.release(&self.run)
        free(self.signals)

    cdef const double *hold(self, array, tuple shape, str name) except NULL:
        """The numbers of an array, which this object keeps alive."""
        cdef Numbers kept = floats(array, shape, name)
        self.keep_alive.append(kept)
        return kept.data

    cdef hold_inputs(self, tuple inputs):
        cdef Py_ssize_t k
        self.signals = <em_signal *> calloc(len(inputs), sizeof(em_signal))
        if self.signals == NULL:
            raise MemoryError
        for k, (kind, times, values) in enumerate(inputs):
            self.signals[k].kind = <em_signal_kind> (<int> kind)
            self.signals[k].count = len(times)
            self.signals[k].times = self.hold(times, (len(times),), "times")
            self.signals[k].values = self.hold(values, (len(values),), "values")
        self.run.inputs = self.signals

    cdef table(self, em_rows *rows):
        """t (k,), y (k, n_state), copied so that they outlive the run."""
        cdef Py_ssize_t k = rows.count
        cdef Numbers t = unset((k,)), y = unset((k, self.model.n_state))
        if k > 0:
            memcpy(t.data, rows.t, t.view.len)
            memcpy(y.data, rows.y, y.view.len)
        return t.array, y.array

    cdef events(self, em_rows *tables):
        """A list of t (k,) and a list of y (k, n_state), one per event; None, None if the model has no events."""
        if tables == NULL:
            return None, None
        return tuple(map(list, zip(*[self.table(&tables[k]) for k in range(self.model.n_events)])))

    @property
    def segments(self):
        """First row, start time and parameters of each segment (between changes of the mode); () without modes."""
        cdef em_rows *segments = &self.run.segments
        cdef const double *c
        cdef Py_ssize_t k, i
        if segments.count == 0:
            return ()
        listed = []
        for k in range(segments.count):
            c = segments.y + k * segments.width
            parameters = tuple([c[i] for i in range(self.model.model.n_parameters)])
            listed.append((int(c[segments.width - 1]), segments.t[k], parameters))
        return tuple(listed)

    def fields(self, str method):
        """The results as the dict of `record`, without `sol`."""
        t, y = self.table(&self.run.rows)
        t_events, y_events = self.events(self.run.events)
        after = None
        if self.model.acts:
            _, after = self.events(self.run.after)
            after = [now if acts else y for now, y, acts in zip(after, y_events, self.model.acting)]
        counts = (self.run.n_rhs, self.run.n_steps, self.run.n_rejected, self.run.n_bounded, self.run.n_stiff,
                  self.run.n_jacobians, self.run.n_factors)
        modes = modes_of(self.model, self.segments) if self.run.segments.count > 0 else ()
        return record(t, y.T, t_events, y_events, self.stop, self.message(), method, counts, None, after, modes)

    @property
    def charts(self):
        """Changes of rotation parameters: t (k,), the states before and after them (k, n_state); k is 0 without dense output."""
        t, y = self.table(&self.run.charts)
        return t[::2], y[::2], y[1::2]

    @property
    def last(self):
        """(t, y (n_state)) of the last accepted state before a failure; None if the run did not fail, or not on its way."""
        if self.run.last.count == 0:
            return None
        t, y = self.table(&self.run.last)
        return t[0], y[0]

    @property
    def n_dense(self):
        """The number of steps stored for dense output."""
        return self.run.n_dense

    cdef message(self):
        """The message about how and where the run ended, and what to do."""
        stiff = stiffness(self.run.n_stiff, self.run.n_steps, self.run.method == EM_RA15) if self.run.n_stiff > 0 else ""
        if self.stop is _FINISHED:
            return _FINISHED_MESSAGE + stiff
        fault = self.run.fault
        words = explain(self.stop, self.model.coordinates, fault.first, fault.second, fault.size, self.model.events,
                        self.model.row_names, tuple(self.model.tables))
        return f"At t = {self.run.t_reached:.9g}: {words}{stiff}"

    @property
    def step_times(self):
        """(n_dense + 1,) ends of the steps stored for dense output."""
        return np.array([*[self.run.dense_steps[k].t for k in range(self.run.n_dense)], self.run.t_reached])

    def __reduce__(self):
        """Pickle the interpolants of dense output."""
        cdef em_run *run = &self.run
        cdef Py_ssize_t width = EM_DENSE_COEFFICIENTS * self.model.n_state * sizeof(double)
        steps = (<char *> run.dense_steps)[:run.n_dense * sizeof(em_dense_step)] if run.n_dense else b""
        table = (<char *> run.dense_table)[:run.n_dense * width] if run.n_dense else b""
        times = run.t_start, run.t_end, run.t_reached
        segments = (<char *> run.segments.y)[:run.segments.count * run.segments.width * sizeof(double)] if run.segments.count else b""
        return _restored_run, (self.keep_alive[0], <int> run.method, run.stabilise, run.least_norm, times, run.n_dense,
                               steps, table, segments)

    def interpolate(self, t):
        """y (k, n_state) at t (k,), published meaning, settled like accepted steps."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), y = zeros((k, self.model.n_state))
        with nogil:
            for i in range(k):
                if self.run.model.interpolate(&self.run, self.step_at(T.data[i]), T.data[i], y.row(i)) != 0:
                    blank(y.row(i), y.width)
        return y.array

    cdef size_t step_at(self, double t) noexcept nogil:
        """The last stored step that starts at or before t, in the direction of time."""
        cdef size_t low = 0, high = self.run.n_dense, middle
        cdef double sign = -1.0 if self.run.t_end < self.run.t_start else 1.0
        while high - low > 1:
            middle = (low + high) // 2
            if sign * self.run.dense_steps[middle].t <= sign * t:
                low = middle
            else:
                high = middle
        return low


def _restored_run(Prepared prepared not None, int method, int stabilise, int least_norm, times, size_t count,
                  bytes steps, bytes table, bytes segments=b""):
    """A finished run, restored from its interpolants."""
    if not 0 <= method <= EM_RADAU9:
        raise ValueError(f"{prepared.model.name}: a run of another version, by a method (number {method}) that is no more")
    cdef Run made = Run.__new__(Run, None, method)
    cdef em_run *run = &made.run
    prepared.model.need_method(method)
    if len(steps) != count * sizeof(em_dense_step):
        raise ValueError(f"{prepared.model.name}: a run of another version, whose dense output has another form")
    made.model, made.keep_alive = prepared.model, [prepared]
    run.model, run.prepared, run.method = prepared.model.model, prepared.c, <em_method> method
    run.stabilise, run.least_norm = stabilise, least_norm
    run.t_start, run.t_end, run.t_reached = times
    run.dense_steps = <em_dense_step *> calloc(count + 1, sizeof(em_dense_step))
    run.dense_table = <double *> calloc(len(table) + 1, 1)
    if run.dense_steps == NULL or run.dense_table == NULL:
        raise MemoryError
    memcpy(run.dense_steps, <char *> steps, len(steps))
    memcpy(run.dense_table, <char *> table, len(table))
    run.n_dense = count
    run.segments.width = prepared.model.model.n_prepared + 1
    run.segments.y = <double *> calloc(len(segments) + 1, 1)
    if run.segments.y == NULL:
        raise MemoryError
    memcpy(run.segments.y, <char *> segments, len(segments))
    return made
