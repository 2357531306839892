# eigenmotion generate governor.py
# input sha256:c8f552fe61a2f14cfdf6738806a86ae5ef77a9561614a03a832e25c8d9ba4840
# body sha256:f9bead8c765368797197046ccb8261dc00b2b52dabf24499d691c0dd60f2e493
# cython: language_level=3
"""governor, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what governor.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model governor_model;
    """
    ctypedef struct em_model:
        pass
    const em_model governor_model


system = System(PyCapsule_New(<void *>&governor_model, "eigenmotion.em_model", NULL), __name__)
