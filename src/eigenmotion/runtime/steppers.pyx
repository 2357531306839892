# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Batch of steppers: K runs of one model that the caller advances to chosen times (em_steppers.h for Python)."""

from hashlib import blake2b

from cpython.bytes cimport PyBytes_AS_STRING, PyBytes_FromStringAndSize
from cpython.exc cimport PyErr_CheckSignals
from libc.math cimport NAN, isfinite
from libc.string cimport memcpy

from .abi cimport EM_MIDPOINT, EM_RK4, em_fault, em_method, em_model, em_rows
from .arrays cimport Numbers, blank, floats, zeros
from .point cimport PointModel
from .steppers cimport em_start, em_steppers, em_steppers_advance, em_steppers_begin, em_steppers_close
from .steppers cimport em_steppers_constants, em_steppers_open, em_steppers_restore, em_steppers_save, em_steppers_size
from .steppers cimport em_steppers_state

import numpy as np

from .status.stop_reasons import StopReason, explain

_REASONS = tuple(StopReason)

cdef enum:
    TAG = 16  # bytes


cdef int poll(void *argument) noexcept with gil:
    """Non-zero if a signal handler raised an exception (only in the main thread), which `raise_pending` raises again."""
    cdef ManySteps many = <ManySteps> argument
    try:
        PyErr_CheckSignals()
    except BaseException as error:
        many.pending = error
        many.stop_requested = 1
    return many.stop_requested


