# Declarations of em_start_check.h: the check of a start.

from .abi cimport em_fault, em_model


cdef extern from "loop/em_start_check.h" nogil:
    double em_next_time_event(int, const double *, double, double)
    int em_time_event_sides(int, const double *, double, double, double, double *)
    void em_factored_matrix(const em_model *, double, const double *, const double *, double *)
    void em_factored_gradient(const em_model *, double, const double *, const double *, double *)
    int em_outside_tables(const em_model *, const double *, const double *, em_fault *)
    int em_undefined(const em_model *, double, const double *, const double *, em_fault *)
    int em_inside_contact(const em_model *, double, const double *, const double *, const double *, double,
                          const double *)
    int em_start(const em_model *, double, const double *, const double *, const double *, double, const double *,
                 double *, int *, double *)
