# eigenmotion generate pendulum_with_stop.py
# input sha256:b44ef6b31bf1b97df0a8fc11e904ff67a8797029c5ee104a80e2ef00721a809e
# body sha256:f08ce14904e1bac0556911ffdf1e36b31008b878738231c44899013c62422711
# cython: language_level=3
"""pendulum_with_stop, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what pendulum_with_stop.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model pendulum_with_stop_model;
    """
    ctypedef struct em_model:
        pass
    const em_model pendulum_with_stop_model


system = System(PyCapsule_New(<void *>&pendulum_with_stop_model, "eigenmotion.em_model", NULL), __name__)
