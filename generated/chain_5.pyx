# eigenmotion generate chain.py
# input sha256:df0847e51f4413d27b68619e7734269a4684d1216d5de34d4e18f77a585723d0
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
