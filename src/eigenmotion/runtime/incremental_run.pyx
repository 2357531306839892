# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Incremental runs: the caller advances them from time to time and may change inputs in between."""

from libc.stdlib cimport calloc, free

from .abi cimport em_fault, em_run, em_status
from .arrays cimport Numbers, floats, zeros
from .point cimport PointModel
from .run cimport Run

from .status.stop_reasons import StopReason

_REASONS = tuple(StopReason)

cdef struct em_increments:
    em_run *run
    void *state      # NULL once the run is closed
    bint jumped      # an input has changed since the last advance
    bint over        # the run has ended
    bint reported    # `IncrementalRuns.ended` has returned it
    long most_steps


cdef void advance_run(em_increments *part, double t) noexcept nogil:
    """Advance to t, unless the run is over."""
    if part.over:
        return
    part.run.max_steps = part.most_steps - part.run.n_steps
    part.over = part.run.model.advance(part.state, t, part.jumped)
    part.jumped = False


cdef void read_state(em_increments *part, PointModel model, double *x, double *v) noexcept:
    """Write x, v (n + p) at the current time; the p states are the last entries of both v and x."""
    cdef int k
    part.run.model.now(part.state, x, v)
    for k in range(model.n_coordinates, model.n):
        x[k] = v[k]


cdef class IncrementalRun(Run):
    """A run that the caller advances to chosen times; parameters as of `Run`."""

    cdef em_increments part

    def __init__(self, task, int method, int other=-1):
        self.may_change(other)
        if self.run.model.open == NULL:
            raise TypeError(f"{self.model.name}: its table has no open: where it is written by hand, it gives what "
                            "em_handle.h has")
        self.part = em_increments(run=&self.run, state=self.run.model.open(&self.run), jumped=False,
                                  over=False, reported=False, most_steps=self.run.max_steps)
        if self.part.state == NULL:
            self.part.over = True
            self.stop = _REASONS[<int> self.run.fault.status]

    def __dealloc__(self):
        self.shut()

    cdef shut(self):
        if self.part.state != NULL:
            self.run.model.close(self.part.state)
        self.part.state, self.part.over = NULL, True

    def advance(self, double t):
        """Advance to t. Return whether the run has reached it and can continue."""
        with nogil:
            advance_run(&self.part, t)
        if self.run.waits and not self.part.over:
            self.change_while_it_waits(self.part.state, t, self.part.most_steps)
            self.part.over = self.run.fault.status != 0
        self.raise_pending(False)
        return not self.part.over

    def set(self, Py_ssize_t place, double value):
        """Set a constant input from here on."""
        self.set_value(place, value)

    cdef void set_value(self, Py_ssize_t place, double value) noexcept:
        cdef double *current = <double *> self.signals[place].values
        self.part.jumped = self.part.jumped or current[0] != value
        current[0] = value

    def now(self):
        """x (n + p,), coordinates followed by states, and v (n,) at the current time."""
        cdef Numbers x = zeros((self.model.n,)), v = zeros((self.model.n,))
        read_state(&self.part, self.model, x.data, v.data)
        return x.array, v.array[:self.model.n_coordinates]

    @property
    def over(self):
        """Whether the run has ended."""
        return self.part.over != 0

    @property
    def reached(self):
        """[s] the time that the run has reached."""
        return self.run.t_reached

    def close(self, stop=None):
        """End the run; `stop` is the caller's StopReason, None keeps the run's own."""
        self.shut()
        if stop is not None:
            self.run.fault = em_fault(status=<em_status> (<int> _REASONS.index(stop)), first=-1, second=-1, size=0.0)
        self.stop = _REASONS[<int> self.run.fault.status]


cdef class IncrementalRuns:
    """Incremental runs of one model that advance together.

    Parameters
    ----------
    model
        The model of all runs.
    runs
        A list of `IncrementalRun`.
    """

    cdef em_increments **parts
    cdef list runs
    cdef readonly PointModel model

    def __cinit__(self, PointModel model not None, list runs not None):
        cdef IncrementalRun run
        self.model, self.runs = model, runs
        self.parts = <em_increments **> calloc(len(runs) + 1, sizeof(em_increments *))
        if self.parts == NULL:
            raise MemoryError
        for k, run in enumerate(runs):
            self.parts[k] = &run.part

    def __dealloc__(self):
        free(self.parts)

    def advance(self, double t, Py_ssize_t first, Py_ssize_t last):
        """Advance runs first ... last - 1 to t without the interpreter's lock."""
        cdef Py_ssize_t k
        if not 0 <= first <= last <= len(self.runs):
            raise IndexError(f"there are {len(self.runs)} runs")
        with nogil:
            for k in range(first, last):
                advance_run(self.parts[k], t)

    def ended(self):
        """The indices of runs that have ended since the last call."""
        cdef Py_ssize_t k
        cdef IncrementalRun run
        cdef list indices = []
        for k in range(len(self.runs)):
            if self.parts[k].reported or not self.parts[k].over:
                continue
            self.parts[k].reported = True
            run = self.runs[k]
            run.raise_pending(False)
            indices.append(k)
        return indices

    def now(self):
        """x (K, n + p), v (K, n) of all runs, as `IncrementalRun.now`; new arrays."""
        cdef Py_ssize_t k, count = len(self.runs)
        cdef Numbers x = zeros((count, self.model.n)), v = zeros((count, self.model.n))
        for k in range(count):
            if self.parts[k].state != NULL:
                read_state(self.parts[k], self.model, x.row(k), v.row(k))
        return x.array, v.array[:, :self.model.n_coordinates]

    def set(self, Py_ssize_t place, values):
        """Set a constant input from here on, to values (K,)."""
        cdef Py_ssize_t k, count = len(self.runs)
        cdef Numbers numbers = floats(values, (count,), "values")
        cdef IncrementalRun run
        for k in range(count):
            run = self.runs[k]
            run.set_value(place, numbers.data[k])
