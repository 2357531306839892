# eigenmotion generate cart_pendulums.py
# input sha256:2166a7ac83f4a77333ace508537ee820c7acdbe8b322220d50204dc1a7bea13e
# body sha256:42491777cf6db07c9d0e783385f83b1ba9304b894cfaad887e7369fc3ea6d0ff
# cython: language_level=3
"""cart_pendulums_3, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what cart_pendulums_3.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model cart_pendulums_3_model;
    """
    ctypedef struct em_model:
        pass
    const em_model cart_pendulums_3_model


system = System(PyCapsule_New(<void *>&cart_pendulums_3_model, "eigenmotion.em_model", NULL), __name__)
