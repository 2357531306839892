# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Many runs of one model that advance to times of the caller's choice: em_steppers.h for Python."""

from hashlib import blake2b

from cpython.bytes cimport PyBytes_AS_STRING, PyBytes_FromStringAndSize
from cpython.exc cimport PyErr_CheckSignals
from libc.math cimport NAN, isfinite
from libc.string cimport memcpy

from .abi cimport EM_MIDPOINT, EM_RK4, em_fault, em_method, em_model, em_rows
from .arrays cimport Numbers, blank, given, zeros
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
    """Non-zero if a signal requests an end (only the main thread sees signals); its exception is kept."""
    cdef ManySteps many = <ManySteps> argument
    try:
        PyErr_CheckSignals()
    except BaseException as error:
        many.pending = error
        many.wanted = 1
    return many.wanted


cdef class ManySteps:
    """One em_steppers.

    Parameters
    ----------
    asked
        An `eigenmotion.arguments.members.Asked`: the task that all members share.
    count, workers
        K; how many threads there may be in `go` at once.
    """

    cdef em_steppers e
    cdef volatile int wanted
    cdef object pending
    cdef bytes tag
    cdef list held
    cdef Numbers goal, y, c
    cdef readonly PointModel model
    cdef readonly object asked
    cdef readonly int count, workers
    cdef readonly object t, x, v, whole_v, u, ended, nfev, nsteps, goals # whole_v: with states behind the rates

    def __cinit__(self, asked, int count, int workers, *rest):
        cdef em_steppers *e = &self.e
        cdef PointModel model = asked.model
        cdef Numbers atol
        model.need_method(asked.method)
        if asked.method == EM_RK4 or asked.method == EM_MIDPOINT:
            model.need_members()
        self.model, self.asked, self.count, self.workers = model, asked, count, workers
        self.y, self.c, self.goal = zeros((count, model.n_state)), zeros((count, model.model.n_prepared)), zeros((count,))
        self.goals = self.goal.array
        atol = given(asked.atol.copy(), (model.n,), "atol")
        self.held = [atol]
        e.model, e.count, e.stop = model.model, count, &self.wanted
        e.t, e.x = self.table("t", (count,)), self.table("x", (count, model.n))
        e.v, e.u = self.table("v", (count, model.n)), self.table("u", (count, model.n_inputs))
        self.make_counts()
        e.task.model, e.task.method = model.model, <em_method> (<int> asked.method)
        e.task.rtol, e.task.atol, e.task.first_step = asked.rtol, atol.data, asked.first_step
        e.task.max_step, e.task.max_steps = asked.max_step, asked.max_steps
        e.task.stabilise, e.task.least_norm = asked.stabilise, asked.least_norm
        e.task.poll, e.task.poll_argument = poll, <void *> self
        if em_steppers_open(e, workers) != 0:
            raise MemoryError

    def __dealloc__(self):
        em_steppers_close(&self.e)

    cdef double *table(self, str name, tuple shape) except? NULL:
        """Numbers that C writes; users get a view of them that they cannot write to."""
        cdef Numbers made = zeros(shape)
        shown = made.array.view()
        shown.flags.writeable = False
        if name == "t":
            self.t = shown
        elif name == "x":
            self.x = shown[:, :self.model.n_coordinates]
        elif name == "v":
            self.whole_v, self.v = shown, shown[:, :self.model.n_coordinates]
        else:
            self.u = shown
        self.held.append(made)
        return made.data

    cdef make_counts(self):
        cdef long[::1] nfev, nsteps
        cdef unsigned char[::1] ended
        arrays = np.zeros(self.count, np.int_), np.zeros(self.count, np.int_), np.zeros(self.count, np.uint8)
        nfev, nsteps, ended = arrays
        self.e.n_rhs, self.e.n_steps, self.e.ended = &nfev[0], &nsteps[0], &ended[0]
        self.nfev, self.nsteps, self.ended = arrays[0].view(), arrays[1].view(), arrays[2].view(np.bool_)
        for shown in (self.nfev, self.nsteps, self.ended):
            shown.flags.writeable = False

    @property
    def width(self):
        """The number of members side by side in the lanes of a vector; 1: lanes are not used."""
        return self.e.width

    def stage(self, members, t, x, v, parameters):
        """Prepare the states at which these members (indices) start; t (K,), x, v (K, n), parameters (K, p).

        Returns the members that need the check in Python.
        """
        cdef Py_ssize_t i, k
        cdef const em_model *model = self.model.model
        cdef Numbers T = given(t, (self.count,), "t"), X = given(x, (self.count, model.n), "x")
        cdef Numbers V = given(v, (self.count, model.n), "v")
        cdef Numbers P = given(parameters, (self.count, model.n_parameters), "parameters")
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

    def put(self, Py_ssize_t member, y):
        """Set the state that the check in Python has found."""
        cdef Numbers found = given(y, (self.model.n_state,), "y")
        memcpy(self.y.row(member), found.data, self.model.n_state * sizeof(double))

    def begin(self, members, t, u):
        """Start the prepared members at t (K,), with inputs u (K, n_inputs)."""
        cdef Py_ssize_t i, k
        cdef int failed = 0
        cdef Py_ssize_t[::1] chosen = members
        cdef Numbers T = given(t, (self.count,), "t"), U = given(u, (self.count, self.model.n_inputs), "inputs")
        with nogil:
            for i in range(chosen.shape[0]):
                k = chosen[i]
                memcpy(self.e.u + k * U.width, U.row(k), U.width * sizeof(double))
                failed |= em_steppers_begin(&self.e, k, T.data[k], self.y.row(k), self.c.row(k))
        if failed:
            raise MemoryError

    def set_inputs(self, u):
        """Set u (K, n_inputs) of members that have not ended; False if one is not finite, and nothing is set."""
        cdef Py_ssize_t k
        cdef Numbers U = given(u, (self.count, self.model.n_inputs), "inputs")
        for k in range(self.count * U.width):
            if not isfinite(U.data[k]):
                return False
        for k in range(self.count):
            if not self.e.ended[k]:
                memcpy(self.e.u + k * U.width, U.row(k), U.width * sizeof(double))
        return True

    def set_goal(self, double t):
        """Set one t for all; False if it is not finite."""
        cdef Py_ssize_t k
        for k in range(self.count):
            self.goal.data[k] = t
        return isfinite(t) != 0

    def go(self, Py_ssize_t first, Py_ssize_t last, int worker):
        """Advance members first ... last - 1 to `goals`. Each worker, and each range, belongs to one thread."""
        with nogil:
            em_steppers_advance(&self.e, first, last, worker, self.goal.data)

    def settle(self):
        """Raise the exception of a signal's handler, if there was one."""
        self.wanted = 0
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
        """(K, n_events) when each event passed zero last within the last advance; NaN where it did not."""
        cdef Numbers made = zeros((self.count, self.model.n_events))
        cdef Py_ssize_t k
        cdef int i
        cdef em_rows *rows
        for k in range(self.count):
            for i in range(self.model.n_events):
                rows = &self.e.steppers[k].run.events[i]
                made.row(k)[i] = rows.t[rows.count - 1] if rows.count > 0 else NAN
        return made.array

    def published(self):
        """y (K, n_state), published meaning."""
        cdef Numbers made = zeros((self.count, self.model.n_state))
        cdef em_fault fault
        cdef Py_ssize_t k
        with nogil:
            for k in range(self.count):
                if em_steppers_state(&self.e, k, made.row(k), &fault) != 0:
                    blank(made.row(k), made.width)
        return made.array

    def energies(self):
        """T2, T1, T0, V (K, 4)."""
        cdef Numbers made = zeros((self.count, 4))
        cdef Py_ssize_t k
        cdef em_steppers *e = &self.e
        with nogil:
            for k in range(self.count):
                e.model.energy(e.t[k], e.x + k * e.model.n, e.v + k * e.model.n,
                               em_steppers_constants(e, k, self.c.row(k)), made.row(k))
        return made.array

    def reactions(self):
        """a (K, n), lambda (K, m); NaN where there are none."""
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
        """All of them as bytes."""
        cdef Py_ssize_t size = self.count * <Py_ssize_t> em_steppers_size(&self.e)
        cdef bytes saved = PyBytes_FromStringAndSize(NULL, TAG + size)
        cdef bytes tag = self.tagged()
        memcpy(PyBytes_AS_STRING(saved), PyBytes_AS_STRING(tag), TAG)
        em_steppers_save(&self.e, PyBytes_AS_STRING(saved) + TAG)
        return saved

    def go_back(self, bytes saved not None):
        """Restore the state of `saved`. Return whether that is possible."""
        cdef Py_ssize_t size = self.count * <Py_ssize_t> em_steppers_size(&self.e)
        if len(saved) != TAG + size or saved[:TAG] != self.tagged():
            return False
        em_steppers_restore(&self.e, PyBytes_AS_STRING(saved) + TAG)
        return True

    cdef bytes tagged(self):
        """The data that two of them must share for one to restore the bytes of the other."""
        if self.tag is None:
            m, asked = self.model, self.asked
            said = (m.identity(m.prepare(m.parameter_defaults)), self.count, self.e.width, asked.method, asked.rtol,
                    asked.atol.tobytes(), asked.first_step, asked.max_step, asked.stabilise, asked.least_norm)
            self.tag = blake2b(repr(said).encode(), digest_size=TAG).digest()
        return self.tag
