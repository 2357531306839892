# eigenmotion generate pendulum.py
# input sha256:52fb53e2f4741a5fadc920567d0721d21d1fc192cb58e17ae46f40910c3d51a0
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
