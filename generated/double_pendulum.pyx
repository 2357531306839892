# eigenmotion generate double_pendulum.py
# input sha256:2aa8c78fd5de9dcc95b82b3b59485521f0f69d4545624273923556883aeddf96
# body sha256:4752a0763ff093c19259e39e58b2b58a12726b9151983c84666453b3c8e27c47
# cython: language_level=3
"""double_pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what double_pendulum.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model double_pendulum_model;
    """
    ctypedef struct em_model:
        pass
    const em_model double_pendulum_model


system = System(PyCapsule_New(<void *>&double_pendulum_model, "eigenmotion.em_model", NULL), __name__)
