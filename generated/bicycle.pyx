# eigenmotion generate bicycle.py
# input sha256:086a2e7d83260e45b545b8ae0bfffd95f92bbe57b7720c7c4a3f813b1553452d
# body sha256:11eabdf6fa8a87fbee28d8e7d06b59b8f6884b2c9f972c9b1ca84003d2a003da
# cython: language_level=3
"""bicycle, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what bicycle.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model bicycle_model;
    """
    ctypedef struct em_model:
        pass
    const em_model bicycle_model


system = System(PyCapsule_New(<void *>&bicycle_model, "eigenmotion.em_model", NULL), __name__)
