# eigenmotion generate bouncing_ball.py
# input sha256:a32b1e6aa8f95644e895a7d8fef01cbd8f56ebac1ee25cfa6f861827098e1439
# body sha256:cbae5523b71267a25b90b97c9c88ef82b011dd4c082a81df9188888caec2167d
# cython: language_level=3
"""bouncing_ball, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what bouncing_ball.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model bouncing_ball_model;
    """
    ctypedef struct em_model:
        pass
    const em_model bouncing_ball_model


system = System(PyCapsule_New(<void *>&bouncing_ball_model, "eigenmotion.em_model", NULL), __name__)
