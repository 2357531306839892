# cython: language_level=3, boundscheck=False, wraparound=False, initializedcheck=False
"""The ABI of eigenmotion.h on float64 arrays. Nothing is shared between calls, so threads need no locks.

Arguments of rows: t (k,), x and v (k, n), y (k, n_state), u (k, n_inputs), one row a time.
Rows at which a function has no value are NaN; single calls raise EvaluationError.
"""

from cpython.buffer cimport PyBUF_FULL_RO, PyBUF_SIMPLE, PyBUF_WRITABLE
from cpython.buffer cimport PyBuffer_Release, PyObject_CheckBuffer, PyObject_GetBuffer
from cpython.exc cimport PyErr_CheckSignals
from cpython.pycapsule cimport PyCapsule_GetPointer
from libc.math cimport NAN, fabs, isnan
from libc.stdlib cimport calloc, free, malloc
from libc.string cimport memcpy, memset

import numpy as np

from .faults import EvaluationError, StopReason, explain

_REASONS = tuple(StopReason)
_empty = np.empty


cdef tuple texts(const char *const *names, int count):
    return tuple([names[k].decode("utf-8") for k in range(count)])


cdef object numbers(const double *values, int count):
    return np.array([values[k] for k in range(count)], dtype=np.float64)


cdef object shaped(object a, tuple shape, str name):
    """a as a C-contiguous float64 array of that shape."""
    array = np.ascontiguousarray(a, dtype=np.float64)
    if array.shape != shape:
        raise ValueError(f"{name} has shape {np.shape(a)}, but this model needs {shape}")
    return array


cdef bint lends(object a, Py_ssize_t n, Py_buffer *view) except -1:
    """Whether a is n float64 numbers in a row; then `view` holds them."""
    if not PyObject_CheckBuffer(a):
        return False
    PyObject_GetBuffer(a, view, PyBUF_FULL_RO)
    if (view.ndim == 1 and view.shape[0] == n and view.strides[0] == sizeof(double)
            and view.format[0] == c"d" and view.format[1] == 0):
        return True
    PyBuffer_Release(view)
    return False


cdef const double *borrow(object a, Py_ssize_t n, Py_buffer *view, str name) except NULL:
    """The n numbers of a (any stride, any number type), valid until PyBuffer_Release(view)."""
    if not lends(a, n, view):
        PyObject_GetBuffer(shaped(a, (n,), name), view, PyBUF_SIMPLE)
    return <const double *> view.buf


cdef inline void blank(double *a, Py_ssize_t count) noexcept nogil:
    cdef Py_ssize_t k
    for k in range(count):
        a[k] = NAN


cdef class Prepared:
    """The constants of one parameter set: blocks of M that no state changes are factored once, here."""

    cdef readonly CompiledModel model
    cdef readonly object parameters
    cdef double *c

    def __dealloc__(self):
        free(self.c)

    def __repr__(self):
        pairs = ", ".join(f"{name}={value:g}" for name, value in zip(self.model.parameters, self.parameters))
        return f"<parameters of {self.model.name}: {pairs}>"


