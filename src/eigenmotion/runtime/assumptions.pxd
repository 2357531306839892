# em_assumptions.h: whether numbers are those that their symbols were declared to have.

from .abi cimport em_declared, em_fault


cdef extern from "loop/em_assumptions.h" nogil:
    int em_refuse(const em_declared *, int, int, const double *, em_fault *)