cdef class ManySteps:
    """K steppers of one model: an em_steppers.

    Parameters
    ----------
    task
        An `eigenmotion.arguments.tasks.EnsembleTask`, which all members share.
    count, workers
        K; the largest number of threads that call `go` at the same time.
    """

    cdef em_steppers e
    cdef volatile int stop_requested
    cdef object pending
    cdef bytes tag
    cdef list keep_alive
    cdef Numbers goal, y, c
    cdef readonly PointModel model
    cdef readonly object task
    cdef readonly int count, workers
    cdef readonly object t, x, v, whole_v, u, ended, nfev, nsteps, goals # whole_v: rates, followed by states

    def __cinit__(self, task, int count, int workers, *rest):
        cdef em_steppers *e = &self.e
        cdef PointModel model = task.model
        cdef Numbers atol
        model.need_method(task.method)
        if task.method == EM_RK4 or task.method == EM_MIDPOINT:
            model.need_members()
        self.model, self.task, self.count, self.workers = model, task, count, workers
        self.y, self.c, self.goal = zeros((count, model.n_state)), zeros((count, model.model.n_prepared)), zeros((count,))
        self.goals = self.goal.array
        atol = floats(task.atol.copy(), (model.n,), "atol")
        self.keep_alive = [atol]
        e.model, e.count, e.stop = model.model, count, &self.stop_requested
        e.t, e.x = self.table("t", (count,)), self.table("x", (count, model.n))
        e.v, e.u = self.table("v", (count, model.n)), self.table("u", (count, model.n_inputs))
        self.make_counts()
        e.task.model, e.task.method = model.model, <em_method> (<int> task.method)
        e.task.rtol, e.task.atol, e.task.first_step = task.rtol, atol.data, task.first_step
        e.task.max_step, e.task.max_steps = task.max_step, task.max_steps
        e.task.stabilise, e.task.least_norm = task.stabilise, task.least_norm
        e.task.poll, e.task.poll_argument = poll, <void *> self
        if em_steppers_open(e, workers) != 0:
            raise MemoryError

    def __dealloc__(self):
        em_steppers_close(&self.e)

    cdef double *table(self, str name, tuple shape) except? NULL:
        """Allocate an array that C writes; users get a read-only view of it."""
        cdef Numbers numbers = zeros(shape)
        view = numbers.array.view()
        view.flags.writeable = False
        if name == "t":
            self.t = view
        elif name == "x":
            self.x = view[:, :self.model.n_coordinates]
        elif name == "v":
            self.whole_v, self.v = view, view[:, :self.model.n_coordinates]
        else:
            self.u = view
        self.keep_alive.append(numbers)
        return numbers.data

    cdef make_counts(self):
        cdef long[::1] nfev, nsteps
        cdef unsigned char[::1] ended
        arrays = np.zeros(self.count, np.int_), np.zeros(self.count, np.int_), np.zeros(self.count, np.uint8)
        nfev, nsteps, ended = arrays
        self.e.n_rhs, self.e.n_steps, self.e.ended = &nfev[0], &nsteps[0], &ended[0]
        self.nfev, self.nsteps, self.ended = arrays[0].view(), arrays[1].view(), arrays[2].view(np.bool_)
        for view in (self.nfev, self.nsteps, self.ended):
            view.flags.writeable = False

    @property
    def width(self):
        """The number of members in the lanes of one vector; 1: lanes are not used."""
        return self.e.width

    def stage(self, members, t, x, v, parameters):
        """Prepare the start states of some members (indices); t (K,), x, v (K, n), parameters (K, p).

        Returns the members whose start failed the quick check and must be checked in Python.
        """
        cdef Py_ssize_t i, k
        cdef const em_model *model = self.model.model
        cdef Numbers T = floats(t, (self.count,), "t"), X = floats(x, (self.count, model.n), "x")
        cdef Numbers V = floats(v, (self.count, model.n), "v")
        cdef Numbers P = floats(parameters, (self.count, model.n_parameters), "parameters")
        cdef Py_ssize_t[::1] chosen = members
        cdef unsigned char[::1] refused = np.zeros(self.count, np.uint8)
        cdef em_fault fault
        self.model.check_tables_of(parameters)
        with nogil:
            for i in range(chosen.shape[0]):
                k = chosen[i]
                if model.prepare(P.row(k), self.c.row(k), &fault) != 0:
                    refused[k] = 1
                    continue
                for j in range(model.n_state):
                    self.y.row(k)[j] = 0.0
                refused[k] = 0 != em_start(model, T.data[k], X.row(k), V.row(k), self.c.row(k), self.e.task.rtol,
                                          self.e.task.atol, self.y.row(k), NULL, NULL)
        return np.flatnonzero(refused)

    def set_start(self, Py_ssize_t member, y):
        """Set the start state y (n_state,) of a member that was checked in Python."""
        cdef Numbers start = floats(y, (self.model.n_state,), "y")
        memcpy(self.y.row(member), start.data, self.model.n_state * sizeof(double))

    def begin(self, members, t, u):
        """Start the prepared members at t (K,), with inputs u (K, n_inputs)."""
        cdef Py_ssize_t i, k
        cdef int failed = 0
        cdef Py_ssize_t[::1] chosen = members
        cdef Numbers T = floats(t, (self.count,), "t"), U = floats(u, (self.count, self.model.n_inputs), "inputs")
        with nogil:
            for i in range(chosen.shape[0]):
                k = chosen[i]
                memcpy(self.e.u + k * U.width, U.row(k), U.width * sizeof(double))
                failed |= em_steppers_begin(&self.e, k, T.data[k], self.y.row(k), self.c.row(k))
        if failed:
            raise MemoryError

    def set_inputs(self, u):
        """Set u (K, n_inputs) of members that have not ended. If a number is not finite, set nothing and return False."""
        cdef Py_ssize_t k
        cdef Numbers U = floats(u, (self.count, self.model.n_inputs), "inputs")
        for k in range(self.count * U.width):
            if not isfinite(U.data[k]):
                return False
        for k in range(self.count):
            if not self.e.ended[k]:
                memcpy(self.e.u + k * U.width, U.row(k), U.width * sizeof(double))
        return True

    def set_goal(self, double t):
        """Set the same goal t for all members; return whether it is finite."""
        cdef Py_ssize_t k
        for k in range(self.count):
            self.goal.data[k] = t
        return isfinite(t) != 0

    def go(self, Py_ssize_t first, Py_ssize_t last, int worker):
        """Advance members first ... last - 1 to `goals`. At one time, a worker and a range may be used by one thread only."""
        with nogil:
            em_steppers_advance(&self.e, first, last, worker, self.goal.data)

    def raise_pending(self):
        """Raise the exception of a signal handler, if there was one."""
        self.stop_requested = 0
        if self.pending is not None:
            pending, self.pending = self.pending, None
            raise pending

    def reason(self, Py_ssize_t k):
        """The StopReason of member k, and its message; None if it has not ended."""
        if not 0 <= k < self.count:
            raise IndexError(f"there are members 0 ... {self.count - 1}, no {k}")
        fault = self.e.fault[k]
        stop = _REASONS[<int> fault.status]
        if not self.e.ended[k]:
            return None
        return stop, explain(stop, self.model.coordinates, fault.first, fault.second, fault.size, self.model.events,
                        self.model.row_names, tuple(self.model.tables))

    def crossings(self):
        """(K, n_events) time of the last zero crossing of each event in the last advance; NaN if there was none."""
        cdef Numbers times = zeros((self.count, self.model.n_events))
        cdef Py_ssize_t k
        cdef int i
        cdef em_rows *rows
        for k in range(self.count):
            for i in range(self.model.n_events):
                rows = &self.e.steppers[k].run.events[i]
                times.row(k)[i] = rows.t[rows.count - 1] if rows.count > 0 else NAN
        return times.array

    def published(self):
        """y (K, n_state), published meaning."""
        cdef Numbers y = zeros((self.count, self.model.n_state))
        cdef em_fault fault
        cdef Py_ssize_t k
        with nogil:
            for k in range(self.count):
                if em_steppers_state(&self.e, k, y.row(k), &fault) != 0:
                    blank(y.row(k), y.width)
        return y.array

    def energies(self):
        """T2, T1, T0, V (K, 4)."""
        cdef Numbers energy = zeros((self.count, 4))
        cdef Py_ssize_t k
        cdef em_steppers *e = &self.e
        with nogil:
            for k in range(self.count):
                e.model.energy(e.t[k], e.x + k * e.model.n, e.v + k * e.model.n,
                               em_steppers_constants(e, k, self.c.row(k)), energy.row(k))
        return energy.array

    def reactions(self):
        """a (K, n), lambda (K, m); NaN where they have no value."""
        cdef Numbers a = zeros((self.count, self.model.n)), L = zeros((self.count, self.model.m))
        cdef em_fault fault
        cdef Py_ssize_t k
        cdef em_steppers *e = &self.e
        with nogil:
            for k in range(self.count):
                if e.model.acceleration(e.t[k], e.x + k * e.model.n, e.v + k * e.model.n,
                                        em_steppers_constants(e, k, self.c.row(k)), e.u + k * e.model.n_inputs,
                                        e.task.least_norm, a.row(k), L.row(k), &fault) != 0:
                    blank(a.row(k), a.width)
                    blank(L.row(k), L.width)
        return a.array, L.array

    def observed(self):
        """The outputs (K, n_outputs); NaN where they have no value."""
        cdef Numbers z = zeros((self.count, self.model.n_outputs))
        cdef em_fault fault
        cdef Py_ssize_t k
        cdef em_steppers *e = &self.e
        with nogil:
            for k in range(self.count if e.model.n_outputs > 0 else 0):
                if e.model.output(e.t[k], e.x + k * e.model.n, e.v + k * e.model.n,
                                  em_steppers_constants(e, k, self.c.row(k)), e.u + k * e.model.n_inputs,
                                  e.task.least_norm, z.row(k), &fault) != 0:
                    blank(z.row(k), z.width)
        return z.array

    def saved(self):
        """The complete state of all members as bytes."""
        cdef Py_ssize_t size = self.count * <Py_ssize_t> em_steppers_size(&self.e)
        cdef bytes saved = PyBytes_FromStringAndSize(NULL, TAG + size)
        cdef bytes tag = self.digest()
        memcpy(PyBytes_AS_STRING(saved), PyBytes_AS_STRING(tag), TAG)
        em_steppers_save(&self.e, PyBytes_AS_STRING(saved) + TAG)
        return saved

    def restore_saved(self, bytes saved not None):
        """Restore the state of `saved`. Return False, and change nothing, if the bytes do not fit."""
        cdef Py_ssize_t size = self.count * <Py_ssize_t> em_steppers_size(&self.e)
        if len(saved) != TAG + size or saved[:TAG] != self.digest():
            return False
        em_steppers_restore(&self.e, PyBytes_AS_STRING(saved) + TAG)
        return True

    cdef bytes digest(self):
        """A digest of the data that must agree for one batch to restore the bytes of another."""
        if self.tag is None:
            m, task = self.model, self.task
            shared = (m.identity(m.prepare(m.parameter_defaults)), self.count, self.e.width, task.method, task.rtol,
                      task.atol.tobytes(), task.first_step, task.max_step, task.stabilise, task.least_norm)
            self.tag = blake2b(repr(shared).encode(), digest_size=TAG).digest()
        return self.tag