cdef class CompiledModel:
    """One `em_model`. The capsule must be named "eigenmotion.em_model" and point at a constant that outlives it."""

    cdef const em_model *model
    cdef readonly str name, formulation, close_eigenvalues, schur
    cdef readonly int n, m, h, n_state, n_inputs, n_outputs, n_events
    cdef readonly tuple coordinates, parameters, inputs, outputs, events, left_out, layout, block, carried
    cdef readonly tuple quasi_velocities
    cdef readonly object parameter_defaults, input_defaults, initial_x, initial_v, initial_y, scales
    cdef readonly bint conserves_energy

    def __cinit__(self, capsule):
        self.model = <const em_model *> PyCapsule_GetPointer(capsule, b"eigenmotion.em_model")
        cdef const em_model *c = self.model
        if c.abi != EM_ABI:
            raise ImportError(f"the compiled model has interface version {c.abi}, this eigenmotion has {EM_ABI}: "
                              "generate and build the model again (`eigenmotion build MODEL.py`)")
        self.name, self.formulation = c.name.decode("utf-8"), c.formulation.decode("utf-8")
        self.close_eigenvalues, self.schur = c.close_eigenvalues.decode("utf-8"), c.schur.decode("utf-8")
        self.n, self.m, self.h, self.n_state = c.n, c.m, c.h, c.n_state
        self.n_inputs, self.n_outputs, self.n_events = c.n_inputs, c.n_outputs, c.n_events
        self.conserves_energy = c.conserves_energy
        self.read_names()
        self.read_defaults()

    cdef read_names(self):
        cdef const em_model *c = self.model
        self.coordinates, self.parameters = texts(c.coordinates, c.n), texts(c.parameters, c.n_parameters)
        self.inputs, self.outputs = texts(c.inputs, c.n_inputs), texts(c.outputs, c.n_outputs)
        self.events, self.left_out = texts(c.events, c.n_events), texts(c.left_out, c.n_left_out)
        self.quasi_velocities = texts(c.quasi_velocities, c.n_quasi)
        self.layout = tuple([(c.layout[k].name.decode("utf-8"), c.layout[k].start, c.layout[k].length)
                             for k in range(c.n_layout)])
        self.block = tuple([c.block[k] for k in range(c.n)])
        self.carried = tuple([k for k in range(c.n) if c.carried[k]])

    cdef read_defaults(self):
        cdef const em_model *c = self.model
        self.parameter_defaults = numbers(c.parameter_defaults, c.n_parameters)
        self.input_defaults = numbers(c.input_defaults, c.n_inputs)
        self.initial_x, self.initial_v = numbers(c.initial_x, c.n), numbers(c.initial_v, c.n)
        self.initial_y = numbers(c.initial_y, c.n) if c.initial_y != NULL else None
        self.scales = numbers(c.scales, c.n)

    cdef failure(self, em_fault *fault):
        stop = _REASONS[<int> fault.status]
        words = explain(stop, self.coordinates, fault.first, fault.second, fault.size)
        return EvaluationError(f"{self.name}: {words}", stop)

    def prepare(self, values):
        """values (n_parameters) -> Prepared."""
        cdef em_fault fault
        cdef Prepared made = Prepared.__new__(Prepared)
        values = shaped(values, (len(self.parameters),), "parameters")
        cdef const double[::1] p = values
        made.model = self
        made.parameters = tuple(values.tolist())
        made.c = <double *> calloc(self.model.n_prepared + 1, sizeof(double))
        if made.c == NULL:
            raise MemoryError
        if self.model.prepare(&p[0], made.c, &fault) != 0:
            raise self.failure(&fault)
        return made

    def rhs(self, double t, y, Prepared c not None, u=None, out=None):
        """dy (n_state) at t, y (n_state), u (n_inputs; None: defaults); into `out` where given."""
        cdef Py_buffer state, signals, rates
        cdef const double *inputs = self.model.input_defaults
        cdef em_fault fault
        cdef int failed
        dy = _empty(self.n_state) if out is None else out
        borrow(y, self.n_state, &state, "y")
        try:
            if u is not None:
                inputs = borrow(u, self.n_inputs, &signals, "inputs")
            try:
                if out is not None and (not lends(out, self.n_state, &rates) or not self.apart(&state, &rates)):
                    dy = _empty(self.n_state)
                PyObject_GetBuffer(dy, &rates, PyBUF_WRITABLE)
                failed = self.model.rhs(t, <const double *> state.buf, c.c, inputs, <double *> rates.buf, &fault)
                PyBuffer_Release(&rates)
            finally:
                if u is not None:
                    PyBuffer_Release(&signals)
        finally:
            PyBuffer_Release(&state)
        if failed:
            raise self.failure(&fault)
        if dy is not out and out is not None:
            out[...] = dy
            return out
        return dy

    cdef bint apart(self, Py_buffer *state, Py_buffer *rates) noexcept:
        """Whether out and y share no memory; the compiled code reads y after writing. Gives `rates` back."""
        cdef bint distinct = (<char *> rates.buf >= <char *> state.buf + state.len
                              or <char *> state.buf >= <char *> rates.buf + rates.len)
        PyBuffer_Release(rates)
        return distinct

    def state(self, double t, x, v, Prepared c not None):
        """y (n_state), published meaning."""
        cdef em_fault fault
        cdef const double[::1] q = shaped(x, (self.n,), "x"), w = shaped(v, (self.n,), "v")
        out = np.zeros(self.n_state)
        cdef double[::1] y = out
        if self.model.state(t, &q[0], &w[0], c.c, &y[0], &fault) != 0:
            raise self.failure(&fault)
        return out

    def mass_matrix(self, double t, x, Prepared c not None):
        """M (n, n)."""
        cdef const double[::1] q = shaped(x, (self.n,), "x")
        out = np.zeros((self.n, self.n))
        cdef double[:, ::1] M = out
        self.model.mass_matrix(t, &q[0], c.c, &M[0, 0])
        return out

    def mass_matrix_gradient(self, double t, x, Prepared c not None):
        """dM (n, n, n), [k, i, j] = dM_ij / dx_k."""
        cdef const double[::1] q = shaped(x, (self.n,), "x")
        out = np.zeros((self.n, self.n, self.n))
        cdef double[:, :, ::1] dM = out
        self.model.mass_matrix_gradient(t, &q[0], c.c, &dM[0, 0, 0])
        return out

    def pfaffian(self, double t, x, Prepared c not None):
        """A (m, n), b (m) of A v + b = 0 (8)."""
        cdef const double[::1] q = shaped(x, (self.n,), "x")
        rows, rates = np.zeros((self.m, self.n)), np.zeros(self.m)
        cdef double[:, ::1] A = rows
        cdef double[::1] b = rates
        if self.m > 0:
            self.model.pfaffian(t, &q[0], c.c, &A[0, 0], &b[0])
        return rows, rates

    def position(self, double t, x, Prepared c not None):
        """phi (h): how far x is off the holonomic constraints."""
        return self.position_rows(np.array([t]), shaped(x, (self.n,), "x")[None], c)[0]

    def acceleration(self, double t, x, v, Prepared c not None, u, bint least_norm):
        """a (n), lambda (m)."""
        cdef em_fault fault
        cdef const double[::1] q = shaped(x, (self.n,), "x"), w = shaped(v, (self.n,), "v")
        cdef const double[::1] s = shaped(u, (self.n_inputs,), "inputs")
        out, multipliers = np.zeros(self.n), np.zeros(self.m)
        cdef double[::1] a = out, L = multipliers
        if self.model.acceleration(t, &q[0], &w[0], c.c, &s[0], least_norm, &a[0], &L[0], &fault) != 0:
            raise self.failure(&fault)
        return out, multipliers

    def project(self, double t, x, v, Prepared c not None, bint least_norm):
        """x (n), v (n): the nearest consistent state in the mass metric."""
        cdef em_fault fault
        position, velocity = shaped(x, (self.n,), "x").copy(), shaped(v, (self.n,), "v").copy()
        cdef double[::1] q = position, w = velocity
        if self.model.project(t, &q[0], &w[0], c.c, least_norm, &fault) != 0:
            raise self.failure(&fault)
        return position, velocity

    def jacobian(self, double t, y, Prepared c not None, u):
        """(n_state, n_state): d rhs / d y."""
        cdef em_fault fault
        cdef const double[::1] q = shaped(y, (self.n_state,), "y"), s = shaped(u, (self.n_inputs,), "inputs")
        out = np.zeros((self.n_state, self.n_state))
        cdef double[:, ::1] J = out
        if self.model.jacobian(t, &q[0], c.c, &s[0], &J[0, 0], &fault) != 0:
            raise self.failure(&fault)
        return out

    def motion_rate(self, double t, z, Prepared c not None, u, bint least_norm):
        """(v, xddot) (2 n) at z = (x, v)."""
        cdef em_fault fault
        cdef const double[::1] q = shaped(z, (2 * self.n,), "z"), s = shaped(u, (self.n_inputs,), "inputs")
        out, multipliers = np.zeros(2 * self.n), np.zeros(self.m + 1)
        cdef double[::1] rate = out, L = multipliers
        memcpy(&rate[0], &q[self.n], self.n * sizeof(double))
        if self.model.acceleration(t, &q[0], &q[self.n], c.c, &s[0], least_norm, &rate[self.n], &L[0], &fault) != 0:
            raise self.failure(&fault)
        return out

    def motion_jacobian(self, double t, z, Prepared c not None, u, bint least_norm):
        """(2 n, 2 n): d (v, xddot) / d (x, v)."""
        cdef em_fault fault
        cdef const double[::1] q = shaped(z, (2 * self.n,), "z"), s = shaped(u, (self.n_inputs,), "inputs")
        out = np.zeros((2 * self.n, 2 * self.n))
        cdef double[:, ::1] J = out
        if self.model.motion_jacobian(t, &q[0], c.c, &s[0], least_norm, &J[0, 0], &fault) != 0:
            raise self.failure(&fault)
        return out

    def state_rows(self, t, x, v, Prepared c not None):
        """y (k, n_state), published meaning, eigenfactors continuous from row to row."""
        cdef em_fault fault
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x, w = v
        cdef Py_ssize_t i, count = T.shape[0]
        out = np.zeros((count, self.n_state))
        cdef double[:, ::1] y = out
        with nogil:
            for i in range(count):
                if i > 0:
                    memcpy(&y[i, 0], &y[i - 1, 0], self.n_state * sizeof(double))
                if self.model.state(T[i], &q[i, 0], &w[i, 0], c.c, &y[i, 0], &fault) != 0:
                    blank(&y[i, 0], self.n_state)
        return out

    def velocity_rows(self, t, y, Prepared c not None):
        """v (k, n)."""
        cdef em_fault fault
        cdef const double[::1] T = t
        cdef const double[:, ::1] Y = y
        cdef Py_ssize_t i, count = T.shape[0]
        out = np.empty((count, self.n))
        cdef double[:, ::1] v = out
        with nogil:
            for i in range(count):
                if self.model.velocity(T[i], &Y[i, 0], c.c, &v[i, 0], &fault) != 0:
                    blank(&v[i, 0], self.n)
        return out

    def energy_rows(self, t, x, v, Prepared c not None):
        """T2, T1, T0, V as (k, 4)."""
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x, w = v
        cdef Py_ssize_t i, count = T.shape[0]
        out = np.empty((count, 4))
        cdef double[:, ::1] e = out
        with nogil:
            for i in range(count):
                self.model.energy(T[i], &q[i, 0], &w[i, 0], c.c, &e[i, 0])
        return out

    def acceleration_rows(self, t, x, v, u, Prepared c not None, bint least_norm):
        """a (k, n), lambda (k, m)."""
        cdef em_fault fault
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x, w = v, s = u
        cdef Py_ssize_t i, count = T.shape[0]
        accelerations, multipliers = np.empty((count, self.n)), np.empty((count, self.m))
        cdef double[:, ::1] a = accelerations, L = multipliers
        with nogil:
            for i in range(count):
                if self.model.acceleration(T[i], &q[i, 0], &w[i, 0], c.c, &s[i, 0], least_norm,
                                           &a[i, 0], &L[i, 0], &fault) != 0:
                    blank(&a[i, 0], self.n)
                    blank(&L[i, 0], self.m)
        return accelerations, multipliers

    def constraint_rows(self, t, x, v, Prepared c not None):
        """A v + b as (k, m)."""
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x, w = v
        cdef Py_ssize_t i, r, j, count = T.shape[0]
        out, matrix, rates = np.empty((count, self.m)), np.zeros((self.m, self.n)), np.zeros(self.m)
        cdef double[:, ::1] residual = out, A = matrix
        cdef double[::1] b = rates
        if self.m == 0:
            return out
        with nogil:
            for i in range(count):
                self.model.pfaffian(T[i], &q[i, 0], c.c, &A[0, 0], &b[0])
                for r in range(self.m):
                    residual[i, r] = b[r]
                    for j in range(self.n):
                        residual[i, r] += A[r, j] * w[i, j]
        return out

    def position_rows(self, t, x, Prepared c not None):
        """phi as (k, h)."""
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x
        cdef Py_ssize_t i, count = T.shape[0]
        out = np.zeros((count, self.h))
        cdef double[:, ::1] phi = out
        if self.h > 0:
            with nogil:
                for i in range(count):
                    self.model.position(T[i], &q[i, 0], c.c, &phi[i, 0])
        return out

    def quasi_rows(self, t, x, v, Prepared c not None):
        """y = P(x, t) v as (k, n_quasi)."""
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x, w = v
        cdef Py_ssize_t i, count = T.shape[0]
        out = np.zeros((count, self.model.n_quasi))
        cdef double[:, ::1] y = out
        if self.model.n_quasi > 0:
            with nogil:
                for i in range(count):
                    self.model.quasi(T[i], &q[i, 0], &w[i, 0], c.c, &y[i, 0])
        return out

    def event_rows(self, t, x, v, u, Prepared c not None):
        """What passes through zero where an event happens, as (k, n_events)."""
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x, w = v, s = u
        cdef Py_ssize_t i, count = T.shape[0]
        out = np.zeros((count, self.n_events))
        cdef double[:, ::1] g = out
        if self.n_events > 0:
            with nogil:
                for i in range(count):
                    self.model.event(T[i], &q[i, 0], &w[i, 0], c.c, &s[i, 0], &g[i, 0])
        return out

    @property
    def event_kinds(self):
        """(direction, terminal) of each event."""
        return tuple([(self.model.event_direction[k], self.model.event_terminal[k] != 0) for k in range(self.n_events)])

    def eigenfactor_rows(self, t, x, Prepared c not None):
        """C (k, n, n), s (k, n) of M(x); each row continues the signs and the order of the last good one."""
        cdef em_fault fault
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x
        cdef Py_ssize_t i, last = -1, count = T.shape[0]
        rotations, roots = np.zeros((count, self.n, self.n)), np.zeros((count, self.n))
        cdef double[:, :, ::1] C = rotations
        cdef double[:, ::1] s = roots
        with nogil:
            for i in range(count):
                if last >= 0:
                    memcpy(&C[i, 0, 0], &C[last, 0, 0], self.n * self.n * sizeof(double))
                    memcpy(&s[i, 0], &s[last, 0], self.n * sizeof(double))
                if self.model.eigenfactors(T[i], &q[i, 0], c.c, &C[i, 0, 0], &s[i, 0], &fault) == 0:
                    last = i
                else:
                    blank(&C[i, 0, 0], self.n * self.n)
                    blank(&s[i, 0], self.n)
        return rotations, roots

    def factor_rows(self, t, x, C, s, Prepared c not None):
        """max|M - C^T S^2 C| / max|M| as (k,), M in the units of the eigenproblem."""
        cdef const double[::1] T = t, unit = self.scales
        cdef const double[:, ::1] q = x, root = s
        cdef const double[:, :, ::1] R = C
        cdef Py_ssize_t i, j, k, r, count = T.shape[0]
        cdef double error, largest, entry, product
        out, matrix = np.empty(count), np.zeros((self.n, self.n))
        cdef double[::1] residual = out
        cdef double[:, ::1] M = matrix
        with nogil:
            for i in range(count):
                self.model.mass_matrix(T[i], &q[i, 0], c.c, &M[0, 0])
                error = largest = 0.0
                for j in range(self.n):
                    for k in range(self.n):
                        entry, product = M[j, k] * unit[j] * unit[k], 0.0
                        for r in range(self.n):
                            product = product + R[i, r, j] * root[i, r] * root[i, r] * R[i, r, k]
                        # NaN must show, and no comparison with it is true
                        if fabs(entry - product) > error or isnan(product) or isnan(entry):
                            error = fabs(entry - product)
                        largest = max(largest, fabs(entry))
                residual[i] = error / largest
        return out

    def output_rows(self, t, x, v, u, Prepared c not None, bint least_norm):
        """The outputs as (k, n_outputs)."""
        cdef em_fault fault
        cdef const double[::1] T = t
        cdef const double[:, ::1] q = x, w = v, s = u
        cdef Py_ssize_t i, count = T.shape[0]
        out = np.zeros((count, self.n_outputs))
        cdef double[:, ::1] z = out
        if self.n_outputs > 0:
            with nogil:
                for i in range(count):
                    if self.model.output(T[i], &q[i, 0], &w[i, 0], c.c, &s[i, 0], least_norm, &z[i, 0], &fault) != 0:
                        blank(&z[i, 0], self.n_outputs)
        return out


