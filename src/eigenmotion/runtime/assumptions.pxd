# Declarations of em_assumptions.h: the check of numbers against the assumptions of their symbols.

from .abi cimport em_declared, em_fault


cdef extern from "loop/em_assumptions.h" nogil:
    int em_check_declared(const em_declared *, int, int, const double *, em_fault *)
