# eigenmotion generate chain.py
# input sha256:0506ee54a3c19fd207366e2d62591b27b9b329b4734ce46f7572381b4a1eb82f
# body sha256:c649ed9140abf8b5eaac5e4ae5bd19cd83ebb7d9342b1472aebc5173f3d0214b
# cython: language_level=3
"""chain_5, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what chain_5.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model chain_5_model;
    """
    ctypedef struct em_model:
        pass
    const em_model chain_5_model


system = System(PyCapsule_New(<void *>&chain_5_model, "eigenmotion.em_model", NULL), __name__)
