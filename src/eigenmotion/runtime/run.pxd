# A run, for runs in parts.

from .abi cimport em_rows, em_run, em_signal
from .point cimport PointModel


cdef class Run:
    cdef em_run run
    cdef em_signal *signals
    cdef readonly PointModel model
    cdef readonly object stop
    cdef list held     # arrays kept as long as the run
    cdef object pending  # exception raised by a signal's handler

    cdef begin(self, task, int method)
    cdef const double *hold(self, array, tuple shape, str name) except NULL
    cdef hold_inputs(self, tuple inputs)
    cdef table(self, em_rows *rows)
    cdef events(self, em_rows *tables)
    cdef message(self)
    cdef size_t step_at(self, double t) noexcept nogil
