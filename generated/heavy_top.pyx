# eigenmotion generate heavy_top.py
# input sha256:e9f4f2af0643a8c63945119eebe764f39e032a7055c33453fcb301da0a3521f3
# body sha256:bf19b70c6cde5a71b4a171a85168c4b02c9f089ffb3759d35fe0973d9960eec3
# cython: language_level=3
"""heavy_top, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what heavy_top.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model heavy_top_model;
    """
    ctypedef struct em_model:
        pass
    const em_model heavy_top_model


system = System(PyCapsule_New(<void *>&heavy_top_model, "eigenmotion.em_model", NULL), __name__)
