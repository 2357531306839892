# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Stepper: a run that the caller advances to chosen times (em_control.h for Python)."""

from hashlib import blake2b

from cpython.bytes cimport PyBytes_AS_STRING, PyBytes_FromStringAndSize
from libc.math cimport isfinite
from libc.stdlib cimport calloc, free
from libc.string cimport memcpy, memset

from .abi cimport em_fault, em_method, em_run, em_signal, em_signal_kind
from .arrays cimport Numbers, floats, zeros
from .control cimport em_stepper, em_stepper_advance, em_stepper_close, em_stepper_open, em_stepper_restore
from .control cimport em_stepper_save, em_stepper_size
from .point cimport PointModel, Prepared
from .run cimport Interruptible, poll

from .status.stop_reasons import MAYBE_UNDEFINED, EvaluationError, StopReason, explain

_REASONS = tuple(StopReason)

cdef enum:
    TAG = 16  # bytes


cdef class Steps(Interruptible):
    """One em_stepper.

    Parameters
    ----------
    task
        An `eigenmotion.arguments.tasks.Task`, of which the start, inputs, tolerances and step limits are used.
    method
        em_method; for methods of fixed step, the step is the task's first step.
    """

    cdef em_stepper *steps
    cdef em_signal *signals
    cdef double *u
    cdef readonly PointModel model
    cdef readonly object task
    cdef readonly int number
    cdef dict places
    cdef list keep_alive
    cdef bytes tag
    cdef bint busy

    def __cinit__(self, task, int method, *rest):
        cdef em_run run
        cdef PointModel model
        cdef Prepared prepared
        cdef Numbers y, atol
        (model, prepared, inputs, start, _, state, rtol, absolute, _, _, first, longest, most, stabilise, least) = task
        model.need_method(method)
        self.model, self.task, self.number, self.keep_alive = model, task, method, [prepared]
        self.places = {name: k for k, name in enumerate(model.inputs)}
        y, atol = floats(state, (model.n_state,), "y"), floats(absolute, (model.n,), "atol")
        self.hold_inputs(inputs.compiled)
        memset(&run, 0, sizeof(run))  # em_run(...) would leave other fields unset
        run.model, run.prepared, run.inputs, run.method = model.model, prepared.c, self.signals, <em_method> method
        run.t_start, run.y_start, run.rtol, run.atol = start, y.data, rtol, atol.data
        run.first_step, run.max_step, run.max_steps, run.stabilise, run.least_norm = first, longest, most, stabilise, least
        run.poll, run.poll_argument = poll, <void *> self
        self.steps = em_stepper_open(model.model, &run, NULL)
        if self.steps == NULL:
            raise MemoryError
        if self.steps.run.fault.status != 0:
            raise self.failure()

    def __dealloc__(self):
        em_stepper_close(self.steps)
        free(self.signals)
        free(self.u)

    cdef hold_inputs(self, tuple inputs):
        cdef Py_ssize_t k
        cdef Numbers times, values
        self.signals = <em_signal *> calloc(len(inputs) + 1, sizeof(em_signal))
        self.u = <double *> calloc(len(inputs) + 1, sizeof(double))
        if self.signals == NULL or self.u == NULL:
            raise MemoryError
        for k, (kind, at, samples) in enumerate(inputs):
            times, values = floats(at, (len(at),), "times"), floats(samples, (len(samples),), "values")
            self.keep_alive += times, values
            self.signals[k] = em_signal(kind=<em_signal_kind> (<int> kind), count=len(at), times=times.data,
                                        values=values.data)

    cdef failure(self):
        fault = self.steps.run.fault
        stop = _REASONS[<int> fault.status]
        words = explain(stop, self.model.coordinates, fault.first, fault.second, fault.size, self.model.events,
                        self.model.row_names, tuple(self.model.tables))
        if stop in MAYBE_UNDEFINED:
            x, v = self.copy(self.steps.x, self.model.n), self.copy(self.steps.v, self.model.n)
            words += self.model.undefined(self.steps.t, x, v, self.prepared, self.copy(self.steps.u, self.model.n_inputs))
        return EvaluationError(f"{self.model.name}: at t = {self.steps.t:.9g}: {words}", stop)

    cdef int set_inputs(self, inputs) except -1:
        """Set u from a dict of inputs by name (others keep their values), or from an array of all inputs."""
        cdef Py_ssize_t k
        cdef Numbers numbers
        memcpy(self.u, self.steps.u, self.model.n_inputs * sizeof(double))
        if type(inputs) is dict:
            for name, value in (<dict> inputs).items():
                k = self.place(name)
                try:
                    self.u[k] = value
                except TypeError:
                    raise TypeError(f"input {self.model.inputs[k]!r} is {value!r}, not a real number") from None
                self.check(k)
            return 0
        numbers = floats(inputs, (self.model.n_inputs,), "inputs")
        for k in range(self.model.n_inputs):
            self.u[k] = numbers.data[k]
            self.check(k)
        return 0

    cdef Py_ssize_t place(self, name) except -1:
        place = self.places.get(name)
        if place is None:
            place = self.places.get(str(name).removesuffix("(t)"))
        if place is None and str(name).removesuffix("(t)") in self.model.prescribed:
            raise ValueError(f"input {name!r} prescribes a motion, which cannot jump: give it when the stepper opens")
        if place is None:
            raise ValueError(f"unknown input {name!r}; known: {', '.join(self.places) or 'none'}")
        return place

    cdef int check(self, Py_ssize_t k) except -1:
        if not isfinite(self.u[k]):
            raise ValueError(f"input {self.model.inputs[k]!r} is {self.u[k]}, not a finite number")
        if self.signals[k].kind != <em_signal_kind> 0 and self.u[k] != self.steps.u[k]:
            raise ValueError(f"input {self.model.inputs[k]!r} is a signal of this stepper, which goes on as it is; "
                             "open one with a number for it to set it on the way")
        return 0

    @property
    def prepared(self):
        """The constants of the current mode of contacts and frictions (modes are among the parameters)."""
        cdef Py_ssize_t n = self.model.model.n_parameters
        cdef Numbers parameters
        if not self.model.switches:
            return self.task.prepared
        parameters = zeros((n,))
        memcpy(parameters.data, self.steps.run.prepared, n * sizeof(double))
        return self.model.prepare(parameters.array)

    cdef int claim(self) except -1:
        if self.busy:
            raise RuntimeError("this stepper is being advanced, by another thread or a signal handler: "
                               "each thread needs one of its own")
        return 0

    def advance(self, t, inputs=None):
        """Advance exactly to t, forwards or backwards, with these inputs from the current time on."""
        cdef const double *u = NULL
        cdef double there
        cdef int failed
        self.claim()
        try:
            there = t
        except TypeError:
            raise TypeError(f"t is {t!r}, not a real number") from None
        if not isfinite(there):
            raise ValueError(f"t is {there}, not a finite number")
        if self.model.acts and there < self.steps.t:
            raise ValueError(f"{self.model.name}: events that act do so forwards only, so this stepper cannot go back to "
                             f"t = {there:.9g}: restore what was saved there")
        if inputs is not None:
            self.set_inputs(inputs)
            u = self.u
        self.busy = True
        with nogil:
            failed = em_stepper_advance(self.steps, there, u)
        self.busy = False
        if failed:
            self.raise_pending(True)
            raise self.failure()

    @property
    def t(self):
        """[s] the current time."""
        return self.steps.t

    @property
    def x(self):
        """(n,) coordinates there."""
        return self.copy(self.steps.x, self.model.n_coordinates)

    @property
    def v(self):
        """(n,) velocities there."""
        return self.copy(self.steps.v, self.model.n_coordinates)

    @property
    def states(self):
        """Name -> value of the first-order states there."""
        cdef int n = self.model.n_coordinates
        return {self.model.coordinates[n + k]: self.steps.v[n + k] for k in range(self.model.n_states)}

    @property
    def motion(self):
        """x, v there in the form of compiled functions, in which the states are the last entries of v."""
        return self.copy(self.steps.x, self.model.n), self.copy(self.steps.v, self.model.n)

    @property
    def u(self):
        """(n_inputs,) current inputs; NaN for inputs that are signals."""
        cdef Numbers u = self.numbers(self.steps.u, self.model.n_inputs)
        for k in range(self.model.n_inputs):
            if self.signals[k].kind != <em_signal_kind> 0:
                u.data[k] = float("nan")
        return u.array

    @property
    def y(self):
        """(n_state,) the state there, published meaning."""
        cdef em_fault fault
        cdef Numbers y = zeros((self.model.n_state,))
        self.claim()
        if self.model.model.publish(self.steps.run_state, y.data, &fault) != 0:
            raise self.model.failure(&fault)
        return y.array

    cdef Numbers numbers(self, const double *numbers, int count):
        cdef Numbers copied = zeros((count,))
        memcpy(copied.data, numbers, count * sizeof(double))
        return copied

    cdef copy(self, const double *numbers, int count):
        return self.numbers(numbers, count).array

    @property
    def nfev(self):
        """Right-hand sides so far."""
        return self.steps.run.n_rhs

    @property
    def nsteps(self):
        """Accepted steps so far."""
        return self.steps.run.n_steps

    @property
    def nrejected(self):
        """Rejected steps so far."""
        return self.steps.run.n_rejected

    @property
    def events(self):
        """Event name -> times (k,) of its zero crossings in the last advance; the last 64 if there are more."""
        return {name: self.copy(self.steps.run.events[k].t, <int> self.steps.run.events[k].count)
                for k, name in enumerate(self.model.events)}

    def save(self):
        """The complete state of the stepper as bytes; `restore` reproduces every number to the last bit."""
        cdef bytes saved = PyBytes_FromStringAndSize(NULL, TAG + <Py_ssize_t> em_stepper_size(self.steps))
        cdef bytes tag = self.digest()
        self.claim()
        memcpy(PyBytes_AS_STRING(saved), PyBytes_AS_STRING(tag), TAG)
        em_stepper_save(self.steps, PyBytes_AS_STRING(saved) + TAG)
        return saved

    def restore(self, bytes saved not None):
        """Return to the state that `save` returned, here or in another stepper of the same model and options.

        Raises
        ------
        ValueError
            The bytes are of a stepper of another model, or with other parameters, method or tolerances.
        """
        self.claim()
        if len(saved) != TAG + <Py_ssize_t> em_stepper_size(self.steps) or saved[:TAG] != self.digest():
            raise ValueError(f"{self.model.name}: what is to be restored was saved by a stepper of another model, "
                             "or with other parameters, method, tolerances or compiled for another processor")
        em_stepper_restore(self.steps, PyBytes_AS_STRING(saved) + TAG)

    cdef bytes digest(self):
        """A digest of the data that must agree for one stepper to restore the bytes of another."""
        if self.tag is None:
            m, task = self.model, self.task
            signals = [(kind, times.tobytes(), values.tobytes()) for kind, times, values in task.inputs.compiled if kind]
            shared = (m.identity(task.prepared), self.number, task.rtol, task.atol.tobytes(), task.first_step,
                      task.max_step, task.stabilise, task.least_norm, signals)
            self.tag = blake2b(repr(shared).encode(), digest_size=TAG).digest()
        return self.tag

    def __reduce__(self):
        """Pickle the task and the saved state."""
        return _restored, (type(self), self.task, self.number, self.save())


def _restored(kind, task, int number, bytes saved):
    stepper = kind(task, number)
    stepper.restore(saved)
    return stepper
