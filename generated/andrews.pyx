# eigenmotion generate andrews.py
# input sha256:771d14621a5f8d802c5503cd56f4fa403aba4e013c8e286a7a5a274fd30492b0
# body sha256:67ad1cea1838603849c1c305aa98bd719ad433228ca25bfb3c34197f61a8300b
# cython: language_level=3
"""andrews, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what andrews.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model andrews_model;
    """
    ctypedef struct em_model:
        pass
    const em_model andrews_model


system = System(PyCapsule_New(<void *>&andrews_model, "eigenmotion.em_model", NULL), __name__)
