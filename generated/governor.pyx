# eigenmotion generate governor.py
# input sha256:202dd52e577d65d0bddec872924c315ac3164fbae4484a324e9d7f2fd425c856
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
