# eigenmotion generate four_bars.py
# input sha256:bcb90918768aa4b82cabda26a10ffab302d61bd800ad437e9fa9db3f90eb0350
# body sha256:7e84677ad3a0edfdd5c78e9edd8f853b3c2d7904bcbe2f05c9b0433baff36fa1
# cython: language_level=3
"""four_bars_2, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what four_bars_2.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model four_bars_2_model;
    """
    ctypedef struct em_model:
        pass
    const em_model four_bars_2_model


system = System(PyCapsule_New(<void *>&four_bars_2_model, "eigenmotion.em_model", NULL), __name__)
