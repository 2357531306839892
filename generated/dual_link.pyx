# eigenmotion generate dual_link.py
# input sha256:c416ea73692bebde0c5cc2025eb4b62195c0c77ba5b73814cc95f95d474c1940
# body sha256:f05b7911c70e5eefd1489f4c4dff5dc00983cd8ba810a115c71f7a81be166b96
# cython: language_level=3
"""dual_link, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what dual_link.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model dual_link_model;
    """
    ctypedef struct em_model:
        pass
    const em_model dual_link_model


system = System(PyCapsule_New(<void *>&dual_link_model, "eigenmotion.em_model", NULL), __name__)
