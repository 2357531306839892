# Declarations of em_lane_scheduler.h: runs of one model in a batch.

from .abi cimport em_fault, em_model, em_rows, em_run, em_signal


cdef extern from "batch/em_lane_scheduler.h" nogil:
    ctypedef struct em_ensemble:
        const em_model *model
        em_run task
        size_t count
        size_t n_rows
        const double *parameters
        const double *x
        const double *v
        const em_signal *inputs
        size_t parameters_stride
        size_t x_stride
        size_t v_stride
        size_t inputs_stride
        const unsigned char *skip
        int end_only
        const volatile int *stop
        double *y
        double *t_end
        em_fault *fault
        long *counts
        em_rows events
        long *event_starts
        long *event_counts

    const int EM_COUNTS

    int em_ensemble_run(em_ensemble *e)
