# eigenmotion generate pendulum.py
# input sha256:d53f6c3fdecb6f24b59994a52196687fc85759167453b9057cbc490f9c45eff3
# body sha256:09037d51b2b2b2550ff8094f27bf8bb2ad11c1611dea9c9fa59879e08f99317b
# cython: language_level=3
"""pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what pendulum.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model pendulum_model;
    """
    ctypedef struct em_model:
        pass
    const em_model pendulum_model


system = System(PyCapsule_New(<void *>&pendulum_model, "eigenmotion.em_model", NULL), __name__)
