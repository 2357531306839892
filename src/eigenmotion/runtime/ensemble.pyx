# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Compiled runs of one model in a batch, without the interpreter's lock; quantities computed from their rows."""

from cpython.exc cimport PyErr_CheckSignals
from libc.math cimport NAN
from libc.stdlib cimport calloc, free, malloc
from libc.string cimport memcpy

from .abi cimport EM_DOP853, em_fault, em_method, em_model, em_signal, em_signal_kind
from .arrays cimport Numbers, blank, floats, zeros
from .ensemble cimport EM_COUNTS, em_ensemble, em_ensemble_run
from .point cimport PointModel

import numpy as np


cdef class Stop:
    """A stop flag, shared by threads."""

    cdef volatile int requested

    def __cinit__(self):
        self.requested = 0

    def set(self):
        """Ask all runs that share this to end, within a tenth of a second."""
        self.requested = 1

    def __bool__(self):
        return self.requested != 0


cdef int poll(void *argument) noexcept with gil:
    """Non-zero if the caller or a signal requests the end (only the main thread sees signals)."""
    cdef Chunk chunk = <Chunk> argument
    try:
        PyErr_CheckSignals()
    except KeyboardInterrupt:
        chunk.stop.requested = 1
    except BaseException as error:
        chunk.pending = error
        chunk.stop.requested = 1
    return chunk.stop.requested


