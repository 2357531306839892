# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Runs in parts: a run saves its state from time to time, and each part of it can be run again, bit for bit.

So the dense output of a long run need not be kept as a whole.
"""

from cpython.bytes cimport PyBytes_AS_STRING, PyBytes_FromStringAndSize
from libc.string cimport memcpy

from .abi cimport em_fault
from .arrays cimport Numbers, zeros
from .point cimport Prepared
from .run cimport Run

import numpy as np

from .status.stop_reasons import StopReason

_REASONS = tuple(StopReason)
_TOO_MANY = _REASONS.index(StopReason.TOO_MANY_STEPS)


class Checkpoint:
    """The state of a run between two steps: its time, its state y (n_state,), the mode, and all that a run needs to go
    on; and the number of steps of the part that starts here."""

    __slots__ = ("t", "y", "prepared", "saved", "steps")

    def __init__(self, t, y, prepared, saved):
        self.t, self.y, self.prepared, self.saved, self.steps = t, y, prepared, saved, 0


cdef class PartialRun(Run):
    """A run that is advanced by a number of steps."""

    cdef void *state
    cdef long most_steps

    cdef start(self):
        if self.run.model.open == NULL:
            raise TypeError(f"{self.model.name}: its table has no open: where it is written by hand, it gives what "
                            "em_handle.h has")
        self.most_steps = self.run.max_steps
        self.state = self.run.model.open(&self.run)

    def __dealloc__(self):
        if self.state != NULL:
            self.run.model.close(self.state)

    cdef bint advance_by(self, long steps) except -1:
        """Advance by at most so many steps. Return whether the run can go on."""
        cdef double end = self.run.t_end
        self.run.max_steps = min(steps, self.most_steps - self.run.n_steps)
        with nogil:
            self.run.model.advance(self.state, end, 0)
        self.raise_pending(False)
        return <int> self.run.fault.status == _TOO_MANY and self.run.n_steps < self.most_steps

    cdef mode(self):
        """The prepared parameters of the current mode."""
        cdef Prepared given = self.keep_alive[0], now
        if self.model.model.n_switches == 0 and not self.model.acts:
            return given
        now = self.model.prepare(np.array(given.parameters, dtype=np.float64))
        memcpy(now.c, self.run.prepared, self.model.model.n_prepared * sizeof(double))
        now.parameters = tuple([now.c[j] for j in range(self.model.model.n_parameters)])
        return now

    cdef shut(self):
        self.stop = _REASONS[<int> self.run.fault.status]
        if self.state != NULL:
            self.run.model.close(self.state)
        self.state = NULL


cdef class CheckpointedRun(PartialRun):
    """A whole run that saves its state about every `steps` steps; the dense output is that of the last part.

    checkpoints : a Checkpoint for the start of each part
    """

    cdef readonly list checkpoints

    def __init__(self, task, int method, long steps):
        self.checkpoints = []
        self.start()
        if self.state != NULL:
            self.run_in_parts(steps)
        self.shut()

    cdef run_in_parts(self, long steps):
        cdef long before = 0
        while True:
            begin = self.save()
            self.checkpoints.append(begin)
            self.run.n_dense = 0
            more = self.advance_by(steps)
            while more and self.at_event():
                more = self.advance_by(1)
            begin.steps = self.run.n_steps - before
            before = self.run.n_steps
            if not more:
                return

    cdef save(self):
        cdef em_fault fault
        cdef Numbers y = zeros((self.model.n_state,))
        saved = PyBytes_FromStringAndSize(NULL, self.run.model.saved())
        self.run.model.save(self.state, PyBytes_AS_STRING(saved))
        if self.run.model.publish(self.state, y.data, &fault) != 0:
            raise self.model.failure(&fault)
        return Checkpoint(self.run.t_reached, y.array, self.mode(), saved)

    cdef bint at_event(self) except -1:
        """Whether an event, a change of rotation parameters or a time event is where the run is: no part ends there."""
        cdef double t = self.run.t_reached, begin = self.run.dense_steps[self.run.n_dense - 1].t
        cdef int k
        for k in range(self.model.n_events):
            if self.run.events[k].count > 0 and self.run.events[k].t[self.run.events[k].count - 1] == t:
                return True
        if self.run.charts.count > 0 and self.run.charts.t[self.run.charts.count - 1] == t:
            return True
        end = self.model.smooth_interval(begin, 1.0 if t > begin else -1.0, self.keep_alive[0])[0]
        return abs(end - t) <= 1e-9 * abs(t - begin)


cdef class ReplayedRun(PartialRun):
    """The part of a run that starts at a checkpoint, with its dense output."""

    def __init__(self, task, int method, checkpoint):
        self.start()
        if self.state == NULL:
            raise MemoryError
        self.run.model.restore(self.state, PyBytes_AS_STRING(checkpoint.saved))
        self.run.segments.count = min(self.run.segments.count, 1)
        self.run.rows.count = self.run.n_dense = 0
        self.advance_by(checkpoint.steps)
        self.shut()
