# eigenmotion generate rimless_wheel.py
# input sha256:16083fc70ce4f8f74a2486776ab2e7ad0d28678092f92365b6aa29bbd500868b
# body sha256:e718ed7cb64303c5ca8457199013aeae71e1611e5dc1f39c468215b737960c61
# cython: language_level=3
"""rimless_wheel, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what rimless_wheel.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model rimless_wheel_model;
    """
    ctypedef struct em_model:
        pass
    const em_model rimless_wheel_model


system = System(PyCapsule_New(<void *>&rimless_wheel_model, "eigenmotion.em_model", NULL), __name__)
