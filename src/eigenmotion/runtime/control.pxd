# Declarations of em_control.h: the C stepper.

from .abi cimport em_model, em_run, em_signal

cdef extern from "em_control.h" nogil:
    ctypedef struct em_stepper:
        double t
        double *x
        double *v
        double *u
        em_run run
        em_signal *inputs
        void *run_state

    em_stepper *em_stepper_open(const em_model *model, const em_run *task, const double *u)
    int em_stepper_advance(em_stepper *s, double t, const double *u)
    size_t em_stepper_size(const em_stepper *s)
    void em_stepper_save(const em_stepper *s, void *saved)
    void em_stepper_restore(em_stepper *s, const void *saved)
    void em_stepper_close(em_stepper *s)
