# eigenmotion generate heavy_top.py
# input sha256:7ccdfa2536616d76d097f61367fff237e8a3488b5040ecad7c5299584f0ca358
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
