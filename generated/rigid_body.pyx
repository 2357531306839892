# eigenmotion generate rigid_body.py
# input sha256:6a1fe9ffd82e911c66db48438e1fdf5de1dc79f32cda1ff870839cf9ae9e6072
# body sha256:5f2a51a5c5845f285aebf9ea11d9072b896760d2e6fb5b9bab00ef6cda1f6441
# cython: language_level=3
"""rigid_body, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what rigid_body.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model rigid_body_model;
    """
    ctypedef struct em_model:
        pass
    const em_model rigid_body_model


system = System(PyCapsule_New(<void *>&rigid_body_model, "eigenmotion.em_model", NULL), __name__)
