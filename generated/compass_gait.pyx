# eigenmotion generate compass_gait.py
# input sha256:16b28dc5eef92bb460ce2a92b01dd77a52ef651273d117ec32a4c6820b543912
# body sha256:fcb418ba600cabb6b8d3ea577281b715158da582240d28d452491f3ae32aa21d
# cython: language_level=3
"""compass_gait, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what compass_gait.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model compass_gait_model;
    """
    ctypedef struct em_model:
        pass
    const em_model compass_gait_model


system = System(PyCapsule_New(<void *>&compass_gait_model, "eigenmotion.em_model", NULL), __name__)
