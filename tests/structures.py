"""The structures of `eigenmotion.h` and `em_tableaux.h`, field by field."""

import ctypes as ct


class Fault(ct.Structure):
    _fields_ = (("status", ct.c_int), ("first", ct.c_int), ("second", ct.c_int), ("size", ct.c_double))


class Signal(ct.Structure):
    _fields_ = (("kind", ct.c_int), ("count", ct.c_size_t), ("times", ct.c_void_p), ("values", ct.c_void_p))


class Rows(ct.Structure):
    _fields_ = (
        *((name, ct.c_size_t) for name in ("count", "capacity", "width")),
        *((name, ct.POINTER(ct.c_double)) for name in ("t", "y")),
    )


class DenseStep(ct.Structure):
    _fields_ = (("t", ct.c_double), ("h", ct.c_double), ("mode", ct.c_int))


Poll = ct.CFUNCTYPE(ct.c_int, ct.c_void_p)


class Run(ct.Structure):
    """`em_run`, field by field."""

    _fields_ = (
        ("t_start", ct.c_double),
        ("t_end", ct.c_double),
        ("y_start", ct.c_void_p),
        ("prepared", ct.c_void_p),
        ("inputs", ct.c_void_p),
        ("method", ct.c_int),
        ("rtol", ct.c_double),
        ("atol", ct.c_void_p),
        ("first_step", ct.c_double),
        ("max_step", ct.c_double),
        ("max_steps", ct.c_long),
        ("stabilise", ct.c_int),
        ("least_norm", ct.c_int),
        ("dense", ct.c_int),
        ("t_eval", ct.c_void_p),
        ("n_t_eval", ct.c_size_t),
        ("event_direction", ct.c_void_p),
        ("event_terminal", ct.c_void_p),
        ("poll", Poll),
        ("poll_argument", ct.c_void_p),
        ("fault", Fault),
        ("rows", Rows),
        ("events", ct.POINTER(Rows)),
        ("dense_steps", ct.POINTER(DenseStep)),
        ("dense_table", ct.POINTER(ct.c_double)),
        ("n_dense", ct.c_size_t),
        ("dense_capacity", ct.c_size_t),
        ("kept", ct.c_int),
        ("n_rhs", ct.c_long),
        ("n_steps", ct.c_long),
        ("n_rejected", ct.c_long),
        ("n_bounded", ct.c_long),
        ("t_reached", ct.c_double),
        ("model", ct.c_void_p),
    )


class Tableau(ct.Structure):
    _fields_ = (
        *(
            (name, ct.c_int)
            for name in ("stages", "solution", "velocity_stage", "error_order", "errors", "last_extra", "corrections")
        ),
        ("c", ct.c_double * 16),
        ("a", ct.c_double * 16 * 16),
        ("e", ct.c_double * 16 * 2),
        ("d", ct.c_double * 16 * 4),
    )
