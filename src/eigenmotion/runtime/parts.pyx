# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""A run in parts, between which inputs change."""

from .abi cimport em_fault, em_status
from .arrays cimport Numbers, zeros
from .run cimport Run

from .status.stop_reasons import StopReason

_REASONS = tuple(StopReason)


cdef class RunInParts(Run):
    """A run that advances to times of the caller's choice, at its start; parameters as of `Run`."""

    cdef void *run_state
    cdef bint jumped
    cdef long most_steps

    def __init__(self, task, int method):
        if self.run.model.open == NULL:
            raise TypeError(f"{self.model.name}: its table has no open: where it is written by hand, it gives what "
                            "em_handle.h has")
        self.most_steps = self.run.max_steps
        self.run_state = self.run.model.open(&self.run)
        if self.run_state == NULL:
            self.stop = _REASONS[<int> self.run.fault.status]

    def __dealloc__(self):
        self.shut()

    cdef shut(self):
        if self.run_state != NULL:
            self.run.model.close(self.run_state)
        self.run_state = NULL

    def advance(self, double t):
        """Advance to t. Return whether the run has reached it and can continue."""
        cdef int ended
        if self.run_state == NULL:
            return False
        self.run.max_steps = self.most_steps - self.run.n_steps
        with nogil:
            ended = self.run.model.advance(self.run_state, t, self.jumped)
        self.jumped = False
        if self.pending is not None:
            raise self.pending
        return not ended

    def set(self, Py_ssize_t place, double value):
        """Set a constant input from here on."""
        cdef double *held = <double *> self.signals[place].values
        self.jumped = self.jumped or held[0] != value
        held[0] = value

    def now(self):
        """x, v (n,) at the current time."""
        cdef Numbers x = zeros((self.model.n,)), v = zeros((self.model.n,))
        self.run.model.now(self.run_state, x.data, v.data)
        return x.array, v.array

    def close(self, stop=None):
        """The end of a run in parts: where it got by itself, or for a StopReason of the caller's."""
        self.shut()
        if stop is not None:
            self.run.fault = em_fault(status=<em_status> (<int> _REASONS.index(stop)), first=-1, second=-1, size=0.0)
        self.stop = _REASONS[<int> self.run.fault.status]
