# eigenmotion generate double_pendulum.py
# input sha256:e6cfab1e1cee15846756b3c2bd8b894b28db22fd5a53cdc41e8f0e725a706b06
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