cdef class Chunk:
    """Runs of some members of an ensemble, with their results.

    task, members : `EnsembleTask` and `Members` of eigenmotion.arguments.tasks
    y : (count, n_rows, n_state), published meaning; NaN at rows that a run did not reach
    t_end, status, first, second, size : (count,) when and how each run ended, as in `em_fault`
    counts : (count, 7), as in `COUNTS`
    events, event_times, event_counts : (k, n_state), (k,), (count, n_events), sorted by member, then by event
    """

    cdef em_ensemble e
    cdef em_signal *signals
    cdef PointModel model
    cdef Stop stop
    cdef list keep_alive
    cdef object pending
    cdef object event_starts
    cdef readonly object y, t_end, status, first, second, size, counts, event_times, events, event_counts

    def __cinit__(self, task, members, Stop stop not None):
        cdef em_ensemble *e = &self.e
        cdef PointModel model = task.model
        model.need_method(task.method)
        if task.method == EM_DOP853:
            model.need_members()
        self.model, self.stop, self.keep_alive = model, stop, []
        e.model, e.count, e.stop = model.model, members.count, &stop.requested
        self.set_task(task)
        self.set_members(members)
        self.allocate_results()
        self.run()

    def __dealloc__(self):
        free(self.signals)
        free(self.e.fault)
        free(self.e.events.t)
        free(self.e.events.y)

    cdef const double *hold(self, array, tuple shape, str name) except NULL:
        cdef Numbers kept = floats(array, shape, name)
        self.keep_alive.append(kept)
        return kept.data

    cdef set_task(self, task):
        cdef em_ensemble *e = &self.e
        cdef const em_model *model = self.model.model
        e.task.model, e.task.method = model, <em_method> (<int> task.method)
        e.task.t_start, e.task.t_end = task.t_start, task.t_end
        e.task.rtol, e.task.atol = task.rtol, self.hold(task.atol, (model.n,), "atol")
        e.task.first_step, e.task.max_step, e.task.max_steps = task.first_step, task.max_step, task.max_steps
        e.task.stabilise, e.task.least_norm = task.stabilise, task.least_norm
        e.task.event_direction, e.task.event_terminal = model.event_direction, model.event_terminal
        e.task.poll, e.task.poll_argument = poll, <void *> self
        e.n_rows = e.task.n_t_eval = len(task.t_eval)
        e.task.t_eval = self.hold(task.t_eval, (len(task.t_eval),), "t_eval")
        e.end_only = task.end_only

    cdef set_members(self, members):
        cdef em_ensemble *e = &self.e
        cdef const em_model *model = self.model.model
        rows = {name: len(getattr(members, name)) for name in ("parameters", "x", "v")}
        e.parameters = self.hold(members.parameters, (rows["parameters"], model.n_parameters), "parameters")
        e.x = self.hold(members.x, (rows["x"], model.n), "x")
        e.v = self.hold(members.v, (rows["v"], model.n), "v")
        e.parameters_stride = model.n_parameters if rows["parameters"] > 1 else 0
        e.x_stride, e.v_stride = model.n if rows["x"] > 1 else 0, model.n if rows["v"] > 1 else 0
        skip = np.ascontiguousarray(members.refused, dtype=np.uint8)
        cdef const unsigned char[::1] flags = skip
        self.keep_alive.append(skip)
        e.skip = &flags[0]
        if model.n_inputs > 0:
            self.set_inputs(members.inputs, members.count)

    cdef set_inputs(self, tuple inputs, size_t count):
        """Fill `signals`. Each input is one signal for all members, an array (count,) of constants, or a list of signals."""
        cdef size_t n = len(inputs), rows = 1, k, member
        cdef Numbers column
        for one in inputs:
            if not isinstance(one, tuple):
                rows = count
        self.signals = <em_signal *> calloc(rows * n + 1, sizeof(em_signal))
        if self.signals == NULL:
            raise MemoryError
        for k in range(n):
            one = inputs[k]
            if isinstance(one, np.ndarray):
                column = floats(one, (count,), "inputs")
                self.keep_alive.append(column)
                for member in range(rows):
                    self.signals[member * n + k].values = column.data + member
                continue
            for member in range(rows if isinstance(one, list) else 1):
                self.set_signal(&self.signals[member * n + k], one[member] if isinstance(one, list) else one)
            for member in range(1, 1 if isinstance(one, list) else rows):
                self.signals[member * n + k] = self.signals[k]
        self.e.inputs, self.e.inputs_stride = self.signals, n if rows > 1 else 0

    cdef set_signal(self, em_signal *signal, tuple samples):
        kind, times, values = samples
        signal.kind, signal.count = <em_signal_kind> (<int> kind), len(times)
        signal.times = self.hold(times, (len(times),), "times")
        signal.values = self.hold(values, (len(values),), "values")

    cdef allocate_results(self):
        cdef em_ensemble *e = &self.e
        cdef Numbers y, t_end
        cdef long[:, ::1] counts, event_counts, event_starts
        self.y = np.full((e.count, e.n_rows, self.model.n_state), NAN)
        self.t_end = np.full(e.count, NAN)
        self.counts = np.zeros((e.count, EM_COUNTS), dtype=np.int_)
        self.event_counts = np.zeros((e.count, self.model.n_events), dtype=np.int_)
        self.event_starts = np.zeros_like(self.event_counts)
        y, t_end = floats(self.y, self.y.shape, "y"), floats(self.t_end, self.t_end.shape, "t_end")
        self.keep_alive += [y, t_end]
        counts, event_counts, event_starts = self.counts, self.event_counts, self.event_starts
        e.y, e.t_end, e.counts = y.data, t_end.data, &counts[0, 0]
        if self.model.n_events > 0:
            e.event_counts, e.event_starts = &event_counts[0, 0], &event_starts[0, 0]
        e.events.width = self.model.n_state
        e.fault = <em_fault *> calloc(e.count, sizeof(em_fault))
        if e.fault == NULL:
            raise MemoryError

    cdef run(self):
        cdef int failed
        with nogil:
            failed = em_ensemble_run(&self.e)
        if self.pending is not None:
            raise self.pending
        if failed:
            raise MemoryError
        self.read_faults()
        self.read_events()
        self.keep_alive = []

    cdef read_faults(self):
        cdef size_t k, count = self.e.count
        cdef int[::1] status, first, second
        cdef double[::1] size
        self.status, self.first, self.second = (np.empty(count, dtype=np.intc) for _ in range(3))
        self.size = np.empty(count)
        status, first, second, size = self.status, self.first, self.second, self.size
        for k in range(count):
            status[k], first[k], second[k] = <int> self.e.fault[k].status, self.e.fault[k].first, self.e.fault[k].second
            size[k] = self.e.fault[k].size

    cdef read_events(self):
        cdef Py_ssize_t k = self.e.events.count
        cdef Numbers t = zeros((k,)), y = zeros((k, self.model.n_state))
        if k > 0:
            memcpy(t.data, self.e.events.t, t.view.len)
            memcpy(y.data, self.e.events.y, y.view.len)
        # runs end in any order: sort by member, then by event
        counts, starts = self.event_counts.ravel(), self.event_starts.ravel()
        order = np.repeat(starts - np.cumsum(counts) + counts, counts) + np.arange(k)
        self.event_times, self.events = t.array[order], y.array[order]


