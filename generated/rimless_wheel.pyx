# eigenmotion generate rimless_wheel.py
# input sha256:bce80e9863561a6e1bf2c46ba9e8914030752e914806d6722b4f921044fa3a3c
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
