# eigenmotion generate chain.py
# input sha256:6bbbcf8677f055b932628a08180eff4ad8cf7573a6c8f3a2f34ed490ef046cfd
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
