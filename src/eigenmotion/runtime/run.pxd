# Declarations of run.pyx for the other modules of the runtime.

from .abi cimport em_rows, em_run, em_signal
from .point cimport PointModel


cdef int poll(void *argument) noexcept with gil


cdef class Interruptible:
    cdef object pending   # exception raised by a signal handler

    cdef int raise_pending(self, bint keyboard_too) except -1


cdef class Run(Interruptible):
    cdef em_run run
    cdef em_signal *signals
    cdef readonly PointModel model
    cdef readonly object stop
    cdef list keep_alive  # arrays that the run uses
    cdef readonly object unchanged  # why the run has kept its method, although another costs less: an exception, or None

    cdef begin(self, task, int method)
    cdef may_change(self, int other)
    cdef simulate_by_either(self)
    cdef bint load_other(self) except -1
    cdef change_while_it_waits(self, void *state, double t, long most_steps)
    cdef const double *hold(self, array, tuple shape, str name) except NULL
    cdef hold_inputs(self, tuple inputs)
    cdef table(self, em_rows *rows)
    cdef events(self, em_rows *tables)
    cdef message(self)
    cdef size_t step_at(self, double t) noexcept nogil