cdef class _Rows:
    """The rows of all members, and memory for the constants of one parameter set."""

    cdef const em_model *model
    cdef Numbers T, Y, P
    cdef Py_ssize_t count, rows, t_stride, y_stride, p_stride
    cdef double *c

    def __cinit__(self, PointModel model not None, t, y, parameters):
        cdef Py_ssize_t shared = len(t)
        self.model, self.count, self.rows = model.model, y.shape[0], y.shape[1]
        self.T = floats(t, (shared, self.rows), "t")
        self.Y = floats(y, (self.count, self.rows, model.n_state), "y")
        self.P = floats(parameters, (len(parameters), self.model.n_parameters), "parameters")
        self.t_stride = self.rows if shared > 1 else 0
        self.p_stride = self.model.n_parameters if len(parameters) > 1 else 0
        self.c = <double *> malloc((self.model.n_prepared + 1) * sizeof(double))
        if self.c == NULL:
            raise MemoryError

    def __dealloc__(self):
        free(self.c)

    cdef bint prepare(self, Py_ssize_t member) noexcept nogil:
        cdef em_fault fault
        return self.model.prepare(self.P.data + member * self.p_stride, self.c, &fault) == 0

    cdef double t(self, Py_ssize_t member, Py_ssize_t row) noexcept nogil:
        return self.T.data[member * self.t_stride + row]

    cdef double *y(self, Py_ssize_t member, Py_ssize_t row) noexcept nogil:
        return self.Y.data + (member * self.rows + row) * self.model.n_state


def velocities(PointModel model not None, t, y, parameters):
    """v (count, n_rows, n) of y (count, n_rows, n_state); t (count or 1, n_rows), parameters (count or 1, n_parameters)."""
    cdef _Rows rows = _Rows(model, t, y, parameters)
    cdef Numbers v = zeros((rows.count * rows.rows, model.n))
    cdef em_fault fault
    cdef Py_ssize_t i, j, k = 0
    with nogil:
        for i in range(rows.count):
            if not rows.prepare(i):
                blank(v.row(i * rows.rows), rows.rows * v.width)
                continue
            for j in range(rows.rows):
                k = i * rows.rows + j
                if rows.model.velocity(rows.t(i, j), rows.y(i, j), rows.c, v.row(k), &fault) != 0:
                    blank(v.row(k), v.width)
    return v.array.reshape(rows.count, rows.rows, model.n)


def energies(PointModel model not None, t, y, v, parameters):
    """T2, T1, T0, V (count, n_rows, 4) at the same rows with velocities v (count, n_rows, n)."""
    cdef _Rows rows = _Rows(model, t, y, parameters)
    cdef Numbers w = floats(v, (rows.count, rows.rows, model.n), "v"), e = zeros((rows.count * rows.rows, 4))
    cdef Py_ssize_t i, j, k = 0
    with nogil:
        for i in range(rows.count):
            if not rows.prepare(i):
                blank(e.row(i * rows.rows), rows.rows * e.width)
                continue
            for j in range(rows.rows):
                k = i * rows.rows + j
                rows.model.energy(rows.t(i, j), rows.y(i, j), w.data + k * model.n, rows.c, e.row(k))
    return e.array.reshape(rows.count, rows.rows, 4)


def reactions(PointModel model not None, t, y, v, u, parameters, int least_norm):
    """a (count, n_rows, n), lambda (count, n_rows, m), outputs (count, n_rows, n_outputs); u (count, n_rows, n_inputs)."""
    cdef _Rows rows = _Rows(model, t, y, parameters)
    cdef Py_ssize_t i, j, k = 0, total = rows.count * rows.rows
    cdef Numbers w = floats(v, (rows.count, rows.rows, model.n), "v")
    cdef Numbers s = floats(u, (rows.count, rows.rows, model.n_inputs), "inputs")
    cdef Numbers a = zeros((total, model.n)), L = zeros((total, model.m)), z = zeros((total, model.n_outputs))
    cdef em_fault fault
    cdef const double *x
    cdef const double *rate
    cdef const double *signals
    with nogil:
        for i in range(rows.count):
            if not rows.prepare(i):
                blank(a.row(i * rows.rows), rows.rows * a.width)
                blank(L.row(i * rows.rows), rows.rows * L.width)
                blank(z.row(i * rows.rows), rows.rows * z.width)
                continue
            for j in range(rows.rows):
                k = i * rows.rows + j
                x, rate, signals = rows.y(i, j), w.data + k * model.n, s.data + k * model.n_inputs
                if rows.model.acceleration(rows.t(i, j), x, rate, rows.c, signals, least_norm, a.row(k), L.row(k),
                                           &fault) != 0:
                    blank(a.row(k), a.width)
                    blank(L.row(k), L.width)
                if model.n_outputs > 0 and rows.model.output(rows.t(i, j), x, rate, rows.c, signals, least_norm,
                                                             z.row(k), &fault) != 0:
                    blank(z.row(k), z.width)
    shape = rows.count, rows.rows
    return a.array.reshape(*shape, model.n), L.array.reshape(*shape, model.m), z.array.reshape(*shape, model.n_outputs)
