# Declarations of em_steppers.h and em_steppers_saved.h: K steppers of one model.

from .abi cimport em_fault, em_model, em_run


cdef extern from "batch/em_steppers_saved.h" nogil:
    ctypedef struct em_stepper:
        em_run run

    ctypedef struct em_steppers:
        const em_model *model
        em_run task
        size_t count
        double *t
        double *x
        double *v
        double *u
        unsigned char *ended
        long *n_rhs
        long *n_steps
        const volatile int *stop
        em_fault *fault
        int width
        em_stepper **steppers

    int em_steppers_open(em_steppers *s, int workers)
    int em_steppers_begin(em_steppers *s, size_t member, double t, const double *y, const double *c)
    void em_steppers_advance(em_steppers *s, size_t first, size_t last, int worker, const double *t_goal)
    const double *em_steppers_constants(const em_steppers *s, size_t member, double *c)
    int em_steppers_state(const em_steppers *s, size_t member, double *y, em_fault *fault)
    size_t em_steppers_size(const em_steppers *s)
    void em_steppers_save(const em_steppers *s, char *saved)
    void em_steppers_restore(em_steppers *s, const char *saved)
    void em_steppers_close(em_steppers *s)

cdef extern from "loop/em_start_check.h" nogil:
    int em_start(const em_model *model, double t, const double *x, const double *v, const double *c, double rtol,
                 const double *atol, double *y, int *at, double *off)
