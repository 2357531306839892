# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""A run in parts, between which inputs change."""

from libc.stdlib cimport calloc, free

from .abi cimport em_fault, em_run, em_status
from .arrays cimport Numbers, given, zeros
from .point cimport PointModel
from .run cimport Run

from .status.stop_reasons import StopReason

_REASONS = tuple(StopReason)

cdef struct em_part:
    em_run *run
    void *state      # NULL once it is closed
    bint jumped      # whether an input has been set to another value since the last advance
    bint over        # whether it has ended,
    bint told        # and `RunsInParts.ended` has said so
    long most_steps


cdef void go(em_part *part, double t) noexcept nogil:
    """Advance to t, unless the run is over."""
    if part.over:
        return
    part.run.max_steps = part.most_steps - part.run.n_steps
    part.over = part.run.model.advance(part.state, t, part.jumped)
    part.jumped = False


cdef void measure(em_part *part, PointModel model, double *x, double *v) noexcept:
    """Write x, v (n + p) of the current time; states, which are the last of v, stand behind the coordinates of x, too."""
    cdef int k
    part.run.model.now(part.state, x, v)
    for k in range(model.n_coordinates, model.n):
        x[k] = v[k]


cdef class RunInParts(Run):
    """A run that advances to times of the caller's choice, at its start; parameters as of `Run`."""

    cdef em_part part

    def __init__(self, task, int method):
        if self.run.model.open == NULL:
            raise TypeError(f"{self.model.name}: its table has no open: where it is written by hand, it gives what "
                            "em_handle.h has")
        self.part = em_part(run=&self.run, state=self.run.model.open(&self.run), jumped=False,
                            over=False, told=False, most_steps=self.run.max_steps)
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
            go(&self.part, t)
        if self.pending is not None:
            raise self.pending
        return not self.part.over

    def set(self, Py_ssize_t place, double value):
        """Set a constant input from here on."""
        self.hold_value(place, value)

    cdef void hold_value(self, Py_ssize_t place, double value) noexcept:
        cdef double *held = <double *> self.signals[place].values
        self.part.jumped = self.part.jumped or held[0] != value
        held[0] = value

    def now(self):
        """x (n + p,), coordinates and states behind them, and v (n,) at the current time."""
        cdef Numbers x = zeros((self.model.n,)), v = zeros((self.model.n,))
        measure(&self.part, self.model, x.data, v.data)
        return x.array, v.array[:self.model.n_coordinates]

    @property
    def over(self):
        """Whether it cannot be advanced any more."""
        return self.part.over != 0

    @property
    def reached(self):
        """[s] the time that the run has come to."""
        return self.run.t_reached

    def close(self, stop=None):
        """The end of a run in parts: where it got by itself, or for a StopReason of the caller's."""
        self.shut()
        if stop is not None:
            self.run.fault = em_fault(status=<em_status> (<int> _REASONS.index(stop)), first=-1, second=-1, size=0.0)
        self.stop = _REASONS[<int> self.run.fault.status]


cdef class RunsInParts:
    """Runs in parts of one model that advance side by side.

    Parameters
    ----------
    model
        Of all of them.
    runs
        Each a `RunInParts`.
    """

    cdef em_part **parts
    cdef list runs
    cdef readonly PointModel model

    def __cinit__(self, PointModel model not None, list runs not None):
        cdef RunInParts run
        self.model, self.runs = model, runs
        self.parts = <em_part **> calloc(len(runs) + 1, sizeof(em_part *))
        if self.parts == NULL:
            raise MemoryError
        for k, run in enumerate(runs):
            self.parts[k] = &run.part

    def __dealloc__(self):
        free(self.parts)

    def advance(self, double t, Py_ssize_t first, Py_ssize_t last):
        """Advance runs first ... last - 1 to t, with the interpreter's lock released once."""
        cdef Py_ssize_t k
        if not 0 <= first <= last <= len(self.runs):
            raise IndexError(f"there are {len(self.runs)} runs")
        with nogil:
            for k in range(first, last):
                go(self.parts[k], t)

    def ended(self):
        """The indices of runs that have ended since this was asked last."""
        cdef Py_ssize_t k
        cdef RunInParts run
        cdef list found = []
        for k in range(len(self.runs)):
            if self.parts[k].told or not self.parts[k].over:
                continue
            self.parts[k].told = True
            run = self.runs[k]
            if run.pending is not None:
                raise run.pending
            found.append(k)
        return found

    def now(self):
        """x (K, n + p), v (K, n), new arrays: where the runs are, as `RunInParts.now`."""
        cdef Py_ssize_t k, count = len(self.runs)
        cdef Numbers x = zeros((count, self.model.n)), v = zeros((count, self.model.n))
        for k in range(count):
            if self.parts[k].state != NULL:
                measure(self.parts[k], self.model, x.row(k), v.row(k))
        return x.array, v.array[:, :self.model.n_coordinates]

    def set(self, Py_ssize_t place, values):
        """Set a constant input from here on, to values (K,)."""
        cdef Py_ssize_t k, count = len(self.runs)
        cdef Numbers taken = given(values, (count,), "values")
        cdef RunInParts run
        for k in range(count):
            run = self.runs[k]
            run.hold_value(place, taken.data[k])
