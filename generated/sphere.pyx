# eigenmotion generate sphere.py
# input sha256:fbd5f25b368f8e9a515de98d41a0d309d988e20f65c0862d1dd5d5e53c4ea918
# body sha256:913666d32f7b1c8f0bedede469dd3df1439cba132305e6db137738240d71b597
# cython: language_level=3
"""sphere, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what sphere.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model sphere_model;
    """
    ctypedef struct em_model:
        pass
    const em_model sphere_model


system = System(PyCapsule_New(<void *>&sphere_model, "eigenmotion.em_model", NULL), __name__)