cdef int poll(void *argument) noexcept with gil:
    """Non-zero where a signal asks for the end of the run. Other exceptions of a handler are raised after it."""
    cdef Run run = <Run> argument
    try:
        PyErr_CheckSignals()
    except KeyboardInterrupt:
        return 1
    except BaseException as error:
        run.pending = error
        return 1
    return 0


cdef class Run:
    """One compiled simulation: what it was given, and what came of it, until the object goes.

    Parameters
    ----------
    y
        (n_state) the start, published meaning.
    inputs
        A (kind, times, values) for each input, as `em_signal` has them.
    method
        0 rk34, 1 dopri5, 2 dop853.
    atol
        (n).
    t_eval
        (k,) in the direction of time, or None: a row for every accepted step.
    """

    cdef em_run run
    cdef em_signal *signals
    cdef readonly CompiledModel model
    cdef readonly object stop
    cdef list held
    cdef object pending

    def __cinit__(self, CompiledModel model not None, Prepared c not None, *, double t_start, double t_end, y,
                  tuple inputs, int method, double rtol, atol, double first_step, double max_step, long max_steps,
                  bint project, bint least_norm, bint dense, t_eval):
        cdef em_run *run = &self.run
        memset(run, 0, sizeof(em_run))
        self.model, self.held = model, [c]
        run.model, run.prepared = model.model, c.c
        run.t_start, run.t_end, run.y_start = t_start, t_end, self.hold(shaped(y, (model.n_state,), "y"))
        run.method, run.rtol, run.atol = <em_method> method, rtol, self.hold(shaped(atol, (model.n,), "atol"))
        run.first_step, run.max_step, run.max_steps = first_step, max_step, max_steps
        run.stabilise, run.least_norm, run.dense = project, least_norm, dense
        run.event_direction, run.event_terminal = model.model.event_direction, model.model.event_terminal
        run.poll, run.poll_argument = poll, <void *> self
        if t_eval is not None:
            run.n_t_eval = len(t_eval)
            run.t_eval = self.hold(t_eval)
        self.hold_inputs(inputs)
        self.go()

    def __dealloc__(self):
        if self.run.model != NULL:
            self.run.model.release(&self.run)
        free(self.signals)

    cdef const double *hold(self, array) except NULL:
        """The numbers of an array that lives as long as the run."""
        array = np.array(array, dtype=np.float64, order="C")
        self.held.append(array)
        cdef const double[::1] flat = array.reshape(-1)
        return &flat[0]

    cdef hold_inputs(self, tuple inputs):
        cdef Py_ssize_t k
        self.signals = <em_signal *> calloc(len(inputs) + 1, sizeof(em_signal))
        if self.signals == NULL:
            raise MemoryError
        for k, (kind, times, values) in enumerate(inputs):
            self.signals[k].kind = <em_signal_kind> (<int> kind)
            self.signals[k].count = len(times)
            self.signals[k].times = self.hold(times)
            self.signals[k].values = self.hold(values)
        self.run.inputs = self.signals

    cdef go(self):
        cdef int status
        with nogil:
            status = self.model.model.simulate(&self.run)
        if self.pending is not None:
            raise self.pending
        self.stop = _REASONS[status]

    cdef table(self, em_rows *rows):
        """t (k,), y (k, n_state): copies, so that they outlive the run."""
        cdef Py_ssize_t count = rows.count
        times, states = np.empty(count), np.empty((count, self.model.n_state))
        cdef double[::1] t = times
        cdef double[:, ::1] y = states
        if count > 0:
            memcpy(&t[0], rows.t, count * sizeof(double))
            memcpy(&y[0, 0], rows.y, count * self.model.n_state * sizeof(double))
        return times, states

    @property
    def rows(self):
        """t (k,), y (k, n_state)."""
        return self.table(&self.run.rows)

    @property
    def events(self):
        """For each event t (k,), y (k, n_state)."""
        if self.run.events == NULL:
            return tuple([(np.empty(0), np.empty((0, self.model.n_state))) for _ in self.model.events])
        return tuple([self.table(&self.run.events[k]) for k in range(self.model.n_events)])

    @property
    def counts(self):
        """n_rhs, n_steps, n_rejected, n_bounded."""
        return self.run.n_rhs, self.run.n_steps, self.run.n_rejected, self.run.n_bounded

    @property
    def t_reached(self):
        return self.run.t_reached

    @property
    def message(self):
        """How the run ended, where, and what to do."""
        fault = self.run.fault
        words = explain(self.stop, self.model.coordinates, fault.first, fault.second, fault.size)
        return words if self.stop is StopReason.FINISHED else f"At t = {self.run.t_reached:.9g}: {words}"

    @property
    def step_times(self):
        """(n_dense + 1,) ends of the steps kept for dense output."""
        cdef Py_ssize_t k, count = self.run.n_dense
        starts = [self.run.dense_steps[k].t for k in range(count)]
        return np.array(starts + [self.run.t_reached] if count else starts)

    def interpolate(self, t):
        """y (k, n_state) at t (k,), published meaning, settled like accepted steps."""
        cdef const double[::1] T = t
        cdef Py_ssize_t i, count = T.shape[0]
        cdef int failed = 0
        out = np.empty((count, self.model.n_state))
        cdef double[:, ::1] y = out
        with nogil:
            for i in range(count):
                if self.model.model.interpolate(&self.run, self.step_at(T[i]), T[i], &y[i, 0]) != 0:
                    blank(&y[i, 0], self.model.n_state)
        return out

    cdef size_t step_at(self, double t) noexcept nogil:
        """The last kept step that starts at or before t, in the direction of time."""
        cdef size_t low = 0, high = self.run.n_dense, middle
        cdef double sign = 1.0 if self.run.t_end > self.run.t_start else -1.0
        while high - low > 1:
            middle = (low + high) // 2
            if sign * self.run.dense_steps[middle].t <= sign * t:
                low = middle
            else:
                high = middle
        return low
