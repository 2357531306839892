# eigenmotion generate compass_gait.py
# input sha256:56edeb7e4db8895b2d2cf8f221a89a13715f4c291bcea9a7fcf319590b9c2400
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
