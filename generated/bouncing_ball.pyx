# eigenmotion generate bouncing_ball.py
# input sha256:4d128ea20431f269a25450ff61477ebcbb2676698bb6448ebdd8d37e15829545
# body sha256:f27e8f8290de1414aa49161108ca03c7d32f420cef6aa2f827a455a09bddf8fe
# cython: language_level=3
"""bouncing_ball, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# the declaration in bouncing_ball.h, which is not included because a header of Python may have the same name
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model bouncing_ball_model;
    """
    ctypedef struct em_model:
        pass
    const em_model bouncing_ball_model


system = System(PyCapsule_New(<void *>&bouncing_ball_model, "eigenmotion.em_model", NULL), __name__)
