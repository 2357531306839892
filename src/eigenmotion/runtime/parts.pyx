# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""A run in parts: inputs change between them, or the steps are the caller's."""

from .abi cimport EM_DENSE_COEFFICIENTS, EM_NON_FINITE_STATE, EM_TOLD, em_fault, em_piece, em_rows, em_status
from .arrays cimport Numbers, zeros
from .run cimport Run

import numpy as np

from .faults import StopReason

TOLD = <int> EM_TOLD
"""The number of the method that makes no steps, but is told them."""
TOLD_NODES = 0.5 - 0.5 * np.cos(np.pi * np.arange(EM_DENSE_COEFFICIENTS) / (EM_DENSE_COEFFICIENTS - 1))
"""(10,) parts of a step that is told: those of em_told.h."""
_REASONS = tuple(StopReason)


cdef class RunInParts(Run):
    """A run that is at its start, and goes on as far as it is told; parameters as of `Run`."""

    cdef em_piece piece
    cdef void *walk
    cdef bint jumped
    cdef long most_steps

    def __init__(self, task, int method):
        if self.run.model.open == NULL:
            raise TypeError(f"{self.model.name}: its table has no open: where it is written by hand, it gives what "
                            "em_handle.h has")
        self.most_steps = self.run.max_steps
        self.walk = self.run.model.open(&self.run)
        if self.walk == NULL:
            self.stop = _REASONS[<int> self.run.fault.status]

    def __dealloc__(self):
        self.shut()

    cdef shut(self):
        if self.walk != NULL:
            self.run.model.close(self.walk)
        self.walk = NULL

    def advance(self, double t):
        """Go on to t. Whether the run has come there, and goes on."""
        cdef int ended
        if self.walk == NULL:
            return False
        self.run.max_steps = self.most_steps - self.run.n_steps
        with nogil:
            ended = self.run.model.advance(self.walk, t, self.jumped)
        self.jumped = False
        if self.pending is not None:
            raise self.pending
        return not ended

    def tell(self, double t, z, double t_new, z_new, inside):
        """Go on along a step that the caller has made (em_told.h).

        Parameters
        ----------
        z, z_new
            (2 n,) x and v at its ends.
        inside
            Called as inside(times (k,)) -> (2 n, k), unless nobody asks for a state within.

        Returns
        -------
        bool or None
            Whether the run goes on; None: from where it stands now, as an event has acted.
        """
        cdef Numbers y = zeros((EM_DENSE_COEFFICIENTS, self.model.n_state))
        cdef bint goes_on, blank = not self.looks_inside()
        table = y.array[:, :2 * self.model.n]
        table[:] = np.nan if blank else inside(t + TOLD_NODES * (t_new - t)).T
        table[0], table[-1] = z, z_new
        self.piece = em_piece(t=t, h=t_new - t, y=y.data, left=False)
        self.run.piece = &self.piece
        goes_on = self.advance(t_new)
        if blank and self.run.fault.status == EM_NON_FINITE_STATE and self.run.t_reached == t:
            table[1:-1] = inside(t + TOLD_NODES[1:-1] * (t_new - t)).T  # its end is none: how far the motion gets
            goes_on = self.advance(t_new)
        return None if goes_on and self.piece.left else goes_on

    cdef bint looks_inside(self):
        """Whether somebody asks for states within steps."""
        cdef Py_ssize_t k
        for k in range(self.model.n_inputs):
            if self.signals[k].count > 0:
                return True
        return self.run.dense or self.run.t_eval != NULL or self.model.n_events > 0

    def set(self, Py_ssize_t place, double value):
        """An input, which is constant, from here on."""
        cdef double *held = <double *> self.signals[place].values
        self.jumped = self.jumped or held[0] != value
        held[0] = value

    def now(self):
        """x, v (n,) where the run stands."""
        cdef Numbers x = zeros((self.model.n,)), v = zeros((self.model.n,))
        self.run.model.now(self.walk, x.data, v.data)
        return x.array, v.array

    @property
    def t(self):
        """[s] where the run stands."""
        return self.run.t_reached

    def close(self, stop=None, str said=""):
        """The end of a run in parts: where it got by itself, or, for a StopReason of the caller's, with what that says."""
        self.shut()
        if stop is not None:
            self.run.fault = em_fault(status=<em_status> (<int> _REASONS.index(stop)), first=-1, second=-1, size=0.0)
            self.said = said
        self.stop = _REASONS[<int> self.run.fault.status]

    @property
    def nsteps(self):
        """Accepted steps so far."""
        return self.run.n_steps

    @property
    def parameters(self):
        """Of the mode it is in; None for a model without modes."""
        cdef em_rows *legs = &self.run.legs
        if legs.count == 0:
            return None
        return [legs.y[(legs.count - 1) * legs.width + i] for i in range(self.model.model.n_parameters)]
