# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""The ABI of eigenmotion.h on float64 arrays. Nothing is shared between calls, so threads need no locks.

Arguments of rows: t (k,), x and v (k, n), y (k, n_state), u (k, n_inputs), one row a time.
Rows at which a function has no value are NaN; single calls raise EvaluationError.
"""

cimport cython
from cpython.buffer cimport PyBUF_FULL_RO, PyBUF_ND
from cpython.buffer cimport PyBuffer_IsContiguous, PyBuffer_Release, PyObject_CheckBuffer, PyObject_GetBuffer
from cpython.exc cimport PyErr_CheckSignals
from cpython.pycapsule cimport PyCapsule_GetPointer
from libc.math cimport NAN, fabs, isnan
from libc.stdlib cimport calloc, free
from libc.string cimport memcpy

import numpy as np

from .faults import EvaluationError, StopReason, explain

_REASONS = tuple(StopReason)
_FINISHED = explain(StopReason.FINISHED, ())
_zeros = np.zeros


@cython.final
@cython.freelist(16)
cdef class Numbers:
    """The numbers of an array as the ABI takes them, float64 and C-contiguous, for as long as this object lives."""

    cdef Py_buffer view
    cdef object array
    cdef double *data
    cdef Py_ssize_t width

    def __dealloc__(self):
        PyBuffer_Release(&self.view)

    cdef int hold(self, object array, int flags) except -1:
        cdef int axis
        PyObject_GetBuffer(array, &self.view, flags)
        self.array, self.data, self.width = array, <double *> self.view.buf, 1
        for axis in range(1, self.view.ndim):
            self.width *= self.view.shape[axis]
        return 0

    cdef bint borrow(self, object a, tuple shape) except -1:
        """Hold a, if it is such an array, and of that shape."""
        cdef int axis
        if not PyObject_CheckBuffer(a):
            return False
        self.hold(a, PyBUF_FULL_RO)
        cdef bint fits = (self.view.ndim == len(shape) and self.view.format[0] == c"d" and self.view.format[1] == 0
                          and PyBuffer_IsContiguous(&self.view, b"C"))
        for axis in range(self.view.ndim if fits else 0):
            fits = fits and self.view.shape[axis] == <Py_ssize_t> shape[axis]
        if not fits:
            PyBuffer_Release(&self.view)
        return fits

    cdef inline double *row(self, Py_ssize_t i) noexcept nogil:
        """Those at index i of the first axis."""
        return self.data + i * self.width

    cdef bint overlaps(self, Numbers other) noexcept:
        cdef char *mine = <char *> self.view.buf
        cdef char *theirs = <char *> other.view.buf
        return mine < theirs + other.view.len and theirs < mine + self.view.len


cdef Numbers given(object a, tuple shape, str name):
    """The numbers of a, of any stride and type; it must have that shape."""
    cdef Numbers made = Numbers.__new__(Numbers)
    if made.borrow(a, shape):
        return made
    if np.iscomplexobj(a):
        raise ValueError(f"{name} is complex; give real numbers")
    if not made.borrow(np.ascontiguousarray(a, dtype=np.float64), shape):
        raise ValueError(f"{name} has shape {np.shape(a)}, but this model needs {shape}")
    return made


cdef bint takes(object out, tuple shape) except -1:
    """Whether it is an array that floating point numbers can be written to: integers would lose what is behind the point."""
    return isinstance(out, np.ndarray) and out.dtype.kind == "f" and out.shape == shape and out.flags.writeable


cdef Numbers zeros(tuple shape):
    """A new array of zeros."""
    cdef Numbers made = Numbers.__new__(Numbers)
    made.hold(_zeros(shape), PyBUF_ND)
    return made


cdef tuple texts(const char *const *names, int count):
    return tuple([names[k].decode("utf-8") for k in range(count)])


cdef object constants(const double *values, int count):
    return np.array([values[k] for k in range(count)], dtype=np.float64)


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

    def __reduce__(self):
        """Prepared anew where it is loaded."""
        return _prepared, (self.model, self.parameters)


def _prepared(CompiledModel model not None, parameters):
    return model.prepare(np.array(parameters, dtype=np.float64))


cdef class CompiledModel:
    """One `em_model`. The capsule must be named "eigenmotion.em_model" and point at a constant that outlives it."""

    cdef const em_model *model
    cdef readonly str name, formulation, close_eigenvalues, schur
    cdef readonly int n, m, h, n_state, n_inputs, n_outputs, n_events
    cdef readonly tuple coordinates, parameters, inputs, outputs, events, left_out, layout, block, carried
    cdef readonly tuple quasi_velocities, event_kinds
    cdef readonly bint augmented
    cdef readonly object parameter_defaults, input_defaults, initial_x, initial_v, initial_y, scales
    cdef readonly bint conserves_energy
    cdef public object recipe
    """Returns, in any process, the System of this model; None where there is no way to it but the capsule."""

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
        self.event_kinds = tuple([(c.event_direction[k], c.event_terminal[k] != 0) for k in range(c.n_events)])

    cdef read_defaults(self):
        cdef const em_model *c = self.model
        self.parameter_defaults = constants(c.parameter_defaults, c.n_parameters)
        self.input_defaults = constants(c.input_defaults, c.n_inputs)
        self.initial_x, self.initial_v = constants(c.initial_x, c.n), constants(c.initial_v, c.n)
        self.initial_y = constants(c.initial_y, c.n) if c.initial_y != NULL else None
        self.scales = constants(c.scales, c.n)
        self.augmented = c.factored_matrix != NULL

    def __reduce__(self):
        """As the way to make it."""
        if self.recipe is None:
            raise TypeError(f"{self.name} was made from a capsule alone, so another process cannot make it; "
                            "what eigenmotion.build returns can be pickled")
        return _compiled, (self.recipe,)

    cdef failure(self, em_fault *fault):
        stop = _REASONS[<int> fault.status]
        words = explain(stop, self.coordinates, fault.first, fault.second, fault.size)
        return EvaluationError(f"{self.name}: {words}", stop)

    # --- at one place; x, v, a (n), lambda (m), y (n_state), u (n_inputs) ---

    def prepare(self, values):
        """values (n_parameters) -> Prepared."""
        cdef em_fault fault
        cdef Prepared made = Prepared.__new__(Prepared)
        cdef Numbers p = given(values, (self.model.n_parameters,), "parameters")
        made.model = self
        made.parameters = tuple([p.data[k] for k in range(self.model.n_parameters)])
        made.c = <double *> calloc(self.model.n_prepared + 1, sizeof(double))
        if made.c == NULL:
            raise MemoryError
        if self.model.prepare(p.data, made.c, &fault) != 0:
            raise self.failure(&fault)
        return made

    def rhs(self, double t, y, Prepared c not None, u=None, out=None):
        """dy at t, y, u (None: defaults); into `out` where given."""
        cdef em_fault fault
        cdef tuple shape = (self.n_state,)
        cdef Numbers state = given(y, shape, "y"), inputs, dy = Numbers.__new__(Numbers)
        cdef const double *signals = self.model.input_defaults
        if u is not None:
            inputs = given(u, (self.n_inputs,), "inputs")
            signals = inputs.data
        # the compiled code reads y after writing dy
        if out is None or not dy.borrow(out, shape) or dy.view.readonly or dy.overlaps(state):
            if out is not None and not takes(out, shape):
                raise ValueError(f"out must be a writable array of floating point numbers of shape {shape}")
            dy = zeros(shape)
        if self.model.rhs(t, state.data, c.c, signals, dy.data, &fault) != 0:
            raise self.failure(&fault)
        if out is None or out is dy.array:
            return dy.array
        out[...] = dy.array
        return out

    def state(self, double t, x, v, Prepared c not None):
        """y, published meaning."""
        cdef em_fault fault
        cdef Numbers q = given(x, (self.n,), "x"), w = given(v, (self.n,), "v"), y = zeros((self.n_state,))
        if self.model.state(t, q.data, w.data, c.c, y.data, &fault) != 0:
            raise self.failure(&fault)
        return y.array

    def start(self, double t, x, v, Prepared c not None, double tolerance, atol):
        """y where a run can start at x, v; None where that takes a closer look (em_start.h)."""
        cdef Numbers q = given(x, (self.n,), "x"), w = given(v, (self.n,), "v"), y = zeros((self.n_state,))
        cdef Numbers least = given(atol, (self.n,), "atol")
        return y.array if em_start(self.model, t, q.data, w.data, c.c, tolerance, least.data, y.data) else None

    def mass_matrix(self, double t, x, Prepared c not None):
        """M (n, n)."""
        cdef Numbers q = given(x, (self.n,), "x"), M = zeros((self.n, self.n))
        self.model.mass_matrix(t, q.data, c.c, M.data)
        return M.array

    def mass_matrix_gradient(self, double t, x, Prepared c not None):
        """dM (n, n, n), [k, i, j] = dM_ij / dx_k."""
        cdef Numbers q = given(x, (self.n,), "x"), dM = zeros((self.n, self.n, self.n))
        self.model.mass_matrix_gradient(t, q.data, c.c, dM.data)
        return dM.array

    def factored_matrix(self, double t, x, Prepared c not None):
        """What is factored (n, n): M, or M + A^T W A where M is singular."""
        cdef Numbers q = given(x, (self.n,), "x"), M = zeros((self.n, self.n))
        em_factored_matrix(self.model, t, q.data, c.c, M.data)
        return M.array

    def factored_gradient(self, double t, x, Prepared c not None):
        """Its gradient (n, n, n), as mass_matrix_gradient."""
        cdef Numbers q = given(x, (self.n,), "x"), dM = zeros((self.n, self.n, self.n))
        em_factored_gradient(self.model, t, q.data, c.c, dM.data)
        return dM.array

    def pfaffian(self, double t, x, Prepared c not None):
        """A (m, n), b (m) of A v + b = 0 (8)."""
        cdef Numbers q = given(x, (self.n,), "x"), A = zeros((self.m, self.n)), b = zeros((self.m,))
        if self.m > 0:
            self.model.pfaffian(t, q.data, c.c, A.data, b.data)
        return A.array, b.array

    def position(self, double t, x, Prepared c not None):
        """phi (h): how far x is off the holonomic constraints; (h) the size of the terms that cancel in them."""
        cdef Numbers q = given(x, (self.n,), "x"), phi = zeros((self.h,)), terms = zeros((self.h,))
        if self.h > 0:
            self.model.position(t, q.data, c.c, phi.data, terms.data)
        return phi.array, terms.array

    def acceleration(self, double t, x, v, Prepared c not None, u, bint least_norm):
        """a, lambda."""
        cdef em_fault fault
        cdef Numbers q = given(x, (self.n,), "x"), w = given(v, (self.n,), "v"), s = given(u, (self.n_inputs,), "inputs")
        cdef Numbers a = zeros((self.n,)), multipliers = zeros((self.m,))
        if self.model.acceleration(t, q.data, w.data, c.c, s.data, least_norm, a.data, multipliers.data, &fault) != 0:
            raise self.failure(&fault)
        return a.array, multipliers.array

    def project(self, double t, x, v, Prepared c not None, bint least_norm):
        """x, v: the nearest consistent state in the mass metric."""
        cdef em_fault fault
        cdef Numbers q = given(np.array(x, dtype=np.float64), (self.n,), "x")
        cdef Numbers w = given(np.array(v, dtype=np.float64), (self.n,), "v")
        if self.model.project(t, q.data, w.data, c.c, least_norm, &fault) != 0:
            raise self.failure(&fault)
        return q.array, w.array

    def jacobian(self, double t, y, Prepared c not None, u):
        """(n_state, n_state): d rhs / d y."""
        cdef em_fault fault
        cdef Numbers q = given(y, (self.n_state,), "y"), s = given(u, (self.n_inputs,), "inputs")
        cdef Numbers J = zeros((self.n_state, self.n_state))
        if self.model.jacobian(t, q.data, c.c, s.data, J.data, &fault) != 0:
            raise self.failure(&fault)
        return J.array

    def motion_rate(self, double t, z, Prepared c not None, u, bint least_norm):
        """(v, a) (2 n) at z = (x, v)."""
        cdef em_fault fault
        cdef Numbers q = given(z, (2 * self.n,), "z"), s = given(u, (self.n_inputs,), "inputs")
        cdef Numbers rate = zeros((2 * self.n,)), multipliers = zeros((self.m,))
        cdef double *v = q.data + self.n
        memcpy(rate.data, v, self.n * sizeof(double))
        if self.model.acceleration(t, q.data, v, c.c, s.data, least_norm, rate.data + self.n, multipliers.data,
                                   &fault) != 0:
            raise self.failure(&fault)
        return rate.array

    def motion_jacobian(self, double t, z, Prepared c not None, u, bint least_norm):
        """(2 n, 2 n): d (v, a) / d (x, v)."""
        cdef em_fault fault
        cdef Numbers q = given(z, (2 * self.n,), "z"), s = given(u, (self.n_inputs,), "inputs")
        cdef Numbers J = zeros((2 * self.n, 2 * self.n))
        if self.model.motion_jacobian(t, q.data, c.c, s.data, least_norm, J.data, &fault) != 0:
            raise self.failure(&fault)
        return J.array

    # --- at k places ---

    def state_rows(self, t, x, v, Prepared c not None):
        """y (k, n_state), published meaning, eigenfactors continuous from row to row."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), w = given(v, (k, self.n), "v")
        cdef Numbers y = zeros((k, self.n_state))
        with nogil:
            for i in range(k):
                if i > 0:
                    memcpy(y.row(i), y.row(i - 1), self.n_state * sizeof(double))
                if self.model.state(T.data[i], q.row(i), w.row(i), c.c, y.row(i), &fault) != 0:
                    blank(y.row(i), self.n_state)
        return y.array

    def velocity_rows(self, t, y, Prepared c not None):
        """v (k, n)."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), Y = given(y, (k, self.n_state), "y"), v = zeros((k, self.n))
        with nogil:
            for i in range(k):
                if self.model.velocity(T.data[i], Y.row(i), c.c, v.row(i), &fault) != 0:
                    blank(v.row(i), self.n)
        return v.array

    def energy_rows(self, t, x, v, Prepared c not None):
        """T2, T1, T0, V as (k, 4)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), w = given(v, (k, self.n), "v")
        cdef Numbers e = zeros((k, 4))
        with nogil:
            for i in range(k):
                self.model.energy(T.data[i], q.row(i), w.row(i), c.c, e.row(i))
        return e.array

    def acceleration_rows(self, t, x, v, u, Prepared c not None, bint least_norm):
        """a (k, n), lambda (k, m)."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), w = given(v, (k, self.n), "v")
        cdef Numbers s = given(u, (k, self.n_inputs), "inputs"), a = zeros((k, self.n)), L = zeros((k, self.m))
        with nogil:
            for i in range(k):
                if self.model.acceleration(T.data[i], q.row(i), w.row(i), c.c, s.row(i), least_norm, a.row(i), L.row(i),
                                           &fault) != 0:
                    blank(a.row(i), self.n)
                    blank(L.row(i), self.m)
        return a.array, L.array

    def constraint_rows(self, t, x, v, Prepared c not None):
        """A v + b as (k, m)."""
        cdef Py_ssize_t i, r, j, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), w = given(v, (k, self.n), "v")
        cdef Numbers A = zeros((self.m, self.n)), residual = zeros((k, self.m))
        with nogil:
            for i in range(k if self.m > 0 else 0):
                self.model.pfaffian(T.data[i], q.row(i), c.c, A.data, residual.row(i))
                for r in range(self.m):
                    for j in range(self.n):
                        residual.row(i)[r] += A.row(r)[j] * w.row(i)[j]
        return residual.array

    def position_rows(self, t, x, Prepared c not None):
        """phi as (k, h)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), phi = zeros((k, self.h))
        cdef Numbers terms = zeros((self.h,))
        with nogil:
            for i in range(k if self.h > 0 else 0):
                self.model.position(T.data[i], q.row(i), c.c, phi.row(i), terms.data)
        return phi.array

    def quasi_rows(self, t, x, v, Prepared c not None):
        """y = P(x, t) v as (k, n_quasi)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), w = given(v, (k, self.n), "v")
        cdef Numbers y = zeros((k, self.model.n_quasi))
        with nogil:
            for i in range(k if self.model.n_quasi > 0 else 0):
                self.model.quasi(T.data[i], q.row(i), w.row(i), c.c, y.row(i))
        return y.array

    def event_rows(self, t, x, v, u, Prepared c not None):
        """What passes through zero where an event happens, as (k, n_events)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), w = given(v, (k, self.n), "v")
        cdef Numbers s = given(u, (k, self.n_inputs), "inputs"), g = zeros((k, self.n_events))
        with nogil:
            for i in range(k if self.n_events > 0 else 0):
                self.model.event(T.data[i], q.row(i), w.row(i), c.c, s.row(i), g.row(i))
        return g.array

    def output_rows(self, t, x, v, u, Prepared c not None, bint least_norm):
        """The outputs as (k, n_outputs)."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x"), w = given(v, (k, self.n), "v")
        cdef Numbers s = given(u, (k, self.n_inputs), "inputs"), z = zeros((k, self.n_outputs))
        with nogil:
            for i in range(k if self.n_outputs > 0 else 0):
                if self.model.output(T.data[i], q.row(i), w.row(i), c.c, s.row(i), least_norm, z.row(i), &fault) != 0:
                    blank(z.row(i), self.n_outputs)
        return z.array

    def eigenfactor_rows(self, t, x, Prepared c not None):
        """C (k, n, n), s (k, n) of M(x); each row continues the signs and the order of the last good one."""
        cdef em_fault fault
        cdef Py_ssize_t i, last = -1, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, self.n), "x")
        cdef Numbers C = zeros((k, self.n, self.n)), s = zeros((k, self.n))
        with nogil:
            for i in range(k):
                if last >= 0:
                    memcpy(C.row(i), C.row(last), C.width * sizeof(double))
                    memcpy(s.row(i), s.row(last), s.width * sizeof(double))
                if self.model.eigenfactors(T.data[i], q.row(i), c.c, C.row(i), s.row(i), &fault) == 0:
                    last = i
                else:
                    blank(C.row(i), C.width)
                    blank(s.row(i), s.width)
        return C.array, s.array

    def factor_rows(self, t, x, C, s, Prepared c not None):
        """max|M - C^T S^2 C| / max|M| as (k,), M what is factored, in the units of the eigenproblem."""
        cdef Py_ssize_t i, k = len(t), n = self.n
        cdef Numbers T = given(t, (k,), "t"), q = given(x, (k, n), "x"), R = given(C, (k, n, n), "C")
        cdef Numbers root = given(s, (k, n), "s"), M = zeros((n, n)), residual = zeros((k,))
        with nogil:
            for i in range(k):
                em_factored_matrix(self.model, T.data[i], q.row(i), c.c, M.data)
                residual.data[i] = self.factor_residual(M, R.row(i), root.row(i))
        return residual.array

    cdef double factor_residual(self, Numbers M, const double *C, const double *s) noexcept nogil:
        cdef Py_ssize_t i, j, r, n = self.n
        cdef double error = 0.0, largest = 0.0, entry, product
        for i in range(n):
            for j in range(n):
                entry, product = M.row(i)[j] * self.model.scales[i] * self.model.scales[j], 0.0
                for r in range(n):
                    product += C[r * n + i] * s[r] * s[r] * C[r * n + j]
                # NaN must show, and no comparison with it is true
                if fabs(entry - product) > error or isnan(entry - product):
                    error = fabs(entry - product)
                largest = max(largest, fabs(entry))
        return error / largest


def _compiled(recipe):
    return recipe().compiled


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
    """One compiled simulation, and what came of it until the object goes.

    Parameters
    ----------
    task
        An `eigenmotion.options.Task`.
    method
        0 rk34, 1 dopri5, 2 dop853.

    Attributes
    ----------
    stop
        A StopReason.
    """

    cdef em_run run
    cdef em_signal *signals
    cdef readonly CompiledModel model
    cdef readonly object stop
    cdef list held
    cdef object pending

    def __cinit__(self, task, int method):
        if task is not None:
            self.begin(task, method)

    cdef begin(self, task, int method):
        cdef em_run *run = &self.run
        cdef CompiledModel model = task.model
        cdef Prepared prepared = task.prepared
        self.model, self.held = model, [prepared]
        run.model, run.prepared, run.method = model.model, prepared.c, <em_method> method
        run.t_start, run.t_end, run.y_start = task.t_start, task.t_end, self.hold(task.y, model.n_state, "y")
        run.rtol, run.atol = task.rtol, self.hold(task.atol, model.n, "atol")
        run.first_step, run.max_step, run.max_steps = task.first_step, task.max_step, task.max_steps
        run.stabilise, run.least_norm, run.dense = task.project, task.least_norm, task.dense
        run.event_direction, run.event_terminal = model.model.event_direction, model.model.event_terminal
        run.poll, run.poll_argument = poll, <void *> self
        if task.t_eval is not None:
            run.n_t_eval = len(task.t_eval)
            run.t_eval = self.hold(task.t_eval, run.n_t_eval, "t_eval")
        if model.n_inputs > 0:
            self.hold_inputs(task.inputs.compiled)
        self.go()

    def __dealloc__(self):
        if self.run.model != NULL:
            self.run.model.release(&self.run)
        free(self.signals)

    cdef const double *hold(self, array, Py_ssize_t count, str name) except NULL:
        """The numbers of an array, which is to live as long as the run."""
        cdef Numbers kept = given(array, (count,), name)
        self.held.append(kept)
        return kept.data

    cdef hold_inputs(self, tuple inputs):
        cdef Py_ssize_t k
        self.signals = <em_signal *> calloc(len(inputs), sizeof(em_signal))
        if self.signals == NULL:
            raise MemoryError
        for k, (kind, times, values) in enumerate(inputs):
            self.signals[k].kind = <em_signal_kind> (<int> kind)
            self.signals[k].count = len(times)
            self.signals[k].times = self.hold(times, len(times), "times")
            self.signals[k].values = self.hold(values, len(values), "values")
        self.run.inputs = self.signals

    cdef go(self):
        cdef int status
        with nogil:
            status = self.run.model.simulate(&self.run)
        if self.pending is not None:
            raise self.pending
        self.stop = _REASONS[status]

    cdef table(self, em_rows *rows):
        """t (k,), y (k, n_state): copies, so that they outlive the run."""
        cdef Py_ssize_t k = rows.count
        cdef Numbers t = zeros((k,)), y = zeros((k, self.model.n_state))
        if k > 0:
            memcpy(t.data, rows.t, t.view.len)
            memcpy(y.data, rows.y, y.view.len)
        return t.array, y.array

    @property
    def rows(self):
        """t (k,), y (k, n_state)."""
        return self.table(&self.run.rows)

    @property
    def events(self):
        """For each event t (k,), and for each y (k, n_state); None where the model has none."""
        if self.run.events == NULL:
            return None, None
        return tuple(map(list, zip(*[self.table(&self.run.events[k]) for k in range(self.model.n_events)])))

    @property
    def counts(self):
        """n_rhs, n_steps, n_rejected, n_bounded."""
        return self.run.n_rhs, self.run.n_steps, self.run.n_rejected, self.run.n_bounded

    @property
    def n_dense(self):
        """How many steps are kept for dense output."""
        return self.run.n_dense

    @property
    def status(self):
        """As SciPy has it: 0 finished, 1 terminal event, -1 failed."""
        return <int> self.run.fault.status if self.run.fault.status <= EM_TERMINAL_EVENT else -1

    @property
    def message(self):
        """How the run ended, where, and what to do."""
        if self.stop is StopReason.FINISHED:
            return _FINISHED
        fault = self.run.fault
        words = explain(self.stop, self.model.coordinates, fault.first, fault.second, fault.size, self.model.events)
        return f"At t = {self.run.t_reached:.9g}: {words}"

    @property
    def step_times(self):
        """(n_dense + 1,) ends of the steps kept for dense output."""
        return np.array([*[self.run.dense_steps[k].t for k in range(self.run.n_dense)], self.run.t_reached])

    def __reduce__(self):
        """As its interpolants: what a run keeps for dense output."""
        cdef em_run *run = &self.run
        cdef Py_ssize_t width = EM_DENSE_COEFFICIENTS * self.model.n_state * sizeof(double)
        steps = (<char *> run.dense_steps)[:run.n_dense * sizeof(em_dense_step)] if run.n_dense else b""
        table = (<char *> run.dense_table)[:run.n_dense * width] if run.n_dense else b""
        times = run.t_start, run.t_end, run.t_reached
        return _kept, (self.held[0], <int> run.method, run.stabilise, run.least_norm, times, run.n_dense, steps, table)

    def interpolate(self, t):
        """y (k, n_state) at t (k,), published meaning, settled like accepted steps."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = given(t, (k,), "t"), y = zeros((k, self.model.n_state))
        with nogil:
            for i in range(k):
                if self.run.model.interpolate(&self.run, self.step_at(T.data[i]), T.data[i], y.row(i)) != 0:
                    blank(y.row(i), y.width)
        return y.array

    cdef size_t step_at(self, double t) noexcept nogil:
        """The last kept step that starts at or before t, in the direction of time."""
        cdef size_t low = 0, high = self.run.n_dense, middle
        cdef double sign = -1.0 if self.run.t_end < self.run.t_start else 1.0
        while high - low > 1:
            middle = (low + high) // 2
            if sign * self.run.dense_steps[middle].t <= sign * t:
                low = middle
            else:
                high = middle
        return low


def _kept(Prepared prepared not None, int method, int stabilise, int least_norm, times, size_t count,
          bytes steps, bytes table):
    """A run that is over, of which there are the interpolants."""
    cdef Run made = Run.__new__(Run, None, method)
    cdef em_run *run = &made.run
    made.model, made.held = prepared.model, [prepared]
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
    return made
